// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Probe/SkdCellLocations.h"

#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMath.h"

#include <algorithm>

namespace skdtree
{
namespace
{
constexpr const char* ValidName = "SkdValid";
constexpr const char* PCoordsName = "SkdParametricCoordinates";
constexpr const char* DistanceName = "SkdDistance";
}

SkdCellLocations::SkdCellLocations(vtkIdType n)
  : Valid(SkdMakeArray<vtkUnsignedCharArray>(ValidName, 1, n, 0))
  , CellIds(SkdMakeArray<vtkIdTypeArray>(CellIdName, 1, n, -1))
  , PCoords(SkdMakeArray<vtkDoubleArray>(PCoordsName, 3, n, vtkMath::Nan()))
  , Distances(SkdMakeArray<vtkDoubleArray>(DistanceName, 1, n, vtkMath::Nan()))
  , Blocks(n, -1)
{
}

void SkdCellLocations::Set(vtkIdType i, const SkdCellLocation& location)
{
  this->Valid->SetValue(i, 1);
  this->CellIds->SetValue(i, location.CellId);
  std::copy_n(location.PCoords, 3, this->PCoords->GetPointer(3 * i));
  this->Distances->SetValue(i, location.Distance);
  this->Blocks[i] = location.Block;
}

void SkdCellLocations::AddTo(
  vtkDataSetAttributes* data, const std::vector<SkdBlock>& source, bool isComposite) const
{
  SkdJoinIds(this->CellIds, this->Blocks, source);
  data->AddArray(this->Valid);
  data->AddArray(this->CellIds);
  if (isComposite)
  {
    data->AddArray(SkdMakeBlockIndices(BlockIndexName, this->Blocks, source));
  }
  data->AddArray(this->PCoords);
  data->AddArray(this->Distances);
}
}
