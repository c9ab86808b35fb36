// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCurveHits.h"

#include "Core/Curves/CurvePairSolver.h"
#include "Core/Curves/NearestOnCurves.h"
#include "Curves/SkdCurveHitGroups.h"
#include "Curves/SkdVisitCurves.h"
#include "Pipeline/SkdLoop.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// What continues a piece beyond its end is not where its curve goes on.
void ForgetBeyondEnds(const SkdCurveSpan& first, const SkdCurveSpan& second,
  const skd::CurvePairHit& hit, SkdCurveHit& found)
{
  const bool areAlong = skd::Dot(found.First.Tangent, found.Second.Tangent) > 0.0;
  const bool startsFirst = hit.T == 0.0 && first.Range.Min == 0.0;
  const bool endsFirst = hit.T == 1.0 && first.Range.Max == 1.0;
  const bool startsSecond = hit.S == 0.0 && second.Range.Min == 0.0;
  const bool endsSecond = hit.S == 1.0 && second.Range.Max == 1.0;
  if (startsFirst || (areAlong ? startsSecond : endsSecond))
  {
    found.Before = {};
  }
  if (endsFirst || (areAlong ? endsSecond : startsSecond))
  {
    found.After = {};
  }
}
}

//------------------------------------------------------------------------------
struct SkdCurveHitFinder::Worker
{
  skd::CurvePairSolver Solver;
  skd::NearestOnCurves Nearest;
  std::vector<SkdCurveHit> Hits;
  std::vector<SkdCurveHit> Near;
  std::vector<SkdCurveInterval> Intervals;
  std::vector<SkdCurveCandidate> Candidates;

  void TakeFrom(const Worker& other);
};

//------------------------------------------------------------------------------
SkdCurveHitFinder::SkdCurveHitFinder(
  const SkdCurveTree& first, const SkdCurveTree& second, const SkdCurveTask& task)
  : First(first)
  , Second(second)
  , Task(task)
  , Rounding(8.0 * std::numeric_limits<double>::epsilon() *
      std::max(skd::LargestCoordinate(first.GetCurves().GetBounds()),
        skd::LargestCoordinate(second.GetCurves().GetBounds())))
{
}

//------------------------------------------------------------------------------
SkdCurveIntersections SkdCurveHitFinder::Find(SkdLoop& loop) const
{
  vtkSMPThreadLocal<Worker> workers;
  loop.For(static_cast<vtkIdType>(this->First.GetSpans().size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Worker& worker = workers.Local();
      for (vtkIdType span = begin; span < end; ++span)
      {
        this->FindOnSpan(static_cast<std::size_t>(span), worker);
      }
    });
  Worker all;
  for (Worker& worker : workers)
  {
    all.TakeFrom(worker);
  }
  SkdCurveIntersections intersections;
  intersections.Candidates = std::move(all.Candidates);
  std::sort(intersections.Candidates.begin(), intersections.Candidates.end());
  intersections.Hits = SkdUniteCurveHits(all.Hits, this->IsSelf());
  intersections.Intervals = SkdJoinIntervals(all.Intervals);
  const std::vector<SkdCurveHit> near = SkdNearestApproaches(all.Near, intersections.Hits);
  if (this->Task.IgnoresJoints)
  {
    SkdUniteAtJoints(intersections.Hits, this->IsSelf());
  }
  intersections.Hits.insert(intersections.Hits.end(), near.begin(), near.end());
  std::stable_sort(intersections.Hits.begin(), intersections.Hits.end(),
    [](const SkdCurveHit& a, const SkdCurveHit& b)
    {
      return std::tuple(a.First.Curve, a.Second.Curve, a.First.U, a.Second.U) <
        std::tuple(b.First.Curve, b.Second.Curve, b.First.U, b.Second.U);
    });
  return intersections;
}

//------------------------------------------------------------------------------
void SkdCurveHitFinder::Worker::TakeFrom(const Worker& other)
{
  const auto take = [](auto& to, const auto& from)
  { to.insert(to.end(), from.begin(), from.end()); };
  take(this->Hits, other.Hits);
  take(this->Near, other.Near);
  take(this->Intervals, other.Intervals);
  take(this->Candidates, other.Candidates);
}

//------------------------------------------------------------------------------
void SkdCurveHitFinder::FindOnSpan(std::size_t span, Worker& worker) const
{
  const double maxDistance = this->Rounding + this->Task.Clearance;
  this->Second.VisitWithin(this->First.GetBox(span).Inflated(maxDistance),
    [&](std::size_t other)
    {
      if (!this->IsSelf() || other > span)
      {
        this->Examine(span, other, worker);
      }
    });
}

//------------------------------------------------------------------------------
/// Whether they are one behind the other on one curve.
bool SkdCurveHitFinder::AreNeighbours(const SkdCurveSpan& first, const SkdCurveSpan& second) const
{
  const SkdCurveSet& curves = this->First.GetCurves();
  const std::size_t number = curves.GetCurveOf(first.Piece);
  if (number != curves.GetCurveOf(second.Piece))
  {
    return false;
  }
  const SkdCurve& curve = curves.GetCurves()[number];
  const auto start = [&](const SkdCurveSpan& span)
  { return static_cast<double>(span.Piece - curve.FirstPiece) + span.Range.Min; };
  const auto end = [&](const SkdCurveSpan& span)
  { return static_cast<double>(span.Piece - curve.FirstPiece) + span.Range.Max; };
  const double last = static_cast<double>(curve.LastPiece - curve.FirstPiece);
  const bool joinsAround = curve.IsClosed && start(first) == 0.0 && end(second) == last;
  return end(first) == start(second) || end(second) == start(first) || joinsAround;
}

//------------------------------------------------------------------------------
// Boxes, then safety cylinders, then the curves themselves.
void SkdCurveHitFinder::Examine(std::size_t first, std::size_t second, Worker& worker) const
{
  const SkdCurveSpan& one = this->First.GetSpans()[first];
  const SkdCurveSpan& other = this->Second.GetSpans()[second];
  const double radius =
    one.Deviation + other.Deviation + 4.0 * this->Rounding + this->Task.Clearance;
  const skd::SegmentPair chords = skd::ClosestPointsAtAnyAngle(one.Chord, other.Chord);
  if (!(chords.Dist2 <= radius * radius) || (this->IsSelf() && this->AreNeighbours(one, other)))
  {
    return;
  }
  const skd::Vector3 origin = one.IsLine && other.IsLine ? skd::Vector3{} : one.Chord.A;
  const auto& hits = worker.Solver.Solve(
    this->First.GetForm(one, origin), this->Second.GetForm(other, origin), this->Rounding);
  int added = 0;
  for (const skd::CurvePairHit& hit : hits)
  {
    added += this->AddHit(one, other, hit, worker) ? 1 : 0;
  }
  if (this->Task.Clearance > 0.0 && hits.empty())
  {
    this->FindNear(one, other, worker);
  }
  if (this->Task.TellsCandidates)
  {
    worker.Candidates.push_back({ first, second, radius, added });
  }
}

//------------------------------------------------------------------------------
/// False of one that is the joint of two curves.
bool SkdCurveHitFinder::AddHit(const SkdCurveSpan& first, const SkdCurveSpan& second,
  const skd::CurvePairHit& hit, Worker& worker) const
{
  SkdCurveHit found{ this->LocationOf(this->First, first, hit.T),
    this->LocationOf(this->Second, second, hit.S), hit.Gap, hit.Error, hit.Kind, hit.Begins,
    hit.IsExact, hit.IsResolved, hit.Before, hit.After };
  found.First.Slack += hit.SlackT * (first.Range.Max - first.Range.Min);
  found.Second.Slack += hit.SlackS * (second.Range.Max - second.Range.Min);
  FindEnd(this->First, found.First);
  FindEnd(this->Second, found.Second);
  ForgetBeyondEnds(first, second, hit, found);
  const bool isSameCurve = this->IsSelf() && found.First.Curve == found.Second.Curve;
  if (isSameCurve && found.Second.U < found.First.U)
  {
    std::swap(found.First, found.Second);
  }
  if (this->IsJoint(found))
  {
    found.Gap = -1.0; // nearer than anything: the two are joined, not near
    worker.Near.push_back(found);
    return false;
  }
  worker.Hits.push_back(found);
  const bool endsInterval = hit.Kind == skd::IntersectionKind::OverlapEnd && !hit.Begins;
  if (endsInterval && worker.Hits.size() > 1)
  {
    worker.Intervals.push_back({ worker.Hits[worker.Hits.size() - 2], found });
  }
  return true;
}

//------------------------------------------------------------------------------
void SkdCurveHitFinder::FindNear(
  const SkdCurveSpan& first, const SkdCurveSpan& second, Worker& worker) const
{
  const bool isSameCurve = this->IsSelf() &&
    this->First.GetCurves().GetCurveOf(first.Piece) ==
      this->Second.GetCurves().GetCurveOf(second.Piece);
  if (isSameCurve)
  {
    return;
  }
  const skd::Vector3 origin = first.Chord.A;
  skd::CurveApproach limit;
  limit.Distance = std::nextafter(this->Task.Clearance, 2.0 * this->Task.Clearance);
  const skd::CurveApproach nearest = worker.Nearest.Find(
    this->First.GetForm(first, origin), this->Second.GetForm(second, origin), limit);
  if (nearest.Distance < limit.Distance)
  {
    worker.Near.push_back({ this->LocationOf(this->First, first, nearest.T),
      this->LocationOf(this->Second, second, nearest.S), nearest.Distance, 0.0,
      skd::IntersectionKind::Near, false, false, false, {}, {} });
  }
}

//------------------------------------------------------------------------------
SkdCurveLocation SkdCurveHitFinder::LocationOf(
  const SkdCurveTree& tree, const SkdCurveSpan& span, double t) const
{
  const SkdCurveSet& curves = tree.GetCurves();
  SkdCurveLocation location{};
  location.Curve = curves.GetCurveOf(span.Piece);
  location.Piece = span.Piece;
  location.T = t < 1.0 ? span.Range.Min + t * (span.Range.Max - span.Range.Min) : span.Range.Max;
  const SkdCurve& curve = curves.GetCurves()[location.Curve];
  if (curve.IsClosed && location.Piece + 1 == curve.LastPiece && location.T == 1.0)
  {
    location.Piece = curve.FirstPiece; // where it began
    location.T = 0.0;
  }
  location.U = static_cast<double>(location.Piece - curve.FirstPiece) + location.T;
  location.Rounding = 4.0 * std::numeric_limits<double>::epsilon() * (1.0 + location.U);
  location.Slack = location.Rounding;
  const skd::Vector3 origin = curves.GetPiece(location.Piece, skd::Vector3{}).Start();
  const skd::CurvePoint point = curves.GetPiece(location.Piece, origin).At(location.T);
  location.X = origin + point.X;
  location.Tangent = point.D1;
  location.Period = curve.IsClosed ? static_cast<double>(curve.LastPiece - curve.FirstPiece) : 0.0;
  location.Joint = SkdCurveJoints::None;
  return location;
}

//------------------------------------------------------------------------------
void SkdCurveHitFinder::FindEnd(const SkdCurveTree& tree, SkdCurveLocation& location)
{
  const SkdCurveSet& curves = tree.GetCurves();
  location.IsExactlyAtEnd =
    curves.IsAtEnd(location.Curve, location.U, location.Rounding, location.Joint);
  location.IsAtEnd = curves.IsAtEnd(location.Curve, location.U, location.Slack, location.Joint);
}

//------------------------------------------------------------------------------
/// Whether two curves of a set only continue each other; intersections with a third one there are
/// reported.
bool SkdCurveHitFinder::IsJoint(const SkdCurveHit& hit) const
{
  return this->Task.IgnoresJoints && this->IsSelf() &&
    hit.Kind != skd::IntersectionKind::OverlapEnd && hit.First.IsAtEnd && hit.Second.IsAtEnd &&
    hit.First.Joint == hit.Second.Joint;
}
}
