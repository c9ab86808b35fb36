// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Polygons_EarClipping_h
#define skd_Geometry_Polygons_EarClipping_h

#include "PolygonPlane.h"

#include <vector>

namespace skd
{

/// Cuts a polygon that is taken for flat (PlanarPolygon.h), and may be concave, into triangles of
/// its own corners: ears are clipped one after the other. Signs are exact, seen along the axis that
/// the polygon is largest along. One that crosses itself is cut somehow. O(n^3) at worst, O(n^2) of
/// convex ones.
template <class Points>
class EarClipping
{
public:
  EarClipping(const Points& points, int size)
    : Corners(points)
    , Left(static_cast<std::size_t>(size))
  {
    const PolygonPlane plane(points, size);
    const int axis = plane.DominantAxis();
    this->AxisX = (axis + 1) % 3;
    this->AxisY = (axis + 2) % 3;
    this->Orientation = plane.Normal[axis] < 0.0 ? -1 : 1;
    for (int i = 0; i < size; ++i)
    {
      this->Left[static_cast<std::size_t>(i)] = i;
    }
  }

  /// Calls visit(a, b, c) with the numbers of the corners of each triangle, size - 2 times.
  template <class Visit>
  void ForEachTriangle(Visit visit)
  {
    while (this->Left.size() >= 3)
    {
      const std::size_t ear = this->FindEar();
      visit(this->At(ear + this->Left.size() - 1), this->At(ear), this->At(ear + 1));
      this->Left.erase(this->Left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
  }

private:
  int At(std::size_t index) const { return this->Left[index % this->Left.size()]; }

  int Side(int a, int b, int c) const
  {
    const Vector3 u = this->Corners[b] - this->Corners[a];
    const Vector3 v = this->Corners[c] - this->Corners[a];
    return this->Orientation *
      SignOfDifference(u[this->AxisX], v[this->AxisY], u[this->AxisY], v[this->AxisX]);
  }

  std::size_t FindEar() const
  {
    std::size_t flat = this->Left.size();
    for (std::size_t i = 0; i < this->Left.size(); ++i)
    {
      const int a = this->At(i + this->Left.size() - 1);
      const int b = this->At(i);
      const int c = this->At(i + 1);
      const int side = this->Side(a, b, c);
      if (side > 0 && this->IsFree(a, b, c))
      {
        return i;
      }
      flat = side == 0 ? i : flat;
    }
    return flat < this->Left.size() ? flat : 0;
  }

  /// Whether no other corner is in the triangle. Those at the position of one of its corners do not
  /// count: polygons may touch themselves.
  bool IsFree(int a, int b, int c) const
  {
    for (const int x : this->Left)
    {
      const bool isCorner = this->Corners[x] == this->Corners[a] ||
        this->Corners[x] == this->Corners[b] || this->Corners[x] == this->Corners[c];
      if (!isCorner && this->Side(a, b, x) >= 0 && this->Side(b, c, x) >= 0 &&
        this->Side(c, a, x) >= 0)
      {
        return false;
      }
    }
    return true;
  }

  const Points& Corners;
  std::vector<int> Left;
  int AxisX;
  int AxisY;
  int Orientation;
};

}

#endif
