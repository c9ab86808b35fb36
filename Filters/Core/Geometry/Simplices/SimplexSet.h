// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points, segments or triangles, or the solid that triangles enclose: the representation of a
/// cell, box or line in tests of spatial relations. Its distances are in SimplexDistance.h, boxes
/// of some of its simplices in SimplexGroups.h; whether two sets meet is in SimplexContact.h,
/// points that they share or do not are found in SimplexWitness.h, what covers what in
/// SimplexCover.h, what insides share in SimplexInteriors.h.
///
/// Sets are closed: boundaries belong to them. The inside of a solid is determined by the parity of
/// exact crossings, so its triangles may be oriented either way. Coordinates must be finite.
#ifndef skd_Geometry_Simplices_SimplexSet_h
#define skd_Geometry_Simplices_SimplexSet_h

#include "../Box.h"
#include "../Segment.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace skd
{

struct SimplexSet
{
  /// The numbers of three points; a segment is { a, b, b }, a point { a, a, a }.
  using Simplex = std::array<int, 3>;
  using Edge = std::array<int, 2>;

  int Dimension = 0;     ///< 0 points, 1 segments, 2 triangles, 3 what triangles enclose
  bool IsConvex = false; ///< true only if known; makes some questions cheaper
  std::vector<Vector3> Points;
  std::vector<Simplex> Simplices;
  std::vector<Edge> Rim; ///< where a surface ends, its edges; where a curve ends, points { a, a }
  Box3 Bounds;           ///< of the points

  /// Makes it empty; memory is kept.
  void Clear(int dimension)
  {
    this->Dimension = dimension;
    this->IsConvex = false;
    this->Points.clear();
    this->Simplices.clear();
    this->Rim.clear();
    this->Bounds = Box3();
  }

  /// Returns the number of the point.
  int Add(const Vector3& x)
  {
    this->Points.push_back(x);
    this->Bounds.Add(x);
    return static_cast<int>(this->Points.size()) - 1;
  }

  void AddSimplex(int a, int b, int c) { this->Simplices.push_back({ a, b, c }); }

  /// When all is there: the rim is what an odd number of simplices has. Computed at the first use.
  void FindRim()
  {
    this->Rim.clear();
    if (this->Dimension < 1 || this->Dimension > 2)
    {
      return;
    }
    std::map<Edge, int> uses;
    for (const Simplex& simplex : this->Simplices)
    {
      if (this->Dimension == 1)
      {
        ++uses[{ simplex[0], simplex[0] }];
        ++uses[{ simplex[1], simplex[1] }];
        continue;
      }
      for (int i = 0; i < 3; ++i)
      {
        const int a = simplex[i];
        const int b = simplex[(i + 1) % 3];
        ++uses[{ std::min(a, b), std::max(a, b) }];
      }
    }
    for (const auto& [edge, count] : uses)
    {
      if (count % 2 == 1)
      {
        this->Rim.push_back(edge);
      }
    }
  }

  std::array<Vector3, 3> Corners(const Simplex& simplex) const
  {
    return { this->Points[simplex[0]], this->Points[simplex[1]], this->Points[simplex[2]] };
  }

  /// The edges of a simplex, none of a point, of a segment one: visit(segment).
  template <class Visit>
  void ForEachEdge(const Simplex& simplex, Visit visit) const
  {
    const int edges = this->Dimension == 0 ? 0 : (this->Dimension == 1 ? 1 : 3);
    for (int i = 0; i < edges; ++i)
    {
      visit(Segment<3>{ this->Points[simplex[i]], this->Points[simplex[(i + 1) % 3]] });
    }
  }
};

/// The box as a solid, with its corners moved by `transform`; a flat one is a rectangle, a segment
/// or a point. A box is convex, if `transform` is affine.
template <class Transform>
SimplexSet MakeBox(const Box3& box, const Transform& transform)
{
  SimplexSet set;
  int axes[3];
  int dimension = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.Max[axis] > box.Min[axis])
    {
      axes[dimension++] = axis;
    }
  }
  set.Clear(dimension);
  set.IsConvex = true;
  for (int corner = 0; corner < 1 << dimension; ++corner)
  {
    Vector3 x = box.Min;
    for (int i = 0; i < dimension; ++i)
    {
      x[axes[i]] = corner >> i & 1 ? box.Max[axes[i]] : box.Min[axes[i]];
    }
    set.Add(transform(x));
  }
  const auto addRectangle = [&set](int a, int b, int c, int d)
  {
    set.AddSimplex(a, b, c);
    set.AddSimplex(a, c, d);
  };
  if (dimension < 2)
  {
    set.AddSimplex(0, dimension, dimension);
  }
  else if (dimension == 2)
  {
    addRectangle(0, 1, 3, 2);
  }
  else
  {
    static constexpr int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
      { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    for (const auto& face : faces)
    {
      addRectangle(face[0], face[1], face[2], face[3]);
    }
  }
  set.FindRim();
  return set;
}

inline SimplexSet MakeBox(const Box3& box)
{
  return MakeBox(box, [](const Vector3& x) { return x; });
}

inline SimplexSet MakeSegment(const Segment<3>& segment)
{
  SimplexSet set;
  const bool isPoint = segment.A == segment.B;
  set.Clear(isPoint ? 0 : 1);
  set.IsConvex = true;
  set.Add(segment.A);
  set.AddSimplex(0, isPoint ? 0 : set.Add(segment.B), isPoint ? 0 : 1);
  set.FindRim();
  return set;
}

}

#endif
