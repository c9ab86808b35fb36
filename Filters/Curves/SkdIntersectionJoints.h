// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdIntersectionJoints_h
#define SkdIntersectionJoints_h

#include "Curves/SkdCurveSet.h"
#include "Curves/SkdSurfaceHit.h"
#include "Curves/SkdSurfaceSet.h"

#include <tuple>

namespace skdtree
{
/// Intersections with a surface at the joint of curves that continue each other are merged.
class SkdIntersectionJoints
{
public:
  SkdIntersectionJoints(const SkdCurveSet& curves, const std::vector<SkdSurfaceElement>& elements)
    : Curves(curves)
    , Elements(elements)
  {
  }

  /// The intersections, with those at joints reported once a part, for the curve with the lowest
  /// number.
  std::vector<SkdSurfaceIntersection> Unite(
    std::vector<SkdSurfaceIntersection> intersections) const;

private:
  struct AtJoint
  {
    std::size_t Joint;
    int Part;
    std::size_t Intersection;
    bool AtEnd; ///< of its curve

    bool operator<(const AtJoint& other) const
    {
      return std::tie(this->Joint, this->Part, this->Intersection) <
        std::tie(other.Joint, other.Part, other.Intersection);
    }
  };

  std::vector<AtJoint> Find(const std::vector<SkdSurfaceIntersection>& intersections) const;
  static void Add(
    SkdSurfaceIntersection& to, bool toAtEnd, const SkdSurfaceIntersection& other, bool atEnd);

  const SkdCurveSet& Curves;
  const std::vector<SkdSurfaceElement>& Elements;
};
}

#endif
