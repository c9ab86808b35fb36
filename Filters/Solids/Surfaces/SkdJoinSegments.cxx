// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdJoinSegments.h"

#include "Core/Geometry/Rows.h"

#include <algorithm>

namespace skdtree
{
namespace
{
class Joining
{
public:
  Joining(const std::vector<SkdEndPair>& segments, const SkdSegmentPoints& points);

  std::vector<SkdPolyline> Join();

private:
  bool IsEnd(std::uint32_t point) const
  {
    return this->AtPoints[point].size() != 2 ||
      (!this->Points.IsEnd.empty() && this->Points.IsEnd[point]);
  }
  SkdPolyline Follow(std::uint32_t start, std::size_t segment);
  void Direct(SkdPolyline& line) const;

  static constexpr std::size_t None = ~std::size_t(0);
  std::size_t FindUnused(std::uint32_t point) const;

  const std::vector<SkdEndPair>& Segments;
  const SkdSegmentPoints& Points;
  skd::Rows<std::size_t> AtPoints; // the segments at each
  std::vector<bool> Used;
};

Joining::Joining(const std::vector<SkdEndPair>& segments, const SkdSegmentPoints& points)
  : Segments(segments)
  , Points(points)
  , AtPoints(points.Number,
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
    segment = this->IsEnd(point) ? None : this->FindUnused(point);
  } while (segment != None);
  line.IsClosed = point == start && !this->IsEnd(start);
  if (!line.IsClosed)
  {
    line.Points.push_back(point);
  }
  this->Direct(line);
  return line;
}

void Joining::Direct(SkdPolyline& line) const
{
  const auto& isBefore = this->Points.IsBefore;
  std::vector<std::uint32_t>& points = line.Points;
  if (line.IsClosed)
  {
    const auto first =
      std::min_element(points.begin(), points.end(), std::cref(isBefore)) - points.begin();
    std::rotate(points.begin(), points.begin() + first, points.end());
    std::rotate(line.Segments.begin(), line.Segments.begin() + first, line.Segments.end());
    if (isBefore(points.back(), points[1]))
    {
      std::reverse(points.begin() + 1, points.end());
      std::reverse(line.Segments.begin(), line.Segments.end());
    }
    return;
  }
  const std::size_t n = points.size();
  const bool areEndsAlike =
    !isBefore(points[0], points[n - 1]) && !isBefore(points[n - 1], points[0]);
  if (isBefore(points[n - 1], points[0]) || (areEndsAlike && isBefore(points[n - 2], points[1])))
  {
    std::reverse(points.begin(), points.end());
    std::reverse(line.Segments.begin(), line.Segments.end());
  }
}

std::vector<SkdPolyline> Joining::Join()
{
  std::vector<SkdPolyline> lines;
  const auto numberOfPoints = static_cast<std::uint32_t>(this->AtPoints.size());
  for (std::uint32_t point = 0; point < numberOfPoints; ++point)
  {
    if (this->IsEnd(point))
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
  const std::vector<SkdEndPair>& segments, const SkdSegmentPoints& points)
{
  return Joining(segments, points).Join();
}
}
