// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdSpreadSource.h"


#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
/// Rounding of distances between points of some coordinates, in units in the last place.
constexpr double UnitsInTheLastPlace = 16.0;

double RoundingAt(double coordinate)
{
  return UnitsInTheLastPlace * std::numeric_limits<double>::epsilon() * coordinate;
}

double LargestOf(const skd::Vector3& x)
{
  return std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
}

/// Squared, from a point to a box inflated by a margin.
double GapOf(const skd::Box3& box, const skd::Vector3& x, double margin)
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double gap =
      std::max({ box.Min[axis] - x[axis] - margin, x[axis] - box.Max[axis] - margin, 0.0 });
    sum += gap * gap;
  }
  return sum;
}
}

vtkDataObject* SkdSpreadSource::Update(
  std::unique_ptr<SkdTransport> transport, vtkDataObject* piece)
{
  this->Transport = std::move(transport);
  const vtkSmartPointer<vtkDataObject> own = this->Pieces.UpdateOwn(*this->Transport, piece);
  if (own != this->Own)
  {
    this->Own = own;
    this->ListBlocks();
  }
  return own;
}

void SkdSpreadSource::ListBlocks()
{
  this->Blocks.clear();
  this->Ids.clear();
  this->NumberOfCells = 0;
  const std::vector<SkdBlock> blocks = SkdBlocksOf(this->Own); // in the order of their places
  std::vector<skd::Box3> boxes;
  std::size_t at = 0;
  this->Pieces.VisitBlocks(
    [&](const SkdSpreadBlock& block)
    {
      if (block.GetNumberOfCells() > 0)
      {
        this->Blocks.push_back(blocks[at]);
        this->Ids.emplace_back(blocks[at].Mesh);
        this->NumberOfCells += block.GetNumberOfCells();
        boxes.insert(boxes.end(), block.GetBoxes().begin(), block.GetBoxes().end());
      }
      ++at;
    });
  this->Cut = std::make_unique<SkdCut>(*this->Transport, std::move(boxes));
}

int SkdSpreadSource::PlaceOf(int blockIndex) const
{
  const auto found = std::find_if(this->Blocks.begin(), this->Blocks.end(),
    [blockIndex](const SkdBlock& block) { return block.BlockIndex == blockIndex; });
  return static_cast<int>(found - this->Blocks.begin());
}

void SkdSpreadSource::ListNear(
  const skd::Vector3& x, double radius, std::vector<SkdNearProcess>& near) const
{
  const std::vector<skd::Box3>& boxes = this->Cut->GetBoxes();
  const std::vector<int>& owners = this->Cut->GetOwners();
  const double limit2 = radius * radius;
  std::size_t at = 0;
  for (int process = 0; process < this->Cut->GetNumberOfProcesses(); ++process)
  {
    const skd::Box3& bounds = this->Cut->GetBounds(process);
    const double margin = RoundingAt(std::max(LargestOf(x), skd::LargestCoordinate(bounds)));
    double nearest2 = std::numeric_limits<double>::infinity();
    const bool isDue = process != this->Transport->GetRank() && !bounds.IsEmpty() &&
      GapOf(bounds, x, margin) <= limit2;
    for (; at < boxes.size() && owners[at] == process; ++at)
    {
      nearest2 = isDue ? std::min(nearest2, GapOf(boxes[at], x, margin)) : nearest2;
    }
    if (isDue && nearest2 <= limit2)
    {
      near.push_back({ process, nearest2 });
    }
  }
}

// Some cells are in several processes' trees, but none of those that are left out.
SkdTreeCounts SkdSpreadSource::CountAll(const SkdTreeCounts& own) const
{
  SkdTreeCounts all;
  for (const std::vector<SkdTreeCounts>& told :
    SkdGatherRows(*this->Transport, std::vector<SkdTreeCounts>{ own }))
  {
    all.CellsLeftOut += told.front().CellsLeftOut;
    all.Tolerance = std::max(all.Tolerance, told.front().Tolerance);
  }
  all.Cells = this->NumberOfCells - all.CellsLeftOut;
  return all;
}
