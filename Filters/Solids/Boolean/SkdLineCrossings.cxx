// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdLineCrossings.h"

#include "Core/Geometry/Predicates/ExactPoint.h"
#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>

namespace skdtree
{
namespace
{
struct Range
{
  double Min;
  double Max;
};

Range RangeOf(const std::array<skd::Vector3, 3>& x, int axis)
{
  return { std::min({ x[0][axis], x[1][axis], x[2][axis] }),
    std::max({ x[0][axis], x[1][axis], x[2][axis] }) };
}

bool IsWithin(const Range& range, double value)
{
  return range.Min <= value && value <= range.Max;
}

skd::ExactPoint CrossingOf(const std::array<skd::Vector3, 3>& x, const SkdAxisLine& line)
{
  skd::Vector3 p = line.Point;
  skd::Vector3 q = line.Point;
  p[line.Axis] = 0.0;
  q[line.Axis] = 1.0;
  return skd::ExactCrossingWithPlane(p, q, x[0], x[1], x[2]);
}
}

std::optional<SkdLineCrossing> SkdCrossTriangle(
  const SkdMovedTriangles& set, std::uint32_t triangle, const SkdAxisLine& line, bool& isSure)
{
  const std::array<skd::Vector3, 3> x = set.GetCornerPoints(triangle);
  for (const int axis : { (line.Axis + 1) % 3, (line.Axis + 2) % 3 })
  {
    if (!IsWithin(RangeOf(x, axis), line.Point[axis]))
    {
      return std::nullopt;
    }
  }
  int left = 0;
  int right = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int side = skd::Orient2D(x[i], x[(i + 1) % 3], line.Point, line.Axis);
    left += side > 0;
    right += side < 0;
  }
  if (left > 0 && right > 0)
  {
    return std::nullopt;
  }
  isSure = isSure && left + right == 3;
  return SkdLineCrossing{ triangle, left > 0 ? 1 : -1 };
}

int SkdCompareCrossings(
  const SkdMovedTriangles& set, std::uint32_t first, std::uint32_t second, const SkdAxisLine& line)
{
  return SkdCompareCrossings(set.GetCornerPoints(first), set.GetCornerPoints(second), line);
}

int SkdCompareCrossings(const std::array<skd::Vector3, 3>& a, const std::array<skd::Vector3, 3>& b,
  const SkdAxisLine& line)
{
  const Range rangeOfA = RangeOf(a, line.Axis);
  const Range rangeOfB = RangeOf(b, line.Axis);
  if (rangeOfA.Max < rangeOfB.Min || rangeOfB.Max < rangeOfA.Min)
  {
    return rangeOfA.Max < rangeOfB.Min ? -1 : 1;
  }
  return skd::ExactCompare(CrossingOf(a, line), CrossingOf(b, line), line.Axis);
}

SkdLineCrossings::SkdLineCrossings(const SkdMovedTriangles& set,
  const std::vector<std::uint32_t>& triangles, std::size_t numberOfLines)
  : Set(set)
  , Triangles(triangles)
{
  constexpr std::size_t few = 16; // about as many lines as the R-tree costs
  if (numberOfLines > few)
  {
    std::vector<skd::Box3> boxes;
    for (const std::uint32_t triangle : triangles)
    {
      boxes.push_back(set.GetBox(triangle));
      this->Bounds.Add(boxes.back());
    }
    this->Boxes.emplace(boxes);
  }
}

std::optional<std::vector<SkdLineCrossing>> SkdLineCrossings::Find(const SkdAxisLine& line) const
{
  std::vector<SkdLineCrossing> crossings;
  bool isSure = true;
  const auto visit = [&](std::uint32_t triangle)
  {
    if (const auto crossing = SkdCrossTriangle(this->Set, triangle, line, isSure))
    {
      crossings.push_back(*crossing);
    }
  };
  if (this->Boxes)
  {
    skd::Box3 along;
    along.Add(line.Point);
    along.Min[line.Axis] = this->Bounds.Min[line.Axis];
    along.Max[line.Axis] = this->Bounds.Max[line.Axis];
    this->Boxes->ForEachOverlapping(along, [&](std::uint32_t i) { visit(this->Triangles[i]); });
    std::sort(crossings.begin(), crossings.end(),
      [](const SkdLineCrossing& a, const SkdLineCrossing& b) { return a.Triangle < b.Triangle; });
  }
  else
  {
    std::for_each(this->Triangles.begin(), this->Triangles.end(), visit);
  }
  return isSure ? std::make_optional(std::move(crossings)) : std::nullopt;
}
}
