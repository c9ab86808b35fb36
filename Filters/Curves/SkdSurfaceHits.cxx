// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdSurfaceHits.h"

#include "Core/Geometry/Intersection/SegmentFacet.h"
#include "Curves/SkdCurveSpans.h"
#include "Curves/SkdIntersectionGroups.h"
#include "Curves/SkdIntersectionJoints.h"
#include "Curves/SkdVisitSurfaces.h"
#include "Pipeline/SkdLoop.h"
#include "vtkSMPThreadLocal.h"

#include <tuple>

namespace skdtree
{
//------------------------------------------------------------------------------
SkdSurfaceHitFinder::SkdSurfaceHitFinder(
  const SkdCurveSet& curves, const SkdSurfaceSet& surfaces, double delta)
  : Curves(curves)
  , Surfaces(surfaces)
  , Delta(delta)
  , Rounding(8.0 * std::numeric_limits<double>::epsilon() *
      std::max(
        skd::LargestCoordinate(curves.GetBounds()), skd::LargestCoordinate(surfaces.GetBounds())))
{
}

//------------------------------------------------------------------------------
SkdSurfaceHit SkdSurfaceHitFinder::BaseOf(std::size_t piece) const
{
  SkdSurfaceHit base{};
  base.Piece = piece;
  base.Curve = this->Curves.GetCurveOf(piece);
  return base;
}

//------------------------------------------------------------------------------
std::vector<SkdSurfaceIntersection> SkdSurfaceHitFinder::Find(SkdLoop& loop) const
{
  struct Worker
  {
    skd::CurvePatchSolver Solver;
    Hits Found;
  };
  vtkSMPThreadLocal<Worker> workers;
  loop.For(static_cast<vtkIdType>(this->Curves.GetNumberOfPieces()),
    [&](vtkIdType begin, vtkIdType end)
    {
      Worker& worker = workers.Local();
      for (vtkIdType piece = begin; piece < end; ++piece)
      {
        this->FindOnPiece(static_cast<std::size_t>(piece), worker.Solver, worker.Found);
      }
    });
  Hits all;
  for (Worker& worker : workers)
  {
    all.insert(all.end(), worker.Found.begin(), worker.Found.end());
  }
  return this->Unite(all);
}

//------------------------------------------------------------------------------
void SkdSurfaceHitFinder::FindOnPiece(
  std::size_t piece, skd::CurvePatchSolver& solver, Hits& hits) const
{
  const SkdSurfaceHit base = this->BaseOf(piece);
  const skd::BezierCurve whole = this->Curves.GetPiece(piece, skd::Vector3{});
  if (whole.IsLine())
  {
    this->Surfaces.VisitAlong({ whole.Start(), whole.End() },
      [&](std::size_t element) { this->MeetLine(whole, element, base, solver, hits); });
    return;
  }
  const skd::Vector3 origin = whole.Start();
  SkdVisitSpans(this->Curves.GetPiece(piece, origin), this->Delta,
    [&](const skd::BezierCurve& part, const skd::Interval& range)
    {
      const skd::Box3 bounds = part.Bounds().Inflated(this->Rounding);
      this->Surfaces.VisitWithin({ bounds.Min + origin, bounds.Max + origin },
        [&](std::size_t element)
        { this->MeetPatch(part, origin, range, element, base, solver, hits); });
    });
}

//------------------------------------------------------------------------------
// A patch meets only the part of a line that is near it.
void SkdSurfaceHitFinder::MeetLine(const skd::BezierCurve& line, std::size_t element,
  SkdSurfaceHit base, skd::CurvePatchSolver& solver, Hits& hits) const
{
  const skd::Segment<3> segment{ line.Start(), line.End() };
  const SkdSurfaceElement& what = this->Surfaces.GetElements()[element];
  if (!what.IsPatch)
  {
    this->MeetTriangle(segment, element, base, hits);
    return;
  }
  const skd::Box3 bounds = skd::BoundsOnDomain(this->Surfaces.GetPatch(what, skd::Vector3{}));
  const auto near = skd::Clip(segment, bounds.Inflated(0.01 * bounds.Diagonal() + this->Rounding));
  if (near && near->Max > near->Min)
  {
    const skd::Vector3 origin = segment.At(near->Min);
    const skd::BezierCurve part =
      skd::BezierCurve::Line(skd::Vector3{}, segment.At(near->Max) - origin);
    const std::size_t first = hits.size();
    this->MeetPatch(part, origin, *near, element, base, solver, hits);
    for (std::size_t i = first; i < hits.size() && what.DegreeR * what.DegreeS == 1; ++i)
    {
      this->DecideAtSides(segment, element, hits[i]);
    }
  }
}

//------------------------------------------------------------------------------
void SkdSurfaceHitFinder::MeetTriangle(
  const skd::Segment<3>& segment, std::size_t element, SkdSurfaceHit base, Hits& hits) const
{
  skd::Vector3 corners[3];
  this->Surfaces.GetTriangle(this->Surfaces.GetElements()[element], corners);
  base.Element = element;
  base.Tangent = segment.B - segment.A;
  base.Normal = skd::Cross(corners[1] - corners[0], corners[2] - corners[0]);
  base.IsExact = true;
  const auto put = [&](double t)
  {
    base.T = t;
    base.X = t < 1.0 ? segment.At(t) : segment.B;
    base.R = skd::Dot(skd::Cross(base.X - corners[0], corners[2] - corners[0]), base.Normal) /
      skd::Norm2(base.Normal);
    base.S = skd::Dot(skd::Cross(corners[1] - corners[0], base.X - corners[0]), base.Normal) /
      skd::Norm2(base.Normal);
    hits.push_back(base);
  };
  if (const auto hit = skd::MeetFacet(segment, corners))
  {
    base.Passes = hit->Passes;
    base.Direction = hit->Direction;
    base.OnBoundary = hit->OnBoundary;
    put(hit->T);
    hits.back().Kind = skd::IntersectionKind::Crossing;
  }
  else if (const auto within = skd::WithinFacet(segment, corners))
  {
    base.Kind = skd::IntersectionKind::OverlapEnd;
    base.OnBoundary = true;
    base.Slack = 8.0 * this->Rounding / skd::Norm(base.Tangent);
    base.Error = 16.0 * this->Rounding;
    base.Begins = true;
    put(within->Min);
    base.Begins = false;
    put(within->Max);
  }
}

//------------------------------------------------------------------------------
void SkdSurfaceHitFinder::MeetPatch(const skd::BezierCurve& part, const skd::Vector3& origin,
  const skd::Interval& range, std::size_t element, SkdSurfaceHit base,
  skd::CurvePatchSolver& solver, Hits& hits) const
{
  const skd::BezierPatch patch =
    this->Surfaces.GetPatch(this->Surfaces.GetElements()[element], origin);
  const double length = range.Max - range.Min;
  for (const skd::CurvePatchHit& hit : solver.Solve(part, patch, this->Rounding))
  {
    base.Element = element;
    base.T = hit.T < 1.0 ? range.Min + hit.T * length : range.Max;
    base.R = hit.R;
    base.S = hit.S;
    base.X = hit.X + origin;
    base.Tangent = part.At(hit.T).D1;
    base.Normal = patch.At(hit.R, hit.S).Normal();
    base.Gap = hit.Gap;
    base.Slack = hit.Slack * length;
    base.Error = hit.Error;
    base.Kind = hit.Kind;
    base.Passes = base.Direction = hit.Passes;
    // What continues the piece beyond its end is not where the curve goes on.
    base.Before = base.T == 0.0 ? 0 : (hit.IsResolved ? hit.Before : -hit.Passes);
    base.After = base.T == 1.0 ? 0 : (hit.IsResolved ? hit.After : hit.Passes);
    base.Begins = hit.Begins;
    base.OnBoundary = hit.OnBoundary;
    base.IsExact = false;
    hits.push_back(base);
  }
}

//------------------------------------------------------------------------------
// A bilinear patch has straight sides: exact signs decide there, as they do for its neighbours.
void SkdSurfaceHitFinder::DecideAtSides(
  const skd::Segment<3>& segment, std::size_t element, SkdSurfaceHit& hit) const
{
  const skd::BezierPatch patch =
    this->Surfaces.GetPatch(this->Surfaces.GetElements()[element], skd::Vector3{});
  const skd::Vector3 corners[4] = { patch.Corner(0, 0), patch.Corner(1, 0), patch.Corner(1, 1),
    patch.Corner(0, 1) };
  const bool isOnSide[4] = { hit.S == 0.0, hit.R == 1.0, hit.S == 1.0, hit.R == 0.0 };
  const bool isAtEnd = hit.T == 0.0 || hit.T == 1.0;
  if (hit.Kind != skd::IntersectionKind::Crossing || isAtEnd)
  {
    return;
  }
  hit.IsExact = true;
  for (int side = 0; side < 4; ++side)
  {
    const bool isInside = !isOnSide[side] ||
      skd::MovedSideOf(segment, corners[side], corners[(side + 1) % 4]) == -hit.Direction;
    hit.Passes = isInside ? hit.Passes : 0;
  }
}

//------------------------------------------------------------------------------
std::vector<SkdSurfaceIntersection> SkdSurfaceHitFinder::Unite(Hits& hits) const
{
  const auto& elements = this->Surfaces.GetElements();
  for (SkdSurfaceHit& hit : hits)
  {
    const SkdCurve& curve = this->Curves.GetCurves()[hit.Curve];
    hit.Closes = curve.IsClosed && hit.Piece + 1 == curve.LastPiece && hit.T == 1.0;
    if (hit.Closes)
    {
      hit.Piece = curve.FirstPiece;
      hit.T = 0.0;
    }
    hit.U = static_cast<double>(hit.Piece - curve.FirstPiece) + hit.T;
  }
  const auto key = [&](const SkdSurfaceHit& hit)
  {
    const SkdSurfaceElement& element = elements[hit.Element];
    return std::tuple(hit.Curve, hit.U, element.Part, element.Block, element.CellId, hit.Element,
      hit.Begins, hit.Piece, hit.Closes);
  };
  std::sort(hits.begin(), hits.end(),
    [&](const SkdSurfaceHit& a, const SkdSurfaceHit& b) { return key(a) < key(b); });
  SkdIntersectionGroups groups(elements);
  for (const SkdSurfaceHit& hit : hits)
  {
    groups.Add(hit);
  }
  return groups.GetIntersections();
}

//------------------------------------------------------------------------------
std::vector<SkdSurfaceIntersection> SkdSurfaceHitFinder::UniteAtJoints(
  std::vector<SkdSurfaceIntersection> intersections) const
{
  SkdIntersectionJoints joints(this->Curves, this->Surfaces.GetElements());
  return joints.Unite(std::move(intersections));
}

//------------------------------------------------------------------------------
std::vector<int> SkdSurfaceHitFinder::FindPartsAround(const skd::Vector3& x) const
{
  const skd::Box3& bounds = this->Surfaces.GetBounds();
  if (!bounds.Contains(x))
  {
    return {};
  }
  const double length = bounds.Diagonal();
  const skd::BezierCurve segmentOut =
    skd::BezierCurve::Line(x, x + skd::Vector3{ { 1.31 * length, 1.13 * length, 1.23 * length } });
  thread_local skd::CurvePatchSolver solver;
  Hits hits;
  const SkdSurfaceHit base{};
  this->Surfaces.VisitAlong({ segmentOut.Start(), segmentOut.End() },
    [&](std::size_t element) { this->MeetLine(segmentOut, element, base, solver, hits); });
  for (SkdSurfaceHit& hit : hits)
  {
    hit.U = hit.T;
  }
  std::sort(hits.begin(), hits.end(),
    [](const SkdSurfaceHit& a, const SkdSurfaceHit& b)
    { return std::tie(a.U, a.Element) < std::tie(b.U, b.Element); });
  SkdIntersectionGroups groups(this->Surfaces.GetElements());
  for (const SkdSurfaceHit& hit : hits)
  {
    groups.Add(hit);
  }
  return groups.GetPartsLeft();
}
}
