// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitPointData.h"

#include "Pipeline/SkdArrayGather.h"
#include "vtkIdList.h"

#include <algorithm>

namespace skdtree
{
void SkdSplitPointData::Gather(
  std::uint32_t point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const
{
  const std::size_t given = this->Set.GetPoints().size();
  if (point >= given)
  {
    this->Interpolate(this->NewPoints[point - given], to, arrays, ids);
    return;
  }
  if (const Origin* at = this->FindOrigin(point))
  {
    arrays.Take(to, at->Block, at->Id);
  }
  else
  {
    arrays.Clear(to);
  }
}

const SkdTriangleSet::Origin* SkdSplitPointData::FindOrigin(std::uint32_t point) const
{
  if (point >= this->Set.GetPoints().size())
  {
    return nullptr;
  }
  const auto origins = this->Origins[point];
  const Origin* at = std::find_if(origins.begin(), origins.end(),
    [](const Origin& origin) { return origin.Id >= 0; }); // not added by a surface
  return at != origins.end() ? at : nullptr;
}

void SkdSplitPointData::Interpolate(
  const SkdSplitPoint& point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const
{
  const int block = this->Set.GetCells()[this->Set.GetCellOf(point.Parent)].Block;
  double weights[3];
  ids->SetNumberOfIds(3);
  for (int i = 0; i < 3; ++i)
  {
    const auto origins = this->Origins[point.Corners[i]];
    const Origin* at = std::lower_bound(origins.begin(), origins.end(), Origin{ block, 0 });
    if (at == origins.end() || at->Block != block)
    {
      arrays.Clear(to);
      return;
    }
    ids->SetId(i, at->Id);
    weights[i] = point.Weights[i];
  }
  arrays.Interpolate(to, block, ids, weights);
}
}
