// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPieceNumbers.h"

#include "Exchange/SkdGridLattice.h"
#include "Exchange/SkdPieceArrays.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace skdtree
{
namespace
{
/// A piece that is the mesh.
void NumberInOrder(int process, vtkDataSet* piece, SkdPieceNumbers& numbers)
{
  std::iota(numbers.CellIds.begin(), numbers.CellIds.end(), vtkIdType(0));
  std::iota(numbers.PointIds.begin(), numbers.PointIds.end(), vtkIdType(0));
  for (vtkIdType point = 0; point < piece->GetNumberOfPoints(); ++point)
  {
    numbers.PointOrigins.push_back({ process, point });
  }
}

//------------------------------------------------------------------------------
/// A point or cell of a grid that several pieces have.
struct GridQuestion
{
  vtkIdType Id; // in the whole grid
  vtkIdType Own;
  bool IsDuplicate;
};

using GridQuestions = SkdRowsByProcess<GridQuestion>;
using Origins = SkdRowsByProcess<SkdPointOrigin>;

/// From the first piece where it is no duplicate, else the first.
Origins ChoosePieces(const GridQuestions& queries)
{
  std::map<vtkIdType, std::tuple<bool, int, vtkIdType>> chosen;
  for (std::size_t process = 0; process < queries.size(); ++process)
  {
    for (const GridQuestion& question : queries[process])
    {
      const std::tuple<bool, int, vtkIdType> own{ question.IsDuplicate, static_cast<int>(process),
        question.Own };
      const auto [entry, isNew] = chosen.emplace(question.Id, own);
      entry->second = isNew ? own : std::min(entry->second, own);
    }
  }
  Origins answers(queries.size());
  for (std::size_t process = 0; process < queries.size(); ++process)
  {
    for (const GridQuestion& question : queries[process])
    {
      const auto& [isDuplicate, from, own] = chosen[question.Id];
      answers[process].push_back({ from, own });
    }
  }
  return answers;
}

/// The points or the cells of a piece of a grid.
class GridNumbers
{
public:
  GridNumbers(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts, int type)
    : Transport(transport)
    , Whole(facts.GetGridExtent(), type)
  {
    const int rank = transport.GetRank();
    std::vector<SkdGridLattice> others;
    for (const int process : facts.GetFull())
    {
      if (process != rank)
      {
        others.emplace_back(facts.Of(process).Extent, type);
      }
    }
    if (facts.IsFull(rank))
    {
      this->Number(
        SkdGridLattice(facts.Of(rank).Extent, type), others, SkdIncompleteOf(piece, type));
    }
    this->AskForOrigins();
  }

  vtkIdType GetSize() const { return this->Whole.GetSize(); }

  std::vector<vtkIdType> Ids;
  std::vector<SkdPointOrigin> Origin;

private:
  void Number(const SkdGridLattice& own, const std::vector<SkdGridLattice>& others,
    const std::vector<unsigned char>& ghosts)
  {
    this->Questions.resize(static_cast<std::size_t>(this->Transport.GetNumber()));
    this->Queries.resize(this->Questions.size());
    own.VisitAll(
      [&](const int(&ijk)[3])
      {
        const auto at = static_cast<vtkIdType>(this->Ids.size());
        const vtkIdType id = this->Whole.IdOf(ijk);
        this->Ids.push_back(id);
        this->Origin.push_back({ this->Transport.GetRank(), at });
        const bool isShared = std::any_of(others.begin(), others.end(),
          [&ijk](const SkdGridLattice& other) { return other.Contains(ijk); });
        if (isShared)
        {
          const auto to = static_cast<std::size_t>(id) % this->Questions.size();
          const bool isDuplicate = !ghosts.empty() && ghosts[static_cast<std::size_t>(at)];
          this->Questions[to].push_back({ id, at, isDuplicate });
          this->Queries[to].push_back(at);
        }
      });
  }

  void AskForOrigins()
  {
    this->Questions.resize(static_cast<std::size_t>(this->Transport.GetNumber()));
    this->Queries.resize(this->Questions.size());
    const Origins answers = SkdAsk<SkdPointOrigin>(this->Transport, this->Questions, ChoosePieces);
    for (std::size_t to = 0; to < answers.size(); ++to)
    {
      for (std::size_t i = 0; i < answers[to].size(); ++i)
      {
        this->Origin[static_cast<std::size_t>(this->Queries[to][i])] = answers[to][i];
      }
    }
  }

  SkdTransport& Transport;
  SkdGridLattice Whole;
  GridQuestions Questions;
  SkdRowsByProcess<vtkIdType> Queries;
};
}

std::vector<SkdRunningSum> SkdSumOver(
  SkdTransport& transport, const std::vector<vtkIdType>& numbers)
{
  std::vector<SkdRunningSum> sums(numbers.size());
  const SkdRowsByProcess<vtkIdType> all = SkdGatherRows(transport, numbers);
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      sums[i].All += all[process][i];
      sums[i].Before += static_cast<int>(process) < transport.GetRank() ? all[process][i] : 0;
    }
  }
  return sums;
}

SkdKindNumbers SkdNumberKinds(SkdTransport& transport, const std::vector<vtkIdType>& counts)
{
  SkdKindNumbers numbers;
  for (const SkdRunningSum& sum : SkdSumOver(transport, counts))
  {
    numbers.First.push_back(numbers.All + sum.Before);
    numbers.All += sum.All;
  }
  return numbers;
}

SkdRepeatedId SkdFirstRepeatedId(SkdTransport& transport, const SkdRepeatedId& own)
{
  SkdRepeatedId first;
  for (const auto& found : SkdGatherRows(transport, std::vector<SkdRepeatedId>{ own }))
  {
    first = first.Or(found.front());
  }
  return first;
}

void SkdNumberGrid(
  SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts, SkdPieceNumbers& numbers)
{
  GridNumbers points(transport, piece, facts, vtkDataObject::POINT);
  numbers.NumberOfPoints = points.GetSize();
  numbers.PointIds = std::move(points.Ids);
  numbers.PointOrigins = std::move(points.Origin);
  GridNumbers cells(transport, piece, facts, vtkDataObject::CELL);
  numbers.NumberOfCells = cells.GetSize();
  numbers.CellIds = std::move(cells.Ids);
  for (std::size_t cell = 0; cell < numbers.CellIds.size(); ++cell)
  {
    const bool isOwn = cells.Origin[cell].Process == transport.GetRank();
    numbers.CellIds[cell] = isOwn ? numbers.CellIds[cell] : -1;
  }
}

std::vector<unsigned char> SkdFindCounted(
  SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts)
{
  if (!facts.IsOnePiece() && !facts.FillGrid() && !facts.GetFull().empty())
  {
    std::vector<vtkIdType> likes;
    SkdFindLikePoints(transport, piece, facts, likes);
    return SkdCountCells(transport, piece, facts, likes);
  }
  const std::vector<vtkIdType> ids = SkdNumberPiece(transport, piece, facts).CellIds;
  std::vector<unsigned char> counted(ids.size());
  std::transform(ids.begin(), ids.end(), counted.begin(),
    [](vtkIdType id) { return static_cast<unsigned char>(id >= 0 ? 1 : 0); });
  return counted;
}

std::vector<vtkIdType> SkdNumberCounted(SkdTransport& transport, vtkDataSet* piece,
  const SkdAllFacts& facts, const std::vector<unsigned char>& counted)
{
  if (facts.IsOnePiece() || facts.FillGrid() || facts.GetFull().empty())
  {
    return SkdNumberPiece(transport, piece, facts).CellIds;
  }
  SkdPieceNumbers numbers;
  numbers.CellIds.resize(counted.size(), -1);
  SkdNumberCells(transport, piece, facts, counted, numbers);
  return std::move(numbers.CellIds);
}

std::vector<unsigned char> SkdFindCountedPoints(
  SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts)
{
  const std::vector<SkdPointOrigin> origins = SkdNumberPiece(transport, piece, facts).PointOrigins;
  std::vector<unsigned char> counted(static_cast<std::size_t>(piece->GetNumberOfPoints()));
  for (std::size_t point = 0; point < counted.size(); ++point)
  {
    const SkdPointOrigin& origin = origins[point];
    const bool isOwn =
      origin.Process == transport.GetRank() && origin.Point == static_cast<vtkIdType>(point);
    counted[point] = static_cast<unsigned char>(isOwn ? 1 : 0);
  }
  return counted;
}

SkdPieceNumbers SkdNumberPiece(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts)
{
  SkdPieceNumbers numbers;
  numbers.CellIds.resize(static_cast<std::size_t>(piece->GetNumberOfCells()), -1);
  numbers.PointIds.resize(static_cast<std::size_t>(piece->GetNumberOfPoints()), -1);
  if (facts.IsOnePiece())
  {
    const int process = facts.GetFull().front();
    numbers.NumberOfCells = facts.Of(process).Cells;
    numbers.NumberOfPoints = facts.Of(process).Points;
    NumberInOrder(process, piece, numbers);
  }
  else if (facts.FillGrid())
  {
    SkdNumberGrid(transport, piece, facts, numbers);
  }
  else if (!facts.GetFull().empty())
  {
    std::vector<vtkIdType> likes;
    SkdNumberPoints(transport, piece, facts, numbers, likes);
    SkdNumberCells(transport, piece, facts, likes, numbers);
  }
  return numbers;
}
}
