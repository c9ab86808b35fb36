// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Probe/SkdProbedData.h"

#include "Pipeline/SkdArrayGather.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// The point of the cell that is nearest to x; ties to the first.
vtkIdType NearestPoint(vtkDataSet* mesh, vtkIdList* ids, const double x[3])
{
  vtkIdType nearest = -1;
  double least = VTK_DOUBLE_MAX;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    double p[3];
    mesh->GetPoint(ids->GetId(i), p);
    const double dist2 = vtkMath::Distance2BetweenPoints(p, x);
    if (nearest < 0 || dist2 < least)
    {
      nearest = ids->GetId(i);
      least = dist2;
    }
  }
  return nearest;
}

SkdArrayGather GatherPointArrays(vtkDataSetAttributes* into, vtkIdType n,
  const std::vector<SkdBlock>& blocks, SkdProbedNames& names, double fill, bool areLabels)
{
  return SkdGatherInto(into, n, blocks, vtkDataObject::POINT, names.Refused, fill,
    [&](const std::string& name) { return (names.Categorical.count(name) > 0) == areLabels; });
}
}

SkdProbedData::SkdProbedData(vtkDataSetAttributes* into, vtkIdType n,
  const std::vector<SkdBlock>& blocks, SkdProbedNames& names, double fill)
  : Blocks(blocks)
  , Quantities(GatherPointArrays(into, n, blocks, names, fill, false))
  , Labels(GatherPointArrays(into, n, blocks, names, fill, true))
  , OfCells(SkdGatherInto(into, n, blocks, vtkDataObject::CELL, names.Refused, fill,
      [](const std::string&) { return true; }))
  , Gradients(blocks, names.Gradients, n, names.Missing)
{
  this->Gradients.AddTo(into);
  this->Activate(into);
  for (const std::string& name : names.Categorical)
  {
    const auto has = [&](const SkdBlock& block)
    { return block.Mesh->GetPointData()->HasArray(name.c_str()) != 0; };
    if (!std::all_of(blocks.begin(), blocks.end(), has))
    {
      names.Missing.insert(name);
    }
  }
}

void SkdProbedData::Activate(vtkDataSetAttributes* into) const
{
  vtkDataArray* own = this->Blocks.empty()
    ? nullptr
    : vtkDataArray::SafeDownCast(this->Blocks.front().Mesh->GetPointData()->GetScalars());
  const std::string preferred = own && own->GetName() ? own->GetName() : "";
  const char* chosen = nullptr;
  for (const SkdArrayGather* gather : { &this->Quantities, &this->Labels, &this->OfCells })
  {
    for (int i = 0; i < gather->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = gather->GetResult(i);
      const bool isFirst = !chosen && array->IsNumeric();
      chosen = isFirst || array->GetName() == preferred ? array->GetName() : chosen;
    }
  }
  if (chosen)
  {
    into->SetActiveScalars(chosen);
  }
}

void SkdProbedData::Set(
  vtkIdType i, const double x[3], SkdCellFinder& finder, SkdGradient& gradient)
{
  const SkdCellLocation& location = finder.GetLocation();
  vtkDataSet* mesh = this->Blocks[location.Block].Mesh;
  this->Quantities.Interpolate(i, location.Block, finder.GetPointIds(), finder.GetWeights());
  this->OfCells.Take(i, location.Block, location.CellId);
  if (this->Labels.GetNumberOfArrays() > 0)
  {
    this->Labels.Take(i, location.Block, NearestPoint(mesh, finder.GetPointIds(), x));
  }
  if (!this->Gradients.IsEmpty())
  {
    gradient.Evaluate(mesh, location);
    this->Gradients.Set(i, location.Block, finder.GetPointIds(), gradient.GetVectors());
  }
}
}
