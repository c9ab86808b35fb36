// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether the interiors of two sets of simplices intersect, or the sets only touch.
#ifndef skd_Geometry_Simplices_SimplexInteriors_h
#define skd_Geometry_Simplices_SimplexInteriors_h

#include "SimplexWitness.h"

namespace skd
{

/// Whether x is in the set, and farther than `depth` from its boundary: the triangles of a solid,
/// the rim of a surface, the ends of a curve. A point is its own inside.
inline bool IsDeepIn(
  const detail::SimplexGroups& groups, const Vector3& x, double tolerance, double depth)
{
  const SimplexSet& set = groups.GetSet();
  if (set.Dimension == 3)
  {
    return !detail::IsNear(groups, x, depth) && Encloses(set, x);
  }
  return detail::IsNear(groups, x, tolerance) && RimDistance2(set, x) > depth * depth;
}

namespace detail
{

/// Points that two sets have in common, among them the corners of what they have in common.
class Contacts
{
public:
  Contacts(const SimplexGroups& a, const SimplexGroups& b, double tolerance)
    : Tolerance(tolerance)
  {
    this->Collect(a, b);
    this->Collect(b, a);
  }

  /// Calls isWanted(x) for the middle of all, and for the middles of pairs of some, until one is.
  template <class IsWanted>
  bool AnyMiddle(const IsWanted& isWanted) const
  {
    constexpr std::size_t most = 24;
    const std::size_t step = this->Points.size() / most + 1;
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    for (const Vector3& x : this->Points)
    {
      sum = sum + x;
    }
    if (this->Points.empty() || isWanted((1.0 / static_cast<double>(this->Points.size())) * sum))
    {
      return !this->Points.empty();
    }
    for (std::size_t i = 0; i < this->Points.size(); i += step)
    {
      for (std::size_t k = 0; k <= i; k += step)
      {
        if (isWanted(0.5 * (this->Points[i] + this->Points[k])))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  void Collect(const SimplexGroups& groups, const SimplexGroups& other)
  {
    const SimplexSet& one = groups.GetSet();
    for (const Vector3& x : one.Points)
    {
      if (IsWithin(other, x, this->Tolerance))
      {
        this->Points.push_back(x);
      }
    }
    const auto addTransitions = [&](const Segment<3>& edge)
    {
      ForEachTransition(
        edge, other, this->Tolerance, [&](double t) { this->Points.push_back(edge.At(t)); });
    };
    for (const SimplexSet::Simplex& simplex : one.Simplices)
    {
      one.ForEachEdge(simplex, addTransitions);
    }
  }

  double Tolerance;
  std::vector<Vector3> Points;
};

}

/// Whether the insides of two sets have a point in common that is deeper than a few tolerances in
/// both. Sure of convex sets: the middle of what they have in common is such a point, if any is. Of
/// others some middles between two of its corners are tested, too. Rims must have been found.
inline bool InteriorsIntersect(const SimplexSet& a, const SimplexSet& b, double tolerance)
{
  const double depth = 4.0 * tolerance;
  const detail::SimplexGroups as(a);
  const detail::SimplexGroups bs(b);
  return detail::Contacts(as, bs, tolerance)
    .AnyMiddle([&](const Vector3& x)
      { return IsDeepIn(as, x, depth, depth) && IsDeepIn(bs, x, depth, depth); });
}

}

#endif
