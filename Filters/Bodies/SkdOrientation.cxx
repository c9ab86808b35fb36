// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdOrientation.h"

#include "Bodies/SkdEdgeTable.h"
#include "Core/Geometry/Rows.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace skdtree
{
namespace
{
struct Neighbour
{
  std::size_t Triangle;
  bool IsAlike; // both have their normals on the same side of the surface
};

/// The triangles across those edges that have exactly two.
skd::Rows<Neighbour> NeighboursOf(
  const std::vector<SkdTriangleIds>& triangles, std::size_t numberOfPoints)
{
  using Use = skd::EdgeUse<vtkIdType>;
  const auto edges = SkdMakeEdgeTable(triangles, numberOfPoints);
  return { triangles.size(),
    [&edges](const auto& add)
    {
      edges.ForEach(
        [&add](vtkIdType, const Use* first, const Use* last)
        {
          if (last - first == 2)
          {
            const bool isAlike = first[0].IsForward != first[1].IsForward;
            add(first[0].Triangle, Neighbour{ first[1].Triangle, isAlike });
            add(first[1].Triangle, Neighbour{ first[0].Triangle, isAlike });
          }
        });
    } };
}

/// All triangles that are connected to the first, oriented like it.
std::vector<std::size_t> OrientAlike(std::size_t first, const skd::Rows<Neighbour>& neighbours,
  std::vector<bool>& isReversed, std::vector<bool>& isVisited)
{
  std::vector<std::size_t> piece{ first };
  isVisited[first] = true;
  for (std::size_t next = 0; next < piece.size(); ++next)
  {
    for (const Neighbour& other : neighbours[piece[next]])
    {
      if (!isVisited[other.Triangle])
      {
        isVisited[other.Triangle] = true;
        isReversed[other.Triangle] = isReversed[piece[next]] == other.IsAlike;
        piece.push_back(other.Triangle);
      }
    }
  }
  return piece;
}

// Distances from a triangle's centre at which both sides are tested, relative to its size: the
// first is far above rounding error and far below other distances, the last is for thin walls.
constexpr double FirstStep = 1e-5;
constexpr double LastStep = 1e-13;
constexpr double NextStep = 1e-2;

skd::Vector3 AcrossOf(const std::vector<skd::Vector3>& points, const SkdTriangleIds& ids)
{
  return skd::Cross(points[ids[1]] - points[ids[0]], points[ids[2]] - points[ids[0]]);
}

/// Whether the inside is in front of a triangle; nothing if it is on both sides or on neither.
std::optional<bool> IsInsideInFront(const std::vector<skd::Vector3>& points,
  const SkdTriangleIds& ids, const std::function<bool(const skd::Vector3&)>& isInside)
{
  const skd::Vector3 across = AcrossOf(points, ids);
  const double size = std::sqrt(skd::Norm(across));
  const skd::Vector3 middle = 1.0 / 3.0 * (points[ids[0]] + points[ids[1]] + points[ids[2]]);
  for (double step = FirstStep; size > 0.0 && step >= LastStep; step *= NextStep)
  {
    const skd::Vector3 aside = (step / size) * across;
    const bool isInFront = isInside(middle + aside);
    if (isInFront != isInside(middle - aside))
    {
      return isInFront;
    }
  }
  return std::nullopt;
}
}

std::vector<bool> SkdFindReversed(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles,
  const std::function<bool(const skd::Vector3&)>& isInside)
{
  const skd::Rows<Neighbour> neighbours = NeighboursOf(triangles, points.size());
  std::vector<bool> isReversed(triangles.size(), false);
  std::vector<bool> isVisited(triangles.size(), false);
  const auto area2 = [&](std::size_t i) { return skd::Norm2(AcrossOf(points, triangles[i])); };
  for (std::size_t first = 0; first < triangles.size(); ++first)
  {
    if (isVisited[first])
    {
      continue;
    }
    const std::vector<std::size_t> piece = OrientAlike(first, neighbours, isReversed, isVisited);
    const std::size_t largest = *std::max_element(piece.begin(), piece.end(),
      [&](std::size_t a, std::size_t b) { return area2(a) < area2(b); });
    const std::optional<bool> isInFront = IsInsideInFront(points, triangles[largest], isInside);
    if (isInFront && *isInFront != isReversed[largest])
    {
      for (const std::size_t i : piece)
      {
        isReversed[i] = !isReversed[i];
      }
    }
  }
  return isReversed;
}
}
