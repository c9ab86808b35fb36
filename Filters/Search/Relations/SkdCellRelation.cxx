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
struct SkdCellRelation::Asked
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
  const Asked asked{ tree, cell, source, set, tolerance };
  // Adjacent cells share a point, so their distance is known; the sets of curved cells are large
  // and made only if necessary.
  const bool asksNeighbours = this->Rules.Relation == SkdRelation::Adjacency &&
    this->Shape.GetKind() == SkdQueryShape::Kind::Cell;
  if (asksNeighbours && !this->IsNeighbour(asked))
  {
    return std::nullopt;
  }
  tree.GetSimplices(cell, source, set);
  if (!asksNeighbours && this->Rules.Relation != SkdRelation::Nearest && !this->IsRelated(asked))
  {
    return std::nullopt;
  }
  const bool isSure = this->Shape.IsSureToHold(tree.Cells().ExtentOf(cell));
  const double distance = isSure ? 0.0 : this->MinDistance(asked);
  return SkdDistances{ asked.IsZero(distance) ? 0.0 : distance, this->MaxDistance(asked) };
}

//------------------------------------------------------------------------------
// A relation may need it before it is set.
double SkdCellRelation::MinDistance(const Asked& asked) const
{
  if (!asked.Least)
  {
    asked.Least = this->FindMinDistance(asked);
  }
  return *asked.Least;
}

//------------------------------------------------------------------------------
double SkdCellRelation::FindMinDistance(const Asked& asked) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      return std::max(0.0, asked.DistanceTo(ball.Centre) - ball.Radius);
    }
    case SkdQueryShape::Kind::Plane:
    {
      const skd::Interval heights = HeightsOf(this->Shape.GetPlane(), asked.Set);
      return std::max({ 0.0, heights.Min, -heights.Max });
    }
    default:
      return std::sqrt(
        skd::MinDistance2(asked.Set, this->Shape.GetSet(), asked.Tolerance * asked.Tolerance));
  }
}

//------------------------------------------------------------------------------
double SkdCellRelation::MaxDistance(const Asked& asked) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      return std::sqrt(skd::MaxDistance2(asked.Set, ball.Centre)) + ball.Radius;
    }
    case SkdQueryShape::Kind::Plane:
    {
      const skd::Interval heights = HeightsOf(this->Shape.GetPlane(), asked.Set);
      return std::max(std::abs(heights.Min), std::abs(heights.Max));
    }
    default:
      return std::sqrt(skd::MaxDistance2(asked.Set, this->Shape.GetSet()));
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsRelated(const Asked& asked) const
{
  switch (this->Rules.Relation)
  {
    case SkdRelation::ExactMatch:
      return this->IsContained(asked) && this->IsEnclosing(asked);
    case SkdRelation::Enclosure:
      return this->IsEnclosing(asked);
    case SkdRelation::Containment:
      return this->IsContained(asked);
    case SkdRelation::Adjacency:
      return this->Touches(asked);
    default:
      return this->Shape.IsSureToHold(asked.Tree.Cells().ExtentOf(asked.Cell)) ||
        asked.IsZero(this->MinDistance(asked));
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsContained(const Asked& asked) const
{
  if (this->Shape.IsSureToHold(asked.Tree.Cells().ExtentOf(asked.Cell)))
  {
    return true;
  }
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      return asked.IsZero(std::sqrt(skd::MaxDistance2(asked.Set, ball.Centre)) - ball.Radius);
    }
    case SkdQueryShape::Kind::Plane:
      return asked.IsZero(this->MaxDistance(asked));
    default:
      return skd::Covers(this->Shape.GetSet(), asked.Set, asked.Tolerance);
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsEnclosing(const Asked& asked) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
    {
      const skd::Sphere<3>& ball = this->Shape.GetBall();
      const bool isDeep = asked.IsZero(ball.Radius) ||
        (asked.Set.Dimension == 3 &&
          asked.IsZero(ball.Radius - std::sqrt(skd::SimplexDistance2(asked.Set, ball.Centre))));
      return isDeep && asked.IsZero(asked.DistanceTo(ball.Centre));
    }
    case SkdQueryShape::Kind::Plane:
      return false;
    default:
      return skd::Covers(asked.Set, this->Shape.GetSet(), asked.Tolerance);
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::Touches(const Asked& asked) const
{
  switch (this->Shape.GetKind())
  {
    case SkdQueryShape::Kind::Ball:
      return this->TouchesBall(asked);
    case SkdQueryShape::Kind::Plane:
    {
      const skd::Interval heights = HeightsOf(this->Shape.GetPlane(), asked.Set);
      const bool isBelow = asked.IsZero(std::abs(heights.Max)) && !asked.IsZero(-heights.Min);
      const bool isAbove = asked.IsZero(std::abs(heights.Min)) && !asked.IsZero(heights.Max);
      return isBelow || isAbove;
    }
    default:
      asked.Set.FindRim();
      return asked.IsZero(this->MinDistance(asked)) &&
        !skd::InteriorsIntersect(asked.Set, this->Shape.GetSet(), asked.Tolerance);
  }
}

//------------------------------------------------------------------------------
bool SkdCellRelation::IsNeighbour(const Asked& asked) const
{
  const SkdCellOutline outline(asked.Source.Load(asked.Tree.Cells().IdOf(asked.Cell)));
  const bool isOne =
    outline.Shares(*this->Shape.GetOutline(), this->Rules.SharedPart, asked.Tolerance);
  asked.Least = isOne ? std::optional<double>(0.0) : std::nullopt;
  return isOne;
}

//------------------------------------------------------------------------------
// A ball from outside; a point on the cell's boundary. A point that is a cell touches itself.
bool SkdCellRelation::TouchesBall(const Asked& asked) const
{
  const skd::Sphere<3>& ball = this->Shape.GetBall();
  const double distance = asked.DistanceTo(ball.Centre);
  if (!asked.IsZero(ball.Radius))
  {
    return asked.IsZero(std::abs(distance - ball.Radius));
  }
  asked.Set.FindRim();
  const double boundary2 = asked.Set.Dimension == 3
    ? skd::SimplexDistance2(asked.Set, ball.Centre)
    : (asked.Set.Dimension == 0 ? 0.0 : skd::RimDistance2(asked.Set, ball.Centre));
  return asked.IsZero(distance) && asked.IsZero(std::sqrt(boundary2));
}
}
