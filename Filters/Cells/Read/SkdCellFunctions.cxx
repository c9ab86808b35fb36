// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdCellFunctions.h"

#include "Cells/Read/SkdHigherOrderFunctions.h"
#include "Cells/Read/SkdTolerances.h"

#include "vtkBezierCurve.h"
#include "vtkBezierHexahedron.h"
#include "vtkBezierInterpolation.h"
#include "vtkBezierQuadrilateral.h"
#include "vtkBezierTetra.h"
#include "vtkBezierTriangle.h"
#include "vtkBezierWedge.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkLagrangeInterpolation.h"
#include "vtkLagrangeTriangle.h"
#include "vtkLagrangeWedge.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <vector>

namespace skdtree
{
namespace
{
/// What VTK makes wedges of; the triangle is the calling thread's own.
struct Bezier
{
  using Interpolation = vtkBezierInterpolation;
  static vtkHigherOrderTriangle& Triangle()
  {
    thread_local vtkNew<vtkBezierTriangle> triangle;
    return *triangle;
  }
};

struct Lagrange
{
  using Interpolation = vtkLagrangeInterpolation;
  static vtkHigherOrderTriangle& Triangle()
  {
    thread_local vtkNew<vtkLagrangeTriangle> triangle;
    return *triangle;
  }
};

template <class Family>
void InterpolateWedge(vtkHigherOrderWedge* wedge, const double pcoords[3], double* weights)
{
  const int* order = wedge->GetOrder();
  vtkHigherOrderInterpolation::WedgeShapeFunctions(order, order[3], pcoords, weights,
    Family::Triangle(), Family::Interpolation::EvaluateShapeFunctions);
}

vtkCell* RealCell(vtkCell* cell)
{
  auto* generic = vtkGenericCell::SafeDownCast(cell);
  return generic ? generic->GetRepresentativeCell() : cell;
}

bool IsBezier(int cellType)
{
  return cellType >= VTK_BEZIER_CURVE && cellType <= VTK_BEZIER_PYRAMID;
}

vtkDoubleArray* RationalWeightsOf(vtkCell* cell)
{
  switch (cell->GetCellType())
  {
    case VTK_BEZIER_CURVE:
      return static_cast<vtkBezierCurve*>(cell)->GetRationalWeights();
    case VTK_BEZIER_QUADRILATERAL:
      return static_cast<vtkBezierQuadrilateral*>(cell)->GetRationalWeights();
    case VTK_BEZIER_TRIANGLE:
      return static_cast<vtkBezierTriangle*>(cell)->GetRationalWeights();
    case VTK_BEZIER_TETRAHEDRON:
      return static_cast<vtkBezierTetra*>(cell)->GetRationalWeights();
    case VTK_BEZIER_HEXAHEDRON:
      return static_cast<vtkBezierHexahedron*>(cell)->GetRationalWeights();
    case VTK_BEZIER_WEDGE:
      return static_cast<vtkBezierWedge*>(cell)->GetRationalWeights();
    default:
      return nullptr;
  }
}

/// Of Lagrange and Bezier cells.
bool IsSimplexOrWedge(int cellType)
{
  switch (cellType)
  {
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_TRIANGLE:
    case VTK_BEZIER_TETRAHEDRON:
    case VTK_BEZIER_WEDGE:
      return true;
    default:
      return false;
  }
}

/// In the order in which VTK multiplies and divides.
void MakeRational(vtkCell* cell, double* weights)
{
  vtkDoubleArray* rational = RationalWeightsOf(cell);
  if (rational->GetNumberOfTuples() == 0)
  {
    return;
  }
  const vtkIdType size = cell->GetNumberOfPoints();
  double sum = 0.0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    weights[i] *= rational->GetValue(i);
    sum += weights[i];
  }
  const double inverse = 1.0 / sum;
  for (vtkIdType i = 0; i < size; ++i)
  {
    weights[i] *= inverse;
  }
}

void InterpolateByVtk(vtkCell* cell, const double pcoords[3], double* weights)
{
  switch (cell->GetCellType())
  {
    case VTK_LAGRANGE_WEDGE:
      InterpolateWedge<Lagrange>(static_cast<vtkLagrangeWedge*>(cell), pcoords, weights);
      return;
    case VTK_BEZIER_WEDGE:
      InterpolateWedge<Bezier>(static_cast<vtkBezierWedge*>(cell), pcoords, weights);
      MakeRational(cell, weights);
      return;
    default:
      cell->InterpolateFunctions(pcoords, weights);
  }
}

/// VTK stores those of Lagrange quadrilaterals and hexahedra point by point; of Bezier cells it
/// forgets the rational weights, and writes past its buffers in triangles, tetrahedra and wedges.
bool HasDerivatives(int cellType)
{
  return cellType != VTK_LAGRANGE_QUADRILATERAL && cellType != VTK_LAGRANGE_HEXAHEDRON &&
    !IsBezier(cellType);
}

void DeriveByDifferences(vtkCell* cell, const double pcoords[3], double* derivatives)
{
  constexpr double h = SkdTolerances::FirstDifference;
  const auto size = static_cast<std::size_t>(cell->GetNumberOfPoints());
  std::vector<double> before(size);
  for (int axis = 0; axis < cell->GetCellDimension(); ++axis)
  {
    double at[3] = { pcoords[0], pcoords[1], pcoords[2] };
    double* after = derivatives + static_cast<std::size_t>(axis) * size;
    at[axis] = pcoords[axis] - h;
    SkdCellFunctions::Interpolate(cell, at, before.data());
    at[axis] = pcoords[axis] + h;
    SkdCellFunctions::Interpolate(cell, at, after);
    for (std::size_t i = 0; i < size; ++i)
    {
      after[i] = (0.5 / h) * (after[i] - before[i]);
    }
  }
}
}

//------------------------------------------------------------------------------
void SkdCellFunctions::Interpolate(vtkCell* cell, const double pcoords[3], double* weights)
{
  const int type = cell->GetCellType();
  if (!IsSimplexOrWedge(type))
  {
    cell->InterpolateFunctions(pcoords, weights);
    return;
  }
  vtkCell* real = RealCell(cell);
  const SkdHigherOrderFunctions* functions = SkdHigherOrderFunctions::Of(real);
  if (!functions)
  {
    InterpolateByVtk(real, pcoords, weights);
    return;
  }
  functions->Evaluate(pcoords, weights);
  if (IsBezier(type))
  {
    MakeRational(real, weights);
  }
}

//------------------------------------------------------------------------------
void SkdCellFunctions::Derive(vtkCell* cell, const double pcoords[3], double* derivatives)
{
  if (cell->GetCellType() == VTK_LAGRANGE_WEDGE)
  {
    const int* order = static_cast<vtkLagrangeWedge*>(RealCell(cell))->GetOrder();
    vtkHigherOrderInterpolation::WedgeShapeDerivatives(order, order[3], pcoords, derivatives,
      Lagrange::Triangle(), vtkLagrangeInterpolation::EvaluateShapeAndGradient);
  }
  else if (HasDerivatives(cell->GetCellType()))
  {
    cell->InterpolateDerivs(pcoords, derivatives);
  }
  else
  {
    DeriveByDifferences(cell, pcoords, derivatives);
  }
}

//------------------------------------------------------------------------------
void SkdCellFunctions::ReadRationalWeights(vtkDataSet* data, vtkGenericCell* cell)
{
  if (!IsBezier(cell->GetCellType()))
  {
    return;
  }
  vtkDataArray* stored = data->GetPointData()->GetRationalWeights();
  vtkDoubleArray* weights = stored ? RationalWeightsOf(cell->GetRepresentativeCell()) : nullptr;
  for (vtkIdType i = 0; weights && i < weights->GetNumberOfValues(); ++i)
  {
    weights->SetValue(i, stored->GetComponent(cell->GetPointId(static_cast<int>(i)), 0));
  }
}

//------------------------------------------------------------------------------
double* SkdCellFunctions::RationalWeights(vtkCell* cell)
{
  vtkDoubleArray* weights =
    IsBezier(cell->GetCellType()) ? RationalWeightsOf(RealCell(cell)) : nullptr;
  const bool isRational = weights && weights->GetNumberOfTuples() == cell->GetNumberOfPoints();
  return isRational ? weights->GetPointer(0) : nullptr;
}

//------------------------------------------------------------------------------
bool SkdCellFunctions::ShareMemory(int cellType)
{
  return cellType == VTK_LAGRANGE_WEDGE || cellType == VTK_BEZIER_WEDGE;
}
}
