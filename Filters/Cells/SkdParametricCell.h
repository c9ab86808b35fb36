// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdParametricCell_h
#define SkdParametricCell_h

#include "Cells/SkdKernels.h"
#include "Core/Geometry/Cells/ParameterDomain.h"

class vtkCell;

/// A curved cell (quadratic, cubic, Lagrange, Bezier) as what it is: the image of a domain under
/// the cell's interpolation functions. VTK's own EvaluatePosition and IntersectWithLine of these
/// cells approximate by straight pieces, by loosely converged or clamped coordinates; here both are
/// solved for on the map itself, to within rounding.
///
/// Parameters are in [0, 1]; they are VTK's parametric coordinates but for two types (ToVTK).
/// Points are relative to an origin: a query point, so that residuals lose nothing to rounding.
/// The buffers are the calling thread's, and good until its next parametric cell.
class SkdParametricCell
{
public:
  /// The domain of a type of cell; nullptr for those that are not parametric.
  static const skd::ParameterDomain* DomainOf(int cellType);

  SkdParametricCell(vtkCell* cell, const skd::Vector3& origin);

  const skd::ParameterDomain& Domain() const { return *this->TheDomain; }
  int NumberOfPoints() const { return this->Size; }
  /// The cell's points, seen from the origin, and the parameters that they are meant to have.
  const skd::Vector3& Point(int i) const { return this->Points[i]; }
  skd::Vector3 ParametersOfPoint(int i) const;

  ///@{
  /// The map, and its derivatives (as LeastResidual wants them).
  skd::Vector3 Value(const skd::Vector3& p) const;
  void Tangents(const skd::Vector3& p, skd::Vector3 (&tangents)[3]) const;
  ///@}

  skd::Vector3 ToVTK(const skd::Vector3& p) const;

  /// 8 units in the last place of the largest coordinate of the cell and of the origin: what is
  /// nearer than this is at distance 0.
  double Rounding() const { return this->TheRounding; }

private:
  skd::Vector3 Sum(const double* weights) const;

  vtkCell* Cell;
  const skd::ParameterDomain* TheDomain;
  int Type;
  int Size;
  const skd::Vector3* Points;
  double* Weights;
  const double* VTKParameters;
  double TheRounding;
};

/// The exact tests of parametric cells.
namespace SkdParametricKernel
{
SkdCellPoint Closest(vtkCell* cell, const skd::Vector3& x);

std::optional<SkdLineHit> Intersect(
  vtkCell* cell, const skd::Segment<3>& segment, double tolerance);
}

#endif
