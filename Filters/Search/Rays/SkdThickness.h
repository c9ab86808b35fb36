// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdThickness_h
#define SkdThickness_h

#include "Search/Rays/SkdBodyExit.h"
#include "Search/Rays/SkdRayCaster.h"
#include "Search/Rays/SkdTiedNearest.h"

#include <vector>

namespace skdtree
{
/// How thickness is measured.
struct SkdThicknessRule
{
  int Rays = 1;            // of a cone, evenly over its solid angle, the first along its axis
  double ConeAngle = 0.0;  // between the axis and the cone's side, in radians
  bool AreSpheres = false; // the largest inscribed sphere; then one ray bounds it
  double Separation = 0.0; // contacts are seen from the centre at least at this angle, in radians
  double Maximum = 0.0;    // thickness beyond is none
  double Rounding = 0.0;   // spheres may intersect the surface by this
};

/// Where thickness was measured, and what lies opposite: none if Block < 0.
struct SkdThickness
{
  double Value = 0.0;
  skd::Vector3 Opposite{};
  vtkIdType CellId = -1;
  int Block = -1;
};

/// The thickness of a body at points of its surface, given inward directions (of length 1, or 0:
/// none). With a SkdBodyExit rays end where they leave the body, without one at their first hit.
///
/// By rays: the median of the distances that a cone of rays travels within the body, the shape
/// diameter function of L. Shapira, A. Shamir, D. Cohen-Or, "Consistent mesh partitioning and
/// skeletonisation using the shape diameter function", The Visual Computer 24 (2008) 249-259.
///
/// By spheres: the diameter of the largest sphere within the body that touches the surface at the
/// point, by the shrinking ball of J. Ma, S. W. Bae, S. Choi, "3D medial axis point approximation
/// using nearest neighbors and the normal field", The Visual Computer 28 (2012) 7-19, with the
/// nearest point of all cells instead of samples, or nearly that where much of the surface is
/// equally far (SkdTiedNearest): then spheres may extend through it by 0.002 of their radius, and
/// most by far less. A contact that the centre sees at less than
/// `Separation` from the point is one with a facet next to it and does not count.
class SkdThicknessMeasure
{
public:
  SkdThicknessMeasure(const SkdTiedNearest& nearest, const SkdRayCaster& caster,
    const SkdBodyExit* exits, const SkdThicknessRule& rule);

  /// Thread-safe; parallel itself. After an abort, the remaining points have none.
  std::vector<SkdThickness> Measure(
    const SkdRayCaster::Vectors& points, const SkdRayCaster::Vectors& inward, SkdLoop& loop) const;

  /// The rays that Measure() casts from the points from `begin` to `end`, those of each together.
  void ListRays(const SkdRayCaster::Vectors& points, const SkdRayCaster::Vectors& inward,
    vtkIdType begin, vtkIdType end, SkdRayCaster::Vectors& starts,
    SkdRayCaster::Vectors& rays) const;

private:
  SkdRayHit FindEnd(
    const SkdRayHit& first, const skd::Vector3& start, const skd::Vector3& ray) const;
  SkdThickness FindMedian(
    const skd::Vector3* starts, const skd::Vector3* rays, const SkdRayHit* hits) const;
  SkdThickness Shrink(
    const skd::Vector3& point, const skd::Vector3& inward, const SkdRayHit& first) const;

  const SkdTiedNearest& Nearest;
  const SkdRayCaster& Caster;
  const SkdBodyExit* Exits; // or nullptr
  SkdThicknessRule Rule;
  std::vector<skd::Vector3> Cone; // directions about the third axis
};
}

#endif
