// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeCellLocator.h"

#include "Cells/Search/SkdLocatorState.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeCellLocator);

namespace
{
/// One value a row, in an array of one component; nothing without an array.
template <class Array, class Value>
void FillColumn(Array* array, vtkIdType number, const Value& value)
{
  if (array)
  {
    array->SetNumberOfComponents(1);
    array->SetNumberOfTuples(number);
    for (vtkIdType i = 0; i < number; ++i)
    {
      array->SetValue(i, value(i));
    }
  }
}

void Clear(vtkIdList* ids, vtkDoubleArray* distances)
{
  ids->Reset();
  if (distances)
  {
    distances->SetNumberOfComponents(1);
    distances->Reset();
  }
}

vtkIdType Fill(
  const std::vector<std::pair<double, vtkIdType>>& found, vtkIdList* ids, vtkDoubleArray* distances)
{
  Clear(ids, distances);
  for (const auto& [dist2, id] : found)
  {
    ids->InsertNextId(id);
    if (distances)
    {
      distances->InsertNextValue(std::sqrt(dist2));
    }
  }
  return ids->GetNumberOfIds();
}

/// As VTK's methods return whether there are any.
int StoreHits(const std::vector<SkdHitCell>& hits, const skd::Segment<3>& segment,
  vtkPoints* points, vtkIdList* cellIds)
{
  if (points)
  {
    points->Reset();
  }
  if (cellIds)
  {
    cellIds->Reset();
  }
  for (const SkdHitCell& hit : hits)
  {
    if (points)
    {
      points->InsertNextPoint(segment.At(hit.T).X);
    }
    if (cellIds)
    {
      cellIds->InsertNextId(hit.Id);
    }
  }
  return hits.empty() ? 0 : 1;
}

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
vtkSkdTreeCellLocator::vtkSkdTreeCellLocator() = default;
vtkSkdTreeCellLocator::~vtkSkdTreeCellLocator() = default;

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::IntersectWithLine(const double p1[3], const double p2[3], double tol,
  double& t, double x[3], double pcoords[3], int& subId)
{
  vtkIdType cellId;
  return this->IntersectWithLine(p1, p2, tol, t, x, pcoords, subId, cellId, nullptr);
}

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::IntersectWithLine(const double p1[3], const double p2[3], double tol,
  double& t, double x[3], double pcoords[3], int& subId, vtkIdType& cellId)
{
  return this->IntersectWithLine(p1, p2, tol, t, x, pcoords, subId, cellId, nullptr);
}

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::IntersectWithLine(const double p1[3], const double p2[3], double tol,
  double& t, double x[3], double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell)
{
  const SkdCellTree& tree = this->GetTree();
  const SkdCellSource source{ this->DataSet, cell };
  const SkdHitCell hit = tree.FindFirstHit(this->Impl->ToTree(p1, p2), tol, source);
  cellId = hit.Id;
  if (hit.Id < 0)
  {
    return 0;
  }
  t = hit.T;
  subId = hit.SubId;
  const skd::Vector3 point = skd::Lerp(SkdVector(p1), SkdVector(p2), t);
  const skd::RigidMotion* motion = this->Impl->GetMotion();
  SkdStore(hit.PCoords, pcoords);
  if (motion)
  {
    SkdStore(tree.MovedPCoords(motion, cellId, point, hit.PCoords), pcoords);
  }
  SkdStore(point, x);
  this->Impl->Load(tree, this->UseExistingSearchStructure, this->DataSet, cellId, cell);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::IntersectWithLine(
  const double p1[3], const double p2[3], vtkPoints* points, vtkIdList* cellIds)
{
  return this->IntersectWithLine(p1, p2, 0.0, points, cellIds);
}

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::IntersectWithLine(
  const double p1[3], const double p2[3], const double tol, vtkPoints* points, vtkIdList* cellIds)
{
  return StoreHits(this->GetTree().FindHits(this->Impl->ToTree(p1, p2), tol, { this->DataSet }),
    { SkdVector(p1), SkdVector(p2) }, points, cellIds);
}

//------------------------------------------------------------------------------
int vtkSkdTreeCellLocator::IntersectWithLine(const double p1[3], const double p2[3],
  const double tol, vtkPoints* points, vtkIdList* cellIds, vtkGenericCell* cell)
{
  if (cell)
  {
    return this->IntersectWithLine(p1, p2, tol, points, cellIds);
  }
  const skd::Segment<3> segment{ SkdVector(p1), SkdVector(p2) };
  return StoreHits(this->GetTree().FindBoundsHits(segment, tol, this->Impl->GetMotion()), segment,
    points, cellIds);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCrossings(const double p1[3], const double p2[3],
  vtkDoubleArray* parameters, vtkPoints* points, vtkCellArray* incidentCells, vtkIdTypeArray* kinds)
{
  const SkdCrossings& crossings =
    this->GetTree().FindCrossings(this->Impl->ToTree(p1, p2), { this->DataSet });
  const auto number = static_cast<vtkIdType>(crossings.List.size());
  const auto at = [&](vtkIdType i) -> const SkdCrossing&
  { return crossings.List[static_cast<std::size_t>(i)]; };
  if (points)
  {
    points->SetNumberOfPoints(number);
    for (vtkIdType i = 0; i < number; ++i)
    {
      points->SetPoint(i, skd::Lerp(SkdVector(p1), SkdVector(p2), at(i).T).X);
    }
  }
  if (incidentCells)
  {
    incidentCells->Reset();
    for (const SkdCrossing& crossing : crossings.List)
    {
      incidentCells->InsertNextCell(static_cast<vtkIdType>(crossing.Last - crossing.First),
        crossings.Cells.data() + crossing.First);
    }
  }
  FillColumn(parameters, number, [&](vtkIdType i) { return at(i).T; });
  FillColumn(kinds, number, [&](vtkIdType i) { return at(i).Passes ? 1 : 0; });
  return number;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::CountCrossings(const double p1[3], const double p2[3])
{
  const SkdCrossings& crossings =
    this->GetTree().FindCrossings(this->Impl->ToTree(p1, p2), { this->DataSet });
  return static_cast<vtkIdType>(std::count_if(crossings.List.begin(), crossings.List.end(),
    [](const SkdCrossing& crossing) { return crossing.Passes; }));
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindPasses(const double p1[3], const double p2[3],
  vtkDoubleArray* parameters, vtkIdTypeArray* cellIds, vtkIdTypeArray* ways)
{
  const std::vector<SkdPass>& passes =
    this->GetTree().FindPasses(this->Impl->ToTree(p1, p2), { this->DataSet });
  const auto number = static_cast<vtkIdType>(passes.size());
  const auto at = [&](vtkIdType i) -> const SkdPass&
  { return passes[static_cast<std::size_t>(i)]; };
  FillColumn(parameters, number, [&](vtkIdType i) { return at(i).T; });
  FillColumn(cellIds, number, [&](vtkIdType i) { return at(i).Id; });
  FillColumn(ways, number, [&](vtkIdType i) { return at(i).Direction; });
  return number;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::CountPasses(
  const double p1[3], const double p2[3], vtkUnsignedCharArray* reversed, vtkIdType& sum)
{
  const std::vector<SkdPass>& passes =
    this->GetTree().FindPasses(this->Impl->ToTree(p1, p2), { this->DataSet });
  sum = 0;
  for (const SkdPass& pass : passes)
  {
    sum += reversed && reversed->GetValue(pass.Id) != 0 ? -pass.Direction : pass.Direction;
  }
  return static_cast<vtkIdType>(passes.size());
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindClosestPoint(
  const double x[3], double closestPoint[3], vtkIdType& cellId, int& subId, double& dist2)
{
  this->FindClosestPoint(x, closestPoint, nullptr, cellId, subId, dist2);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindClosestPoint(const double x[3], double closestPoint[3],
  vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2)
{
  double point[3] = { x[0], x[1], x[2] };
  int inside;
  this->FindClosestPointWithinRadius(
    point, vtkMath::Inf(), closestPoint, cell, cellId, subId, dist2, inside);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindClosestPointWithinRadius(
  double x[3], double radius, double closestPoint[3], vtkIdType& cellId, int& subId, double& dist2)
{
  int inside;
  return this->FindClosestPointWithinRadius(
    x, radius, closestPoint, nullptr, cellId, subId, dist2, inside);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindClosestPointWithinRadius(double x[3], double radius,
  double closestPoint[3], vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2)
{
  int inside;
  return this->FindClosestPointWithinRadius(
    x, radius, closestPoint, cell, cellId, subId, dist2, inside);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindClosestPointWithinRadius(double x[3], double radius,
  double closestPoint[3], vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2,
  int& inside)
{
  const SkdCellTree& tree = this->GetTree();
  cellId = -1;
  inside = 0;
  if (!(radius >= 0.0))
  {
    return 0;
  }
  const SkdCellSource source{ this->DataSet, cell };
  const SkdFoundCell found = tree.FindNearest(this->Impl->ToTree(x), radius * radius, source);
  if (found.Id < 0)
  {
    return 0;
  }
  cellId = found.Id;
  subId = found.SubId;
  dist2 = found.Dist2;
  inside = found.ProjectsInside || found.Dist2 <= tree.Rounding() * tree.Rounding() ? 1 : 0;
  SkdStore(this->Impl->ToWorld(found.Point), closestPoint);
  this->Impl->Load(tree, this->UseExistingSearchStructure, this->DataSet, cellId, cell);
  return 1;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindClosestCells(
  const double x[3], int k, vtkIdList* cellIds, vtkDoubleArray* distances)
{
  const auto number = static_cast<std::size_t>(std::max(k, 0));
  const auto& found = this->GetTree().FindNearestCells(
    this->Impl->ToTree(x), number, vtkMath::Inf(), { this->DataSet });
  return Fill(found, cellIds, distances);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCellsWithinRadius(
  const double x[3], double radius, vtkIdList* cellIds, vtkDoubleArray* distances)
{
  const SkdCellTree& tree = this->GetTree();
  const double limit2 = radius >= 0.0 ? radius * radius : -1.0;
  auto& found = tree.FindNearestCells(
    this->Impl->ToTree(x), tree.Cells().NumberOfCells(), limit2, { this->DataSet });
  std::sort(
    found.begin(), found.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return Fill(found, cellIds, distances);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCell(double x[3])
{
  return this->FindCell(x, 0.0);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCell(double x[3], double tol2)
{
  const SkdCellSource source{ this->DataSet };
  return this->GetTree().FindContaining(this->Impl->ToTree(x), tol2, -1, source).Id;
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCell(
  double x[3], double tol2, vtkGenericCell* cell, double pcoords[3], double* weights)
{
  int subId;
  return this->FindCellWithHint(x, tol2, -1, cell, subId, pcoords, weights);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCell(
  double x[3], double tol2, vtkGenericCell* cell, int& subId, double pcoords[3], double* weights)
{
  return this->FindCellWithHint(x, tol2, -1, cell, subId, pcoords, weights);
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCellWithHint(double x[3], double tol2, vtkIdType hint,
  vtkGenericCell* cell, int& subId, double pcoords[3], double* weights)
{
  const SkdCellTree& tree = this->GetTree();
  const SkdCellSource source{ this->DataSet, cell };
  SkdFoundCell found = tree.FindContaining(this->Impl->ToTree(x), tol2, hint, source);
  if (found.Id < 0)
  {
    return -1;
  }
  tree.Interpolate(found, weights, source);
  subId = found.SubId;
  const skd::Vector3 point = this->Impl->ToWorld(found.Point);
  SkdStore(tree.MovedPCoords(this->Impl->GetMotion(), found.Id, point, found.PCoords), pcoords);
  this->Impl->Load(tree, this->UseExistingSearchStructure, this->DataSet, found.Id, cell);
  return found.Id;
}

#if VTK_SKD_LOCATOR_97

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindCell(double x[3], vtkCell*, vtkGenericCell* genericCell,
  vtkIdType cellId, double tol2, int& subId, double pcoords[3], double* weights)
{
  return this->FindCellWithHint(x, tol2, cellId, genericCell, subId, pcoords, weights);
}
#endif

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
  const SkdCellSource source{ this->DataSet };
  this->GetTree().FindBorders(segment, tolerance, source, borders);
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  parameters->SetNumberOfTuples(static_cast<vtkIdType>(borders.size()));
  std::copy(borders.begin(), borders.end(), parameters->GetPointer(0));
  return parameters->GetNumberOfTuples();
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindCellsWithinBounds(double* bbox, vtkIdList* cells)
{
  const skd::Box3 box({ { bbox[0], bbox[2], bbox[4] } }, { { bbox[1], bbox[3], bbox[5] } });
  this->GetTree().FindWithinBounds(box, this->Impl->GetMotion(), cells);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindCellsAlongLine(
  const double p1[3], const double p2[3], double tolerance, vtkIdList* cells)
{
  this->IntersectWithLine(p1, p2, tolerance, nullptr, cells, nullptr);
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::FindCellsAlongPlane(
  const double o[3], const double n[3], double tolerance, vtkIdList* cells)
{
  this->GetTree().FindAlongPlane(SkdPlane(o, n), tolerance, this->Impl->GetMotion(), cells);
}

//------------------------------------------------------------------------------
#if VTK_SKD_LOCATOR_97
bool vtkSkdTreeCellLocator::InsideCellBounds(double x[3], vtkIdType cellId, double tol)
{
#else
bool vtkSkdTreeCellLocator::InsideCellBounds(double x[3], vtkIdType cellId)
{
  constexpr double tol = 0.0;
#endif
  return this->GetTree().BoundsHold(SkdVector(x), cellId, tol, this->Impl->GetMotion());
}

//------------------------------------------------------------------------------
void vtkSkdTreeCellLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
