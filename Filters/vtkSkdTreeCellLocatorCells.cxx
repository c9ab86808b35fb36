// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The locator's queries of single cells, and of their ends.
#include "vtkSkdTreeCellLocator.h"

#include "Cells/Search/SkdLocatorState.h"

#include "vtkDoubleArray.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Where a point is nearest to a cell, in the caller's memory.
struct Location
{
  double* Point;
  int& SubId;
  double* PCoords;
  double& Dist2;
  double* Weights;

  /// False, and sets nothing, if there is no cell.
  bool Set(const SkdLocatorState& state, const SkdCellSource& source, SkdFoundCell found) const
  {
    if (found.Id < 0)
    {
      return false;
    }
    const SkdCellTree& tree = *state.GetTree();
    tree.Interpolate(found, this->Weights, source);
    this->SubId = found.SubId;
    this->Dist2 = found.Dist2;
    const skd::Vector3 point = state.ToWorld(found.Point);
    SkdStore(point, this->Point);
    SkdStore(tree.MovedPCoords(state.GetMotion(), found.Id, point, found.PCoords), this->PCoords);
    return true;
  }
};
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindClosestLocation(const double x[3], double radius,
  double closestPoint[3], int& subId, double pcoords[3], double& dist2, double* weights)
{
  const SkdCellTree& tree = this->GetTree();
  if (!(radius >= 0.0))
  {
    return -1;
  }
  const SkdCellSource source{ this->DataSet };
  const SkdFoundCell found = tree.FindNearest(this->Impl->ToTree(x), radius * radius, source);
  Location{ closestPoint, subId, pcoords, dist2, weights }.Set(*this->Impl, source, found);
  return found.Id;
}

//------------------------------------------------------------------------------
bool vtkSkdTreeCellLocator::EvaluateCell(vtkIdType cellId, const double x[3],
  double closestPoint[3], int& subId, double pcoords[3], double& dist2, double* weights)
{
  const SkdCellTree& tree = this->GetTree();
  const SkdCellSource source{ this->DataSet };
  const SkdFoundCell found = tree.Evaluate(cellId, this->Impl->ToTree(x), source);
  return Location{ closestPoint, subId, pcoords, dist2, weights }.Set(*this->Impl, source, found);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCellBorders(
  const double p1[3], const double p2[3], double tolerance, vtkDoubleArray* parameters)
{
  thread_local std::vector<double> borders;
  borders.clear();
  parameters->SetNumberOfComponents(1);
  parameters->Reset();
  const skd::Segment<3> segment = this->Impl->ToTree(p1, p2);
  if (!skd::SegmentView(segment).IsValid())
  {
    return 0;
  }
  borders.insert(borders.end(), { 0.0, 1.0 });
  const SkdCellSource source{ this->DataSet };
  this->GetTree().FindBorders(segment, tolerance, source, borders);
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  parameters->SetNumberOfTuples(static_cast<vtkIdType>(borders.size()));
  std::copy(borders.begin(), borders.end(), parameters->GetPointer(0));
  return parameters->GetNumberOfTuples();
}

VTK_ABI_NAMESPACE_END
