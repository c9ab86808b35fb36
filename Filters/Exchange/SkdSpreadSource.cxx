// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdSpreadSource.h"

#include "Exchange/SkdCompositePieces.h"
#include "Exchange/SkdMessage.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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

/// By its place, the piece of each block that any process has: an empty mesh where this one has
/// none.
std::map<SkdBlockPath, vtkSmartPointer<vtkDataSet>> PlacedPieces(
  SkdTransport& transport, vtkDataObject* piece)
{
  std::vector<int> told; // the length of each path, and the path
  std::map<SkdBlockPath, vtkSmartPointer<vtkDataSet>> pieces;
  for (const SkdPlacedBlock& leaf : SkdPlacedBlocksOf(piece))
  {
    pieces[leaf.Path] = leaf.Mesh;
    told.push_back(static_cast<int>(leaf.Path.size()));
    told.insert(told.end(), leaf.Path.begin(), leaf.Path.end());
  }
  for (const std::vector<int>& other : SkdGatherRows(transport, told))
  {
    for (auto at = other.begin(); at != other.end(); at += 1 + *at)
    {
      vtkSmartPointer<vtkDataSet>& mesh = pieces[SkdBlockPath(at + 1, at + 1 + *at)];
      mesh = mesh ? mesh : vtkSmartPointer<vtkDataSet>(vtkSmartPointer<vtkPolyData>::New());
    }
  }
  return pieces;
}

/// The structure of composite data of all processes; nullptr of a data set.
vtkSmartPointer<vtkDataObject> SharedStructure(
  vtkDataObject* piece, vtkMultiProcessController* controller)
{
  vtkSmartPointer<vtkDataObject> structure = SkdStructureOf(piece);
  if (structure)
  {
    for (vtkDataObject* other : SkdExchangeAll(SkdStructureOf(piece), controller))
    {
      SkdUniteStructures(structure, other);
    }
  }
  return structure;
}
}

bool SkdSpreadSource::Update(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  SkdWholeInput::Stamp stamp = SkdWholeInput::StampOf(piece);
  const int isNew = !this->Own || stamp != this->Known ? 1 : 0;
  int isAnyNew = 0;
  controller->AllReduce(&isNew, &isAnyNew, 1, vtkCommunicator::MAX_OP);
  if (isAnyNew != 0)
  {
    *this = SkdSpreadSource();
    this->Transport = SkdMakeTransport(controller);
    if (!this->Transport)
    {
      return false;
    }
    this->Number(piece, controller);
    this->Known = std::move(stamp);
    this->Piece = piece;
  }
  return true;
}

void SkdSpreadSource::Number(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  this->Own = SharedStructure(piece, controller);
  std::vector<std::vector<vtkIdType>> ids;
  std::vector<vtkIdType> sizes;
  for (const auto& [path, mesh] : PlacedPieces(*this->Transport, piece))
  {
    const SkdPieceNumbers numbers =
      SkdNumberPiece(*this->Transport, mesh, SkdAllFacts(*this->Transport, mesh));
    SkdOwnCells own = SkdTakeOwnCells(*this->Transport, mesh, numbers);
    ids.push_back(std::move(own.Ids));
    sizes.push_back(numbers.NumberOfCells);
    if (this->Own && !path.empty())
    {
      SkdSetBlock(this->Own, path, own.Mesh);
    }
    else
    {
      this->Own = own.Mesh;
    }
  }
  const std::vector<SkdBlock> blocks = SkdBlocksOf(this->Own); // in the order of their places
  std::vector<skd::Box3> boxes;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (sizes[i] > 0)
    {
      this->Blocks.push_back(blocks[i]);
      this->Ids.push_back(std::move(ids[i]));
      const std::vector<skd::Box3> ofCells = SkdBoxesOfCells(blocks[i].Mesh, true);
      boxes.insert(boxes.end(), ofCells.begin(), ofCells.end());
    }
  }
  this->Cut = std::make_shared<SkdCut>(*this->Transport, std::move(boxes));
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

SkdTreeCounts SkdSpreadSource::CountAll(const SkdTreeCounts& own) const
{
  SkdTreeCounts all;
  for (const std::vector<SkdTreeCounts>& told :
    SkdGatherRows(*this->Transport, std::vector<SkdTreeCounts>{ own }))
  {
    all.Cells += told.front().Cells;
    all.CellsLeftOut += told.front().CellsLeftOut;
    all.Tolerance = std::max(all.Tolerance, told.front().Tolerance);
  }
  return all;
}
