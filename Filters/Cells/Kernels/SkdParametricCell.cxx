// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdParametricCell.h"

#include "Cells/Read/SkdCellFunctions.h"
#include "Cells/Read/SkdTolerances.h"
#include "Core/Geometry/TwoDoubles.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkPoints.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace skdtree
{
namespace
{
/// Grown to the largest cell that the thread met, so that a query allocates nothing.
struct Buffers
{
  std::vector<skd::Vector3> Points;
  std::vector<double> Weights; // as many as points, and three times that many derivatives
};

Buffers& BuffersFor(int size)
{
  thread_local Buffers buffers;
  const auto needed = static_cast<std::size_t>(size);
  if (buffers.Points.size() < needed)
  {
    buffers.Points.resize(needed);
    buffers.Weights.resize(3 * needed);
  }
  return buffers;
}

/// The types whose InterpolateDerivs are the derivatives of their InterpolateFunctions, stored axis
/// by axis. Those of pyramids are not, nor those of rational Bezier cells, and those of Lagrange
/// and Bezier cells are stored in another order by each type: differences serve these.
bool HasDerivatives(int cellType)
{
  return cellType >= VTK_QUADRATIC_EDGE && cellType <= VTK_BIQUADRATIC_TRIANGLE &&
    cellType != VTK_QUADRATIC_PYRAMID;
}
}

//------------------------------------------------------------------------------
const skd::ParameterDomain* SkdParametricCell::DomainOf(int cellType)
{
  switch (cellType)
  {
    case VTK_QUADRATIC_EDGE:
    case VTK_CUBIC_LINE:
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return &skd::UnitSegment;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return &skd::UnitTriangle;
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return &skd::UnitSquare;
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return &skd::UnitTetrahedron;
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return &skd::UnitPrism;
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return &skd::UnitCube;
    default:
      return nullptr;
  }
}

//------------------------------------------------------------------------------
SkdParametricCell::SkdParametricCell(vtkCell* cell, const skd::Vector3& origin)
  : Cell(cell)
  , TheDomain(DomainOf(cell->GetCellType()))
  , Type(cell->GetCellType())
  , Size(static_cast<int>(cell->GetNumberOfPoints()))
{
  Buffers& buffers = BuffersFor(this->Size);
  double largest = std::max({ std::abs(origin[0]), std::abs(origin[1]), std::abs(origin[2]) });
  for (int i = 0; i < this->Size; ++i)
  {
    skd::Vector3 point;
    cell->GetPoints()->GetPoint(i, point.X);
    largest = std::max({ largest, std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) });
    buffers.Points[static_cast<std::size_t>(i)] = point - origin;
  }
  this->Points = buffers.Points.data();
  this->Weights = buffers.Weights.data();
  this->VTKParameters = cell->GetParametricCoords();
  this->TheRounding = 8.0 * std::numeric_limits<double>::epsilon() * largest;
}

//------------------------------------------------------------------------------
// Cubic lines go from -1 to 1. The pyramid of 19 points has a pyramid for a domain, with its base
// at height 0.5 and its tip at 1; it is seen as a cube whose top is drawn together.
skd::Vector3 SkdParametricCell::ToVTK(int cellType, const skd::Vector3& p)
{
  switch (cellType)
  {
    case VTK_CUBIC_LINE:
      return { { 2.0 * p[0] - 1.0, 0.0, 0.0 } };
    case VTK_TRIQUADRATIC_PYRAMID:
      return { { 0.5 + (p[0] - 0.5) * (1.0 - p[2]), 0.5 + (p[1] - 0.5) * (1.0 - p[2]),
        0.5 + 0.5 * p[2] } };
    default:
      return p;
  }
}

//------------------------------------------------------------------------------
skd::Vector3 SkdParametricCell::ParametersOfPoint(int i) const
{
  const double* q = this->VTKParameters + 3 * i;
  switch (this->Type)
  {
    case VTK_CUBIC_LINE:
      return { { 0.5 * (q[0] + 1.0), 0.0, 0.0 } };
    case VTK_TRIQUADRATIC_PYRAMID:
    {
      const double width = 2.0 * (1.0 - q[2]);
      return width > 0.0
        ? skd::Vector3{ { 0.5 + (q[0] - 0.5) / width, 0.5 + (q[1] - 0.5) / width, 1.0 - width } }
        : skd::Vector3{ { 0.5, 0.5, 1.0 } };
    }
    default:
      return { { q[0], q[1], q[2] } };
  }
}

//------------------------------------------------------------------------------
const double* SkdParametricCell::RationalWeights() const
{
  return SkdCellFunctions::RationalWeights(this->Cell);
}

//------------------------------------------------------------------------------
skd::Vector3 SkdParametricCell::Sum(const double* weights) const
{
  skd::TwoDoubles xy(0.0); // of three coordinates apart GCC makes more instructions
  double z = 0.0;
  for (int i = 0; i < this->Size; ++i)
  {
    const skd::Vector3& point = this->Points[i];
    xy = xy + skd::TwoDoubles(weights[i]) * skd::TwoDoubles::Read(point.X);
    z += weights[i] * point[2];
  }
  return { { xy.First(), xy.Second(), z } };
}

//------------------------------------------------------------------------------
skd::Vector3 SkdParametricCell::Value(const skd::Vector3& p) const
{
  SkdCellFunctions::Interpolate(this->Cell, this->ToVTK(p).X, this->Weights);
  return this->Sum(this->Weights);
}

//------------------------------------------------------------------------------
void SkdParametricCell::Tangents(const skd::Vector3& p, skd::Vector3 (&tangents)[3]) const
{
  if (HasDerivatives(this->Type))
  {
    this->Cell->InterpolateDerivs(this->ToVTK(p).X, this->Weights);
    for (int axis = 0; axis < this->TheDomain->Dimension; ++axis)
    {
      tangents[axis] = this->Sum(this->Weights + axis * this->Size);
    }
    return;
  }
  constexpr double h = SkdTolerances::FirstDifference;
  for (int axis = 0; axis < this->TheDomain->Dimension; ++axis)
  {
    skd::Vector3 before = p;
    skd::Vector3 after = p;
    before[axis] -= h;
    after[axis] += h;
    tangents[axis] = (0.5 / h) * (this->Value(after) - this->Value(before));
  }
}
}
