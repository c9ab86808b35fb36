// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdSpreadSource.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace skdtree
{
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

/// Squared, along a line from x to where it enters a box; negative if it does not between its ends.
double GapAlong(const skd::Box3& box, const skd::Vector3& x, const skd::Vector3& direction,
  double back, double maxDistance)
{
  double first = -back;
  double last = maxDistance;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box.Min[axis] - x[axis];
    const double high = box.Max[axis] - x[axis];
    if (direction[axis] != 0.0)
    {
      first = std::max(first, std::min(low / direction[axis], high / direction[axis]));
      last = std::min(last, std::max(low / direction[axis], high / direction[axis]));
    }
    else if (low > 0.0 || high < 0.0)
    {
      return -1.0;
    }
  }
  const double gap = std::max({ first, -last, 0.0 });
  return first <= last ? gap * gap : -1.0;
}

/// Whether a squared distance is one, and within a limit.
bool IsWithin(double gap2, double limit2)
{
  return gap2 >= 0.0 && gap2 <= limit2;
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
  const std::vector<SkdBlock> blocks = SkdBlocksOf(this->Own); // in the order of their paths
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

std::vector<SkdBlock> SkdSpreadSource::BringTouching() const
{
  SkdSearchRange maxDistance;
  maxDistance.WithOwn = true;
  std::vector<SkdBlock> blocks = this->Blocks;
  std::size_t at = 0;
  this->VisitBlocks([&](const SkdSpreadBlock& block)
    { blocks[at++].Mesh = block.Bring(*this->Transport, *this->Cut, nullptr, maxDistance); });
  return blocks;
}

int SkdSpreadSource::BlockSlotOf(int blockIndex) const
{
  const auto found = std::find_if(this->Blocks.begin(), this->Blocks.end(),
    [blockIndex](const SkdBlock& block) { return block.BlockIndex == blockIndex; });
  return static_cast<int>(found - this->Blocks.begin());
}

/// gapOf(box, largest) is the squared distance of a box, where coordinates are not larger than the
/// other: more than the limit, or infinite, if it is not near.
template <class GapFunction>
void SkdSpreadSource::List(
  double limit2, const GapFunction& gapOf, std::vector<SkdNearProcess>& near) const
{
  const std::vector<skd::Box3>& boxes = this->Cut->GetBoxes();
  for (int process = 0; process < this->Cut->GetNumberOfProcesses(); ++process)
  {
    const skd::Box3& bounds = this->Cut->GetBounds(process);
    const double largest = skd::LargestCoordinate(bounds);
    if (process == this->Transport->GetRank() || bounds.IsEmpty() ||
      !IsWithin(gapOf(bounds, largest), limit2))
    {
      continue;
    }
    double nearest2 = -1.0; // as long as there is none
    for (std::size_t i = this->Cut->GetFirst(process); i < this->Cut->GetFirst(process + 1); ++i)
    {
      const double gap2 = gapOf(boxes[i], largest);
      const bool isNearer = IsWithin(gap2, nearest2 < 0.0 ? limit2 : nearest2);
      nearest2 = isNearer ? gap2 : nearest2;
    }
    if (nearest2 >= 0.0)
    {
      near.push_back({ process, nearest2 });
    }
  }
}

void SkdSpreadSource::ListNear(
  const skd::Vector3& x, double radius, std::vector<SkdNearProcess>& near) const
{
  this->List(
    radius * radius,
    [&](const skd::Box3& box, double largest)
    { return GapOf(box, x, RoundingAt(std::max(LargestOf(x), largest))); },
    near);
}

void SkdSpreadSource::ListAlong(const skd::Vector3& x, const skd::Vector3& direction, double back,
  double maxDistance, double margin, std::vector<SkdNearProcess>& near) const
{
  this->List(
    std::numeric_limits<double>::infinity(),
    [&](const skd::Box3& box, double largest)
    {
      const double rounding = 4.0 * RoundingAt(LargestOf(x) + largest);
      return GapAlong(box.Inflated(margin + rounding), x, direction, back, maxDistance);
    },
    near);
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
}
