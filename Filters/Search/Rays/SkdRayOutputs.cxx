// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdRayOutputs.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "Search/Rays/SkdSurfaceNormals.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
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
constexpr const char* CountName = "SkdRayHits";
constexpr const char* DistanceName = "SkdRayDistance";
constexpr const char* PointName = "SkdRayHitPoint";
constexpr const char* CellIdName = "SkdRayCellId";
constexpr const char* SideName = "SkdRaySide";
constexpr const char* BlockName = "SkdRayBlockIndex";
constexpr const char* StartName = "SkdRayStartId";

bool IsOurs(const std::string& name)
{
  const auto names = { CountName, DistanceName, PointName, CellIdName, SideName, BlockName };
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The arrays that describe hits, one a tuple; initially none.
class HitArrays
{
public:
  explicit HitArrays(vtkIdType n)
    : Distances(SkdMakeArray<vtkDoubleArray>(DistanceName, 1, n, vtkMath::Nan()))
    , Points(SkdMakeArray<vtkDoubleArray>(PointName, 3, n, vtkMath::Nan()))
    , CellIds(SkdMakeArray<vtkIdTypeArray>(CellIdName, 1, n, -1))
    , Sides(SkdMakeArray<vtkIntArray>(SideName, 1, n, 0))
    , Blocks(static_cast<std::size_t>(n), -1)
  {
  }

  /// Thread-safe for distinct i.
  void Set(vtkIdType i, const SkdCastRays& rays, vtkIdType ray, const SkdRayHit& hit,
    const SkdRayTarget& target)
  {
    const skd::Vector3 point = rays.PointOf(ray, hit);
    const double sign = std::signbit(hit.Distance) ? -1.0 : 1.0;
    const double along = sign *
      skd::Dot(SkdNormalOfCell(target.Trees.GetMesh(hit.Block), hit.CellId, point),
        rays.Starts.Directions[static_cast<std::size_t>(ray)]);
    this->Distances->SetValue(i, hit.Distance);
    this->Points->SetTypedTuple(i, point.X);
    this->CellIds->SetValue(i, hit.CellId);
    this->Sides->SetValue(i, (along < 0.0) - (along > 0.0));
    this->Blocks[static_cast<std::size_t>(i)] = hit.Block;
  }

  void AddTo(vtkDataSetAttributes* data, const SkdRayTarget& target, bool hasPoints) const
  {
    SkdJoinIds(this->CellIds, this->Blocks, target.Blocks);
    data->AddArray(this->Distances);
    if (hasPoints)
    {
      data->AddArray(this->Points);
    }
    data->AddArray(this->CellIds);
    data->AddArray(this->Sides);
    if (target.IsComposite)
    {
      data->AddArray(SkdMakeBlockIndices(BlockName, this->Blocks, target.Blocks));
    }
    data->SetActiveScalars(DistanceName);
  }

  const double* GetPoint(vtkIdType i) const { return this->Points->GetPointer(3 * i); }

private:
  vtkSmartPointer<vtkDoubleArray> Distances;
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkSmartPointer<vtkIdTypeArray> CellIds;
  vtkSmartPointer<vtkIntArray> Sides;
  std::vector<int> Blocks;
};

/// Where the rays of each data set begin in a list of the hits of all.
std::vector<vtkIdType> FirstHitsOf(const std::vector<SkdCastRays>& rays)
{
  std::vector<vtkIdType> first{ 0 };
  for (const SkdCastRays& cast : rays)
  {
    first.push_back(first.back() + cast.Lists.GetNumberOfHits());
  }
  return first;
}

/// Adds the data of the starts that `all` hits come from: which of them, and their arrays.
void AddStarts(vtkDataSetAttributes* data, const std::vector<SkdCastRays>& rays,
  const std::vector<vtkDataSetAttributes*>& starts, const std::vector<vtkIdType>& first)
{
  const std::string ghosts = vtkDataSetAttributes::GhostArrayName();
  SkdArrayGather gather(starts,
    [&](vtkAbstractArray* array)
    {
      const std::string name = array->GetName() ? array->GetName() : "";
      return name != ghosts && !IsOurs(name);
    });
  gather.Allocate(first.back());
  auto ids = SkdMakeArray<vtkIdTypeArray>(StartName, 1, first.back());
  for (std::size_t block = 0; block < rays.size(); ++block)
  {
    SkdForEach(rays[block].Starts.GetNumber(),
      [&](vtkIdType ray)
      {
        const auto& lists = rays[block].Lists;
        const vtkIdType from = first[block] + lists.GetStart(ray);
        for (vtkIdType hit = from; hit < from + lists.GetNumberOfHits(ray); ++hit)
        {
          gather.Take(hit, static_cast<int>(block), ray);
          ids->SetValue(hit, ray);
        }
      });
  }
  gather.AddTo(data);
  data->AddArray(ids);
}

/// Points of the hits, or of the starts and hits in turn, and the cells on them.
void AddGeometry(vtkPolyData* output, const std::vector<SkdCastRays>& rays, const HitArrays& hits,
  vtkIdType number, bool areLines)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  points->SetDataTypeToDouble();
  if (areLines)
  {
    vtkIdType hit = 0;
    for (const SkdCastRays& cast : rays)
    {
      for (vtkIdType ray = 0; ray < cast.Starts.GetNumber(); ++ray)
      {
        const vtkIdType end = hit + cast.Lists.GetNumberOfHits(ray);
        for (; hit < end; ++hit)
        {
          const auto& start = cast.Starts.Points[static_cast<std::size_t>(ray)];
          const vtkIdType from = points->InsertNextPoint(start.X);
          cells->InsertNextCell({ from, points->InsertNextPoint(hits.GetPoint(hit)) });
        }
      }
    }
  }
  else
  {
    for (vtkIdType hit = 0; hit < number; ++hit)
    {
      cells->InsertNextCell({ points->InsertNextPoint(hits.GetPoint(hit)) });
    }
  }
  output->SetPoints(points);
  areLines ? output->SetLines(cells) : output->SetVerts(cells);
}
}

//------------------------------------------------------------------------------
void SkdAddHitCounts(vtkDataSetAttributes* data, const SkdCastRays& rays)
{
  const vtkIdType n = rays.Starts.GetNumber();
  auto counts = SkdMakeArray<vtkIdTypeArray>(CountName, 1, n);
  SkdForEach(n, [&](vtkIdType i) { counts->SetValue(i, rays.Lists.GetNumberOfHits(i)); });
  data->AddArray(counts);
  data->SetActiveScalars(CountName);
}

//------------------------------------------------------------------------------
void SkdAddFirstHits(
  vtkDataSetAttributes* data, const SkdCastRays& rays, const SkdRayTarget& target)
{
  HitArrays arrays(rays.Starts.GetNumber());
  SkdForEach(rays.Starts.GetNumber(),
    [&](vtkIdType ray)
    {
      if (const SkdRayHit* hit = rays.Lists.GetFirst(ray))
      {
        arrays.Set(ray, rays, ray, *hit, target);
      }
    });
  arrays.AddTo(data, target, true);
}

//------------------------------------------------------------------------------
std::vector<SkdCastRays> SkdListedRays(
  std::vector<SkdCastRays> rays, const std::vector<std::vector<unsigned char>>& listed)
{
  for (std::size_t block = 0; block < listed.size(); ++block)
  {
    SkdRayHitLists lists;
    for (std::size_t ray = 0; ray < listed[block].size(); ++ray)
    {
      const SkdRayHitLists::Row hits = rays[block].Lists[ray];
      lists.Add(hits.begin(), listed[block][ray] ? hits.end() : hits.begin());
    }
    if (!listed[block].empty())
    {
      rays[block].Lists = std::move(lists);
    }
  }
  return rays;
}

//------------------------------------------------------------------------------
void SkdFillHits(vtkPolyData* output, const std::vector<SkdCastRays>& rays,
  const std::vector<vtkDataSetAttributes*>& starts, const SkdRayTarget& target, bool areLines)
{
  const std::vector<vtkIdType> first = FirstHitsOf(rays);
  HitArrays arrays(first.back());
  for (std::size_t block = 0; block < rays.size(); ++block)
  {
    const SkdCastRays& cast = rays[block];
    SkdForEach(cast.Starts.GetNumber(),
      [&](vtkIdType ray)
      {
        vtkIdType to = first[block] + cast.Lists.GetStart(ray);
        for (const SkdRayHit& hit : cast.Lists[static_cast<std::size_t>(ray)])
        {
          arrays.Set(to++, cast, ray, hit, target);
        }
      });
  }
  AddGeometry(output, rays, arrays, first.back(), areLines);
  vtkDataSetAttributes* data =
    areLines ? static_cast<vtkDataSetAttributes*>(output->GetCellData()) : output->GetPointData();
  AddStarts(data, rays, starts, first);
  arrays.AddTo(data, target, areLines);
}
}
