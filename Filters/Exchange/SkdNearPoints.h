// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNearPoints_h
#define SkdNearPoints_h

#include "Core/Geometry/Vector.h"
#include "Exchange/SkdPieceArrays.h"

#include <vector>

namespace skdtree
{
/// Where pieces meet, a source may compute the same point twice with different rounding, as VTK's
/// own sphere does. Given all different points of some pieces, and which of them each point of a
/// piece is, this makes those one that lie within 4 units in the last place of the largest
/// coordinate, at the precision of the pieces' points, and of which no piece has two. `keys` is
/// changed accordingly: to the lower number. O(n log n).
void SkdMergeNearPoints(const SkdPieces& pieces, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys);

/// The same of some of the points of the pieces, with the tolerance of all.
void SkdMergeNearPoints(double tolerance, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys);

/// Whether the points of a piece are stored in single precision.
bool SkdIsSingle(vtkDataSet* piece);

/// The largest magnitude of a coordinate of a piece's points, but of those that are not finite or
/// beyond SkdMeasurable. O(n).
double SkdLargestCoordinateOf(vtkDataSet* piece);

/// How near such points are to each other.
double SkdNearTolerance(bool isSingle, double largestCoordinate);
}

#endif
