// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdSpreadBlock.h"

#include "Exchange/SkdCellParts.h"
#include "Exchange/SkdDirectionBoxes.h"
#include "Exchange/SkdFindShape.h"
#include "Exchange/SkdMessage.h"
#include "Pipeline/SkdSubset.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace skdtree
{
namespace
{
/// Both ends of a box along each axis, the upper ones negative: the least of each is the outermost.
using Ends = std::array<double, 6>;

Ends EndsOf(const skd::Box3& box)
{
  return { box.Min[0], box.Min[1], box.Min[2], -box.Max[0], -box.Max[1], -box.Max[2] };
}

/// Cells ascending, each once. Most are already.
void Sort(std::vector<vtkIdType>& cells)
{
  if (!std::is_sorted(cells.begin(), cells.end()))
  {
    std::sort(cells.begin(), cells.end());
  }
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

/// Into such a list.
void Insert(std::vector<vtkIdType>& cells, vtkIdType cell)
{
  const auto at = std::lower_bound(cells.begin(), cells.end(), cell);
  if (at == cells.end() || *at != cell)
  {
    cells.insert(at, cell);
  }
}

/// Of the boxes of all processes.
double LargestDiagonalOf(SkdTransport& transport, const std::vector<skd::Box3>& boxes)
{
  double own = 0.0;
  for (const skd::Box3& box : boxes)
  {
    own = std::max(own, box.Diagonal());
  }
  for (const std::vector<double>& other : SkdGatherRows(transport, std::vector<double>{ own }))
  {
    own = std::max(own, other.front());
  }
  return (1.0 + 1e-6) * own;
}
}

vtkSmartPointer<vtkDataSet> SkdSpreadBlock::MakeExample(vtkDataSet* piece)
{
  SkdSubset subset(piece);
  if (piece->GetNumberOfCells() > 0)
  {
    subset.SetCells({ 0 });
  }
  else if (piece->GetNumberOfPoints() > 0)
  {
    subset.SetPoints({ 0 });
  }
  subset.CopyData();
  subset.Get()->SetFieldData(piece->GetFieldData());
  return subset.Get();
}

SkdSpreadBlock::SkdSpreadBlock(SkdTransport& transport, vtkDataSet* piece, SkdPieces examples)
  : Piece(piece)
  , Examples(std::move(examples))
  , Facts(transport, piece)
  , Numbers(SkdNumberPiece(transport, piece, this->Facts))
  , Boxes(SkdBoxesOfCells(piece, true))
{
  for (std::size_t cell = 0; cell < this->Boxes.size(); ++cell)
  {
    if (this->Numbers.CellIds[cell] < 0)
    {
      this->Boxes[cell] = skd::Box3();
    }
  }
}

std::vector<skd::Box3> SkdSpreadBlock::FindDirections(bool inDegrees) const
{
  std::vector<skd::Box3> boxes = SkdDirectionBoxesOfCells(this->Piece, inDegrees);
  for (std::size_t cell = 0; cell < boxes.size(); ++cell)
  {
    boxes[cell] = this->Numbers.CellIds[cell] < 0 ? skd::Box3() : boxes[cell];
  }
  return boxes;
}

// Cells that follow each other mostly lie together. Where all are far from other processes, which
// are near this one is not asked: to search some more of the own cells costs less.
void SkdSpreadBlock::AddNear(const std::vector<skd::Box3>& boxes, const SkdCut& cut, int rank,
  double distance, double ofDiagonal, Chosen& chosen) const
{
  constexpr std::size_t together = 32;
  const auto reachOf = [&](const skd::Box3& box)
  { return box.Inflated(distance + ofDiagonal * box.Diagonal()); };
  std::vector<int> nearAny;
  std::vector<int> near;
  for (std::size_t begin = 0; begin < boxes.size(); begin += together)
  {
    const std::size_t end = std::min(begin + together, boxes.size());
    skd::Box3 all;
    std::for_each(boxes.begin() + static_cast<std::ptrdiff_t>(begin),
      boxes.begin() + static_cast<std::ptrdiff_t>(end),
      [&](const skd::Box3& box) { all.Add(reachOf(box)); });
    cut.FindOverlapping(all, nearAny);
    const bool isOfThis = nearAny.size() == 1 && nearAny.front() == rank;
    for (std::size_t cell = begin; cell < end && !nearAny.empty(); ++cell)
    {
      near.assign(isOfThis && !boxes[cell].IsEmpty() ? 1 : 0, rank);
      if (!isOfThis)
      {
        cut.FindOverlapping(reachOf(boxes[cell]), near);
      }
      for (const int process : near)
      {
        chosen[static_cast<std::size_t>(process)].push_back(static_cast<vtkIdType>(cell));
      }
    }
  }
}

vtkSmartPointer<vtkDataSet> SkdSpreadBlock::Bring(SkdTransport& transport, const SkdCut& cut,
  const SkdCut* directions, const SkdSearchRange& range) const
{
  // Tests of single cells allow for some units in the last place.
  const double rounding =
    64.0 * std::numeric_limits<double>::epsilon() * this->Facts.GetLargestCoordinate();
  // What touches a box that is near is not farther than that box is large.
  const auto distanceOf = [&](const std::vector<skd::Box3>& boxes)
  { return range.WithNeighbours ? LargestDiagonalOf(transport, boxes) : 0.0; };
  Chosen chosen(static_cast<std::size_t>(transport.GetNumber()));
  const int rank = transport.GetRank();
  this->AddNear(this->Boxes, cut, rank, range.Distance + rounding + distanceOf(this->Boxes),
    range.OfDiagonal, chosen);
  if (directions)
  {
    const std::vector<skd::Box3> boxes = this->FindDirections(range.IsSearchedInDegrees);
    this->AddNear(boxes, *directions, rank, distanceOf(boxes), 0.0, chosen);
  }
  if (range.WithOwn)
  {
    std::vector<vtkIdType>& own = chosen[static_cast<std::size_t>(transport.GetRank())];
    own.clear(); // those that are near are among them
    this->AddOwn(own);
  }
  vtkSmartPointer<vtkDataSet> mesh = this->Send(transport, std::move(chosen));
  if (range.WithOwn && !this->Facts.GetFull().empty())
  {
    const SkdJoinedShape shape = SkdFindShape(transport, this->Piece, this->Facts, this->Numbers);
    shape.KeepIn(mesh);
  }
  return mesh;
}

vtkSmartPointer<vtkDataSet> SkdSpreadBlock::BringOwn(SkdTransport& transport) const
{
  Chosen chosen(static_cast<std::size_t>(transport.GetNumber()));
  this->AddOwn(chosen[static_cast<std::size_t>(transport.GetRank())]);
  return this->Send(transport, std::move(chosen));
}

void SkdSpreadBlock::AddOwn(std::vector<vtkIdType>& cells) const
{
  for (std::size_t cell = 0; cell < this->Boxes.size(); ++cell)
  {
    if (this->Numbers.CellIds[cell] >= 0)
    {
      cells.push_back(static_cast<vtkIdType>(cell));
    }
  }
}

vtkSmartPointer<vtkDataSet> SkdSpreadBlock::BringThose(
  SkdTransport& transport, const SkdRowsByProcess<vtkIdType>& wanted) const
{
  return this->Send(transport, this->FindThose(transport, wanted));
}

vtkSmartPointer<vtkDataSet> SkdSpreadBlock::BringOnly(
  SkdTransport& transport, const SkdRowsByProcess<vtkIdType>& wanted) const
{
  return this->SendOnly(transport, this->FindThose(transport, wanted));
}

std::vector<vtkIdType> SkdSpreadBlock::ListOwnIds() const
{
  std::vector<vtkIdType> ids;
  std::copy_if(this->Numbers.CellIds.begin(), this->Numbers.CellIds.end(), std::back_inserter(ids),
    [](vtkIdType id) { return id >= 0; });
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// What the others want of this process's piece.
SkdSpreadBlock::Chosen SkdSpreadBlock::FindThose(
  SkdTransport& transport, const SkdRowsByProcess<vtkIdType>& wanted) const
{
  std::vector<std::pair<vtkIdType, vtkIdType>> order; // joined ids and cells
  for (std::size_t cell = 0; cell < this->Boxes.size(); ++cell)
  {
    if (this->Numbers.CellIds[cell] >= 0)
    {
      order.emplace_back(this->Numbers.CellIds[cell], static_cast<vtkIdType>(cell));
    }
  }
  std::sort(order.begin(), order.end());
  Chosen chosen = SkdExchangeRows(transport, wanted);
  for (std::vector<vtkIdType>& ids : chosen)
  {
    std::vector<vtkIdType> cells;
    for (const vtkIdType id : ids)
    {
      const auto found =
        std::lower_bound(order.begin(), order.end(), std::make_pair(id, vtkIdType(-1)));
      if (found != order.end() && found->first == id)
      {
        cells.push_back(found->second);
      }
    }
    ids = std::move(cells);
  }
  return chosen;
}

// Of each end the first process that has it sends its first such cell.
void SkdSpreadBlock::AddExtremes(SkdTransport& transport, Chosen& chosen) const
{
  constexpr double none = std::numeric_limits<double>::max();
  Ends ends;
  ends.fill(none);
  std::array<vtkIdType, 6> cells{};
  for (std::size_t cell = 0; cell < this->Boxes.size(); ++cell)
  {
    const Ends own = EndsOf(this->Boxes[cell]);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      if (!this->Boxes[cell].IsEmpty() && own[i] < ends[i])
      {
        ends[i] = own[i];
        cells[i] = static_cast<vtkIdType>(cell);
      }
    }
  }
  const SkdRowsByProcess<Ends> all = SkdGatherRows(transport, std::vector<Ends>{ ends });
  std::for_each(chosen.begin(), chosen.end(), Sort);
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const auto first = std::min_element(all.begin(), all.end(),
      [i](const auto& a, const auto& b) { return a.front()[i] < b.front()[i]; });
    if (first - all.begin() == transport.GetRank() && ends[i] < none)
    {
      for (std::vector<vtkIdType>& ids : chosen)
      {
        Insert(ids, cells[i]);
      }
    }
  }
}

vtkSmartPointer<vtkDataSet> SkdSpreadBlock::Send(SkdTransport& transport, Chosen chosen) const
{
  this->AddExtremes(transport, chosen);
  return this->SendOnly(transport, chosen);
}

vtkSmartPointer<vtkDataSet> SkdSpreadBlock::SendOnly(
  SkdTransport& transport, const Chosen& chosen) const
{
  SkdCellParts parts(transport, this->Facts, this->Examples);
  SkdExchangeMeshes(
    transport,
    [&](int to)
    {
      return SkdTakeCells(this->Piece, chosen[static_cast<std::size_t>(to)], this->Numbers,
        this->Facts.AreSurfaces());
    },
    [&](int from, vtkDataSet* cells) { parts.Take(from, cells); });
  parts.AskForPoints(transport, this->Piece);
  return this->Facts.GetFull().empty() ? this->Piece : parts.Assemble();
}
}
