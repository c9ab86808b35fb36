// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPieceNumbers.h"

#include "Cells/Read/SkdCellReader.h"
#include "Exchange/SkdPieceArrays.h"
#include "Exchange/SkdRepeatedCells.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

namespace skdtree
{
namespace
{
/// The rank of a cell with a global id among all: by kind, then by global id, then by piece.
struct Ranked
{
  vtkIdType GlobalId;
  vtkIdType Cell; // in its piece
  int Kind;
};

class CellNumbering
{
public:
  CellNumbering(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
    const std::vector<vtkIdType>& likes, SkdPieceNumbers& numbers)
    : Transport(transport)
    , Piece(piece)
    , Reader(piece)
    , Likes(likes)
    , Numbers(numbers)
    , Kinds(facts.AreSurfaces() ? vtkPolyData::SafeDownCast(piece) : nullptr)
    , GlobalIds(facts.HaveCellIds() ? piece->GetCellData()->GetGlobalIds() : nullptr)
    , AreByIds(facts.HaveCellIds())
    , Counts(static_cast<std::size_t>(piece->GetNumberOfCells()), 1)
  {
  }

  void Number()
  {
    this->LeaveOutRepeated();
    this->NumberCounted();
  }

  void Number(const std::vector<unsigned char>& counted)
  {
    this->Counts = counted;
    this->NumberCounted();
  }

  void NumberCounted() { this->AreByIds ? this->NumberByGlobalIds() : this->NumberInOrder(); }

  std::vector<unsigned char> FindCounted()
  {
    this->LeaveOutRepeated();
    return std::move(this->Counts);
  }

private:
  using Ids = SkdRowsByProcess<vtkIdType>;

  int KindOf(vtkIdType cell) const { return this->Kinds.Of(cell); }
  vtkIdType GlobalIdOf(vtkIdType cell) const
  {
    return static_cast<vtkIdType>(this->GlobalIds->GetTuple1(cell));
  }

  template <class Visit>
  void VisitCounted(const Visit& visit) const
  {
    for (std::size_t cell = 0; cell < this->Counts.size(); ++cell)
    {
      if (this->Counts[cell])
      {
        visit(static_cast<vtkIdType>(cell));
      }
    }
  }

  /// Calls visit(cell, numbers of points) for each cell that counts and may be in several pieces:
  /// points like all of its own are.
  template <class Visit>
  void VisitShared(const Visit& visit) const
  {
    const bool areSome =
      std::any_of(this->Likes.begin(), this->Likes.end(), [](vtkIdType like) { return like >= 0; });
    std::vector<vtkIdType> points;
    vtkNew<vtkIdList> list;
    this->Reader.VisitCells(0, areSome ? this->Piece->GetNumberOfCells() : 0, list,
      [&](vtkIdType cell, const auto* ids, std::size_t size)
      {
        const auto likeOf = [this](auto id) { return this->Likes[static_cast<std::size_t>(id)]; };
        if (this->Counts[static_cast<std::size_t>(cell)] &&
          std::all_of(ids, ids + size, [&](auto id) { return likeOf(id) >= 0; }))
        {
          points.resize(size);
          std::transform(ids, ids + size, points.begin(), likeOf);
          visit(cell, points);
        }
      });
  }

  SkdRepeatedCells::Key KeyOf(vtkIdType cell, const std::vector<vtkIdType>& points) const
  {
    return this->AreByIds
      ? SkdRepeatedCells::KeyById(this->GlobalIdOf(cell), points.data(), points.size())
      : SkdRepeatedCells::KeyByPoints(this->Reader.TypeOf(cell), points.data(), points.size());
  }

  // Each question is the length of a key and the key.
  void LeaveOutRepeated()
  {
    const auto processes = static_cast<std::size_t>(this->Transport.GetNumber());
    Ids questions(processes);
    Ids queries(processes);
    const std::vector<unsigned char> ghosts = SkdDuplicatesOf(this->Piece, vtkDataObject::CELL);
    std::transform(ghosts.begin(), ghosts.end(), this->Counts.begin(),
      [](unsigned char isGhost) { return static_cast<unsigned char>(isGhost ? 0 : 1); });
    this->VisitShared(
      [&](vtkIdType cell, const std::vector<vtkIdType>& points)
      {
        const SkdRepeatedCells::Key key = this->KeyOf(cell, points);
        const std::size_t to = HashOf(key) % processes;
        questions[to].push_back(static_cast<vtkIdType>(key.size()));
        questions[to].insert(questions[to].end(), key.begin(), key.end());
        queries[to].push_back(cell);
      });
    const SkdRowsByProcess<unsigned char> answers =
      SkdAsk<unsigned char>(this->Transport, questions, FindRepeated);
    for (std::size_t to = 0; to < processes; ++to)
    {
      for (std::size_t i = 0; i < queries[to].size(); ++i)
      {
        this->Counts[static_cast<std::size_t>(queries[to][i])] = answers[to][i] == 0;
      }
    }
  }

  static std::size_t HashOf(const SkdRepeatedCells::Key& key)
  {
    std::uint64_t hash = 0;
    for (const vtkIdType id : key)
    {
      hash = (hash ^ static_cast<std::uint64_t>(id)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }

  /// By process and question whether an earlier one has the cell.
  static SkdRowsByProcess<unsigned char> FindRepeated(const Ids& questions)
  {
    SkdRepeatedCells repeated;
    SkdRowsByProcess<unsigned char> answers(questions.size());
    for (std::size_t piece = 0; piece < questions.size(); ++piece)
    {
      for (auto at = questions[piece].begin(); at != questions[piece].end();)
      {
        const auto last = at + 1 + *at;
        const bool isRepeated =
          repeated.IsOfEarlier(static_cast<int>(piece), SkdRepeatedCells::Key(at + 1, last));
        answers[piece].push_back(isRepeated ? 1 : 0);
        at = last;
      }
    }
    return answers;
  }

  //----------------------------------------------------------------------------
  /// The first id of each kind, and how many of it earlier processes have.
  std::vector<vtkIdType> FirstIds(const std::vector<vtkIdType>& counts)
  {
    SkdKindNumbers numbers = SkdNumberKinds(this->Transport, counts);
    this->Numbers.NumberOfCells = numbers.All;
    return std::move(numbers.First);
  }

  // Those of the first piece first.
  void NumberInOrder()
  {
    std::vector<vtkIdType> counts(SkdNumberOfKinds, 0);
    this->VisitCounted(
      [&](vtkIdType cell) { ++counts[static_cast<std::size_t>(this->KindOf(cell))]; });
    std::vector<vtkIdType> next = this->FirstIds(counts);
    this->VisitCounted(
      [&](vtkIdType cell)
      {
        this->Numbers.CellIds[static_cast<std::size_t>(cell)] =
          next[static_cast<std::size_t>(this->KindOf(cell))]++;
      });
  }

  // Each process sorts the ids of a range.
  void NumberByGlobalIds()
  {
    vtkIdType range[2] = { std::numeric_limits<vtkIdType>::max(),
      std::numeric_limits<vtkIdType>::lowest() };
    this->VisitCounted(
      [&](vtkIdType cell)
      {
        range[0] = std::min(range[0], this->GlobalIdOf(cell));
        range[1] = std::max(range[1], this->GlobalIdOf(cell));
      });
    for (const auto& ranges :
      SkdGatherRows(this->Transport, std::vector<vtkIdType>(range, range + 2)))
    {
      range[0] = std::min(range[0], ranges[0]);
      range[1] = std::max(range[1], ranges[1]);
    }
    const auto processes = static_cast<std::size_t>(this->Transport.GetNumber());
    const double first = static_cast<double>(range[0]);
    const double width = static_cast<double>(range[1]) - first + 1.0;
    SkdRowsByProcess<Ranked> questions(processes);
    Ids queries(processes);
    this->VisitCounted(
      [&](vtkIdType cell)
      {
        const vtkIdType id = this->GlobalIdOf(cell);
        const double share = (static_cast<double>(id) - first) / width;
        const auto to =
          std::min(processes - 1, static_cast<std::size_t>(share * static_cast<double>(processes)));
        questions[to].push_back({ id, cell, this->KindOf(cell) });
        queries[to].push_back(cell);
      });
    SkdRepeatedId repeated = this->Numbers.Repeated;
    const Ids answers = SkdAsk<vtkIdType>(this->Transport, questions,
      [&](const SkdRowsByProcess<Ranked>& all) { return this->Rank(all, repeated); });
    this->Numbers.Repeated = SkdFirstRepeatedId(this->Transport, repeated);
    for (std::size_t to = 0; to < processes; ++to)
    {
      for (std::size_t i = 0; i < queries[to].size(); ++i)
      {
        this->Numbers.CellIds[static_cast<std::size_t>(queries[to][i])] = answers[to][i];
      }
    }
  }

  Ids Rank(const SkdRowsByProcess<Ranked>& all, SkdRepeatedId& repeated)
  {
    std::vector<std::tuple<int, vtkIdType, std::size_t, std::size_t>> order;
    std::vector<vtkIdType> counts(SkdNumberOfKinds, 0);
    Ids ids(all.size());
    for (std::size_t piece = 0; piece < all.size(); ++piece)
    {
      ids[piece].resize(all[piece].size());
      for (std::size_t i = 0; i < all[piece].size(); ++i)
      {
        order.emplace_back(all[piece][i].Kind, all[piece][i].GlobalId, piece, i);
        ++counts[static_cast<std::size_t>(all[piece][i].Kind)];
      }
    }
    std::sort(order.begin(), order.end());
    std::vector<vtkIdType> next = this->FirstIds(counts);
    for (std::size_t rank = 0; rank < order.size(); ++rank)
    {
      const auto& [kind, globalId, piece, i] = order[rank];
      ids[piece][i] = next[static_cast<std::size_t>(kind)]++;
      const auto& [kindBefore, idBefore, pieceBefore, before] = order[rank > 0 ? rank - 1 : 0];
      if (rank > 0 && !repeated.IsThere && kind == kindBefore && globalId == idBefore)
      {
        repeated = { true, false, globalId,
          { { { static_cast<int>(pieceBefore), all[pieceBefore][before].Cell },
            { static_cast<int>(piece), all[piece][i].Cell } } } };
      }
    }
    return ids;
  }

  SkdTransport& Transport;
  vtkDataSet* Piece;
  SkdCellReader Reader;
  const std::vector<vtkIdType>& Likes;
  SkdPieceNumbers& Numbers;
  SkdKinds Kinds;
  vtkDataArray* GlobalIds;
  bool AreByIds;
  std::vector<unsigned char> Counts; // whether each cell does
};
}

void SkdNumberCells(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  const std::vector<vtkIdType>& likes, SkdPieceNumbers& numbers)
{
  CellNumbering(transport, piece, facts, likes, numbers).Number();
}

void SkdNumberCells(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  const std::vector<unsigned char>& counted, SkdPieceNumbers& numbers)
{
  CellNumbering(transport, piece, facts, {}, numbers).Number(counted);
}

std::vector<unsigned char> SkdCountCells(SkdTransport& transport, vtkDataSet* piece,
  const SkdAllFacts& facts, const std::vector<vtkIdType>& likes)
{
  SkdPieceNumbers none;
  return CellNumbering(transport, piece, facts, likes, none).FindCounted();
}
}
