// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Relations/SkdCellRelation.h"

#include "Core/Geometry/Simplices/SimplexCover.h"
#include "Core/Geometry/Simplices/SimplexInteriors.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
skd::Interval HeightsOf(const skd::Plane<3>& plane, const skd::SimplexSet& set)
{
  skd::Interval heights{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (const skd::Vector3& x : set.Points)
  {
    const double height = skd::Dot(plane.Normal, x - plane.Origin);
    heights.Min = std::min(heights.Min, height);
    heights.Max = std::max(heights.Max, height);
  }
  return heights;
}
}

/// A cell, its simplices, and what counts as 0.
struct SkdCellRelation::Candidate
{
  const SkdCellTree& Tree;
  std::uint32_t Cell;
  const SkdCellSource& Source;
  skd::SimplexSet& Set;
  double Tolerance;
  mutable std::optional<double> Least = std::nullopt; // MinDistance(), once it is known

  double DistanceTo(const skd::Vector3& x) const
  {
    return std::sqrt(
      this->Tree.Evaluate(this->Tree.Cells().IdOf(this->Cell), x, this->Source).Dist2);
  }
  bool IsZero(double distance) const { return distance <= this->Tolerance; }
};

//------------------------------------------------------------------------------
std::optional<SkdDistances> SkdCellRelation::Ask(
  const SkdCellTree& tree, std::uint32_t cell, const SkdCellSource& source) const
{
  const double tolerance = std::max(this->Rules.Tolerance, this->Shape.Rounding(tree));
  // Computing the distance of two sets of simplices takes far longer than a bound that excludes
  // them.
  if (this->Rules.Relation == SkdRelation::Overlap && this->Shape.IsAlignedBox() &&
    !tree.Overlaps(cell, this->Shape.GetBounds().Inflated(2.0 * tolerance)))
  {
    return std::nullopt;
  }
  thread_local skd::SimplexSet set; // keeps its memory
  const Candidate candidate{ tree, cell, source, set, tolerance };
  // Adjacent cells share a point, so their distance is known; the sets of curved cells are large
  // and made only if necessary.
  const bool asksNeighbours = this->Rules.Relation == SkdRelation::Adjacency &&
    this->Shape.GetKind() == SkdQueryShape::Kind::Cell;
  if (asksNeighbours && !this->IsNeighbour(candidate))
  {
    return std::nullopt;
  }
  tree.GetSimplices(cell, source, set);
  if (!asksNeighbours && this->Rules.Relation != SkdRelation::Nearest &&
    !this->IsRelated(candidate))
  {
    return std::nullopt;
  }
  const bool isSure = this->Shape.IsSureToHold(tree.Cells().ExtentOf(cell));
  const double distance = isSure ? 0.0 : this->MinDistance(candidate);
  return SkdDistances{ candidate.IsZero(distance) ? 0.0 : distance, this->MaxDistance(candidate) };
}

//------------------------------------------------------------------------------
// A relation may need it before it is set.
double SkdCellRelation::MinDistance(const Candidate& candidate) const
{
  if (!candidate.Least)
  {
    candidate.Least = this->FindMinDistance(candidate);
  }
  return *candidate.Least;
}

//------------------------------------------------------------------------------
double SkdCellRelation::FindMinDistance(const Candidate& candidate) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      return std::max(0.0, candidate.DistanceTo(ball.Centre) - ball.Radius);
    }
    case SkdQueryShape::Kind::Plane:
    {
      const skd::Interval heights = HeightsOf(this->Shape.GetPlane(), candidate.Set);
      return std::max({ 0.0, heights.Min, -heights.Max });
    }
    default:
      return std::sqrt(skd::MinDistance2(
        candidate.Set, this->Shape.GetSet(), candidate.Tolerance * candidate.Tolerance));
  }
}

//------------------------------------------------------------------------------
double SkdCellRelation::MaxDistance(const Candidate& candidate) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      return std::sqrt(skd::MaxDistance2(candidate.Set, ball.Centre)) + ball.Radius;
    }
    case SkdQueryShape::Kind::Plane:
    {
      const skd::Interval heights = HeightsOf(this->Shape.GetPlane(), candidate.Set);
      return std::max(std::abs(heights.Min), std::abs(heights.Max));
    }
    default:
      return std::sqrt(skd::MaxDistance2(candidate.Set, this->Shape.GetSet()));
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsRelated(const Candidate& candidate) const
{
  switch (this->Rules.Relation)
  {
    case SkdRelation::ExactMatch:
      return this->IsContained(candidate) && this->IsEnclosing(candidate);
    case SkdRelation::Enclosure:
      return this->IsEnclosing(candidate);
    case SkdRelation::Containment:
      return this->IsContained(candidate);
    case SkdRelation::Adjacency:
      return this->Touches(candidate);
    default:
      return this->Shape.IsSureToHold(candidate.Tree.Cells().ExtentOf(candidate.Cell)) ||
        candidate.IsZero(this->MinDistance(candidate));
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsContained(const Candidate& candidate) const
{
  if (this->Shape.IsSureToHold(candidate.Tree.Cells().ExtentOf(candidate.Cell)))
  {
    return true;
  }
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      return candidate.IsZero(
        std::sqrt(skd::MaxDistance2(candidate.Set, ball.Centre)) - ball.Radius);
    }
    case SkdQueryShape::Kind::Plane:
      return candidate.IsZero(this->MaxDistance(candidate));
    default:
      return skd::Covers(this->Shape.GetSet(), candidate.Set, candidate.Tolerance);
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsEnclosing(const Candidate& candidate) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      const bool isDeep = candidate.IsZero(ball.Radius) ||
        (candidate.Set.Dimension == 3 &&
          candidate.IsZero(
            ball.Radius - std::sqrt(skd::SimplexDistance2(candidate.Set, ball.Centre))));
      return isDeep && candidate.IsZero(candidate.DistanceTo(ball.Centre));
    }
    case SkdQueryShape::Kind::Plane:
      return false;
    default:
      return skd::Covers(candidate.Set, this->Shape.GetSet(), candidate.Tolerance);
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::Touches(const Candidate& candidate) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
      return this->TouchesBall(candidate);
    case SkdQueryShape::Kind::Plane:
    {
      const skd::Interval heights = HeightsOf(this->Shape.GetPlane(), candidate.Set);
      const bool isBelow =
        candidate.IsZero(std::abs(heights.Max)) && !candidate.IsZero(-heights.Min);
      const bool isAbove =
        candidate.IsZero(std::abs(heights.Min)) && !candidate.IsZero(heights.Max);
      return isBelow || isAbove;
    }
    default:
      candidate.Set.FindRim();
      return candidate.IsZero(this->MinDistance(candidate)) &&
        !skd::InteriorsIntersect(candidate.Set, this->Shape.GetSet(), candidate.Tolerance);
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsNeighbour(const Candidate& candidate) const
{
  const SkdCellOutline outline(candidate.Source.Load(candidate.Tree.Cells().IdOf(candidate.Cell)));
  const bool isOne =
    outline.Shares(*this->Shape.GetOutline(), this->Rules.SharedPart, candidate.Tolerance);
  candidate.Least = isOne ? std::optional<double>(0.0) : std::nullopt;
  return isOne;
}

//------------------------------------------------------------------------------
// A ball from outside; a point on the cell's boundary. A point that is a cell touches itself.
bool SkdCellRelation::TouchesBall(const Candidate& candidate) const
{
  const skd::Sphere<3>& ball = this->Shape.GetBall();
  const double distance = candidate.DistanceTo(ball.Centre);
  if (!candidate.IsZero(ball.Radius))
  {
    return candidate.IsZero(std::abs(distance - ball.Radius));
  }
  candidate.Set.FindRim();
  const double boundary2 = candidate.Set.Dimension == 3
    ? skd::SimplexDistance2(candidate.Set, ball.Centre)
    : (candidate.Set.Dimension == 0 ? 0.0 : skd::RimDistance2(candidate.Set, ball.Centre));
  return candidate.IsZero(distance) && candidate.IsZero(std::sqrt(boundary2));
}
}
