// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SkdBooleanSurface.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkCellArray.h"
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
using Origin = SkdTriangleSet::Origin;

class Output
{
public:
  Output(const SkdPlacement& placement, const std::array<SkdSplitResult, 2>& split,
    const SkdBooleanResult& result, const SkdBooleanBlocks& blocks, vtkPolyData* output)
    : Sets{ &placement.First, &placement.GetSecond() }
    , Split(split)
    , Result(result)
    , FirstBlock{ 0, static_cast<int>(blocks.Of[0]->size()) }
    , IsComposite(blocks.IsComposite)
    , To(output)
  {
    for (int side = 0; side < 2; ++side)
    {
      this->Blocks.insert(this->Blocks.end(), blocks.Of[side]->begin(), blocks.Of[side]->end());
      this->Origins[side] = this->Sets[side]->GetSet().FindOrigins();
    }
  }

  void FillShape(double scale) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Result.Points.size()));
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, ((1.0 / scale) * this->Result.Points[i].Position).X);
    }
    vtkNew<vtkCellArray> cells;
    for (const SkdBooleanPiece& piece : this->Result.Pieces)
    {
      cells->InsertNextCell({ static_cast<vtkIdType>(piece.Corners[0]),
        static_cast<vtkIdType>(piece.Corners[1]), static_cast<vtkIdType>(piece.Corners[2]) });
    }
    this->To->SetPoints(points);
    this->To->SetPolys(cells);
  }

  void FillCellData(std::set<std::string>& refused) const
  {
    const auto n = static_cast<vtkIdType>(this->Result.Pieces.size());
    auto inputs = SkdMakeArray<vtkIntArray>(SkdBooleanNames::Input, 1, n);
    auto ids = SkdMakeArray<vtkIdTypeArray>(SkdBooleanNames::Cell, 1, n);
    auto blockIndices = SkdMakeArray<vtkIntArray>(SkdBooleanNames::Block, 1, n);
    vtkCellData* data = this->To->GetCellData();
    data->AddArray(inputs);
    data->AddArray(ids);
    if (this->IsComposite)
    {
      data->AddArray(blockIndices);
    }
    SkdArrayGather gather = SkdGatherInto(data, n, this->Blocks, vtkDataObject::CELL, refused);
    for (vtkIdType i = 0; i < n; ++i)
    {
      const SkdBooleanPiece& piece = this->Result.Pieces[i];
      const SkdTriangleSet::Cell& cell = this->CellOf(piece.Side, piece.Parent);
      const int block = this->FirstBlock[piece.Side] + cell.Block;
      inputs->SetValue(i, piece.Side);
      ids->SetValue(i, cell.Id);
      blockIndices->SetValue(i, this->Blocks[block].BlockIndex);
      gather.Take(i, block, cell.Id);
    }
  }

  void FillPointData(std::set<std::string>& refused) const
  {
    const auto n = static_cast<vtkIdType>(this->Result.Points.size());
    SkdArrayGather gather =
      SkdGatherInto(this->To->GetPointData(), n, this->Blocks, vtkDataObject::POINT, refused);
    for (vtkIdType i = 0; gather.GetNumberOfArrays() > 0 && i < n; ++i)
    {
      const SkdBooleanPoint& point = this->Result.Points[i];
      const std::size_t old = this->Sets[point.Side]->GetPoints().size();
      if (point.Local >= old)
      {
        this->Interpolate(i, point.Side, this->Split[point.Side].Points[point.Local - old], gather);
        continue;
      }
      const Origin* origin = this->FindOrigin(point.Side, { point.Local, 0, 0 });
      if (origin)
      {
        gather.Take(i, this->FirstBlock[point.Side] + origin->Block, origin->Id);
      }
    }
  }

private:
  const SkdTriangleSet::Cell& CellOf(int side, std::uint32_t triangle) const
  {
    const SkdTriangleSet& set = this->Sets[side]->GetSet();
    return set.GetCells()[set.GetCellOf(triangle)];
  }

  /// The first at or after one, of the same point.
  const Origin* FindOrigin(int side, const Origin& least) const
  {
    const std::vector<Origin>& all = this->Origins[side];
    const auto at = std::lower_bound(all.begin(), all.end(), least);
    return at != all.end() && at->Point == least.Point ? &*at : nullptr;
  }

  void Interpolate(vtkIdType to, int side, const SkdSplitPoint& point, SkdArrayGather& gather) const
  {
    const int block = this->CellOf(side, point.Parent).Block;
    vtkNew<vtkIdList> ids;
    double weights[3];
    for (int i = 0; i < 3; ++i)
    {
      const Origin* origin = this->FindOrigin(side, { point.Corners[i], block, 0 });
      if (!origin || origin->Block != block)
      {
        return;
      }
      ids->InsertNextId(origin->Id);
      weights[i] = point.Weights[i];
    }
    gather.Interpolate(to, this->FirstBlock[side] + block, ids, weights);
  }

  const std::array<const SkdPlacedTriangles*, 2> Sets;
  const std::array<SkdSplitResult, 2>& Split;
  const SkdBooleanResult& Result;
  const std::array<int, 2> FirstBlock; // of each side
  const bool IsComposite;
  std::vector<SkdBlock> Blocks; // of both
  std::array<std::vector<Origin>, 2> Origins;
  vtkPolyData* To;
};
}

void SkdFillBooleanSurface(const SkdPlacement& placement,
  const std::array<SkdSplitResult, 2>& split, const SkdBooleanResult& result,
  const SkdBooleanBlocks& blocks, vtkPolyData* output, std::set<std::string>& refused)
{
  const Output to(placement, split, result, blocks, output);
  to.FillShape(placement.Scale);
  to.FillCellData(refused);
  to.FillPointData(refused);
}
