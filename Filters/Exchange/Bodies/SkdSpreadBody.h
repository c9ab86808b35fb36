// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSpreadBody.h
 * @brief What a Source encloses that stays in its pieces: each process has the faces of its own
 * cells.
 *
 * Nearest faces are found by asking (SkdNearestExchange). Whether a point is inside is decided as
 * by SkdSolid: along one line to the outside, on which each process counts the passes through its
 * own faces; the sums are exact, because each facet decides for itself whether the line passes it.
 */

#ifndef SkdSpreadBody_h
#define SkdSpreadBody_h

#include "Bodies/SkdBody.h"
#include "Exchange/Bodies/SkdSpreadShells.h"
#include "Exchange/SkdSpreadSource.h"
#include "Pipeline/SkdLoop.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace skdtree
{
/// What came of a collective search.
enum class SkdSpreadResult
{
  Done = 0,
  Undecided, // of a point the passes do not say whether it is inside: bodies overlap or are nested
  Aborted
};

class SkdSpreadBody
{
public:
  struct Line
  {
    skd::Vector3 From;
    skd::Vector3 To;
  };

  SkdSpreadBody() = default;

  /// The body of some blocks of a source, given as by BringTouching(). All processes must call it
  /// together.
  SkdSpreadBody(
    const SkdSpreadSource& spread, const std::vector<SkdBlock>& touching, double epsilon);

  /// Updates the body to all blocks of the source; returns the number of trees built. All processes
  /// must call it together.
  int Update(const SkdSpreadSource& spread, double epsilon);

  /// Forgets all.
  void Clear() { *this = SkdSpreadBody(); }

  ///@{
  /// Of all processes.
  vtkIdType GetNumberOfFaces() const { return this->NumberOfFaces; }
  vtkIdType GetNumberOfOpenEdges() const { return this->OpenEdges; }
  const SkdTreeCounts& GetCounts() const { return this->Counts; }
  const double* GetBounds() const { return this->Bounds; }
  ///@}

  /// Whether a point is in the bounds of all faces.
  bool BoundsHold(const double x[3]) const;

  /// Whether its faces are those of the whole, and tell sides: it is closed, has no curved cells,
  /// and volume cells are of no structured grid. Otherwise the source must be gathered. The same on
  /// all processes.
  bool IsFit() const { return this->Fit; }

  /// The nearest face of this process, as a cell of the whole. Thread-safe.
  std::optional<SkdNearest> FindNearest(const double x[3], double maximumDistance) const
  {
    return SkdFindNearestFace(this->Faces, this->Origins, x, maximumDistance);
  }

  /// For those of n points that isDue(i), whether they are inside: calls set(i, isInside). See
  /// SkdSolid::Ask. All processes must call it together.
  template <class PointOf, class IsDue, class Set>
  SkdSpreadResult FindSides(
    std::size_t n, const PointOf& pointOf, const IsDue& isDue, const Set& set, SkdLoop& loop);

  /// For n lines, each with both ends outside: calls set(i, passes) with the passes along it, in
  /// order, also if there are none; SkdPassAlong::At is between 0 and 1. See SkdSolid::FindPasses.
  /// All processes must call it together.
  template <class LineOf, class Set>
  void FindPasses(std::size_t n, const LineOf& lineOf, const Set& set);

  /// How often a point or a line was sent to another process.
  std::uint64_t CountRequests() const { return this->NumberOfRequests; }

private:
  /// Of a line through facets: how many, and the sum of their directions when each shell is
  /// oriented outward.
  struct Passes
  {
    int Number = 0;
    int Sum = 0;

    void Add(const Passes& other)
    {
      this->Number += other.Number;
      this->Sum += other.Sum;
    }
  };

  /// A point of a round whose side is asked for.
  struct Open
  {
    std::size_t Number; // among all
    Line Ray;
    Passes Found;
  };

  /// A pass of a line through a facet: where, and in which direction when its shell is oriented
  /// outward.
  struct Pass
  {
    double At;
    int Ray;
  };
  using PassesOfLines = std::vector<std::vector<Pass>>;

  void Make(const std::vector<SkdBlock>& blocks);
  int Build(double epsilon, bool isNew);
  void SetFaces(const SkdBoundary& boundary, const std::vector<SkdBlock>& blocks,
    const std::function<bool(const SkdBoundary::Origin&)>& isOwn);
  void FindBounds();
  Line SegmentOutOf(const skd::Vector3& x) const;
  Passes CountHere(const Line& line) const;
  std::vector<Pass> FindHere(const Line& line) const;
  PassesOfLines FindOfAll(const std::vector<Line>& lines);
  std::vector<SkdPassAlong> InOrder(std::vector<Pass> passes) const;
  void ListProcesses(const Line& line, std::vector<int>& processes) const;
  SkdSpreadResult Decide(std::vector<Open>& points, SkdLoop& loop);
  void AskOthers(std::vector<Open>& points);
  bool IsClear(const Passes& passes) const;

  const SkdSpreadSource* Spread = nullptr;
  vtkSmartPointer<vtkDataObject> Known; // what the faces are of
  std::vector<SkdBoundary::Origin> Origins;
  vtkSmartPointer<vtkSkdTreeCellLocator> Faces;
  vtkSmartPointer<vtkSkdTreeCellLocator> Surface; // often that of the faces
  SkdSpreadShells Shells;

  ///@{
  /// Of all processes.
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  vtkIdType NumberOfFaces = 0;
  vtkIdType OpenEdges = 0;
  bool HasRepeats = false; // see SkdBoundary
  bool Fit = false;
  SkdTreeCounts Counts;
  ///@}

  std::uint64_t NumberOfRequests = 0;
};

//------------------------------------------------------------------------------
template <class PointOf, class IsDue, class Set>
SkdSpreadResult SkdSpreadBody::FindSides(
  std::size_t n, const PointOf& pointOf, const IsDue& isDue, const Set& set, SkdLoop& loop)
{
  SkdTransport& transport = this->Spread->GetTransport();
  const std::size_t share = SkdSizeOfRound(transport.GetNumber(), sizeof(Line));
  SkdSpreadResult own = SkdSpreadResult::Done;
  std::size_t begin = 0;
  while (true)
  {
    const int rest = begin < n ? 1 : 0;
    const int state =
      SkdMostOf(transport, own == SkdSpreadResult::Done ? rest : 1 + static_cast<int>(own));
    if (state != 1)
    {
      return state == 0 ? SkdSpreadResult::Done : static_cast<SkdSpreadResult>(state - 1);
    }
    const std::size_t end = std::min(n, begin + share);
    std::vector<Open> points;
    for (std::size_t i = begin; i < end; ++i)
    {
      const skd::Vector3 x = pointOf(i);
      if (isDue(i) && this->BoundsHold(x.X))
      {
        points.push_back({ i, this->SegmentOutOf(x), {} });
      }
      else if (isDue(i))
      {
        set(i, false);
      }
    }
    own = this->Decide(points, loop);
    for (const Open& point : points)
    {
      set(point.Number, point.Found.Number == 1 || point.Found.Sum != 0);
    }
    begin = end;
  }
}

template <class LineOf, class Set>
void SkdSpreadBody::FindPasses(std::size_t n, const LineOf& lineOf, const Set& set)
{
  SkdTransport& transport = this->Spread->GetTransport();
  const std::size_t share = SkdSizeOfRound(transport.GetNumber(), sizeof(Line));
  for (std::size_t begin = 0; SkdMostOf(transport, begin < n ? 1 : 0) == 1;)
  {
    const std::size_t end = std::min(n, begin + share);
    std::vector<Line> lines;
    for (std::size_t i = begin; i < end; ++i)
    {
      lines.push_back(lineOf(i));
    }
    const PassesOfLines found = this->FindOfAll(lines);
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      set(begin + i, this->InOrder(found[i]));
    }
    begin = end;
  }
}
}

#endif
