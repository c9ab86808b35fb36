// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Closest/SkdClosestArrays.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
constexpr const char* ClosestPointName = "SkdClosestPoint";
constexpr const char* DistanceName = "SkdDistance";
constexpr const char* CellIdName = "SkdClosestCellId";
constexpr const char* BlockIndexName = "SkdClosestBlockIndex";
}

bool SkdClosestArrays::IsOurs(const std::string& name)
{
  return name == ClosestPointName || name == DistanceName || name == CellIdName ||
    name == BlockIndexName;
}

SkdClosestArrays::SkdClosestArrays(vtkIdType n)
  : Points(SkdMakeArray<vtkDoubleArray>(ClosestPointName, 3, n, vtkMath::Nan()))
  , Distances(SkdMakeArray<vtkDoubleArray>(DistanceName, 1, n, vtkMath::Nan()))
  , CellIds(SkdMakeArray<vtkIdTypeArray>(CellIdName, 1, n, -1))
  , Blocks(n, -1)
{
}

void SkdClosestArrays::Set(vtkIdType i, const SkdNearest& nearest, bool isInside)
{
  const double distance = std::sqrt(nearest.Distance2);
  std::copy_n(nearest.Point, 3, this->Points->GetPointer(3 * i));
  this->Distances->SetValue(i, isInside ? -distance : distance);
  this->CellIds->SetValue(i, nearest.CellId);
  this->Blocks[i] = nearest.Block;
}

void SkdClosestArrays::SetInside(vtkIdType i, bool isInside)
{
  const double distance = std::abs(this->Distances->GetValue(i));
  this->Distances->SetValue(i, isInside ? -distance : distance);
}

void SkdClosestArrays::AddTo(
  vtkPointData* pointData, const std::vector<SkdBlock>& source, bool isComposite) const
{
  pointData->AddArray(this->Points);
  pointData->AddArray(this->Distances);
  pointData->AddArray(this->CellIds);
  pointData->SetActiveScalars(DistanceName);
  if (isComposite)
  {
    pointData->AddArray(SkdMakeBlockIndices(BlockIndexName, this->Blocks, source));
  }
}

void SkdConnectClosest(const std::vector<SkdBlock>& meshes,
  const std::vector<SkdClosestArrays>& answers,
  const std::vector<std::vector<unsigned char>>& listed, vtkPolyData* lines)
{
  struct Start
  {
    int Mesh;
    vtkIdType Point;
  };
  std::vector<Start> starts;
  std::vector<vtkDataSetAttributes*> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
  {
    data.push_back(meshes[mesh].Mesh->GetPointData());
    const bool areAll = listed.empty() || listed[mesh].empty();
    const std::vector<unsigned char> shown = SkdFindShown(meshes[mesh].Mesh, vtkDataObject::POINT);
    for (vtkIdType i = 0; i < answers[mesh].GetNumberOfPoints(); ++i)
    {
      const bool isListed = (areAll || listed[mesh][static_cast<std::size_t>(i)] != 0) &&
        shown[static_cast<std::size_t>(i)] != 0;
      if (isListed && answers[mesh].GetBlock(i) >= 0)
      {
        double x[3];
        meshes[mesh].Mesh->GetPoint(i, x);
        const vtkIdType from = points->InsertNextPoint(x);
        cells->InsertNextCell({ from, points->InsertNextPoint(answers[mesh].GetPoint(i)) });
        starts.push_back({ static_cast<int>(mesh), i });
      }
    }
  }
  lines->SetPoints(points);
  lines->SetLines(cells);

  const std::string ghosts = vtkDataSetAttributes::GhostArrayName();
  SkdArrayGather gather(data, [&](vtkAbstractArray* array) { return array->GetName() != ghosts; });
  gather.Allocate(static_cast<vtkIdType>(starts.size()));
  SkdForEach(static_cast<vtkIdType>(starts.size()),
    [&](vtkIdType i) { gather.Take(i, starts[i].Mesh, starts[i].Point); });
  gather.AddTo(lines->GetCellData());
  lines->GetCellData()->SetActiveScalars(DistanceName);
}
}
