// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPieceNumbers.h"

#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Exchange/SkdCut.h"
#include "Exchange/SkdNearPoints.h"
#include "Exchange/SkdPieceArrays.h"
#include "Exchange/SkdPointJoin.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace skdtree
{
namespace
{
/// When a point is added to the joined mesh: ghosts after all others, in the order in which cells
/// use them, or not at all.
constexpr vtkIdType AtOnce = -1;
constexpr vtkIdType Never = -2;

struct PointQuestion
{
  skd::Vector3 X;
  vtkIdType GlobalId; // if all points have such
  vtkIdType Point;
  vtkIdType Order;
  bool IsIncomplete;
};

struct PointAnswer
{
  SkdPointOrigin Numbered; // by whom
  SkdPointOrigin Data;
  SkdPointOrigin FirstLike; // see SkdPieceNumbers; a process of -1: no other piece has such
};

using Questions = SkdRowsByProcess<PointQuestion>;
using Answers = SkdRowsByProcess<PointAnswer>;
using Keys = std::vector<std::vector<vtkIdType>>;

//------------------------------------------------------------------------------
// Where questions are answered.

std::size_t FindKeysByGlobalIds(
  const Questions& queries, double largestCoordinate, Keys& keys, SkdRepeatedId& repeated)
{
  struct First
  {
    vtkIdType Key;
    int Process;
    const PointQuestion* Question;
  };
  std::unordered_map<vtkIdType, First> known;
  for (std::size_t piece = 0; piece < queries.size(); ++piece)
  {
    for (const PointQuestion& question : queries[piece])
    {
      const First own{ static_cast<vtkIdType>(known.size()), static_cast<int>(piece), &question };
      const First& first = known.emplace(question.GlobalId, own).first->second;
      keys[piece].push_back(first.Key);
      if (!repeated.IsThere && SkdAreDifferent(question.X, first.Question->X, largestCoordinate))
      {
        repeated = { true, true, question.GlobalId,
          { { { first.Process, first.Question->Point }, { own.Process, question.Point } } } };
      }
    }
  }
  return known.size();
}

std::size_t FindKeysByCoordinates(const Questions& queries, const SkdRounding& rounding, Keys& keys)
{
  SkdWeld weld;
  for (std::size_t piece = 0; piece < queries.size(); ++piece)
  {
    for (const PointQuestion& question : queries[piece])
    {
      keys[piece].push_back(weld.GetId(question.X.X));
    }
  }
  SkdMergeNearPoints(rounding, weld.GetPoints(), keys);
  return weld.GetPoints().size();
}

/// Adds the points of all pieces in the order of SkdPiecePoints.
class PointDirectory
{
public:
  PointDirectory(const Questions& queries, const Keys& keys, std::size_t numberOfKeys)
    : Queries(queries)
    , Keyed(keys)
    , Join(numberOfKeys)
    , Ids(queries.size())
  {
    for (std::size_t piece = 0; piece < queries.size(); ++piece)
    {
      this->Ids[piece].assign(queries[piece].size(), -1);
      this->AddOwn(piece);
    }
    for (std::size_t piece = 0; piece < queries.size(); ++piece)
    {
      this->AddGhosts(piece);
    }
  }

  Answers GetAnswers() const
  {
    Answers answers(this->Queries.size());
    for (std::size_t piece = 0; piece < this->Queries.size(); ++piece)
    {
      for (const vtkIdType id : this->Ids[piece])
      {
        answers[piece].push_back(
          id < 0 ? PointAnswer{ { -1, -1 }, { -1, -1 }, { -1, -1 } } : this->AnswerOf(id));
      }
    }
    return answers;
  }

private:
  PointAnswer AnswerOf(vtkIdType id) const
  {
    const Origin& origin = this->Origins[static_cast<std::size_t>(id)];
    const vtkIdType first = this->Join.FirstLike(id);
    return { origin.Numbered, origin.Data,
      this->Join.IsShared(first) ? this->Origins[static_cast<std::size_t>(first)].Numbered
                                 : SkdPointOrigin{ -1, -1 } };
  }

  void AddOwn(std::size_t piece)
  {
    for (std::size_t i = 0; i < this->Queries[piece].size(); ++i)
    {
      if (this->Queries[piece][i].Order == AtOnce)
      {
        this->Add(piece, i);
      }
    }
  }

  void AddGhosts(std::size_t piece)
  {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < this->Queries[piece].size(); ++i)
    {
      if (this->Queries[piece][i].Order >= 0)
      {
        used.push_back(i);
      }
    }
    std::sort(used.begin(), used.end(),
      [&](std::size_t a, std::size_t b)
      { return this->Queries[piece][a].Order < this->Queries[piece][b].Order; });
    for (const std::size_t i : used)
    {
      this->Add(piece, i);
    }
  }

  void Add(std::size_t piece, std::size_t i)
  {
    const vtkIdType before = this->Join.GetNumber();
    const vtkIdType id = this->Join.Add(static_cast<int>(piece), this->Keyed[piece][i]);
    const PointQuestion& question = this->Queries[piece][i];
    const SkdPointOrigin own{ static_cast<int>(piece), question.Point };
    if (id == before)
    {
      this->Origins.push_back({ own, own, question.IsIncomplete });
    }
    Origin& origin = this->Origins[static_cast<std::size_t>(id)];
    if (origin.IsIncomplete && !question.IsIncomplete)
    {
      origin.Data = own;
      origin.IsIncomplete = false;
    }
    this->Ids[piece][i] = id;
  }

  /// The first point, and the first that is complete (SkdIncompleteOf).
  struct Origin
  {
    SkdPointOrigin Numbered;
    SkdPointOrigin Data;
    bool IsIncomplete;
  };

  const Questions& Queries;
  const Keys& Keyed;
  SkdPointJoin Join;
  Keys Ids;
  std::vector<Origin> Origins; // by joined point
};

//------------------------------------------------------------------------------
/// Which process compares points that are near each other: that of a cell of a lattice so coarse
/// that few points are near two of its cells. These are told to both. Where points are so far from
/// the origin that rounding is larger than usual, the lattice is, too: by powers of two, so that it
/// changes at the sides of its cells.
class PointBins
{
public:
  PointBins(const SkdRounding& rounding, int processes)
    : Rounding(rounding)
    , Processes(static_cast<std::size_t>(processes))
  {
  }

  /// The first is the one whose answer counts.
  void Find(const skd::Vector3& x, std::vector<std::size_t>& processes) const
  {
    processes.assign(1, this->ProcessOf(x));
    const double margin = MarginInTolerances * this->Rounding.PowerAt(x);
    for (int corner = 0; corner < 8; ++corner)
    {
      skd::Vector3 near = x;
      for (int axis = 0; axis < 3; ++axis)
      {
        near[axis] += (corner >> axis) & 1 ? margin : -margin;
      }
      const std::size_t other = this->ProcessOf(near);
      if (std::find(processes.begin(), processes.end(), other) == processes.end())
      {
        processes.push_back(other);
      }
    }
  }

private:
  // Points that are one are within a tolerance of each other, at most a few in a row.
  static constexpr double MarginInTolerances = 16.0;
  static constexpr double WidthInTolerances = 1024.0;

  std::size_t ProcessOf(const skd::Vector3& x) const
  {
    const double tolerance = this->Rounding.PowerAt(x);
    const double width = tolerance > 0.0 ? WidthInTolerances * tolerance : 1.0;
    skd::Vector3 cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = std::floor(x[axis] / width) + 0.0; // no -0: its bits differ
    }
    return SkdWeld::HashOf(cell) % this->Processes;
  }

  const SkdRounding& Rounding;
  std::size_t Processes;
};

//------------------------------------------------------------------------------
class PointNumbering
{
public:
  PointNumbering(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts)
    : Transport(transport)
    , Piece(piece)
    , Facts(facts)
    , Orders(static_cast<std::size_t>(piece->GetNumberOfPoints()), AtOnce)
    , Incomplete(SkdIncompleteOf(piece, vtkDataObject::POINT))
    , Queries(static_cast<std::size_t>(transport.GetNumber()))
    , QueriedPoints(Queries.size())
  {
    this->FindOrders();
  }

  void Number(SkdPieceNumbers& numbers, std::vector<vtkIdType>& likes)
  {
    const bool byIds = this->Facts.HavePointIds();
    const SkdRounding rounding = this->Facts.GetRounding();
    SkdRepeatedId repeated;
    byIds ? this->AskByGlobalIds() : this->AskByCoordinates(rounding);
    const Answers answers = SkdAsk<PointAnswer>(this->Transport, this->Queries,
      [&](const Questions& queries)
      {
        Keys keys(queries.size());
        const std::size_t number = byIds
          ? FindKeysByGlobalIds(queries, this->Facts.GetLargestCoordinate(), keys, repeated)
          : FindKeysByCoordinates(queries, rounding, keys);
        return PointDirectory(queries, keys, number).GetAnswers();
      });
    likes.assign(this->Orders.size(), -1);
    this->TakeOrigins(answers, numbers.PointOrigins, likes);
    this->NumberOwn(numbers);
    this->AskForOthers(numbers);
    numbers.Repeated = byIds ? SkdFirstRepeatedId(this->Transport, repeated) : repeated;
  }

private:
  // Ghost points in the order in which cells that are no ghosts use them.
  void FindOrders()
  {
    const std::vector<unsigned char> ghosts = SkdDuplicatesOf(this->Piece, vtkDataObject::POINT);
    if (ghosts.empty())
    {
      return;
    }
    std::transform(ghosts.begin(), ghosts.end(), this->Orders.begin(),
      [](unsigned char isGhost) { return isGhost ? Never : AtOnce; });
    const std::vector<unsigned char> ghostCells = SkdDuplicatesOf(this->Piece, vtkDataObject::CELL);
    const SkdCellReader reader(this->Piece);
    vtkNew<vtkIdList> list;
    for (vtkIdType cell = 0; cell < this->Piece->GetNumberOfCells(); ++cell)
    {
      if (ghostCells.empty() || !ghostCells[static_cast<std::size_t>(cell)])
      {
        reader.VisitPoints(cell, list,
          [&](const auto* points, std::size_t size)
          { std::for_each(points, points + size, [&](auto point) { this->Use(point); }); });
      }
    }
  }

  void Use(vtkIdType point)
  {
    vtkIdType& order = this->Orders[static_cast<std::size_t>(point)];
    if (order == Never)
    {
      order = static_cast<vtkIdType>(this->UsedGhosts.size());
      this->UsedGhosts.push_back(point);
    }
  }

  PointQuestion QuestionOf(vtkIdType point) const
  {
    PointQuestion question;
    this->Piece->GetPoint(point, question.X.X);
    question.GlobalId = -1;
    question.Point = point;
    question.Order = this->Orders[static_cast<std::size_t>(point)];
    question.IsIncomplete =
      !this->Incomplete.empty() && this->Incomplete[static_cast<std::size_t>(point)];
    return question;
  }

  void AskByGlobalIds()
  {
    vtkDataArray* ids = this->Piece->GetPointData()->GetGlobalIds();
    for (vtkIdType point = 0; point < this->Piece->GetNumberOfPoints(); ++point)
    {
      PointQuestion question = this->QuestionOf(point);
      question.GlobalId = static_cast<vtkIdType>(ids->GetTuple1(point));
      const std::size_t to = static_cast<std::size_t>(question.GlobalId) % this->Queries.size();
      this->Queries[to].push_back(question);
      this->QueriedPoints[to].push_back(point);
    }
  }

  /// Around a point, where what is the same point may be.
  static skd::Box3 Around(const skd::Box3& point, const SkdRounding& rounding)
  {
    return point.Inflated(64.0 * rounding.ToleranceAt(point.Min));
  }

  /// The bounds of other pieces where points of this one may be.
  std::vector<skd::Box3> FindNeighbours(const SkdRounding& rounding) const
  {
    const skd::Box3& bounds = this->Facts.Of(this->Transport.GetRank()).Bounds;
    const double largest = std::min(skd::LargestCoordinate(bounds), SkdMeasurable.Largest);
    const double most = rounding.ToleranceAt({ { largest, largest, largest } });
    const skd::Box3 own = bounds.Inflated(64.0 * most);
    std::vector<skd::Box3> neighbours;
    for (const int process : this->Facts.GetFull())
    {
      const skd::Box3& other = this->Facts.Of(process).Bounds;
      if (process != this->Transport.GetRank() && other.Overlaps(own))
      {
        neighbours.push_back(other);
      }
    }
    return neighbours;
  }

  /// The points that are in them, and no others are another piece's, too.
  std::vector<vtkIdType> FindPointsIn(
    const std::vector<skd::Box3>& neighbours, const SkdRounding& rounding) const
  {
    std::vector<vtkIdType> points;
    const vtkIdType number = neighbours.empty() ? 0 : this->Piece->GetNumberOfPoints();
    for (vtkIdType point = 0; point < number; ++point)
    {
      const skd::Box3 box = Around(SkdBoxOfPoint(this->Piece, point), rounding);
      if (std::any_of(neighbours.begin(), neighbours.end(),
            [&box](const skd::Box3& other) { return other.Overlaps(box); }))
      {
        points.push_back(point);
      }
    }
    return points;
  }

  // Of those points that others may have each process tells the others a cover.
  void AskByCoordinates(const SkdRounding& rounding)
  {
    const std::vector<vtkIdType> points =
      this->FindPointsIn(this->FindNeighbours(rounding), rounding);
    std::vector<skd::Box3> boxes;
    for (const vtkIdType point : points)
    {
      boxes.push_back(SkdBoxOfPoint(this->Piece, point));
    }
    const SkdCut cut(this->Transport, boxes);
    const PointBins bins(rounding, this->Transport.GetNumber());
    std::vector<int> owners;
    std::vector<std::size_t> to;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      cut.FindOverlapping(Around(boxes[i], rounding), owners);
      if (std::all_of(owners.begin(), owners.end(),
            [this](int process) { return process == this->Transport.GetRank(); }))
      {
        continue;
      }
      const PointQuestion question = this->QuestionOf(points[i]);
      bins.Find(question.X, to);
      for (const std::size_t process : to)
      {
        this->Queries[process].push_back(question);
        this->QueriedPoints[process].push_back(process == to.front() ? points[i] : -1);
      }
    }
  }

  void TakeOrigins(
    const Answers& answers, std::vector<SkdPointOrigin>& origins, std::vector<vtkIdType>& likes)
  {
    origins.reserve(this->Orders.size());
    for (std::size_t point = 0; point < this->Orders.size(); ++point)
    {
      const bool isUsed = this->Orders[point] != Never;
      origins.push_back(isUsed
          ? SkdPointOrigin{ this->Transport.GetRank(), static_cast<vtkIdType>(point) }
          : SkdPointOrigin{ -1, -1 });
    }
    this->Numbered = origins;
    for (std::size_t to = 0; to < answers.size(); ++to)
    {
      for (std::size_t i = 0; i < answers[to].size(); ++i)
      {
        if (this->QueriedPoints[to][i] >= 0)
        {
          const auto point = static_cast<std::size_t>(this->QueriedPoints[to][i]);
          this->Numbered[point] = answers[to][i].Numbered;
          origins[point] = answers[to][i].Data;
          const SkdPointOrigin& first = answers[to][i].FirstLike;
          likes[point] =
            first.Process < 0 ? -1 : first.Point * this->Transport.GetNumber() + first.Process;
        }
      }
    }
  }

  bool IsOwn(vtkIdType point) const
  {
    const SkdPointOrigin& origin = this->Numbered[static_cast<std::size_t>(point)];
    return origin.Process == this->Transport.GetRank() && origin.Point == point;
  }

  /// Those that no earlier piece has.
  void NumberOwn(SkdPieceNumbers& numbers) const
  {
    std::vector<vtkIdType> own;
    own.reserve(this->Orders.size());
    for (std::size_t point = 0; point < this->Orders.size(); ++point)
    {
      if (this->Orders[point] == AtOnce && this->IsOwn(static_cast<vtkIdType>(point)))
      {
        own.push_back(static_cast<vtkIdType>(point));
      }
    }
    std::vector<vtkIdType> ghosts;
    std::copy_if(this->UsedGhosts.begin(), this->UsedGhosts.end(), std::back_inserter(ghosts),
      [&](vtkIdType point) { return this->IsOwn(point); });
    const std::vector<SkdRunningSum> sums = SkdSumOver(this->Transport,
      { static_cast<vtkIdType>(own.size()), static_cast<vtkIdType>(ghosts.size()) });
    const auto number = [&](const std::vector<vtkIdType>& points, vtkIdType next)
    {
      for (const vtkIdType point : points)
      {
        numbers.PointIds[static_cast<std::size_t>(point)] = next++;
      }
    };
    number(own, sums[0].Before);
    number(ghosts, sums[0].All + sums[1].Before);
    numbers.NumberOfPoints = sums[0].All + sums[1].All;
  }

  void AskForOthers(SkdPieceNumbers& numbers) const
  {
    SkdRowsByProcess<vtkIdType> queries(this->Queries.size());
    SkdRowsByProcess<std::size_t> points(this->Queries.size());
    for (std::size_t point = 0; point < this->Orders.size(); ++point)
    {
      const SkdPointOrigin& origin = this->Numbered[point];
      if (numbers.PointIds[point] < 0 && origin.Process >= 0)
      {
        queries[static_cast<std::size_t>(origin.Process)].push_back(origin.Point);
        points[static_cast<std::size_t>(origin.Process)].push_back(point);
      }
    }
    const SkdRowsByProcess<vtkIdType> ids = SkdAsk<vtkIdType>(this->Transport, queries,
      [&](SkdRowsByProcess<vtkIdType> all)
      {
        for (std::vector<vtkIdType>& some : all)
        {
          std::transform(some.begin(), some.end(), some.begin(),
            [&](vtkIdType point) { return numbers.PointIds[static_cast<std::size_t>(point)]; });
        }
        return all;
      });
    for (std::size_t process = 0; process < ids.size(); ++process)
    {
      for (std::size_t i = 0; i < ids[process].size(); ++i)
      {
        numbers.PointIds[points[process][i]] = ids[process][i];
      }
    }
  }

  SkdTransport& Transport;
  vtkDataSet* Piece;
  const SkdAllFacts& Facts;
  std::vector<vtkIdType> Orders;         // by point
  std::vector<unsigned char> Incomplete; // likewise, or none is
  std::vector<SkdPointOrigin> Numbered;  // by whom each is
  std::vector<vtkIdType> UsedGhosts;     // in their order
  Questions Queries;
  SkdRowsByProcess<vtkIdType> QueriedPoints; // -1: the answer is another's
};
}

void SkdNumberPoints(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  SkdPieceNumbers& numbers, std::vector<vtkIdType>& likes)
{
  PointNumbering(transport, piece, facts).Number(numbers, likes);
}
}
