// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdLineBatches.h
 * Batches of lines and rays against a tree of cells: first hits, and all hits as lists.
 */
#ifndef SkdLineBatches_h
#define SkdLineBatches_h

#include "Cells/Search/SkdBatchLists.h"
#include "Cells/Search/SkdBatchOutputs.h"
#include "Cells/Search/SkdLocatorState.h"

#include "vtkDoubleArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace skdtree
{
/// A query: both ends, and what a parameter is multiplied by before it is handed out.
struct SkdBatchLine
{
  double From[3];
  double To[3];
  double Scale;

  skd::Vector3 At(double t) const
  {
    return skd::Lerp(SkdVector(this->From), SkdVector(this->To), t);
  }
};

/// Reads lines as they are given.
class SkdGivenLines
{
public:
  explicit SkdGivenLines(const SkdBatch& batch)
    : Batch(batch)
  {
  }

  SkdBatchLine Get(vtkIdType slot) const
  {
    double ends[6];
    this->Batch.ReadWithEnds(slot, ends);
    return { { ends[0], ends[1], ends[2] }, { ends[3], ends[4], ends[5] }, 1.0 };
  }

private:
  const SkdBatch& Batch;
};

/// Makes lines of rays: as long as they may go, but no longer than it takes to leave the ball
/// around all cells, for the shorter a line the finer its parameter. A ray without a direction, or
/// that may go nowhere, becomes a line that hits nothing.
class SkdLinesOfRays
{
public:
  SkdLinesOfRays(const SkdBatch& origins, vtkDataArray* directions, const skd::Box3& bounds,
    const SkdLocatorState& state, double maximum, double tol)
    : Origins(origins)
    , Directions(directions)
    , Maximum(maximum)
    , Centre(bounds.IsEmpty() ? SkdNoPoint() : state.ToWorld(bounds.Centroid()))
    , Radius(0.5 * bounds.Diagonal() + std::max(tol, 0.0))
  {
  }

  SkdBatchLine Get(vtkIdType slot) const
  {
    SkdBatchLine line;
    double along[3];
    this->Origins.Read(slot, line.From);
    this->Directions.Read(slot, along);
    line.Scale = this->LengthFrom(SkdVector(line.From));
    // Divided by the largest first, so that no square overflows or vanishes.
    const double largest = std::max({ std::abs(along[0]), std::abs(along[1]), std::abs(along[2]) });
    const skd::Vector3 scaled{ { along[0] / largest, along[1] / largest, along[2] / largest } };
    SkdStore(SkdVector(line.From) + (line.Scale / skd::Norm(scaled)) * scaled, line.To);
    return line;
  }

private:
  /// NaN of a maximum that is negative or NaN.
  double LengthFrom(const skd::Vector3& origin) const
  {
    constexpr double slack = 64.0 * std::numeric_limits<double>::epsilon();
    const double maxDistance = (1.0 + slack) * (skd::Norm(origin - this->Centre) + this->Radius) +
      slack * skd::Norm(this->Centre);
    return this->Maximum >= 0.0 ? std::min(maxDistance, this->Maximum) : vtkMath::Nan();
  }

  const SkdBatch& Origins;
  SkdTuples Directions;
  double Maximum;
  skd::Vector3 Centre;
  double Radius;
};

/// The locator that is queried.
struct SkdLineSearch
{
  const SkdCellTree& Tree;
  const SkdLocatorState& State;
  vtkDataSet* Data;
  double Tolerance;

  skd::Segment<3> Segment(const SkdBatchLine& line) const
  {
    return this->State.ToTree(line.From, line.To);
  }
  SkdCellSource Source() const { return { this->Data }; }

  /// Whether lines are sorted: not where the tree fits into a cache, some 25 MB, for a first hit is
  /// not much more work than its part of the sort. Sorted lines took 1.1 to 2.3 times as long as
  /// one by one in a tree of 7 * 10^4 triangles, even those that gain in one of 10^6.
  bool Sorts() const
  {
    constexpr std::uint32_t large = 1u << 18;
    return this->Tree.Cells().NumberOfCells() >= large;
  }
};

struct SkdHitOutputs
{
  vtkIdTypeArray* CellIds;
  vtkDoubleArray* Parameters;
  const char* ParameterName;
  vtkDoubleArray* Points;
};

/// Whether lines of a piece run about as the next one does: most of some of them.
template <class Lines>
bool SkdAreNeighbours(
  const SkdLineSearch& queries, const SkdBatch& batch, const Lines& lines, vtkIdType piece)
{
  constexpr vtkIdType step = SkdBatch::PieceSize / 8;
  int surplus = 0;
  for (vtkIdType at = piece * SkdBatch::PieceSize; at + 1 < batch.EndOf(piece); at += step)
  {
    const skd::Segment<3> pair[] = { queries.Segment(lines.Get(batch.GetSlot(at))),
      queries.Segment(lines.Get(batch.GetSlot(at + 1))) };
    surplus += queries.Tree.AreAlike(pair, 2) ? 1 : -1;
  }
  return surplus > 0;
}

/// The first hits of the lines of a piece, one by one; returns how many there are. What is called
/// for each of them has two callers, so compilers do not inline it of themselves.
template <class Lines, class Store>
SKD_FLATTEN vtkIdType SkdFindHitOfEach(const SkdLineSearch& queries, const SkdBatch& batch,
  const Lines& lines, vtkIdType piece, const Store& store)
{
  const SkdCellSource source = queries.Source();
  vtkIdType found = 0;
  batch.ForEachIn(piece,
    [&](vtkIdType slot)
    {
      const SkdBatchLine line = lines.Get(slot);
      found += store(
        slot, line, queries.Tree.FindFirstHit(queries.Segment(line), queries.Tolerance, source));
    });
  return found;
}

/// The first hits of a few lines: of all at once, if they run nearly alike.
inline void SkdFindHitsOfFew(const SkdLineSearch& queries, const SkdBatchLine* lines, int count,
  const SkdCellSource& source, SkdHitCell* hits)
{
  skd::Segment<3> segments[SkdLinesAtOnce];
  std::transform(lines, lines + count, segments,
    [&](const SkdBatchLine& line) { return queries.Segment(line); });
  if (!queries.Tree.FindFirstHits(segments, count, queries.Tolerance, hits))
  {
    std::transform(segments, segments + count, hits,
      [&](const skd::Segment<3>& segment)
      { return queries.Tree.FindFirstHit(segment, queries.Tolerance, source); });
  }
}

/// As SkdFindHitOfEach, of a piece whose lines are neighbours.
template <class Lines, class Store>
vtkIdType SkdFindHitsOfNeighbours(const SkdLineSearch& queries, const SkdBatch& batch,
  const Lines& lines, vtkIdType piece, const Store& store)
{
  const SkdCellSource source = queries.Source();
  vtkIdType found = 0;
  batch.ForEachFewIn<SkdLinesAtOnce>(piece,
    [&](const vtkIdType* slots, int count)
    {
      SkdBatchLine some[SkdLinesAtOnce];
      SkdHitCell hits[SkdLinesAtOnce];
      std::transform(slots, slots + count, some, [&](vtkIdType slot) { return lines.Get(slot); });
      SkdFindHitsOfFew(queries, some, count, source, hits);
      for (int i = 0; i < count; ++i)
      {
        found += store(slots[i], some[i], hits[i]);
      }
    });
  return found;
}

template <class Lines>
vtkIdType SkdFindFirstHits(const SkdLineSearch& queries, const SkdBatch& batch, const Lines& lines,
  const SkdHitOutputs& outputs)
{
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = SkdPrepare(outputs.CellIds, "SkdCellId", 1, size);
  double* ts = SkdPrepare(outputs.Parameters, outputs.ParameterName, 1, size);
  double* xs = SkdPrepare(outputs.Points, "SkdPoint", 3, size);
  const auto store = [&](vtkIdType slot, const SkdBatchLine& line, const SkdHitCell& hit)
  {
    const bool isHit = hit.Id >= 0;
    SkdStoreAt(ids, slot, hit.Id);
    SkdStoreAt(ts, slot, isHit ? hit.T * line.Scale : vtkMath::Nan());
    SkdStoreAt(xs, slot, isHit ? line.At(hit.T) : SkdNoPoint());
    return isHit ? 1 : 0;
  };
  std::atomic<vtkIdType> total(0);
  batch.ForEachPiece(
    [&](vtkIdType piece)
    {
      total += SkdAreNeighbours(queries, batch, lines, piece)
        ? SkdFindHitsOfNeighbours(queries, batch, lines, piece, store)
        : SkdFindHitOfEach(queries, batch, lines, piece, store);
    });
  return total;
}

struct SkdListedHit
{
  vtkIdType Id;
  double T;
};

/// All hits of the lines of a piece; close(slot) is called after those of each.
template <class Lines, class Close>
void SkdFindAllHitsIn(const SkdLineSearch& queries, const SkdBatch& batch, const Lines& lines,
  vtkIdType piece, std::vector<SkdListedHit>& values, const Close& close)
{
  const SkdCellSource source = queries.Source();
  const bool areNeighbours = SkdAreNeighbours(queries, batch, lines, piece);
  batch.ForEachFewIn<SkdLinesAtOnce>(piece,
    [&](const vtkIdType* slots, int count)
    {
      skd::Segment<3> segments[SkdLinesAtOnce];
      std::transform(slots, slots + count, segments,
        [&](vtkIdType slot) { return queries.Segment(lines.Get(slot)); });
      const std::vector<SkdHitOfLine>* ofAll =
        areNeighbours ? queries.Tree.FindHitsOfLines(segments, count, queries.Tolerance) : nullptr;
      std::size_t next = 0;
      for (int i = 0; i < count; ++i)
      {
        for (; ofAll && next < ofAll->size() && (*ofAll)[next].Line == i; ++next)
        {
          values.push_back({ (*ofAll)[next].Id, (*ofAll)[next].T });
        }
        if (!ofAll)
        {
          for (const SkdHitCell& hit :
            queries.Tree.FindHits(segments[i], queries.Tolerance, source))
          {
            values.push_back({ hit.Id, hit.T });
          }
        }
        close(slots[i]);
      }
    });
}

template <class Lines>
vtkIdType SkdFindHitLists(const SkdLineSearch& queries, const SkdBatch& batch, const Lines& lines,
  vtkIdTypeArray* offsets, const SkdHitOutputs& outputs)
{
  const SkdBatchLists<SkdListedHit> hits(batch, offsets,
    [&](vtkIdType piece, std::vector<SkdListedHit>& values, const auto& close)
    { SkdFindAllHitsIn(queries, batch, lines, piece, values, close); });
  const vtkIdType size = hits.GetNumberOfValues();
  vtkIdType* ids = SkdPrepare(outputs.CellIds, "SkdCellId", 1, size);
  double* ts = SkdPrepare(outputs.Parameters, outputs.ParameterName, 1, size);
  double* xs = SkdPrepare(outputs.Points, "SkdPoint", 3, size);
  hits.ForEach(
    [&](vtkIdType index, vtkIdType slot, const SkdListedHit& hit)
    {
      const SkdBatchLine line = lines.Get(slot);
      SkdStoreAt(ids, index, hit.Id);
      SkdStoreAt(ts, index, hit.T * line.Scale);
      SkdStoreAt(xs, index, line.At(hit.T));
    });
  return size;
}

/// The reason why a batch of two arrays of points, with these names, is invalid.
inline std::string SkdReasonAgainstBoth(vtkDataArray* first, const std::string& firsts,
  vtkDataArray* second, const std::string& seconds, const SkdOutputs& outputs)
{
  std::string reason = SkdReasonAgainst(first, firsts, SkdBatchOf::Points, outputs);
  if (reason.empty())
  {
    reason = SkdReasonAgainst(second, seconds, SkdBatchOf::Points, outputs);
  }
  if (reason.empty() && second->GetNumberOfTuples() != first->GetNumberOfTuples())
  {
    reason = "there are " + std::to_string(first->GetNumberOfTuples()) + " " + firsts + ", but " +
      std::to_string(second->GetNumberOfTuples()) + " " + seconds;
  }
  return reason;
}
}

#endif
