// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPieceNumbers.h"

#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Cells/Read/SkdVisitPoints.h"
#include "Exchange/SkdCut.h"
#include "Exchange/SkdNearPoints.h"
#include "Exchange/SkdPieceArrays.h"
#include "Exchange/SkdPointQuestions.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skdtree
{
namespace
{
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
    , Orders(static_cast<std::size_t>(piece->GetNumberOfPoints()), SkdPointQuestion::AtOnce)
    , Incomplete(SkdIncompleteOf(piece, vtkDataObject::POINT))
    , Queries(static_cast<std::size_t>(transport.GetNumber()))
    , QueriedPoints(Queries.size())
  {
    this->FindOrders();
  }

  void Number(SkdPieceNumbers& numbers, std::vector<vtkIdType>& likes)
  {
    SkdRepeatedId repeated;
    const SkdPointAnswers answers = this->Ask(false, repeated);
    this->TakeOrigins(answers, numbers.PointOrigins);
    this->TakeLikes(answers, likes);
    this->NumberOwn(numbers);
    this->AskForOthers(numbers);
    numbers.Repeated =
      this->Facts.HavePointIds() ? SkdFirstRepeatedId(this->Transport, repeated) : repeated;
  }

  /// Only of points that cells of other pieces may have, too.
  void FindLikes(std::vector<vtkIdType>& likes)
  {
    SkdRepeatedId repeated;
    this->TakeLikes(this->Ask(true, repeated), likes);
  }

private:
  SkdPointAnswers Ask(bool isOfCells, SkdRepeatedId& repeated)
  {
    const bool byIds = this->Facts.HavePointIds();
    const SkdRounding rounding = this->Facts.GetRounding();
    byIds ? this->AskByGlobalIds() : this->AskByCoordinates(rounding, isOfCells);
    return SkdAsk<SkdPointAnswer>(this->Transport, this->Queries,
      [&](const SkdPointQuestions& queries)
      {
        return byIds ? SkdAnswerByGlobalIds(queries, this->Facts.GetLargestCoordinate(), repeated)
                     : SkdAnswerByCoordinates(queries, rounding);
      });
  }

  // Ghost points in the order in which cells that are no ghosts use them.
  void FindOrders()
  {
    const std::vector<unsigned char> ghosts = SkdDuplicatesOf(this->Piece, vtkDataObject::POINT);
    if (ghosts.empty())
    {
      return;
    }
    std::transform(ghosts.begin(), ghosts.end(), this->Orders.begin(),
      [](unsigned char isGhost)
      { return isGhost ? SkdPointQuestion::Never : SkdPointQuestion::AtOnce; });
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
    if (order == SkdPointQuestion::Never)
    {
      order = static_cast<vtkIdType>(this->UsedGhosts.size());
      this->UsedGhosts.push_back(point);
    }
  }

  SkdPointQuestion QuestionOf(vtkIdType point) const
  {
    SkdPointQuestion question;
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
      SkdPointQuestion question = this->QuestionOf(point);
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

  /// The largest tolerance of this piece's points.
  double MostOf(const SkdRounding& rounding) const
  {
    const skd::Box3& bounds = this->Facts.Of(this->Transport.GetRank()).Bounds;
    const double largest = std::min(skd::LargestCoordinate(bounds), SkdMeasurable.Largest);
    return rounding.ToleranceAt({ { largest, largest, largest } });
  }

  /// The bounds of other pieces where points of this one may be.
  std::vector<skd::Box3> FindNeighbours(const SkdRounding& rounding) const
  {
    const skd::Box3& bounds = this->Facts.Of(this->Transport.GetRank()).Bounds;
    const skd::Box3 own = bounds.Inflated(64.0 * this->MostOf(rounding));
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

  /// The points that are in them, or nowhere; no others are another piece's, too.
  std::vector<vtkIdType> FindPointsIn(
    const std::vector<skd::Box3>& neighbours, const SkdRounding& rounding) const
  {
    std::vector<vtkIdType> points;
    std::vector<skd::Box3> wide; // by more than any point's tolerance: most points are not in them
    for (const skd::Box3& other : neighbours)
    {
      wide.push_back(other.Inflated(128.0 * this->MostOf(rounding)));
    }
    const auto visit = [&](vtkIdType point, const skd::Vector3& x)
    {
      if (!SkdHasDistances(x)) // nowhere: any other piece may have it
      {
        points.push_back(point);
        return;
      }
      if (std::none_of(
            wide.begin(), wide.end(), [&x](const skd::Box3& other) { return other.Contains(x); }))
      {
        return;
      }
      const skd::Box3 box = Around(SkdBoxOfPoint(this->Piece, point), rounding);
      if (std::any_of(neighbours.begin(), neighbours.end(),
            [&box](const skd::Box3& other) { return other.Overlaps(box); }))
      {
        points.push_back(point);
      }
    };
    if (this->Facts.GetFull().size() > 1)
    {
      SkdVisitPoints(this->Piece, visit);
    }
    return points;
  }

  /// Those of some points that have a cell of such points alone: another piece may have it.
  std::vector<vtkIdType> FindPointsOfCells(const std::vector<vtkIdType>& some) const
  {
    enum Known : unsigned char
    {
      IsOther,
      IsSome,
      IsOfCell
    };
    std::vector<unsigned char> known(some.empty() ? 0 : this->Orders.size(), IsOther);
    for (const vtkIdType point : some)
    {
      known[static_cast<std::size_t>(point)] = IsSome;
    }
    const SkdCellReader reader(this->Piece);
    vtkNew<vtkIdList> list;
    reader.VisitCells(0, some.empty() ? 0 : this->Piece->GetNumberOfCells(), list,
      [&known](vtkIdType, const auto* ids, std::size_t size)
      {
        if (std::all_of(ids, ids + size,
              [&known](auto id) { return known[static_cast<std::size_t>(id)] != IsOther; }))
        {
          std::for_each(
            ids, ids + size, [&known](auto id) { known[static_cast<std::size_t>(id)] = IsOfCell; });
        }
      });
    std::vector<vtkIdType> points;
    std::copy_if(some.begin(), some.end(), std::back_inserter(points),
      [&known](vtkIdType point) { return known[static_cast<std::size_t>(point)] == IsOfCell; });
    return points;
  }

  // Of those points that others may have each process tells the others a cover.
  void AskByCoordinates(const SkdRounding& rounding, bool isOfCells)
  {
    std::vector<vtkIdType> points = this->FindPointsIn(this->FindNeighbours(rounding), rounding);
    if (isOfCells)
    {
      points = this->FindPointsOfCells(points);
    }
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
      if (!boxes[i].IsEmpty() &&
        std::all_of(owners.begin(), owners.end(),
          [this](int process) { return process == this->Transport.GetRank(); }))
      {
        continue;
      }
      const SkdPointQuestion question = this->QuestionOf(points[i]);
      bins.Find(question.X, to);
      for (const std::size_t process : to)
      {
        this->Queries[process].push_back(question);
        this->QueriedPoints[process].push_back(process == to.front() ? points[i] : -1);
      }
    }
  }

  template <class Take>
  void VisitAnswers(const SkdPointAnswers& answers, const Take& take) const
  {
    for (std::size_t to = 0; to < answers.size(); ++to)
    {
      for (std::size_t i = 0; i < answers[to].size(); ++i)
      {
        if (this->QueriedPoints[to][i] >= 0)
        {
          take(static_cast<std::size_t>(this->QueriedPoints[to][i]), answers[to][i]);
        }
      }
    }
  }

  void TakeLikes(const SkdPointAnswers& answers, std::vector<vtkIdType>& likes) const
  {
    likes.assign(this->Orders.size(), -1);
    this->VisitAnswers(answers,
      [&](std::size_t point, const SkdPointAnswer& answer)
      {
        const SkdPointOrigin& first = answer.FirstLike;
        likes[point] =
          first.Process < 0 ? -1 : first.Point * this->Transport.GetNumber() + first.Process;
      });
  }

  void TakeOrigins(const SkdPointAnswers& answers, std::vector<SkdPointOrigin>& origins)
  {
    origins.reserve(this->Orders.size());
    for (std::size_t point = 0; point < this->Orders.size(); ++point)
    {
      const bool isUsed = this->Orders[point] != SkdPointQuestion::Never;
      origins.push_back(isUsed
          ? SkdPointOrigin{ this->Transport.GetRank(), static_cast<vtkIdType>(point) }
          : SkdPointOrigin{ -1, -1 });
    }
    this->Numbered = origins;
    this->VisitAnswers(answers,
      [&](std::size_t point, const SkdPointAnswer& answer)
      {
        this->Numbered[point] = answer.Numbered;
        origins[point] = answer.Data;
      });
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
      if (this->Orders[point] == SkdPointQuestion::AtOnce &&
        this->IsOwn(static_cast<vtkIdType>(point)))
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
  SkdPointQuestions Queries;
  SkdRowsByProcess<vtkIdType> QueriedPoints; // -1: the answer is another's
};
}

void SkdNumberPoints(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  SkdPieceNumbers& numbers, std::vector<vtkIdType>& likes)
{
  PointNumbering(transport, piece, facts).Number(numbers, likes);
}

void SkdFindLikePoints(SkdTransport& transport, vtkDataSet* piece, const SkdAllFacts& facts,
  std::vector<vtkIdType>& likes)
{
  PointNumbering(transport, piece, facts).FindLikes(likes);
}
}
