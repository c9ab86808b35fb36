// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe/SkdCellFinder.h"

#include "Pipeline/SkdBlocks.h"
#include "vtkBoundingBox.h"
#include "vtkGenericCell.h"

#include <algorithm>
#include <cmath>

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
  double largest = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const double diagonal = DiagonalOf(mesh, cell);
    largest = std::isfinite(diagonal) ? std::max(largest, diagonal) : largest;
  }
  return largest;
}
}

SkdCellFinderSource::SkdCellFinderSource(
  const SkdSourceTrees& trees, const std::vector<SkdBlock>& blocks)
  : Trees(trees)
  , Blocks(blocks)
{
}

void SkdCellFinderSource::Update(int built)
{
  for (const SkdBlock& block : this->Blocks)
  {
    SkdTouchCells(block.Mesh);
  }
  if (built == 0 && this->LargestCells.size() == this->Blocks.size())
  {
    return;
  }
  this->LargestCells.clear();
  this->MaxCellSize = 0;
  for (const SkdBlock& block : this->Blocks)
  {
    this->LargestCells.push_back(std::make_unique<LargestCell>());
    this->MaxCellSize = std::max(this->MaxCellSize, block.Mesh->GetMaxCellSize());
  }
}

// By one thread while others wait: a nested parallel loop might execute work that waits for it.
double SkdCellFinderSource::GetLargestTolerance(const SkdCellFinderRules& rules, int block) const
{
  if (!(rules.RelativeTolerance > 0.0))
  {
    return rules.AbsoluteTolerance;
  }
  LargestCell& largest = *this->LargestCells[block];
  std::call_once(
    largest.IsKnown, [&]() { largest.Diagonal = LargestDiagonal(this->Blocks[block].Mesh); });
  return std::max(rules.AbsoluteTolerance, rules.RelativeTolerance * largest.Diagonal);
}

SkdCellFinder::SkdCellFinder(const SkdCellFinderSource& source, const SkdCellFinderRules& rules)
  : Source(source)
  , Rules(rules)
  , Weights(std::max(source.MaxCellSize, 1))
{
}

bool SkdCellFinder::Find(const double x[3])
{
  this->Place = SkdCellLocation();
  return this->FindWithin(x) || this->FindByTolerance(x) || this->FindOutside(x);
}

// Without a hint, although it would halve the search along a line: the cell of the last point would
// be preferred to a lower one that also contains this point, so answers would depend on previous
// queries and on threads.
bool SkdCellFinder::FindWithin(const double x[3])
{
  double asked[3] = { x[0], x[1], x[2] };
  SkdCellLocation& place = this->Place;
  for (std::size_t block = 0; block < this->Source.Blocks.size(); ++block)
  {
    vtkSkdTreeCellLocator* locator = this->Source.Trees.GetLocator(static_cast<int>(block));
    place.CellId =
      locator->FindCell(asked, 0.0, nullptr, place.SubId, place.PCoords, this->Weights.data());
    if (place.CellId >= 0)
    {
      place.Block = static_cast<int>(block);
      return this->Finish();
    }
  }
  return false;
}

bool SkdCellFinder::IsTolerated(int block, vtkIdType cell, double distance) const
{
  return distance <= this->Rules.AbsoluteTolerance ||
    distance <= this->Rules.RelativeTolerance * DiagonalOf(this->Source.Blocks[block].Mesh, cell);
}

bool SkdCellFinder::FindByTolerance(const double x[3])
{
  SkdCellLocation best;
  for (std::size_t block = 0; block < this->Source.Blocks.size(); ++block)
  {
    this->FindTolerated(static_cast<int>(block), x, best);
  }
  return best.Block >= 0 && this->Evaluate(best.Block, best.CellId, x);
}

// The tolerance of the nearest cell may be too small for x although that of a larger cell is not.
void SkdCellFinder::FindTolerated(int block, const double x[3], SkdCellLocation& best)
{
  double asked[3] = { x[0], x[1], x[2] };
  const double reach = this->Source.GetLargestTolerance(this->Rules, block);
  vtkSkdTreeCellLocator* locator = this->Source.Trees.GetLocator(block);
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
    if ((best.Block < 0 || distance < best.Distance) && this->IsTolerated(block, id, distance))
    {
      best.Block = block;
      best.CellId = id;
      best.Distance = distance;
    }
  };
  if (this->IsTolerated(block, cell, std::sqrt(dist2)))
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

bool SkdCellFinder::FindOutside(const double x[3])
{
  if (!(this->Rules.OutsideRadius >= 0.0))
  {
    return false;
  }
  const auto nearest = this->Source.Trees.FindNearest(x, this->Rules.OutsideRadius);
  return nearest && this->Evaluate(nearest->Block, nearest->CellId, x);
}

bool SkdCellFinder::Evaluate(int block, vtkIdType cellId, const double x[3])
{
  double point[3], dist2;
  SkdCellLocation place;
  place.Block = block;
  place.CellId = cellId;
  if (!this->Source.Trees.GetLocator(block)->EvaluateCell(
        cellId, x, point, place.SubId, place.PCoords, dist2, this->Weights.data()))
  {
    this->Place = SkdCellLocation();
    return false;
  }
  place.Distance = std::sqrt(dist2);
  this->Place = place;
  return this->Finish();
}

bool SkdCellFinder::Finish()
{
  this->Source.Blocks[this->Place.Block].Mesh->GetCellPoints(this->Place.CellId, this->PointIds);
  return true;
}

bool SkdCellFinder::IsInVolume() const
{
  thread_local vtkNew<vtkGenericCell> cell;
  cell->SetCellType(this->Source.Blocks[this->Place.Block].Mesh->GetCellType(this->Place.CellId));
  return cell->GetCellDimension() == 3;
}
