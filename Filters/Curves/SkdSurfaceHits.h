// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSurfaceHits.h
 * @brief Intersections of curves with surfaces (section 6.2), each once.
 *
 * Straight pieces intersect triangles by exact signs (SegmentFacet.h); others are solved in their
 * native representation (CurvePatchSolver.h), where distances within rounding error count as
 * intersections.
 */

#ifndef SkdSurfaceHits_h
#define SkdSurfaceHits_h

#include "Core/Curves/CurvePatchSolver.h"
#include "Curves/SkdCurveSet.h"
#include "Curves/SkdSurfaceHit.h"
#include "Curves/SkdSurfaceSet.h"

namespace skdtree
{
class SkdLoop;

class SkdSurfaceHitFinder
{
public:
  /// `delta`: the chord tolerance by which curves are cut, in world units.
  SkdSurfaceHitFinder(const SkdCurveSet& curves, const SkdSurfaceSet& surfaces, double delta);

  /// All intersections, sorted by curve and parameter, then by part and cell id. In parallel.
  /// Curves that continue each other each have the intersections at their joint: see
  /// UniteAtJoints().
  std::vector<SkdSurfaceIntersection> Find(SkdLoop& loop) const;

  /// The same, with intersections at a joint once, for the curve with the lowest number. Ends of
  /// intervals are kept.
  std::vector<SkdSurfaceIntersection> UniteAtJoints(
    std::vector<SkdSurfaceIntersection> intersections) const;

  /// The closed parts that contain a point, sorted by the distance at which a line from the point
  /// leaves them. Thread-safe.
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
}

#endif
