// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitPointData.h"

#include "Pipeline/SkdArrayGather.h"
#include "vtkIdList.h"

#include <algorithm>

void SkdSplitPointData::Gather(
  std::uint32_t point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const
{
  const std::size_t given = this->Set.GetPoints().size();
  if (point >= given)
  {
    this->Interpolate(this->NewPoints[point - given], to, arrays, ids);
    return;
  }
  auto at = std::lower_bound(this->Origins.begin(), this->Origins.end(), Origin{ point, 0, 0 });
  while (at != this->Origins.end() && at->Point == point && at->Id < 0)
  {
    ++at; // added by a surface
  }
  if (at != this->Origins.end() && at->Point == point)
  {
    arrays.Take(to, at->Block, at->Id);
  }
}

void SkdSplitPointData::Interpolate(
  const SkdSplitPoint& point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const
{
  const int block = this->Set.GetCells()[this->Set.GetCellOf(point.Parent)].Block;
  double weights[3];
  ids->SetNumberOfIds(3);
  for (int i = 0; i < 3; ++i)
  {
    const Origin least{ point.Corners[i], block, 0 };
    const auto at = std::lower_bound(this->Origins.begin(), this->Origins.end(), least);
    if (at == this->Origins.end() || at->Point != least.Point || at->Block != block)
    {
      return;
    }
    ids->SetId(i, at->Id);
    weights[i] = point.Weights[i];
  }
  arrays.Interpolate(to, block, ids, weights);
}
