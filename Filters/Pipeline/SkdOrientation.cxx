// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdOrientation.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace
{
struct Side
{
  vtkIdType Least;
  vtkIdType Most;
  bool IsForward; // the triangle goes from the least to the most
  std::size_t Triangle;

  bool IsSameEdge(const Side& other) const
  {
    return this->Least == other.Least && this->Most == other.Most;
  }
};

struct Neighbour
{
  std::size_t Triangle;
  bool IsAlike; // both have their normals on the same side of the surface
};

/// The triangles across those edges that have exactly two.
class Neighbours
{
public:
  explicit Neighbours(const std::vector<SkdTriangleIds>& triangles)
    : Lists(triangles.size())
  {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const vtkIdType from = triangles[i][k], to = triangles[i][(k + 1) % 3];
        sides.push_back({ std::min(from, to), std::max(from, to), from < to, i });
      }
    }
    std::sort(sides.begin(), sides.end(),
      [](const Side& a, const Side& b)
      { return std::tie(a.Least, a.Most, a.Triangle) < std::tie(b.Least, b.Most, b.Triangle); });
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end)
    {
      while (end < sides.size() && sides[end].IsSameEdge(sides[first]))
      {
        ++end;
      }
      if (end - first == 2)
      {
        this->Join(sides[first], sides[first + 1]);
      }
    }
  }

  const std::vector<Neighbour>& Of(std::size_t triangle) const { return this->Lists[triangle]; }

private:
  void Join(const Side& a, const Side& b)
  {
    const bool isAlike = a.IsForward != b.IsForward;
    this->Lists[a.Triangle].push_back({ b.Triangle, isAlike });
    this->Lists[b.Triangle].push_back({ a.Triangle, isAlike });
  }

  std::vector<std::vector<Neighbour>> Lists;
};

/// All triangles that hang together with the first, turned like it.
std::vector<std::size_t> TurnAlike(std::size_t first, const Neighbours& neighbours,
  std::vector<bool>& isTurned, std::vector<bool>& isSeen)
{
  std::vector<std::size_t> piece{ first };
  isSeen[first] = true;
  for (std::size_t next = 0; next < piece.size(); ++next)
  {
    for (const Neighbour& other : neighbours.Of(piece[next]))
    {
      if (!isSeen[other.Triangle])
      {
        isSeen[other.Triangle] = true;
        isTurned[other.Triangle] = isTurned[piece[next]] == other.IsAlike;
        piece.push_back(other.Triangle);
      }
    }
  }
  return piece;
}

skd::Vector3 AcrossOf(const std::vector<skd::Vector3>& points, const SkdTriangleIds& ids)
{
  return skd::Cross(points[ids[1]] - points[ids[0]], points[ids[2]] - points[ids[0]]);
}
}

std::vector<bool> SkdFindReversed(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles,
  const std::function<bool(const skd::Vector3&)>& isInside)
{
  const Neighbours neighbours(triangles);
  std::vector<bool> isTurned(triangles.size(), false);
  std::vector<bool> isSeen(triangles.size(), false);
  const auto area2 = [&](std::size_t i) { return skd::Norm2(AcrossOf(points, triangles[i])); };
  for (std::size_t first = 0; first < triangles.size(); ++first)
  {
    if (isSeen[first])
    {
      continue;
    }
    const std::vector<std::size_t> piece = TurnAlike(first, neighbours, isTurned, isSeen);
    const std::size_t largest = *std::max_element(piece.begin(), piece.end(),
      [&](std::size_t a, std::size_t b) { return area2(a) < area2(b); });
    // A distance from the centre far above rounding error and far below other distances.
    const SkdTriangleIds& ids = triangles[largest];
    const skd::Vector3 across = AcrossOf(points, ids);
    const double length = std::sqrt(skd::Norm(across));
    const skd::Vector3 step = (length > 0.0 ? 1e-5 / length : 0.0) * across;
    const skd::Vector3 middle = 1.0 / 3.0 * (points[ids[0]] + points[ids[1]] + points[ids[2]]);
    const bool isInFront = isInside(middle + step);
    const bool isBehind = isInside(middle - step);
    if (isInFront != isBehind && isInFront != isTurned[largest])
    {
      for (const std::size_t i : piece)
      {
        isTurned[i] = !isTurned[i];
      }
    }
  }
  return isTurned;
}
