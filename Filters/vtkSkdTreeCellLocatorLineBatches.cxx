// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The locator's batches of lines and rays.
#include "vtkSkdTreeCellLocator.h"

#include "Cells/Search/SkdBatchLists.h"
#include "Cells/Search/SkdBatchOutputs.h"
#include "Cells/Search/SkdLocatorState.h"

#include "vtkDoubleArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// A query: both ends, and what a parameter is multiplied by before it is handed out.
struct Line
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
class GivenLines
{
public:
  explicit GivenLines(const SkdBatch& batch)
    : Batch(batch)
  {
  }

  Line Get(vtkIdType slot) const
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
class LinesOfRays
{
public:
  LinesOfRays(const SkdBatch& origins, vtkDataArray* directions, const skd::Box3& bounds,
    const SkdLocatorState& state, double maximum, double tol)
    : Origins(origins)
    , Directions(directions)
    , Maximum(maximum)
    , Centre(bounds.IsEmpty() ? SkdNoPoint() : state.ToWorld(bounds.Centroid()))
    , Radius(0.5 * bounds.Diagonal() + std::max(tol, 0.0))
  {
  }

  Line Get(vtkIdType slot) const
  {
    Line line;
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
struct LineQueries
{
  const SkdCellTree& Tree;
  const SkdLocatorState& State;
  vtkDataSet* Data;
  double Tolerance;

  skd::Segment<3> Segment(const Line& line) const { return this->State.ToTree(line.From, line.To); }
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

struct HitOutputs
{
  vtkIdTypeArray* CellIds;
  vtkDoubleArray* Parameters;
  const char* ParameterName;
  vtkDoubleArray* Points;
};

template <class Lines>
vtkIdType FindFirstHits(
  const LineQueries& queries, const SkdBatch& batch, const Lines& lines, const HitOutputs& outputs)
{
  const vtkIdType size = batch.GetNumberOfQueries();
  vtkIdType* ids = SkdPrepare(outputs.CellIds, "SkdCellId", 1, size);
  double* ts = SkdPrepare(outputs.Parameters, outputs.ParameterName, 1, size);
  double* xs = SkdPrepare(outputs.Points, "SkdPoint", 3, size);
  return batch.CountTrue([&] { return queries.Source(); },
    [&](const SkdCellSource& source, vtkIdType slot)
    {
      const Line line = lines.Get(slot);
      const SkdHitCell hit =
        queries.Tree.FindFirstHit(queries.Segment(line), queries.Tolerance, source);
      const bool isHit = hit.Id >= 0;
      SkdStoreAt(ids, slot, hit.Id);
      SkdStoreAt(ts, slot, isHit ? hit.T * line.Scale : vtkMath::Nan());
      SkdStoreAt(xs, slot, isHit ? line.At(hit.T) : SkdNoPoint());
      return isHit;
    });
}

struct Hit
{
  vtkIdType Id;
  double T;
};

template <class Lines>
vtkIdType FindHitLists(const LineQueries& queries, const SkdBatch& batch, const Lines& lines,
  vtkIdTypeArray* offsets, const HitOutputs& outputs)
{
  const SkdBatchLists<Hit> hits(batch, offsets,
    [&](vtkIdType slot, std::vector<Hit>& values)
    {
      const skd::Segment<3> segment = queries.Segment(lines.Get(slot));
      for (const SkdHitCell& hit :
        queries.Tree.FindHits(segment, queries.Tolerance, queries.Source()))
      {
        values.push_back({ hit.Id, hit.T });
      }
    });
  const vtkIdType size = hits.GetNumberOfValues();
  vtkIdType* ids = SkdPrepare(outputs.CellIds, "SkdCellId", 1, size);
  double* ts = SkdPrepare(outputs.Parameters, outputs.ParameterName, 1, size);
  double* xs = SkdPrepare(outputs.Points, "SkdPoint", 3, size);
  hits.ForEach(
    [&](vtkIdType index, vtkIdType slot, const Hit& hit)
    {
      const Line line = lines.Get(slot);
      SkdStoreAt(ids, index, hit.Id);
      SkdStoreAt(ts, index, hit.T * line.Scale);
      SkdStoreAt(xs, index, line.At(hit.T));
    });
  return size;
}

/// The reason why a batch of two arrays of points, with these names, is invalid.
std::string ReasonAgainstBoth(vtkDataArray* first, const std::string& firsts, vtkDataArray* second,
  const std::string& seconds, const SkdOutputs& outputs)
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

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::IntersectWithLines(vtkDataArray* lines, vtkIdTypeArray* cellIds,
  vtkDoubleArray* parameters, vtkDoubleArray* points, double tol)
{
  if (SkdIsRefused(
        this, "IntersectWithLines", lines, SkdBatchOf::Lines, { cellIds, parameters, points }))
  {
    return -1;
  }
  const LineQueries queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(lines, SkdBatchOf::Lines, queries.Sorts());
  return FindFirstHits(
    queries, batch, GivenLines(batch), { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindAllHits(vtkDataArray* lines, vtkIdTypeArray* offsets,
  vtkIdTypeArray* cellIds, vtkDoubleArray* parameters, vtkDoubleArray* points, double tol)
{
  if (SkdIsRefused(
        this, "FindAllHits", lines, SkdBatchOf::Lines, { offsets, cellIds, parameters, points }))
  {
    return -1;
  }
  const LineQueries queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(lines, SkdBatchOf::Lines, queries.Sorts());
  return FindHitLists(
    queries, batch, GivenLines(batch), offsets, { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::IntersectWithSegments(vtkDataArray* starts, vtkDataArray* ends,
  vtkIdTypeArray* cellIds, vtkDoubleArray* parameters, vtkDoubleArray* points, double tol)
{
  if (SkdIsRefused(this, "IntersectWithSegments",
        ReasonAgainstBoth(starts, "starts", ends, "ends", { cellIds, parameters, points })))
  {
    return -1;
  }
  const LineQueries queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(starts, ends, queries.Sorts());
  return FindFirstHits(
    queries, batch, GivenLines(batch), { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindAllSegmentHits(vtkDataArray* starts, vtkDataArray* ends,
  vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds, vtkDoubleArray* parameters,
  vtkDoubleArray* points, double tol)
{
  if (SkdIsRefused(this, "FindAllSegmentHits",
        ReasonAgainstBoth(
          starts, "starts", ends, "ends", { offsets, cellIds, parameters, points })))
  {
    return -1;
  }
  const LineQueries queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(starts, ends, queries.Sorts());
  return FindHitLists(
    queries, batch, GivenLines(batch), offsets, { cellIds, parameters, "SkdParameter", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::IntersectWithRays(vtkDataArray* origins, vtkDataArray* directions,
  vtkIdTypeArray* cellIds, vtkDoubleArray* distances, vtkDoubleArray* points, double maximum,
  double tol)
{
  if (SkdIsRefused(this, "IntersectWithRays",
        ReasonAgainstBoth(
          origins, "origins", directions, "directions", { cellIds, distances, points })))
  {
    return -1;
  }
  const LineQueries queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(origins, SkdBatchOf::Points, queries.Sorts());
  const LinesOfRays lines(
    batch, directions, queries.Tree.Cells().GetBounds(), queries.State, maximum, tol);
  return FindFirstHits(queries, batch, lines, { cellIds, distances, "SkdDistance", points });
}

//------------------------------------------------------------------------------
vtkIdType vtkSkdTreeCellLocator::FindAllRayHits(vtkDataArray* origins, vtkDataArray* directions,
  vtkIdTypeArray* offsets, vtkIdTypeArray* cellIds, vtkDoubleArray* distances,
  vtkDoubleArray* points, double maximum, double tol)
{
  if (SkdIsRefused(this, "FindAllRayHits",
        ReasonAgainstBoth(
          origins, "origins", directions, "directions", { offsets, cellIds, distances, points })))
  {
    return -1;
  }
  const LineQueries queries{ this->GetTree(), *this->Impl, this->DataSet, tol };
  const SkdBatch batch(origins, SkdBatchOf::Points, queries.Sorts());
  const LinesOfRays lines(
    batch, directions, queries.Tree.Cells().GetBounds(), queries.State, maximum, tol);
  return FindHitLists(
    queries, batch, lines, offsets, { cellIds, distances, "SkdDistance", points });
}
VTK_ABI_NAMESPACE_END
