// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurveHit_h
#define SkdCurveHit_h

#include "Core/Curves/Meeting.h"
#include "Core/Geometry/Vector.h"

#include <cstddef>

/// A place on a curve.
struct SkdCurvePlace
{
  std::size_t Curve;
  std::size_t Piece;
  double T;     ///< on the piece
  double U;     ///< number of the piece within its curve, and T
  double Slack; ///< what U may be off by
  skd::Vector3 X;
  skd::Vector3 Tangent; ///< of any length
};

/// A place that two curves have in common, or where they are nearest.
struct SkdCurveHit
{
  SkdCurvePlace First;
  SkdCurvePlace Second;
  double Gap;
  double Reach; ///< what the place may be off by
  skd::MeetingKind Kind;
  bool Begins; ///< of an OverlapEnd
};

/// A stretch that two curves have in common, along the first.
struct SkdCurveStretch
{
  SkdCurveHit Begin;
  SkdCurveHit End;
};

#endif
