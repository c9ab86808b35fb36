// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdJoinSegments.h"

#include "Core/Geometry/Rows.h"

namespace skdtree
{
namespace
{
class Joining
{
public:
  Joining(const std::vector<SkdEndPair>& segments, std::uint32_t numberOfPoints);

  std::vector<SkdPolyline> Join();

private:
  std::size_t CountAt(std::uint32_t point) const { return this->AtPoints[point].size(); }
  SkdPolyline Follow(std::uint32_t start, std::size_t segment);

  static constexpr std::size_t None = ~std::size_t(0);
  std::size_t FindUnused(std::uint32_t point) const;

  const std::vector<SkdEndPair>& Segments;
  skd::Rows<std::size_t> AtPoints; // the segments at each
  std::vector<bool> Used;
};

Joining::Joining(const std::vector<SkdEndPair>& segments, std::uint32_t numberOfPoints)
  : Segments(segments)
  , AtPoints(numberOfPoints,
      [&](const auto& add)
      {
        for (std::size_t i = 0; i < segments.size(); ++i)
        {
          add(segments[i].A, i);
          add(segments[i].B, i);
        }
      })
  , Used(segments.size(), false)
{
}

std::size_t Joining::FindUnused(std::uint32_t point) const
{
  for (const std::size_t segment : this->AtPoints[point])
  {
    if (!this->Used[segment])
    {
      return segment;
    }
  }
  return None;
}

SkdPolyline Joining::Follow(std::uint32_t start, std::size_t segment)
{
  SkdPolyline line;
  std::uint32_t point = start;
  do
  {
    line.Points.push_back(point);
    line.Segments.push_back(segment);
    this->Used[segment] = true;
    const SkdEndPair& ends = this->Segments[segment];
    point = ends.A == point ? ends.B : ends.A;
    segment = this->CountAt(point) == 2 ? this->FindUnused(point) : None;
  } while (segment != None);
  line.IsClosed = point == start && this->CountAt(start) == 2;
  if (!line.IsClosed)
  {
    line.Points.push_back(point);
  }
  return line;
}

std::vector<SkdPolyline> Joining::Join()
{
  std::vector<SkdPolyline> lines;
  const auto numberOfPoints = static_cast<std::uint32_t>(this->AtPoints.size());
  for (std::uint32_t point = 0; point < numberOfPoints; ++point)
  {
    if (this->CountAt(point) != 2)
    {
      for (std::size_t next = this->FindUnused(point); next != None; next = this->FindUnused(point))
      {
        lines.push_back(this->Follow(point, next));
      }
    }
  }
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    if (!this->Used[i])
    {
      lines.push_back(this->Follow(this->Segments[i].A, i));
    }
  }
  return lines;
}
}

std::vector<SkdPolyline> SkdJoinSegments(
  const std::vector<SkdEndPair>& segments, std::uint32_t numberOfPoints)
{
  return Joining(segments, numberOfPoints).Join();
}
}
