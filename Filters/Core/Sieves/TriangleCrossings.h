// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Sieves_TriangleCrossings_h
#define skd_Sieves_TriangleCrossings_h

#include "../Geometry/Segment.h"
#include "TrianglePack.h"

namespace skd
{

/// A line as packs see it: sheared to run along an axis, as in SegmentTriangle.h, in the tree's
/// frame.
class TriangleCrossings
{
public:
  TriangleCrossings() = default;

  /// The segment must not be much longer than the tree is wide, or rounding counts for too little.
  /// `margin`: by how much triangles may be missed, in the frame.
  TriangleCrossings(const Segment<3>& local, double margin)
    : Origin(local.A)
    , Margin(margin)
  {
    const Vector3 direction = local.B - local.A;
    this->Z = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      this->Z = std::abs(direction[axis]) > std::abs(direction[this->Z]) ? axis : this->Z;
    }
    this->X = (this->Z + 1) % 3;
    this->Y = (this->Z + 2) % 3;
    this->SlopeX = direction[this->X] / direction[this->Z];
    this->SlopeY = direction[this->Y] / direction[this->Z];
  }

  /// Bit i: the line may meet the triangle of lane i.
  SKD_IN_ONE_PIECE unsigned MayMeet(const TrianglePack& pack) const
  {
    const Vector3 origin = pack.Raster.Of(this->Origin);
    const double x = origin[this->X] - this->SlopeX * origin[this->Z];
    const double y = origin[this->Y] - this->SlopeY * origin[this->Z];
    // A corner's error in the plane across the line, and what that does to products of two corners.
    const double reach = 2.0 * Raster::Reach + std::max(std::abs(x), std::abs(y));
    const double error =
      2.0 * (Raster::CornerError + this->Margin / pack.Raster.Unit) + 1e-6 * reach;
    const double slack = 4.0 * error * reach + 2.0 * error * error + 1e-6 * reach * reach;
    unsigned met = 0;
    for (int first = 0; first < TrianglePack::Width; first += NativeWidth)
    {
      met |= this->Test<NativeWidth>(
               pack, static_cast<float>(x), static_cast<float>(y), static_cast<float>(slack), first)
        << first;
    }
    return met;
  }

private:
  template <int W>
  struct Across
  {
    Lanes<W> X;
    Lanes<W> Y;
  };

  template <int W>
  Across<W> See(const TrianglePack& pack, int corner, float x, float y, int first) const
  {
    using L = Lanes<W>;
    const L z = pack.Load<W>(corner, this->Z, first);
    return { pack.Load<W>(corner, this->X, first) - L(static_cast<float>(this->SlopeX)) * z - L(x),
      pack.Load<W>(corner, this->Y, first) - L(static_cast<float>(this->SlopeY)) * z - L(y) };
  }

  template <int W>
  unsigned Test(const TrianglePack& pack, float x, float y, float slack, int first) const
  {
    using L = Lanes<W>;
    const Across<W> a = this->See<W>(pack, 0, x, y, first);
    const Across<W> b = this->See<W>(pack, 1, x, y, first);
    const Across<W> c = this->See<W>(pack, 2, x, y, first);
    const L u = b.X * c.Y - b.Y * c.X;
    const L v = c.X * a.Y - c.Y * a.X;
    const L w = a.X * b.Y - a.Y * b.X;
    const L least = Min(Min(u, v), w);
    const L most = Max(Max(u, v), w);
    return LessEqual(L(-slack), least) | LessEqual(most, L(slack));
  }

  Vector3 Origin;
  double Margin;
  int X;
  int Y;
  int Z;
  double SlopeX;
  double SlopeY;
};

}

#endif
