// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances of simplex sets from points and from each other, and what is inside a solid.
#ifndef skd_Geometry_Simplices_SimplexDistance_h
#define skd_Geometry_Simplices_SimplexDistance_h

#include "../Cells/Polyhedron.h"
#include "../Distance/ClosestTriangles.h"
#include "../Distance/Distance.h"
#include "SimplexSet.h"

#include <array>
#include <limits>
#include <optional>

namespace skd
{

/// The distance to the simplices: of a solid to its boundary.
inline double SimplexDistance2(const SimplexSet& set, const Vector3& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SimplexSet::Simplex& simplex : set.Simplices)
  {
    const Vector3* p = set.Points.data();
    least =
      std::min(least, ClosestPointOnTriangle(p[simplex[0]], p[simplex[1]], p[simplex[2]], x).Dist2);
  }
  return least;
}

inline double RimDistance2(const SimplexSet& set, const Vector3& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SimplexSet::Edge& edge : set.Rim)
  {
    least =
      std::min(least, ClosestPointOnSegment(set.Points[edge[0]], set.Points[edge[1]], x).Dist2);
  }
  return least;
}

/// Whether x is inside a solid or on a face of it. On its edges either may be the answer.
inline bool Encloses(const SimplexSet& set, const Vector3& x)
{
  if (set.Dimension < 3 || !set.Bounds.Contains(x))
  {
    return false;
  }
  const SegmentView view(detail::SegmentOutOf(set.Bounds, x));
  bool isInside = false;
  for (const SimplexSet::Simplex& simplex : set.Simplices)
  {
    const Vector3* p = set.Points.data();
    const auto hit =
      view.IsValid() ? Intersect(view, p[simplex[0]], p[simplex[1]], p[simplex[2]]) : std::nullopt;
    if (hit && hit->T == 0.0)
    {
      return true;
    }
    isInside ^= hit && hit->Passes;
  }
  return isInside;
}

inline double MinDistance2(const SimplexSet& set, const Vector3& x)
{
  return Encloses(set, x) ? 0.0 : SimplexDistance2(set, x);
}

inline double MaxDistance2(const SimplexSet& set, const Vector3& x)
{
  double most = 0.0;
  for (const Vector3& point : set.Points)
  {
    most = std::max(most, Distance2(point, x));
  }
  return most;
}

/// Between the farthest points of two sets: of corners, whatever they are corners of.
inline double MaxDistance2(const SimplexSet& a, const SimplexSet& b)
{
  double most = 0.0;
  for (const Vector3& x : b.Points)
  {
    most = MaxDistance2(x, a.Bounds) > most ? std::max(most, MaxDistance2(a, x)) : most;
  }
  return most;
}

namespace detail
{

using Triangle3 = std::array<Vector3, 3>;

inline Box3 BoundsOf(const Triangle3& corners)
{
  Box3 bounds(corners[0], corners[0]);
  bounds.Add(corners[1]);
  bounds.Add(corners[2]);
  return bounds;
}

/// Whether an edge of the first goes through the second.
inline bool Pierces(const Triangle3& first, const Triangle3& second)
{
  for (int i = 0; i < 3; ++i)
  {
    const SegmentView view(Segment<3>{ first[i], first[(i + 1) % 3] });
    if (view.IsValid() && Intersect(view, second[0], second[1], second[2]))
    {
      return true;
    }
  }
  return false;
}

inline double SimplexDistance2(const Triangle3& a, const Triangle3& b)
{
  const bool mayCross = BoundsOf(a).Overlaps(BoundsOf(b));
  if (mayCross && (Pierces(a, b) || Pierces(b, a)))
  {
    return 0.0;
  }
  return ClosestPoints(a, b).Dist2;
}

/// Of sets whose boundaries do not meet one is within the other if any point of it is; points alone
/// may be here and there.
inline bool HasPointWithin(const SimplexSet& solid, const SimplexSet& set)
{
  const std::size_t numberOfPoints = set.Dimension == 0 ? set.Points.size() : 1;
  for (std::size_t i = 0; i < std::min(numberOfPoints, set.Points.size()); ++i)
  {
    if (Encloses(solid, set.Points[i]))
    {
      return true;
    }
  }
  return false;
}

}

/// Between the nearest points of two sets, 0 when they have one in common. What is not more than
/// `enough2` need not be least. O(simplices of a x simplices of b) at worst.
inline double MinDistance2(const SimplexSet& a, const SimplexSet& b, double enough2 = 0.0)
{
  if (detail::HasPointWithin(a, b) || detail::HasPointWithin(b, a))
  {
    return 0.0;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const SimplexSet::Simplex& one : a.Simplices)
  {
    const detail::Triangle3 first = a.Corners(one);
    const Box3 bounds = detail::BoundsOf(first);
    if (!(MinDistance2(bounds, b.Bounds) < least))
    {
      continue;
    }
    for (const SimplexSet::Simplex& other : b.Simplices)
    {
      const detail::Triangle3 second = b.Corners(other);
      if (MinDistance2(bounds, detail::BoundsOf(second)) < least)
      {
        least = std::min(least, detail::SimplexDistance2(first, second));
      }
    }
    if (least <= enough2)
    {
      return least;
    }
  }
  return least;
}

}

#endif
