// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSurfaceHits.h
 * @brief Where curves meet surfaces (section 6.2): each place once.
 *
 * A straight piece against a triangle is decided by exact signs (SegmentFacet.h); anything else on
 * the native forms (CurvePatchSolver.h), where what rounding may be off by counts as met.
 */

#ifndef SkdSurfaceHits_h
#define SkdSurfaceHits_h

#include "Core/Curves/CurvePatchSolver.h"
#include "Curves/SkdCurveSet.h"
#include "Curves/SkdSurfaceHit.h"
#include "Curves/SkdSurfaceSet.h"

class SkdLoop;

class SkdSurfaceHitFinder
{
public:
  /// `delta`: the chord tolerance by which curves are cut, in world units.
  SkdSurfaceHitFinder(const SkdCurveSet& curves, const SkdSurfaceSet& surfaces, double delta);

  /// All places, by curve and then along it; at one place by part and cell id. In parallel. Of
  /// curves that go on as each other each tells what is in the joint: see UniteAtJoints().
  std::vector<SkdSurfaceIntersection> Find(SkdLoop& loop) const;

  /// The same with what is in a joint told once, of the curve of the lowest number, as if both were
  /// one curve. Ends of stretches stay.
  std::vector<SkdSurfaceIntersection> UniteAtJoints(
    std::vector<SkdSurfaceIntersection> intersections) const;

  /// The parts that have a point inside, if they are closed, by ascending distance to where a line
  /// from there leaves them. Thread-safe.
  std::vector<int> FindPartsAround(const skd::Vector3& x) const;

  /// The distance that is 0 to within rounding.
  double GetRounding() const { return this->Rounding; }

private:
  using Hits = std::vector<SkdSurfaceHit>;

  void FindOnPiece(std::size_t piece, skd::CurvePatchSolver& solver, Hits& hits) const;
  void MeetLine(const skd::BezierCurve& line, std::size_t element, SkdSurfaceHit base,
    skd::CurvePatchSolver& solver, Hits& hits) const;
  void MeetTriangle(
    const skd::Segment<3>& segment, std::size_t element, SkdSurfaceHit base, Hits& hits) const;
  void MeetPatch(const skd::BezierCurve& part, const skd::Vector3& origin,
    const skd::Interval& range, std::size_t element, SkdSurfaceHit base,
    skd::CurvePatchSolver& solver, Hits& hits) const;
  void DecideAtSides(const skd::Segment<3>& segment, std::size_t element, SkdSurfaceHit& hit) const;
  std::vector<SkdSurfaceIntersection> Unite(Hits& hits) const;
  SkdSurfaceHit BaseOf(std::size_t piece) const;

  const SkdCurveSet& Curves;
  const SkdSurfaceSet& Surfaces;
  double Delta;
  double Rounding;
};

#endif
