// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_TriangleCrossings_h
#define skd_LeafFilters_TriangleCrossings_h

#include "../../Geometry/Intersection/SegmentTriangle.h"
#include "../Tree/Tolerances.h"
#include "TrianglePacket.h"

namespace skd
{

/// A line for tests with packets: sheared to run along an axis, as in SegmentTriangle.h, in the
/// tree's frame.
class TriangleCrossings
{
public:
  explicit TriangleCrossings(const Shear& shear)
    : TheShear(shear)
    , SlopeX(static_cast<float>(shear.SlopeX))
    , SlopeY(static_cast<float>(shear.SlopeY))
  {
  }

  /// `local`: a point of the line, in the frame, that is not much farther from the packets than the
  /// tree is wide, or rounding counts for too little. `margin`: by how much triangles may be
  /// missed, in the range of float.
  void Aim(const Vector3& local, double margin)
  {
    const Shear& shear = this->TheShear;
    this->X = local[shear.X] - shear.SlopeX * local[shear.Z];
    this->Y = local[shear.Y] - shear.SlopeY * local[shear.Z];
    constexpr double two = 2.0 + 1.0 / (1 << 22); // rounding does not make less than 2 of it
    this->TwoMargins = static_cast<float>(two * margin);
  }

  /// Bit i: the line may intersect the triangle of lane i.
  SKD_FLATTEN unsigned MayIntersect(const TrianglePacket& packet) const
  {
    const Shear& shear = this->TheShear;
    const float* centre = packet.Grid.Centre;
    const double z = centre[shear.Z];
    const float perUnit = 1.0f / packet.Grid.Unit;
    const float x = perUnit * static_cast<float>(this->X - (centre[shear.X] - shear.SlopeX * z));
    const float y = perUnit * static_cast<float>(this->Y - (centre[shear.Y] - shear.SlopeY * z));
    // A corner's error in the plane across the line, and what that does to products of two corners.
    // A line that meets any of the triangles is, but for the error, no farther away than corners.
    constexpr float extent = 4.0f * QuantizationGrid::Largest;
    // The last quarter is for the sums of products.
    constexpr float rounding = 2.0f * static_cast<float>(QuantizationGrid::CornerError) +
      1.25f * tolerances::CrossingSum * extent;
    const float error = rounding + this->TwoMargins * perUnit;
    const float slack = (error + error) * (extent + extent + error);
    const Rows rows{ { packet, shear.X }, { packet, shear.Y }, { packet, shear.Z } };
    unsigned met = 0;
    for (int first = 0; first < TrianglePacket::Width; first += NativeWidth)
    {
      met |= this->Test<NativeWidth>(rows, x, y, slack, first) << first;
    }
    return met;
  }

private:
  struct Rows
  {
    TrianglePacket::Row X;
    TrianglePacket::Row Y;
    TrianglePacket::Row Z;
  };

  template <int W>
  struct Across
  {
    Lanes<W> X;
    Lanes<W> Y;
  };

  template <int W>
  Across<W> See(const Rows& rows, int corner, float x, float y, int first) const
  {
    using L = Lanes<W>;
    const L z = rows.Z.Load<W>(corner, first);
    return { MinusProduct(rows.X.Load<W>(corner, first), L(this->SlopeX), z) - L(x),
      MinusProduct(rows.Y.Load<W>(corner, first), L(this->SlopeY), z) - L(y) };
  }

  template <int W>
  unsigned Test(const Rows& rows, float x, float y, float slack, int first) const
  {
    using L = Lanes<W>;
    const Across<W> a = this->See<W>(rows, 0, x, y, first);
    const Across<W> b = this->See<W>(rows, 1, x, y, first);
    const Across<W> c = this->See<W>(rows, 2, x, y, first);
    const L u = MinusProduct(b.X * c.Y, b.Y, c.X);
    const L v = MinusProduct(c.X * a.Y, c.Y, a.X);
    const L w = MinusProduct(a.X * b.Y, a.Y, b.X);
    const L least = Min(Min(u, v), w);
    const L most = Max(Max(u, v), w);
    return LessEqual(Min(L(0.0f) - least, most), L(slack));
  }

  Shear TheShear;
  float SlopeX;
  float SlopeY;
  double X = 0.0; ///< where the line meets the plane through the frame's centre, across axis Z
  double Y = 0.0;
  float TwoMargins = 0.0f;
};

}

#endif
