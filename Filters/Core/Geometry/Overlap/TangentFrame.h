// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_TangentFrame_h
#define skd_Geometry_Overlap_TangentFrame_h

#include "PlanarOverlap.h"
#include "SphericalFrame.h"

namespace skd
{

/// A plane anywhere in space: what is not in it is seen along its normal. Counter-clockwise is as
/// seen from where the normal points.
struct TangentFrame
{
  Vector3 Origin;
  SphericalFrame Axes; // of the normal

  /// The normal is a unit vector.
  TangentFrame(const Vector3& origin, const Vector3& normal)
    : Origin(origin)
    , Axes(normal)
  {
  }

  const Vector3& GetNormal() const { return this->Axes.Origin; }
  double HeightOf(const Vector3& x) const { return Dot(x - this->Origin, this->GetNormal()); }

  Vector3 Projected(const Vector3& x) const
  {
    const Vector3 offset = x - this->Origin;
    return { { Dot(offset, this->Axes.E1), Dot(offset, this->Axes.E2), 1.0 } };
  }
  Vector3 FromFrame(const Vector<2>& x) const
  {
    return this->Origin + (x[0] * this->Axes.E1 + x[1] * this->Axes.E2);
  }

  /// About the origin, in the axes of the world.
  skd::Moments Moments(const ConvexPolygon& polygon) const
  {
    skd::Moments moments = PlanarMoments(polygon);
    moments.First = this->Axes.Rotated(moments.First);
    return moments;
  }
};

}

#endif
