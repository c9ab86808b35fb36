// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurveHit_h
#define SkdCurveHit_h

#include "Core/Curves/IntersectionKind.h"
#include "Core/Geometry/Vector.h"

#include <cstddef>

namespace skdtree
{
/// A location on a curve.
struct SkdCurveLocation
{
  std::size_t Curve;
  std::size_t Piece;
  double T;        ///< on the piece
  double U;        ///< number of the piece within its curve, and T
  double Slack;    ///< what U may be off by
  double Rounding; ///< the same of a location that is known exactly
  double Period;   ///< of a closed curve the number of its pieces, or 0
  skd::Vector3 X;
  skd::Vector3 Tangent; ///< of any length
  bool IsAtEnd;         ///< of an open curve, to within `Slack`
  bool IsExactlyAtEnd;  ///< the same to within `Rounding`
  std::size_t Joint;    ///< where another curve goes on there: see SkdCurveJoints
};

/// An intersection of two curves, or their nearest approach.
struct SkdCurveHit
{
  SkdCurveLocation First;
  SkdCurveLocation Second;
  double Gap;
  double Error; ///< what the position may be off by
  skd::IntersectionKind Kind;
  bool Begins;     ///< of an OverlapEnd
  bool IsExact;    ///< of two straight pieces that have it in common by exact signs
  bool IsResolved; ///< not simple
  /// For an intersection that is not simple: the vector from the other curve to this one before and
  /// after it; 0 at an end of a piece, or if it is undefined.
  skd::Vector3 Before;
  skd::Vector3 After;
};

/// An interval that two curves have in common, along the first.
struct SkdCurveInterval
{
  SkdCurveHit Begin;
  SkdCurveHit End;
};
}

#endif
