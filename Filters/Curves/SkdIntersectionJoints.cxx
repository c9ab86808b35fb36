// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdIntersectionJoints.h"

#include <algorithm>
#include <limits>

namespace skdtree
{
//------------------------------------------------------------------------------
std::vector<SkdIntersectionJoints::AtJoint> SkdIntersectionJoints::Find(
  const std::vector<SkdSurfaceIntersection>& intersections) const
{
  std::vector<AtJoint> found;
  for (std::size_t i = 0; i < intersections.size(); ++i)
  {
    const SkdSurfaceHit& hit = intersections[i].Hit;
    const double slack = hit.IsExact ? 0.0 : hit.Slack;
    std::size_t joint = SkdCurveJoints::None;
    if (this->Curves.IsAtEnd(hit.Curve, hit.U, slack, joint) && joint != SkdCurveJoints::None)
    {
      const bool atEnd = hit.U > slack;
      found.push_back({ joint, this->Elements[hit.Element].Part, i, atEnd });
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

//------------------------------------------------------------------------------
// Along the first of the two: the other's values are reversed if it runs against it.
void SkdIntersectionJoints::Add(
  SkdSurfaceIntersection& to, bool toAtEnd, const SkdSurfaceIntersection& other, bool atEnd)
{
  const int sum = to.Sense + (toAtEnd != atEnd ? other.Sense : -other.Sense);
  const int coming = toAtEnd ? to.Before : to.After;
  const int going = atEnd ? other.Before : other.After;
  to.Sense = (sum > 0) - (sum < 0);
  if (coming != 0 && going != 0)
  {
    to.Sense = coming == going ? 0 : (toAtEnd ? coming : going);
  }
  to.Hit.Kind = to.Sense != 0 ? skd::IntersectionKind::Crossing : skd::IntersectionKind::Touching;
}

//------------------------------------------------------------------------------
std::vector<SkdSurfaceIntersection> SkdIntersectionJoints::Unite(
  std::vector<SkdSurfaceIntersection> intersections) const
{
  const std::vector<AtJoint> found = this->Find(intersections);
  std::vector<char> isLeftOut(intersections.size(), 0);
  for (std::size_t i = 0; i + 1 < found.size(); ++i)
  {
    const AtJoint& one = found[i];
    const AtJoint& other = found[i + 1];
    if (one.Joint != other.Joint || one.Part != other.Part)
    {
      continue;
    }
    SkdSurfaceIntersection& first = intersections[one.Intersection];
    const SkdSurfaceIntersection& second = intersections[other.Intersection];
    const bool endsInterval = first.Hit.Kind == skd::IntersectionKind::OverlapEnd;
    if (!endsInterval && second.Hit.Kind != skd::IntersectionKind::OverlapEnd)
    {
      Add(first, one.AtEnd, second, other.AtEnd);
    }
    if (second.Hit.Kind != skd::IntersectionKind::OverlapEnd)
    {
      isLeftOut[other.Intersection] = 1;
    }
    else if (!endsInterval)
    {
      isLeftOut[one.Intersection] = 1;
    }
    ++i; // no more than two curves share a joint
  }
  std::vector<SkdSurfaceIntersection> left;
  for (std::size_t i = 0; i < intersections.size(); ++i)
  {
    if (!isLeftOut[i])
    {
      left.push_back(intersections[i]);
    }
  }
  return left;
}
}
