// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Kernels/SkdGenericKernel.h"

#include "Cells/Kernels/SkdParametricCell.h"
#include "Cells/Kernels/SkdPiecewiseKernel.h"
#include "Cells/Read/SkdCellFunctions.h"
#include "Cells/Read/SkdCellReader.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <limits>
#include <vector>

namespace skdtree
{
namespace
{
/// A buffer for unused weights that EvaluatePosition writes: one a thread, as large as the largest
/// cell so far, so that queries do not allocate.
double* SpareWeights(vtkCell* cell)
{
  thread_local std::vector<double> buffer;
  const auto size = static_cast<std::size_t>(cell->GetNumberOfPoints());
  if (buffer.size() < size)
  {
    buffer.resize(size);
  }
  return buffer.data();
}

/// EvaluatePosition, with infinity where it fails.
SkdCellPoint Evaluate(vtkCell* cell, const skd::Vector3& x, double* weights)
{
  SkdCellPoint found;
  found.PCoords = { { 0.0, 0.0, 0.0 } };
  found.Point = x;
  found.Dist2 = std::numeric_limits<double>::infinity();
  const int status =
    cell->EvaluatePosition(x.X, found.Point.X, found.SubId, found.PCoords.X, found.Dist2, weights);
  found.ProjectsInside = status == 1;
  if (status < 0 || !(found.Dist2 >= 0.0))
  {
    found.Dist2 = std::numeric_limits<double>::infinity();
  }
  return found;
}

void KeepNearer(SkdCellPoint& nearest, const SkdCellPoint& other)
{
  if (other.Dist2 < nearest.Dist2)
  {
    nearest = other;
  }
}

SkdCellPoint ClosestOnFaces(vtkCell* cell, const skd::Vector3& x)
{
  SkdCellPoint nearest;
  nearest.Dist2 = std::numeric_limits<double>::infinity();
  for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    vtkCell* face = cell->GetFace(i);
    KeepNearer(nearest, Evaluate(face, x, SpareWeights(face)));
  }
  nearest.ProjectsInside = false;
  nearest.SubId = 0;
  return nearest;
}

/// For degenerate cells that cannot be evaluated: their points are what is certain.
SkdCellPoint ClosestCellPoint(vtkCell* cell, const skd::Vector3& x)
{
  SkdCellPoint nearest;
  nearest.Dist2 = std::numeric_limits<double>::infinity();
  nearest.PCoords = { { 0.0, 0.0, 0.0 } };
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    skd::Vector3 point;
    cell->GetPoints()->GetPoint(i, point.X);
    KeepNearer(nearest, { point, { { 0.0, 0.0, 0.0 } }, skd::Distance2(point, x) });
  }
  return nearest;
}
}

//------------------------------------------------------------------------------
vtkGenericCell* SkdScratchCell()
{
  thread_local vtkNew<vtkGenericCell> cell;
  return cell;
}

//------------------------------------------------------------------------------
vtkCell* SkdCellSource::Load(vtkIdType id) const
{
  vtkGenericCell* cell = this->Cell ? this->Cell : SkdScratchCell();
  SkdLoadCell(this->Data, id, cell);
  return cell->GetRepresentativeCell();
}

//------------------------------------------------------------------------------
SkdCellPoint SkdGenericKernel::Closest(vtkCell* cell, const skd::Vector3& x, double limit2)
{
  if (SkdParametricCell::DomainOf(cell->GetCellType()))
  {
    return SkdParametricKernel::Closest(cell, x, limit2);
  }
  if (SkdPiecewiseKernel::Knows(cell->GetCellType()))
  {
    return SkdPiecewiseKernel::Closest(cell, x);
  }
  SkdCellPoint found = Evaluate(cell, x, SpareWeights(cell));
  if (cell->GetCellDimension() == 3)
  {
    if (found.ProjectsInside && std::isfinite(found.Dist2))
    {
      found.Point = x;
      found.Dist2 = 0.0;
      return found;
    }
    found = ClosestOnFaces(cell, x);
  }
  return std::isfinite(found.Dist2) ? found : ClosestCellPoint(cell, x);
}

//------------------------------------------------------------------------------
std::optional<SkdLineHit> SkdGenericKernel::Intersect(
  vtkCell* cell, const skd::Box3& bounds, const skd::Segment<3>& segment, double tolerance)
{
  if (SkdParametricCell::DomainOf(cell->GetCellType()))
  {
    return SkdParametricKernel::Intersect(cell, bounds, segment, tolerance);
  }
  if (SkdPiecewiseKernel::Knows(cell->GetCellType()))
  {
    return SkdPiecewiseKernel::Intersect(cell, segment, { tolerance, 0.0 });
  }
  SkdLineHit hit;
  skd::Vector3 point;
  hit.PCoords = { { 0.0, 0.0, 0.0 } };
  const int found = cell->IntersectWithLine(
    segment.A.X, segment.B.X, tolerance, hit.T, point.X, hit.PCoords.X, hit.SubId);
  if (!found || !(hit.T >= 0.0 && hit.T <= 1.0))
  {
    return std::nullopt;
  }
  return hit;
}

//------------------------------------------------------------------------------
void SkdGenericKernel::Locate(
  vtkCell* cell, const skd::Vector3& point, int& subId, skd::Vector3& pcoords, double* weights)
{
  if (SkdParametricCell::DomainOf(cell->GetCellType()))
  {
    if (weights)
    {
      SkdCellFunctions::Interpolate(cell, pcoords.X, weights);
    }
    return;
  }
  SkdCellPoint found{ point, pcoords, 0.0, subId };
  if (SkdPiecewiseKernel::Knows(cell->GetCellType()))
  {
    SkdPiecewiseKernel::Locate(cell, found, weights);
  }
  else
  {
    found = Evaluate(cell, point, weights ? weights : SpareWeights(cell));
  }
  subId = found.SubId;
  pcoords = found.PCoords;
}
}
