// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitSurface.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdMakeMesh.h"
#include "Solids/Surfaces/SkdSplitPointData.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"

#include <algorithm>

namespace skdtree
{
namespace
{
class Output
{
public:
  Output(const SkdMovedTriangles& set, const SkdSplitResult& split,
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
    const SkdSplitPointData data(this->Set.GetSet(), this->Split.Points);
    vtkSMPThreadLocalObject<vtkIdList> ids;
    SkdForEach(gather.GetNumberOfArrays() > 0 ? n : 0,
      [&](vtkIdType i) { data.Gather(static_cast<std::uint32_t>(i), i, gather, ids.Local()); });
  }

private:
  const SkdTriangleSet::Cell& CellOf(vtkIdType triangle) const
  {
    const SkdTriangleSet& set = this->Set.GetSet();
    return set.GetCells()[set.GetCellOf(this->Split.Parents[triangle])];
  }

  const SkdMovedTriangles& Set;
  const SkdSplitResult& Split;
  const std::vector<SkdBlock>& Blocks;
  vtkPolyData* To;
};

/// Pieces of a triangle begin with their least corner by coordinates, however points are numbered.
void BeginAtLeast(const SkdMovedTriangles& set, SkdSplitResult& split)
{
  const std::size_t old = set.GetPoints().size();
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  {
    const auto at = [&](std::uint32_t i) -> const skd::Vector3&
    { return i < old ? set.GetPoints()[i] : split.Points[i - old].Position; };
    return at(a) < at(b);
  };
  const std::size_t n = split.Triangles.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool isPiece = (i > 0 && split.Parents[i - 1] == split.Parents[i]) ||
      (i + 1 < n && split.Parents[i + 1] == split.Parents[i]);
    SkdTriangleSet::Corners& corners = split.Triangles[i];
    if (isPiece)
    {
      const auto least = static_cast<std::size_t>(
        std::min_element(corners.begin(), corners.end(), isBefore) - corners.begin());
      corners = { corners[least], corners[(least + 1) % 3], corners[(least + 2) % 3] };
    }
  }
}
}

vtkIdType SkdFillSplitSurface(const SkdSplitSegments& segments, int side,
  const std::vector<SkdBlock>& blocks, bool isComposite, double scale, vtkPolyData* output,
  std::set<std::string>& refused, SkdLoop& loop)
{
  std::optional<SkdSplitResult> split = SkdSplitTriangles(segments, side, loop);
  if (!split)
  {
    return 0;
  }
  BeginAtLeast(*segments.GetSide(side).Set, *split);
  const Output to(*segments.GetSide(side).Set, *split, blocks, output);
  to.FillShape(scale);
  if (!blocks.empty())
  {
    to.FillCellData(isComposite, refused);
    to.FillPointData(refused);
  }
  return split->NumberSplit;
}
}
