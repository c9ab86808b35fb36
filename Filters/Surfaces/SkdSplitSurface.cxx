// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SkdSplitSurface.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdMakeMesh.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
class Output
{
public:
  Output(const SkdPlacedTriangles& set, const SkdSplitResult& split,
    const std::vector<SkdBlock>& blocks, vtkPolyData* output)
    : Set(set)
    , Split(split)
    , Blocks(blocks)
    , To(output)
  {
  }

  void FillShape(double scale) const
  {
    const auto old = static_cast<vtkIdType>(this->Set.GetPoints().size());
    const double unscaled = 1.0 / scale;
    const auto pointAt = [&](vtkIdType i) {
      return unscaled * (i < old ? this->Set.GetPoints()[i] : this->Split.Points[i - old].Position);
    };
    SkdSetTriangles(
      this->To, old + static_cast<vtkIdType>(this->Split.Points.size()), pointAt,
      this->Split.Triangles, [](const SkdTriangleSet::Corners& ids) -> const auto& { return ids; });
  }

  void FillCellData(bool isComposite, std::set<std::string>& refused) const
  {
    const auto n = static_cast<vtkIdType>(this->Split.Triangles.size());
    auto ids = SkdMakeArray<vtkIdTypeArray>(SkdSplitNames::Cell, 1, n);
    auto blockIndices = SkdMakeArray<vtkIntArray>(SkdSplitNames::Block, 1, n);
    auto regions = SkdMakeArray<vtkIdTypeArray>(SkdSplitNames::Region, 1, n);
    const std::vector<std::uint32_t> found =
      SkdFindSplitRegions(this->Split.Triangles, this->Split.Curves);
    vtkCellData* data = this->To->GetCellData();
    data->AddArray(ids);
    data->AddArray(regions);
    if (isComposite)
    {
      data->AddArray(blockIndices);
    }
    SkdArrayGather gather = SkdGatherInto(data, n, this->Blocks, vtkDataObject::CELL, refused);
    for (vtkIdType i = 0; i < n; ++i)
    {
      const SkdTriangleSet::Cell& cell = this->CellOf(i);
      ids->SetValue(i, cell.Id);
      blockIndices->SetValue(i, this->Blocks[cell.Block].BlockIndex);
      regions->SetValue(i, found[i]);
      gather.Take(i, cell.Block, cell.Id);
    }
  }

  void FillPointData(std::set<std::string>& refused) const
  {
    const auto n = this->To->GetNumberOfPoints();
    SkdArrayGather gather =
      SkdGatherInto(this->To->GetPointData(), n, this->Blocks, vtkDataObject::POINT, refused);
    const std::vector<Origin> origins = this->Set.GetSet().FindOrigins();
    for (auto at = origins.begin(); at != origins.end(); ++at)
    {
      if (at->Id >= 0 &&
        (at == origins.begin() || (at - 1)->Point != at->Point || (at - 1)->Id < 0))
      {
        gather.Take(at->Point, at->Block, at->Id);
      }
    }
    vtkIdType to = static_cast<vtkIdType>(this->Set.GetPoints().size());
    for (const SkdSplitPoint& point : this->Split.Points)
    {
      this->Interpolate(point, to++, origins, gather);
    }
  }

private:
  using Origin = SkdTriangleSet::Origin;

  const SkdTriangleSet::Cell& CellOf(vtkIdType triangle) const
  {
    const SkdTriangleSet& set = this->Set.GetSet();
    return set.GetCells()[set.GetCellOf(this->Split.Parents[triangle])];
  }

  /// The corners as the data set has them that the point's own triangle is of.
  void Interpolate(const SkdSplitPoint& point, vtkIdType to, const std::vector<Origin>& origins,
    SkdArrayGather& gather) const
  {
    const SkdTriangleSet& set = this->Set.GetSet();
    const int block = set.GetCells()[set.GetCellOf(point.Parent)].Block;
    vtkNew<vtkIdList> ids;
    double weights[3];
    bool isKnown = true;
    for (int i = 0; i < 3; ++i)
    {
      const Origin least{ point.Corners[i], block, 0 };
      const auto at = std::lower_bound(origins.begin(), origins.end(), least);
      isKnown =
        isKnown && at != origins.end() && at->Point == point.Corners[i] && at->Block == block;
      ids->InsertNextId(isKnown ? at->Id : -1);
      weights[i] = point.Weights[i];
    }
    if (isKnown)
    {
      gather.Interpolate(to, block, ids, weights);
    }
  }

  const SkdPlacedTriangles& Set;
  const SkdSplitResult& Split;
  const std::vector<SkdBlock>& Blocks;
  vtkPolyData* To;
};
}

vtkIdType SkdFillSplitSurface(const SkdSplitSegments& segments, int side,
  const std::vector<SkdBlock>& blocks, bool isComposite, double scale, vtkPolyData* output,
  std::set<std::string>& refused)
{
  const SkdSplitResult split = SkdSplitTriangles(segments, side);
  const Output to(*segments.GetSide(side).Set, split, blocks, output);
  to.FillShape(scale);
  if (!blocks.empty())
  {
    to.FillCellData(isComposite, refused);
    to.FillPointData(refused);
  }
  return split.NumberSplit;
}
