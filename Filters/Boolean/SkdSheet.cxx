// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Boolean/SkdSheet.h"

#include "Core/Geometry/Distance/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr unsigned InFront = 1;
constexpr unsigned Behind = 2;

/// The sides of the sheet that each region is at.
std::vector<unsigned> FindSides(const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t sheet)
{
  std::vector<unsigned> sides(arrangement.NumberOfRegions, 0);
  for (std::uint32_t facet = 0; facet < arrangement.Facets.GetNumberOfFacets(); ++facet)
  {
    arrangement.Facets.ForEachLayer(facet,
      [&](std::uint32_t parent, int sign)
      {
        if (surfaceOf[parent] == sheet)
        {
          sides[arrangement.GetFront(facet)] |= sign > 0 ? InFront : Behind;
          sides[arrangement.GetBack(facet)] |= sign > 0 ? Behind : InFront;
        }
      });
  }
  return sides;
}

/// A point at each region: the centroid of its first facet.
std::vector<skd::Vector3> FindPoints(
  const SkdPlacedTriangles& set, const SkdArrangement& arrangement)
{
  std::vector<skd::Vector3> points(arrangement.NumberOfRegions);
  for (std::size_t facet = arrangement.Facets.GetNumberOfFacets(); facet-- > 0;)
  {
    const auto corners = arrangement.Facets.GetPositions(set, static_cast<std::uint32_t>(facet));
    const skd::Vector3 centroid = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
    points[arrangement.GetFront(static_cast<std::uint32_t>(facet))] = centroid;
    points[arrangement.GetBack(static_cast<std::uint32_t>(facet))] = centroid;
  }
  return points;
}

/// The side of the sheet's nearest triangle that a point is at; of several that are as near, as at
/// a common edge, that of the one that faces the point most. O(n).
unsigned FindNearestSide(
  const SkdPlacedTriangles& set, const std::vector<std::uint32_t>& triangles, const skd::Vector3& x)
{
  constexpr double same = 1.0 + 1e-12; // of squared distances
  double nearest2 = std::numeric_limits<double>::infinity();
  double facing = 0.0;
  for (const std::uint32_t triangle : triangles)
  {
    const auto corners = set.GetCornerPoints(triangle);
    const auto [point, r, s, dist2] =
      skd::ClosestPointOnTriangle(corners[0], corners[1], corners[2], x);
    const skd::Vector3 normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = Norm(normal);
    if (dist2 > same * nearest2 || length == 0.0)
    {
      continue;
    }
    const double height = Dot(normal, x - point) / length;
    if (same * dist2 < nearest2 || std::abs(height) > std::abs(facing))
    {
      facing = height;
    }
    nearest2 = std::min(nearest2, dist2);
  }
  return facing < 0.0 ? Behind : InFront;
}

std::vector<std::uint32_t> TrianglesOf(
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t surface)
{
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t triangle = 0; triangle < surfaceOf.size(); ++triangle)
  {
    if (surfaceOf[triangle] == surface)
    {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}
}

vtkIdType SkdPlaceSheet(const SkdPlacedTriangles& set, const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t sheet,
  std::vector<SkdRegionWindings>& windings)
{
  std::vector<unsigned> sides = FindSides(arrangement, surfaceOf, sheet);
  const std::vector<skd::Vector3> points = FindPoints(set, arrangement);
  const std::vector<std::uint32_t> triangles = TrianglesOf(surfaceOf, sheet);
  vtkIdType undivided = 0;
  for (std::uint32_t region = 0; region < windings.size(); ++region)
  {
    SkdRegionWindings& of = windings[region];
    of.erase(std::remove_if(of.begin(), of.end(),
               [&](const SkdWindingOf& winding) { return winding.Surface == sheet; }),
      of.end());
    if (of.empty())
    {
      continue; // outside
    }
    if (sides[region] == 0)
    {
      sides[region] = FindNearestSide(set, triangles, points[region]);
    }
    undivided += sides[region] == (InFront | Behind);
    if (sides[region] == Behind)
    {
      of.push_back({ sheet, 1 });
    }
  }
  return undivided;
}
