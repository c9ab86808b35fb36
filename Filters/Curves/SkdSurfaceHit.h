// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSurfaceHit_h
#define SkdSurfaceHit_h

#include "Core/Curves/IntersectionKind.h"
#include "Core/Geometry/Vector.h"

#include <cstddef>

namespace skdtree
{
/// An intersection of a piece of a curve and an element.
struct SkdSurfaceHit
{
  std::size_t Curve;
  std::size_t Piece;
  double U; ///< number of the piece within its curve, and T: what hits are ordered by
  double T; ///< on the piece
  std::size_t Element;
  double R;
  double S;
  skd::Vector3 X;
  skd::Vector3 Tangent; ///< of the curve, of any length
  skd::Vector3 Normal;  ///< of the surface, of any length
  double Gap;
  double Slack; ///< what U may be off by
  double Error; ///< and X
  skd::IntersectionKind Kind;
  int Passes;    ///< exact: sums over all pieces at a point decide whether the curve passes through
  int Direction; ///< 1 along the normal, -1 against it, 0 along the surface
  int Before;    ///< the side on which the curve comes, 1 where the normal points to, and on which
  int After;     ///< it goes; 0 where its piece ends, or where exact signs decide
  bool IsExact;
  bool Begins;
  bool OnBoundary;
  bool Closes; ///< was at the end of a closed curve, and is where it began
};

/// An intersection of a curve and a surface, for any number of pieces and elements that meet there.
struct SkdSurfaceIntersection
{
  SkdSurfaceHit Hit; ///< of those that meet there the one of the lowest (block, cell id)
  int Sense;         ///< 1: the curve goes in, against the normal; -1: out; 0: neither
  int Before;        ///< as of the hit, of all that meet there; 0 also where they do not agree
  int After;
};
}

#endif
