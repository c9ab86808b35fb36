// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Probe/SkdCellFinder.h"

#include "Pipeline/SkdBlocks.h"
#include "vtkBoundingBox.h"
#include "vtkGenericCell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
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
  , NextWeights(this->Weights.size())
{
}

bool SkdCellFinder::Find(const double x[3])
{
  this->Location = SkdCellLocation();
  return this->FindWithin(x) || this->FindByTolerance(x) || this->FindOutside(x);
}

// Without a hint, although it would halve the search along a line: the cell of the last point would
// be preferred to a lower one that also contains this point, so answers would depend on previous
// queries and on threads.
bool SkdCellFinder::FindWithin(const double x[3])
{
  double query[3] = { x[0], x[1], x[2] };
  SkdCellLocation& location = this->Location;
  for (std::size_t block = 0; block < this->Source.Blocks.size(); ++block)
  {
    vtkSkdTreeCellLocator* locator = this->Source.Trees.GetLocator(static_cast<int>(block));
    location.CellId = locator->FindCell(
      query, 0.0, nullptr, location.SubId, location.PCoords, this->Weights.data());
    if (location.CellId >= 0)
    {
      location.Block = static_cast<int>(block);
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
  bool isComplete = false;
  for (std::size_t block = 0; block < this->Source.Blocks.size(); ++block)
  {
    this->FindTolerated(static_cast<int>(block), x, isComplete);
  }
  return this->Location.Block >= 0 &&
    (isComplete ? this->Finish() : this->Evaluate(this->Location.Block, this->Location.CellId, x));
}

// The tolerance of the nearest cell may be too small for x although that of a larger cell is not.
void SkdCellFinder::FindTolerated(int block, const double x[3], bool& isComplete)
{
  SkdCellLocation& best = this->Location;
  const auto isBetter = [&](vtkIdType id, double distance) {
    return (best.Block < 0 || distance < best.Distance) && this->IsTolerated(block, id, distance);
  };
  const double tolerance = this->Source.GetLargestTolerance(this->Rules, block);
  double dist2;
  if (!(tolerance > 0.0) || !this->FindNext(block, x, tolerance, dist2))
  {
    return;
  }
  if (this->IsTolerated(block, this->Next.CellId, this->Next.Distance))
  {
    if (isBetter(this->Next.CellId, this->Next.Distance))
    {
      this->TakeNext();
      isComplete = true;
    }
    return;
  }
  this->Source.Trees.GetLocator(block)->FindCellsWithinRadius(
    x, tolerance, this->Near, this->Distances);
  for (vtkIdType i = 0; i < this->Near->GetNumberOfIds(); ++i)
  {
    const vtkIdType id = this->Near->GetId(i);
    const double distance = this->Distances->GetValue(i);
    if (isBetter(id, distance))
    {
      best.Block = block;
      best.CellId = id;
      best.Distance = distance;
      isComplete = false;
    }
  }
}

bool SkdCellFinder::FindOutside(const double x[3])
{
  double radius = this->Rules.OutsideRadius;
  double least2 = std::numeric_limits<double>::infinity();
  for (std::size_t block = 0; block < this->Source.Blocks.size(); ++block)
  {
    double dist2;
    if (this->FindNext(static_cast<int>(block), x, radius, dist2) && dist2 < least2)
    {
      least2 = dist2;
      radius = std::min(radius, SkdRadiusIncluding(dist2));
      this->TakeNext();
    }
  }
  return this->Location.Block >= 0 && this->Finish();
}

bool SkdCellFinder::FindNext(int block, const double x[3], double radius, double& dist2)
{
  double point[3];
  SkdCellLocation& next = this->Next;
  next.Block = block;
  next.CellId = this->Source.Trees.GetLocator(block)->FindClosestLocation(
    x, radius, point, next.SubId, next.PCoords, dist2, this->NextWeights.data());
  next.Distance = next.CellId < 0 ? 0.0 : std::sqrt(dist2);
  return next.CellId >= 0;
}

void SkdCellFinder::TakeNext()
{
  this->Location = this->Next;
  this->Weights.swap(this->NextWeights);
}

bool SkdCellFinder::Evaluate(int block, vtkIdType cellId, const double x[3])
{
  double point[3], dist2;
  SkdCellLocation location;
  location.Block = block;
  location.CellId = cellId;
  if (!this->Source.Trees.GetLocator(block)->EvaluateCell(
        cellId, x, point, location.SubId, location.PCoords, dist2, this->Weights.data()))
  {
    this->Location = SkdCellLocation();
    return false;
  }
  location.Distance = std::sqrt(dist2);
  this->Location = location;
  return this->Finish();
}

bool SkdCellFinder::Finish()
{
  this->Source.Blocks[this->Location.Block].Mesh->GetCellPoints(
    this->Location.CellId, this->PointIds);
  return true;
}

bool SkdCellFinder::IsInVolume() const
{
  thread_local vtkNew<vtkGenericCell> cell;
  cell->SetCellType(
    this->Source.Blocks[this->Location.Block].Mesh->GetCellType(this->Location.CellId));
  return cell->GetCellDimension() == 3;
}
}
