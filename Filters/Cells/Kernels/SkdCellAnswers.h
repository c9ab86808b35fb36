// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellAnswers_h
#define SkdCellAnswers_h

#include "Core/Geometry/Vector.h"

namespace skdtree
{
/// The point of a cell nearest to a query point.
struct SkdCellPoint
{
  skd::Vector3 Point;
  skd::Vector3 PCoords;
  double Dist2;
  int SubId = 0;
  bool ProjectsInside = false; ///< the query point projects into the cell's interior, or is in it
};

/// A hit of a segment and a cell.
struct SkdLineHit
{
  double T;
  skd::Vector3 PCoords;
  int SubId = 0;
};

/// The distance up to which a segment hits a cell.
struct SkdHitTolerance
{
  double Tolerance; ///< the caller's, of surfaces
  double Rounding;  ///< what rounding alone makes of coordinates: lines and points need it
  double OfLines() const
  {
    return this->Tolerance > this->Rounding ? this->Tolerance : this->Rounding;
  }
};
}

#endif
