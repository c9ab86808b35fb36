// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_ParameterDomain_h
#define skd_Geometry_Cells_ParameterDomain_h

#include "Core/Geometry/Vector.h"

namespace skd
{

/// The points p with Normal . p <= Offset.
struct DomainSide
{
  Vector3 Normal;
  double Offset;
};

/// What parametric coordinates may be: a polytope in the first `Dimension` coordinates. The others
/// are 0.
struct ParameterDomain
{
  int Dimension;
  int Size;
  DomainSide Sides[6];
};

// Each is [0, 1] in every coordinate, cut where a sum may not exceed 1.
inline constexpr DomainSide AtLeast0[3] = { { { { -1.0, 0.0, 0.0 } }, 0.0 },
  { { { 0.0, -1.0, 0.0 } }, 0.0 }, { { { 0.0, 0.0, -1.0 } }, 0.0 } };
inline constexpr DomainSide AtMost1[3] = { { { { 1.0, 0.0, 0.0 } }, 1.0 },
  { { { 0.0, 1.0, 0.0 } }, 1.0 }, { { { 0.0, 0.0, 1.0 } }, 1.0 } };
inline constexpr DomainSide SumOf2AtMost1 = { { { 1.0, 1.0, 0.0 } }, 1.0 };
inline constexpr DomainSide SumOf3AtMost1 = { { { 1.0, 1.0, 1.0 } }, 1.0 };

inline constexpr ParameterDomain UnitSegment = { 1, 2, { AtLeast0[0], AtMost1[0] } };
inline constexpr ParameterDomain UnitSquare = { 2, 4,
  { AtLeast0[0], AtMost1[0], AtLeast0[1], AtMost1[1] } };
inline constexpr ParameterDomain UnitTriangle = { 2, 3,
  { AtLeast0[0], AtLeast0[1], SumOf2AtMost1 } };
inline constexpr ParameterDomain UnitCube = { 3, 6,
  { AtLeast0[0], AtMost1[0], AtLeast0[1], AtMost1[1], AtLeast0[2], AtMost1[2] } };
inline constexpr ParameterDomain UnitTetrahedron = { 3, 4,
  { AtLeast0[0], AtLeast0[1], AtLeast0[2], SumOf3AtMost1 } };
inline constexpr ParameterDomain UnitPrism = { 3, 5,
  { AtLeast0[0], AtLeast0[1], SumOf2AtMost1, AtLeast0[2], AtMost1[2] } };

/// How far inside a side p is; negative outside.
inline double Slack(const DomainSide& side, const Vector3& p)
{
  return side.Offset - Dot(side.Normal, p);
}

/// Whether p is in the domain and on none of its sides.
inline bool IsInterior(const ParameterDomain& domain, const Vector3& p)
{
  for (int i = 0; i < domain.Size; ++i)
  {
    if (!(Slack(domain.Sides[i], p) > 0.0))
    {
      return false;
    }
  }
  return true;
}

/// Takes back what rounding put outside.
inline Vector3 Clamped(const ParameterDomain& domain, Vector3 p)
{
  for (int i = 0; i < domain.Size; ++i)
  {
    const DomainSide& side = domain.Sides[i];
    const double slack = Slack(side, p);
    if (slack < 0.0)
    {
      p = p + (slack / Norm2(side.Normal)) * side.Normal;
    }
  }
  return p;
}

}

#endif
