// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether one set of simplices covers another. It is decided by witnesses: points of the part,
/// chosen so that among them is one outside of the whole if any point is. What differs by less than
/// a few tolerances makes no difference. O(simplices of one x of the other) witnesses at worst.
#ifndef skd_Geometry_Simplices_SimplexCover_h
#define skd_Geometry_Simplices_SimplexCover_h

#include "SimplexWitness.h"

#include <algorithm>

namespace skd
{

namespace detail
{

/// A triangle with an area, and its plane.
struct PlaneTriangle
{
  Triangle3 Corners;
  Vector3 Normal; ///< of length 1; NaN if there is no area

  explicit PlaneTriangle(const Triangle3& corners)
    : Corners(corners)
    , Normal(Cross(corners[1] - corners[0], corners[2] - corners[0]))
  {
    this->Normal = (1.0 / Norm(this->Normal)) * this->Normal;
  }

  double Height(const Vector3& x) const { return Dot(this->Normal, x - this->Corners[0]); }

  /// By how much x is inside of an edge, times its length; x in the plane.
  double Inside(int edge, const Vector3& x) const
  {
    const Vector3& a = this->Corners[edge];
    return Dot(Cross(this->Normal, this->Corners[(edge + 1) % 3] - a), x - a);
  }

  bool Holds(const Vector3& x) const
  {
    return this->Inside(0, x) > 0.0 && this->Inside(1, x) > 0.0 && this->Inside(2, x) > 0.0;
  }

  /// What of a segment in the plane is in the triangle.
  std::optional<Interval> Clip(const Segment<3>& segment) const
  {
    Interval uncovered{ 0.0, 1.0 };
    for (int edge = 0; edge < 3; ++edge)
    {
      const double a = this->Inside(edge, segment.A);
      const double b = this->Inside(edge, segment.B);
      if (a < 0.0 && b < 0.0)
      {
        return std::nullopt;
      }
      if (a < 0.0)
      {
        uncovered.Min = std::max(uncovered.Min, a / (a - b));
      }
      else if (b < 0.0)
      {
        uncovered.Max = std::min(uncovered.Max, a / (a - b));
      }
    }
    return uncovered.Min < uncovered.Max ? std::optional<Interval>(uncovered) : std::nullopt;
  }

  /// Calls visit(segment) with where another triangle meets the plane: of one that lies in it, to
  /// within the tolerance, its edges.
  template <class Visit>
  void ForEachCut(const Triangle3& other, double tolerance, Visit visit) const
  {
    const double heights[3] = { this->Height(other[0]), this->Height(other[1]),
      this->Height(other[2]) };
    const auto isIn = [&](int i) { return std::abs(heights[i]) <= tolerance; };
    if (isIn(0) && isIn(1) && isIn(2))
    {
      for (int i = 0; i < 3; ++i)
      {
        visit(Segment<3>{ other[i], other[(i + 1) % 3] });
      }
      return;
    }
    Vector3 ends[3];
    int count = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double a = heights[i];
      const double b = heights[(i + 1) % 3];
      if ((a < 0.0) != (b < 0.0))
      {
        ends[count++] = Lerp(other[i], other[(i + 1) % 3], a / (a - b));
      }
    }
    if (count == 2)
    {
      visit(Segment<3>{ ends[0], ends[1] });
    }
  }
};

/// Whether a set holds another.
class CoverTest
{
public:
  CoverTest(const SimplexSet& whole, const SimplexSet& part, double tolerance)
    : Whole(whole)
    , Groups(whole)
    , Other(part)
    , Tolerance(tolerance)
  {
  }

  bool Run() const
  {
    if (!this->Whole.Bounds.Inflated(this->Tolerance).Contains(this->Other.Bounds) ||
      !std::all_of(this->Other.Points.begin(), this->Other.Points.end(),
        [this](const Vector3& x) { return this->Holds(x, this->Tolerance); }))
    {
      return false;
    }
    if (this->Whole.IsConvex || this->Other.Dimension == 0)
    {
      return true;
    }
    return this->Other.Dimension <= this->Whole.Dimension && this->HoldsEdges() &&
      (this->Other.Dimension < 2 || this->HoldsTriangles()) &&
      (this->Other.Dimension < 3 || !this->HasHollow());
  }

private:
  // Computed points are off by up to a few tolerances; those beside a cut must be farther from it.
  static constexpr double WitnessFactor = 4.0;
  static constexpr double BesideFactor = 4.0 * WitnessFactor;

  bool Holds(const Vector3& x, double tolerance) const
  {
    return IsWithin(this->Groups, x, tolerance);
  }
  /// Of points that were computed.
  bool HoldsWitness(const Vector3& x) const
  {
    return this->Holds(x, WitnessFactor * this->Tolerance);
  }

  /// Between two turns an edge is in, or out, all the way.
  bool HoldsEdges() const
  {
    bool isHeld = true;
    std::vector<double> transitions;
    const auto ask = [&](const Segment<3>& edge)
    {
      if (!isHeld)
      {
        return;
      }
      transitions.assign({ 0.0, 1.0 });
      ForEachTransition(edge, this->Groups, WitnessFactor * this->Tolerance,
        [&](double t) { transitions.push_back(t); });
      std::sort(transitions.begin(), transitions.end());
      for (std::size_t i = 1; i < transitions.size() && isHeld; ++i)
      {
        isHeld = this->HoldsWitness(edge.At(0.5 * (transitions[i - 1] + transitions[i])));
      }
    };
    for (const SimplexSet::Simplex& simplex : this->Other.Simplices)
    {
      this->Other.ForEachEdge(simplex, ask);
    }
    return isHeld;
  }

  /// Whether all triangles of the part are held, whose edges are. What of such a triangle is not
  /// in the whole is a region of the triangle's plane bounded by where simplices of the whole cut
  /// that plane. So either no cut bounds it and the centroid tells, or there is a cut with points
  /// of the region right beside it (HoldsBeside).
  bool HoldsTriangles() const
  {
    for (const SimplexSet::Simplex& simplex : this->Other.Simplices)
    {
      const PlaneTriangle triangle(this->Other.Corners(simplex));
      const Triangle3& p = triangle.Corners;
      if (!this->HoldsWitness((1.0 / 3.0) * (p[0] + p[1] + p[2])))
      {
        return false;
      }
      if (!this->HoldsBesideCuts(triangle))
      {
        return false;
      }
    }
    return true;
  }

  bool HoldsBesideCuts(const PlaneTriangle& triangle) const
  {
    bool isHeld = true;
    const Box3 bounds = BoundsOf(triangle.Corners).Inflated(this->Tolerance);
    this->Groups.ForEachOverlapping(bounds,
      [&](const Triangle3& corners)
      {
        if (isHeld)
        {
          triangle.ForEachCut(corners, this->Tolerance,
            [&](const Segment<3>& cut) { isHeld = isHeld && this->HoldsBeside(triangle, cut); });
        }
      });
    return isHeld;
  }

  /// Points on both sides of the middle of a cut: at a distance that is safely beyond what
  /// HoldsWitness forgives, and at one that is a small part of the cut, since of a crowd of cuts
  /// the nearer point may be between this one and the next.
  bool HoldsBeside(const PlaneTriangle& triangle, const Segment<3>& cut) const
  {
    const std::optional<Interval> uncovered = triangle.Clip(cut);
    if (!uncovered)
    {
      return true;
    }
    const Vector3 along = cut.B - cut.A;
    const double length = Norm(along);
    const Vector3 aside = (1.0 / length) * Cross(triangle.Normal, along);
    const Vector3 middle = cut.At(0.5 * (uncovered->Min + uncovered->Max));
    constexpr double smallPart = 1.0 / 64.0;
    const double lengthOfCut = (uncovered->Max - uncovered->Min) * length;
    for (const double step : { BesideFactor * this->Tolerance, smallPart * lengthOfCut })
    {
      for (const double signedStep : { step, -step })
      {
        const Vector3 witness = middle + signedStep * aside;
        if (triangle.Holds(witness) && !this->HoldsWitness(witness))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Whether a corner of the whole's boundary is inside of the part, whose own boundary is held.
  bool HasHollow() const
  {
    const SimplexGroups others(this->Other);
    return std::any_of(this->Whole.Points.begin(), this->Whole.Points.end(),
      [&](const Vector3& x)
      { return !IsNear(others, x, WitnessFactor * this->Tolerance) && Encloses(this->Other, x); });
  }

  const SimplexSet& Whole;
  const SimplexGroups Groups; ///< of the whole
  const SimplexSet& Other;
  double Tolerance;
};

}

/// Whether every point of the part is at a distance of at most `tolerance` from the whole. A part
/// of a higher dimension than a whole that is not convex is not held.
inline bool Covers(const SimplexSet& whole, const SimplexSet& part, double tolerance)
{
  return detail::CoverTest(whole, part, tolerance).Run();
}

}

#endif
