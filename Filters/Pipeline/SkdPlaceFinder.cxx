// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdPlaceFinder.h"

#include "Pipeline/SkdTouchCells.h"
#include "vtkBoundingBox.h"
#include "vtkGenericCell.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
double DiagonalOf(vtkDataSet* mesh, vtkIdType cell)
{
  double bounds[6];
  mesh->GetCellBounds(cell, bounds);
  const vtkBoundingBox box(bounds);
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

double LargestDiagonal(vtkDataSet* mesh)
{
  vtkSMPThreadLocal<double> largest(0.0);
  vtkSMPTools::For(0, mesh->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      double& mine = largest.Local();
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const double diagonal = DiagonalOf(mesh, cell);
        mine = std::isfinite(diagonal) ? std::max(mine, diagonal) : mine;
      }
    });
  return std::accumulate(
    largest.begin(), largest.end(), 0.0, [](double a, double b) { return std::max(a, b); });
}
}

SkdPlaceSource::SkdPlaceSource(const SkdSourceTrees& trees, const std::vector<SkdLeaf>& leaves)
  : Trees(trees)
  , Leaves(leaves)
{
}

void SkdPlaceSource::MeasureCells()
{
  this->LargestCells.clear();
  this->MaxCellSize = 0;
  for (const SkdLeaf& leaf : this->Leaves)
  {
    SkdTouchCells(leaf.Mesh);
    this->LargestCells.push_back(LargestDiagonal(leaf.Mesh));
    this->MaxCellSize = std::max(this->MaxCellSize, leaf.Mesh->GetMaxCellSize());
  }
}

SkdPlaceFinder::SkdPlaceFinder(const SkdPlaceSource& source, const SkdPlaceRules& rules)
  : Source(source)
  , Rules(rules)
  , Weights(std::max(source.MaxCellSize, 1))
{
}

bool SkdPlaceFinder::Find(const double x[3])
{
  this->Place = SkdPlace();
  return this->FindWithin(x) || this->FindByTolerance(x) || this->FindOutside(x);
}

bool SkdPlaceFinder::FindWithin(const double x[3])
{
  double asked[3] = { x[0], x[1], x[2] };
  SkdPlace& place = this->Place;
  for (std::size_t leaf = 0; leaf < this->Source.Leaves.size(); ++leaf)
  {
    vtkSkdTreeCellLocator* locator = this->Source.Trees.GetLocator(static_cast<int>(leaf));
    place.CellId =
      locator->FindCell(asked, 0.0, nullptr, place.SubId, place.PCoords, this->Weights.data());
    if (place.CellId >= 0)
    {
      place.Leaf = static_cast<int>(leaf);
      return this->Finish();
    }
  }
  return false;
}

double SkdPlaceFinder::LargestTolerance(int leaf) const
{
  return std::max(
    this->Rules.AbsoluteTolerance, this->Rules.RelativeTolerance * this->Source.LargestCells[leaf]);
}

bool SkdPlaceFinder::IsTolerated(int leaf, vtkIdType cell, double distance) const
{
  return distance <= this->Rules.AbsoluteTolerance ||
    distance <= this->Rules.RelativeTolerance * DiagonalOf(this->Source.Leaves[leaf].Mesh, cell);
}

bool SkdPlaceFinder::FindByTolerance(const double x[3])
{
  SkdPlace best;
  for (std::size_t leaf = 0; leaf < this->Source.Leaves.size(); ++leaf)
  {
    this->FindTolerated(static_cast<int>(leaf), x, best);
  }
  return best.Leaf >= 0 && this->Evaluate(best.Leaf, best.CellId, x);
}

// The nearest cell may be too small for its tolerance to reach x where that of a larger one does.
void SkdPlaceFinder::FindTolerated(int leaf, const double x[3], SkdPlace& best)
{
  double asked[3] = { x[0], x[1], x[2] };
  const double reach = this->LargestTolerance(leaf);
  vtkSkdTreeCellLocator* locator = this->Source.Trees.GetLocator(leaf);
  double point[3], dist2;
  vtkIdType cell;
  int subId;
  if (!(reach > 0.0) ||
    !locator->FindClosestPointWithinRadius(asked, reach, point, nullptr, cell, subId, dist2))
  {
    return;
  }
  const auto offer = [&](vtkIdType id, double distance)
  {
    if ((best.Leaf < 0 || distance < best.Distance) && this->IsTolerated(leaf, id, distance))
    {
      best.Leaf = leaf;
      best.CellId = id;
      best.Distance = distance;
    }
  };
  if (this->IsTolerated(leaf, cell, std::sqrt(dist2)))
  {
    offer(cell, std::sqrt(dist2));
    return;
  }
  locator->FindCellsWithinRadius(x, reach, this->Near, this->Distances);
  for (vtkIdType i = 0; i < this->Near->GetNumberOfIds(); ++i)
  {
    offer(this->Near->GetId(i), this->Distances->GetValue(i));
  }
}

bool SkdPlaceFinder::FindOutside(const double x[3])
{
  if (!(this->Rules.OutsideRadius >= 0.0))
  {
    return false;
  }
  const auto nearest = this->Source.Trees.FindNearest(x, this->Rules.OutsideRadius);
  return nearest && this->Evaluate(nearest->Leaf, nearest->CellId, x);
}

bool SkdPlaceFinder::Evaluate(int leaf, vtkIdType cellId, const double x[3])
{
  double point[3], dist2;
  SkdPlace place;
  place.Leaf = leaf;
  place.CellId = cellId;
  if (!this->Source.Trees.GetLocator(leaf)->EvaluateCell(
        cellId, x, point, place.SubId, place.PCoords, dist2, this->Weights.data()))
  {
    this->Place = SkdPlace();
    return false;
  }
  place.Distance = std::sqrt(dist2);
  this->Place = place;
  return this->Finish();
}

bool SkdPlaceFinder::Finish()
{
  this->Source.Leaves[this->Place.Leaf].Mesh->GetCellPoints(this->Place.CellId, this->PointIds);
  return true;
}

bool SkdPlaceFinder::IsInVolume() const
{
  thread_local vtkNew<vtkGenericCell> cell;
  cell->SetCellType(this->Source.Leaves[this->Place.Leaf].Mesh->GetCellType(this->Place.CellId));
  return cell->GetCellDimension() == 3;
}
