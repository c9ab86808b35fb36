// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdParametricCell_h
#define SkdParametricCell_h

#include "Cells/Kernels/SkdCellAnswers.h"
#include "Core/Geometry/Box.h"
#include "Core/Geometry/Cells/ParameterDomain.h"
#include "Core/Geometry/Segment.h"

#include <limits>
#include <optional>

class vtkCell;

namespace skdtree
{
/// A curved cell (quadratic, cubic, Lagrange, Bezier) as the image of a domain under its
/// interpolation functions. VTK's own EvaluatePosition and IntersectWithLine of these cells
/// approximate by straight pieces or by loosely converged or clamped coordinates; here both are
/// solved on the map itself, to within rounding.
///
/// Parameters are in [0, 1]; they are VTK's parametric coordinates but for two types (ToVTK).
/// Points are relative to an origin: a query point, so that residuals lose nothing to rounding. The
/// buffers are thread-local and valid until the thread's next parametric cell.
class SkdParametricCell
{
public:
  /// The domain of a type of cell; nullptr for those that are not parametric.
  static const skd::ParameterDomain* DomainOf(int cellType);

  SkdParametricCell(vtkCell* cell, const skd::Vector3& origin);

  const skd::ParameterDomain& Domain() const { return *this->TheDomain; }
  int NumberOfPoints() const { return this->Size; }
  /// The cell's points relative to the origin, and their parameters.
  const skd::Vector3& Point(int i) const { return this->Points[i]; }
  skd::Vector3 ParametersOfPoint(int i) const;

  ///@{
  /// The map, and its derivatives (as LeastResidual wants them).
  skd::Vector3 Value(const skd::Vector3& p) const;
  void Tangents(const skd::Vector3& p, skd::Vector3 (&tangents)[3]) const;
  ///@}

  /// The rational weights of the points, nullptr if there are none.
  const double* RationalWeights() const;

  ///@{
  /// VTK's parametric coordinates.
  skd::Vector3 ToVTK(const skd::Vector3& p) const { return ToVTK(this->Type, p); }
  static skd::Vector3 ToVTK(int cellType, const skd::Vector3& p);
  ///@}

  /// 8 units in the last place of the largest coordinate of the cell and of the origin: smaller
  /// distances count as 0.
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

/// The exact tests of parametric cells. The nearest point is the nearest of the whole cell: a local
/// minimum is one answer of many, until the cell's Bernstein form shows that none is less. So it is
/// with the first hit of a line.
namespace SkdParametricKernel
{
/// What is farther than limit2, a squared distance, need not be the nearest.
SkdCellPoint Closest(
  vtkCell* cell, const skd::Vector3& x, double limit2 = std::numeric_limits<double>::infinity());

/// The first place where the segment comes within the tolerance, or within rounding, of the cell,
/// of a volume of its sides: a crossing, or where it is nearest for once. `bounds`: of the whole
/// cell, which may reach beyond its points.
std::optional<SkdLineHit> Intersect(
  vtkCell* cell, const skd::Box3& bounds, const skd::Segment<3>& segment, double tolerance);
}
}

#endif
