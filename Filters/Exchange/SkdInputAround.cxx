// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdInputAround.h"

#include "Bodies/SkdWeld.h"
#include "Exchange/SkdPieceArrays.h"
#include "Exchange/SkdRepeatedCells.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdSearchRange.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace skdtree
{
namespace
{
/// Of the points of all processes.
double LargestCoordinateOf(SkdTransport& transport, vtkDataObject* piece)
{
  double largest = skd::LargestCoordinate(SkdBoundsOfPoints(piece));
  for (const std::vector<double>& other : SkdGatherRows(transport, std::vector<double>(1, largest)))
  {
    largest = std::max(largest, other.front());
  }
  return largest;
}

/// Cells by the coordinates of their points.
class CellsByPoints
{
public:
  void Add(vtkDataSet* mesh)
  {
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      this->Cells[this->KeyOf(mesh, cell)].push_back(cell);
    }
  }

  /// Of several that are equal each once, one after the other; -1: there is none.
  vtkIdType Take(vtkDataSet* mesh, vtkIdType cell)
  {
    const auto found = this->Cells.find(this->KeyOf(mesh, cell));
    if (found == this->Cells.end())
    {
      return -1;
    }
    std::rotate(found->second.begin(), found->second.begin() + 1, found->second.end());
    return found->second.back();
  }

private:
  SkdRepeatedCells::Key KeyOf(vtkDataSet* mesh, vtkIdType cell)
  {
    mesh->GetCellPoints(cell, this->Points);
    for (vtkIdType i = 0; i < this->Points->GetNumberOfIds(); ++i)
    {
      this->Points->SetId(i, this->Weld.GetId(mesh->GetPoint(this->Points->GetId(i))));
    }
    return SkdRepeatedCells::KeyByPoints(mesh->GetCellType(cell), this->Points->GetPointer(0),
      static_cast<std::size_t>(this->Points->GetNumberOfIds()));
  }

  vtkNew<vtkIdList> Points;
  SkdWeld Weld;
  std::map<SkdRepeatedCells::Key, std::vector<vtkIdType>> Cells;
};

/// Which cell of a mesh each one of a piece is; -1: none.
std::vector<vtkIdType> FindCells(
  vtkDataSet* mesh, vtkDataSet* piece, const std::vector<vtkIdType>& ids)
{
  const SkdJoinedIds joined(mesh);
  const std::vector<unsigned char> ghosts = SkdDuplicatesOf(piece, vtkDataObject::CELL);
  const auto isOfOther = [&](std::size_t cell)
  { return ids[cell] < 0 && (ghosts.empty() || ghosts[cell] == 0); };
  std::vector<vtkIdType> cells(ids.size(), -1);
  CellsByPoints byPoints;
  bool areKnown = false;
  for (std::size_t cell = 0; cell < ids.size(); ++cell)
  {
    if (ids[cell] >= 0)
    {
      cells[cell] = joined.Find(ids[cell]);
    }
    else if (isOfOther(cell))
    {
      if (!areKnown)
      {
        byPoints.Add(mesh);
        areKnown = true;
      }
      cells[cell] = byPoints.Take(piece, static_cast<vtkIdType>(cell));
    }
  }
  return cells;
}

/// An id of a list.
struct Listed
{
  vtkIdType List;
  vtkIdType Id;
};

/// Each process sorts the ids of a range.
class Ranks
{
public:
  Ranks(SkdTransport& transport, const std::vector<std::vector<vtkIdType>>& ids)
    : Transport(transport)
    , Lists(ids.size())
    , Processes(static_cast<std::size_t>(transport.GetNumber()))
  {
    for (const std::vector<vtkIdType>& some : ids)
    {
      this->Largest = some.empty()
        ? this->Largest
        : std::max(this->Largest, *std::max_element(some.begin(), some.end()));
    }
    for (const auto& other : SkdGatherRows(transport, std::vector<vtkIdType>(1, this->Largest)))
    {
      this->Largest = std::max(this->Largest, other.front());
    }
  }

  std::size_t ProcessOf(vtkIdType id) const
  {
    const double share = static_cast<double>(id) / (static_cast<double>(this->Largest) + 1.0);
    return std::min(
      this->Processes - 1, static_cast<std::size_t>(share * static_cast<double>(this->Processes)));
  }

  SkdRowsByProcess<vtkIdType> Find(const SkdRowsByProcess<Listed>& asked) const
  {
    std::vector<std::tuple<vtkIdType, vtkIdType, std::size_t, std::size_t>> order;
    std::vector<vtkIdType> counts(this->Lists, 0);
    SkdRowsByProcess<vtkIdType> ranks(asked.size());
    for (std::size_t process = 0; process < asked.size(); ++process)
    {
      ranks[process].resize(asked[process].size());
      for (std::size_t i = 0; i < asked[process].size(); ++i)
      {
        const Listed& one = asked[process][i];
        order.emplace_back(one.List, one.Id, process, i);
        ++counts[static_cast<std::size_t>(one.List)];
      }
    }
    std::sort(order.begin(), order.end());
    std::vector<vtkIdType> next = SkdNumberKinds(this->Transport, counts).First;
    for (const auto& [list, id, process, i] : order)
    {
      ranks[process][i] = next[static_cast<std::size_t>(list)]++;
    }
    return ranks;
  }

private:
  SkdTransport& Transport;
  std::size_t Lists;
  std::size_t Processes;
  vtkIdType Largest = 0;
};
}

vtkDataObject* SkdInputAround::Update(SkdTransport& transport, vtkDataObject* piece)
{
  // Ends of cells that go on in each other are no farther apart than a few times rounding.
  SkdSearchRange range;
  range.WithOwn = true;
  range.Distance =
    256.0 * std::numeric_limits<double>::epsilon() * LargestCoordinateOf(transport, piece);
  this->Around = this->Input.Update(transport, piece, piece, range);
  return this->Around;
}

std::vector<std::vector<vtkIdType>> SkdInputAround::TakeBack(
  const std::vector<std::vector<vtkIdType>>& values, vtkDataObject* piece,
  const std::vector<std::vector<vtkIdType>>& ids) const
{
  std::map<SkdBlockPath, std::size_t> numbers;
  const std::vector<SkdLeafBlock> leaves = SkdLeafBlocksOf(this->Around);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    numbers[leaves[i].Path] = i;
  }
  std::vector<std::vector<vtkIdType>> ofPiece;
  for (const SkdLeafBlock& leaf : SkdLeafBlocksOf(piece))
  {
    const std::size_t block = numbers.at(leaf.Path);
    std::vector<vtkIdType> cells = FindCells(leaves[block].Mesh, leaf.Mesh, ids[ofPiece.size()]);
    std::transform(cells.begin(), cells.end(), cells.begin(),
      [&of = values[block]](vtkIdType cell)
      { return cell < 0 ? 0 : of[static_cast<std::size_t>(cell)]; });
    ofPiece.push_back(std::move(cells));
  }
  return ofPiece;
}

std::vector<std::vector<vtkIdType>> SkdRankOverProcesses(
  SkdTransport& transport, const std::vector<std::vector<vtkIdType>>& ids)
{
  const Ranks ranks(transport, ids);
  SkdRowsByProcess<Listed> questions(static_cast<std::size_t>(transport.GetNumber()));
  for (std::size_t list = 0; list < ids.size(); ++list)
  {
    for (const vtkIdType id : ids[list])
    {
      questions[ranks.ProcessOf(id)].push_back({ static_cast<vtkIdType>(list), id });
    }
  }
  const SkdRowsByProcess<vtkIdType> answers = SkdAsk<vtkIdType>(
    transport, questions, [&](const SkdRowsByProcess<Listed>& asked) { return ranks.Find(asked); });
  std::vector<std::size_t> next(answers.size(), 0);
  std::vector<std::vector<vtkIdType>> places;
  for (const std::vector<vtkIdType>& list : ids)
  {
    places.emplace_back();
    for (const vtkIdType id : list)
    {
      const std::size_t to = ranks.ProcessOf(id);
      places.back().push_back(answers[to][next[to]++]);
    }
  }
  return places;
}
}
