// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Intersection_NeighbourTriangles_h
#define skd_Geometry_Intersection_NeighbourTriangles_h

#include "../Predicates/Orient3D.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace skd
{

/// Three corners, where they are stored. Masks of corners have a bit for each.
using CornerPointers = std::array<const Vector3*, 3>;

namespace detail
{

struct CornerPair
{
  std::uint8_t First;
  std::uint8_t Second;
};

/// Of each mask of corners two that are not in it, the same twice if there is only one.
inline constexpr CornerPair CornersOutside[8] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 2, 2 }, { 0, 1 },
  { 1, 1 }, { 0, 0 }, { 0, 0 } };

}

/// Whether the corners of a triangle but those shared (in the mask) with a plane's triangle are
/// surely on one side of the plane: if so, the triangles surely have nothing but these in common.
inline bool AreOthersOnOneSide(
  const FloatingPlane& plane, const CornerPointers& corners, unsigned shared)
{
  const detail::CornerPair others = detail::CornersOutside[shared];
  constexpr unsigned all = 7;
  const int side = plane.SureSideOfBoth(*corners[others.First], *corners[others.Second]);
  return side != 0 && shared != all && (shared != 0 || plane.SureSideOf(*corners[2]) == side);
}

namespace detail
{

/// The sign of an area seen along an axis, as Orient2D; 0 also where rounding could matter.
inline int SureOrient2D(const Vector3& a, const Vector3& b, const Vector3& c, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double left = (b[u] - a[u]) * (c[v] - a[v]);
  const double right = (b[v] - a[v]) * (c[u] - a[u]);
  const double rounding = Orient2DBound * (std::abs(left) + std::abs(right));
  return (left - right > rounding) - (left - right < -rounding);
}

/// Whether the line of an edge of the first triangle, seen along an axis, surely has the first one
/// on one side and the second on the other, but for shared corners at the edge.
inline bool IsBeyondAnEdge(const CornerPointers& first, unsigned sharedOfFirst,
  const CornerPointers& second, unsigned sharedOfSecond, int axis)
{
  const int inside = SureOrient2D(*first[0], *first[1], *first[2], axis);
  const auto isBeyond = [&](const Vector3& from, const Vector3& to)
  {
    bool areAll = inside != 0;
    for (unsigned k = 0; k < 3 && areAll; ++k)
    {
      areAll =
        (sharedOfSecond >> k & 1u) != 0 || SureOrient2D(from, to, *second[k], axis) == -inside;
    }
    return areAll;
  };
  constexpr unsigned edges[3] = { 3, 6, 5 }; // the corners of each
  return ((sharedOfFirst & ~edges[0]) == 0 && isBeyond(*first[0], *first[1])) ||
    ((sharedOfFirst & ~edges[1]) == 0 && isBeyond(*first[1], *first[2])) ||
    ((sharedOfFirst & ~edges[2]) == 0 && isBeyond(*first[2], *first[0]));
}

}

/// Whether two triangles, seen along an axis, are surely apart but for the corners that they share
/// (those in the masks): also if they lie in one plane, or would meet where one is continued.
inline bool AreApartAlong(int axis, const CornerPointers& first, unsigned sharedOfFirst,
  const CornerPointers& second, unsigned sharedOfSecond)
{
  return detail::IsBeyondAnEdge(first, sharedOfFirst, second, sharedOfSecond, axis) ||
    detail::IsBeyondAnEdge(second, sharedOfSecond, first, sharedOfFirst, axis);
}

/// Whether two triangles that share one or two corners (those in the masks) surely have nothing
/// else in common, since they are apart as seen from above, or the other corners of one are on one
/// side of the other's plane: true of most pairs of neighbours in a surface, and found in a
/// fraction of the time that FindContact() takes.
inline bool HaveOnlyCornersInCommon(const CornerPointers& first, unsigned sharedOfFirst,
  const CornerPointers& second, unsigned sharedOfSecond)
{
  const FloatingPlane plane(*first[0], *first[1], *first[2]);
  return AreApartAlong(plane.DominantAxis(), first, sharedOfFirst, second, sharedOfSecond) ||
    AreOthersOnOneSide(plane, second, sharedOfSecond) ||
    AreOthersOnOneSide({ *second[0], *second[1], *second[2] }, first, sharedOfFirst);
}

}

#endif
