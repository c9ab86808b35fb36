// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNearPoints_h
#define SkdNearPoints_h

#include "Core/Geometry/Vector.h"
#include "Exchange/SkdPieceArrays.h"

#include <vector>

namespace skdtree
{
/// Magnitudes of coordinates, of a point the largest of its three. Those that are not finite or
/// beyond SkdMeasurable do not count.
struct SkdPointMagnitudes
{
  vtkIdType Points = 0;
  double Low = 0.0; ///< that of a tenth of the points is less
  double Largest = 0.0;
};

/// Of a piece's points. O(n).
SkdPointMagnitudes SkdMagnitudesOf(vtkDataSet* piece);

/// By how much the same point may differ if it is computed twice: 4 units in the last place of its
/// largest coordinate, but at least of the largest that is usual in the mesh, because coordinates
/// near 0 may be differences of such. Points that are far from most others, or whose coordinates
/// stand for none, are not usual: with a tolerance by these different points would be one.
class SkdRounding
{
public:
  SkdRounding(bool isSingle, std::vector<SkdPointMagnitudes> pieces);

  /// How near another point must be to this one.
  double ToleranceAt(const skd::Vector3& x) const;

  /// A power of two, at least the tolerance and at most twice that: the same between one power of
  /// two of the largest coordinate and the next.
  double PowerAt(const skd::Vector3& x) const;

private:
  double MagnitudeAt(const skd::Vector3& x) const;

  double Precision;
  double Usual = 0.0;
};

/// Where pieces meet, a source may compute the same point twice with different rounding, as VTK's
/// own sphere does. Given all different points of some pieces, and which of them each point of a
/// piece is, this makes those one that differ by rounding, at the precision of the pieces' points,
/// and of which no piece has two. `keys` is changed accordingly: to the lower number. O(n log n).
void SkdMergeNearPoints(const SkdPieces& pieces, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys);

/// The same of some of the points of the pieces, with the rounding of all.
void SkdMergeNearPoints(const SkdRounding& rounding, const std::vector<skd::Vector3>& points,
  std::vector<std::vector<vtkIdType>>& keys);

/// Whether the points of a piece are stored in single precision.
bool SkdIsSingle(vtkDataSet* piece);
}

#endif
