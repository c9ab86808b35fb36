// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of a triangle, and where two triangles touch by these: what TriangleContact.h finds.
#ifndef skd_Geometry_Intersection_TriangleFeature_h
#define skd_Geometry_Intersection_TriangleFeature_h

#include <array>
#include <cstdint>

namespace skd
{

/// A part of a triangle: corner 0 to 2, edge 3 + i from corner i to the next, or its inside.
using TriangleFeature = std::int8_t;
constexpr TriangleFeature TriangleInside = 6;

inline bool IsCorner(TriangleFeature feature)
{
  return feature < 3;
}
inline bool IsEdge(TriangleFeature feature)
{
  return feature >= 3 && feature < TriangleInside;
}

/// The edges of a triangle that a part of it lies on, a bit each.
inline unsigned EdgesAt(TriangleFeature feature)
{
  if (IsCorner(feature))
  {
    return (1u << feature) | (1u << (feature == 0 ? 2 : feature - 1));
  }
  return IsEdge(feature) ? 1u << (feature - 3) : 0u;
}

/// A point where two triangles touch: the least part of each that it lies on.
struct ContactPoint
{
  TriangleFeature First;
  TriangleFeature Second;
};

/// What two triangles have in common: nothing, a point, a segment, or when they lie in one plane a
/// convex polygon, by its corners. The corners of a polygon are given around it.
struct TriangleContact
{
  std::array<ContactPoint, 6> Points;
  int Count = 0;
  bool IsFlat = false; ///< both lie in one plane

  void Add(TriangleFeature first, TriangleFeature second)
  {
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Points[i].First == first && this->Points[i].Second == second)
      {
        return;
      }
    }
    this->Points[this->Count++] = { first, second };
  }
};

}

#endif
