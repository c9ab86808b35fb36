// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Relations/SkdQueryShape.h"

#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Rounding = 8.0 * std::numeric_limits<double>::epsilon();

skd::Box3 BoundsOf(const skd::Sphere<3>& ball)
{
  return skd::Box3(ball.Centre, ball.Centre).Inflated(ball.Radius);
}

/// How far the box is above and below a plane: the least and the greatest height.
skd::Interval HeightsOf(const skd::Plane<3>& plane, const skd::Box3& box)
{
  skd::Interval heights{ 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = plane.Normal[axis] * (box.Min[axis] - plane.Origin[axis]);
    const double b = plane.Normal[axis] * (box.Max[axis] - plane.Origin[axis]);
    heights.Min += std::min(a, b);
    heights.Max += std::max(a, b);
  }
  return heights;
}
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakeBall(const skd::Vector3& centre, double radius)
{
  SkdQueryShape shape;
  shape.TheKind = Kind::Ball;
  shape.Ball = { centre, radius };
  shape.Bounds = BoundsOf(shape.Ball);
  shape.Usable =
    radius >= 0.0 && skd::IsFinite(shape.Bounds.Min) && skd::IsFinite(shape.Bounds.Max);
  shape.Largest = skd::LargestCoordinate(shape.Bounds);
  return shape;
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakePlane(const skd::Vector3& origin, const skd::Vector3& normal)
{
  SkdQueryShape shape;
  shape.TheKind = Kind::Plane;
  shape.Plane = { origin, (1.0 / skd::Norm(normal)) * normal };
  shape.Usable = skd::IsFinite(origin) && skd::IsFinite(shape.Plane.Normal);
  shape.Largest = skd::LargestCoordinate(skd::Box3(origin, origin));
  return shape;
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakeLine(const skd::Vector3& a, const skd::Vector3& b)
{
  return MakeSet(Kind::Line, skd::MakeSegment({ a, b }));
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakeBox(const skd::Vector3& corner, const skd::Vector3 (&edges)[3])
{
  skd::Vector3 opposite = corner;
  bool isAligned = true;
  bool isFinite = skd::IsFinite(corner);
  for (int axis = 0; axis < 3; ++axis)
  {
    const skd::Vector3& edge = edges[axis];
    isFinite = isFinite && skd::IsFinite(edge);
    isAligned = isAligned && edge[(axis + 1) % 3] == 0.0 && edge[(axis + 2) % 3] == 0.0;
    opposite[axis] += edge[axis];
  }
  if (!isFinite)
  {
    return SkdQueryShape();
  }
  if (isAligned)
  {
    skd::Box3 box(corner, corner);
    box.Add(opposite);
    SkdQueryShape shape = MakeSet(Kind::Box, skd::MakeBox(box));
    shape.IsAligned = true;
    return shape;
  }
  skd::Box3 shares(skd::Vector3{ { 0.0, 0.0, 0.0 } }, skd::Vector3{ { 0.0, 0.0, 0.0 } });
  for (int axis = 0; axis < 3; ++axis)
  {
    shares.Max[axis] = edges[axis] == shares.Min ? 0.0 : 1.0;
  }
  const auto place = [&](const skd::Vector3& x)
  { return corner + x[0] * edges[0] + x[1] * edges[1] + x[2] * edges[2]; };
  return MakeSet(Kind::Box, skd::MakeBox(shares, place));
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakeCell(const SkdCellTree& tree, std::uint32_t cell,
  const SkdCellSource& source, std::shared_ptr<const SkdCellOutline> outline)
{
  skd::SimplexSet set;
  tree.GetSimplices(cell, source, set);
  SkdQueryShape shape = MakeSet(Kind::Cell, std::move(set));
  shape.Bounds = tree.Cells().ReachOf(cell);
  shape.SafetyMargin = 2.0 * tree.AbsoluteEpsilon();
  shape.Outline = std::move(outline);
  return shape;
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakeSet(Kind kind, skd::SimplexSet set)
{
  SkdQueryShape shape;
  shape.TheKind = kind;
  shape.Usable = std::all_of(
    set.Points.begin(), set.Points.end(), [](const skd::Vector3& x) { return skd::IsFinite(x); });
  shape.Bounds = set.Bounds;
  shape.Largest = skd::LargestCoordinate(set.Bounds);
  shape.Set = std::move(set);
  return shape;
}

//------------------------------------------------------------------------------
double SkdQueryShape::Rounding(const SkdCellTree& tree) const
{
  return std::max(::Rounding * this->Largest, tree.Rounding());
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdQueryShape::FindNear(const SkdCellTree& tree, double reach) const
{
  vtkNew<vtkIdList> ids;
  if (this->TheKind == Kind::Ball)
  {
    tree.FindSafetyBoxesWithin(this->Ball.Centre, this->Ball.Radius + reach, ids);
  }
  else if (this->TheKind == Kind::Plane)
  {
    tree.FindSafetyBoxesAlong(this->Plane, reach, ids);
  }
  else if (this->TheKind == Kind::Line && reach <= tree.AbsoluteEpsilon())
  {
    tree.FindSafetyBoxesAlong({ this->Set.Points.front(), this->Set.Points.back() }, ids);
  }
  else
  {
    tree.FindSafetyBoxesWithin(this->Bounds.Inflated(reach), ids);
  }
  std::vector<std::uint32_t> cells;
  cells.reserve(static_cast<std::size_t>(ids->GetNumberOfIds()));
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    cells.push_back(static_cast<std::uint32_t>(tree.Cells().CellOfId(ids->GetId(i))));
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

//------------------------------------------------------------------------------
double SkdQueryShape::LowerBound(const skd::Box3& box) const
{
  if (this->TheKind == Kind::Ball)
  {
    return skd::MinDistance(this->Ball, box);
  }
  if (this->TheKind == Kind::Plane)
  {
    const skd::Interval heights = HeightsOf(this->Plane, box);
    return std::max({ 0.0, heights.Min, -heights.Max });
  }
  return std::sqrt(skd::MinDistance2(this->Bounds.Inflated(this->SafetyMargin), box));
}

//------------------------------------------------------------------------------
double SkdQueryShape::OptimisticDistance(const skd::Box3& box) const
{
  const double bound = this->LowerBound(box);
  const bool isTurned =
    this->TheKind == Kind::Line || (this->TheKind == Kind::Box && !this->IsAligned);
  return isTurned ? std::max(bound, std::sqrt(skd::MinDistance2(this->Set, skd::MakeBox(box))))
                  : bound;
}

//------------------------------------------------------------------------------
double SkdQueryShape::PessimisticDistance(const skd::Box3& box) const
{
  switch (this->TheKind)
  {
    case Kind::Ball:
      return skd::MaxDistance(this->Ball, box);
    case Kind::Plane:
    {
      const skd::Interval heights = HeightsOf(this->Plane, box);
      return std::max(std::abs(heights.Min), std::abs(heights.Max));
    }
    case Kind::Cell:
      return std::sqrt(skd::MaxDistance2(this->Bounds.Inflated(this->SafetyMargin), box));
    default:
      break;
  }
  double most2 = 0.0;
  for (const skd::Vector3& x : this->Set.Points)
  {
    most2 = std::max(most2, skd::MaxDistance2(x, box));
  }
  return std::sqrt(most2);
}

//------------------------------------------------------------------------------
bool SkdQueryShape::IsCandidate(
  SkdRelation relation, const SkdCellTree& tree, std::uint32_t cell, double tolerance) const
{
  return this->OptimisticDistance(tree.SafetyBoxOf(cell)) <= tolerance &&
    this->AreBoundsRelated(relation, tree, cell, tolerance);
}

//------------------------------------------------------------------------------
// Nothing holds an unbounded plane. Bounds of curved cells hold more than these, so that their
// being within others is not asked for.
bool SkdQueryShape::AreBoundsRelated(
  SkdRelation relation, const SkdCellTree& tree, std::uint32_t cell, double tolerance) const
{
  const bool asksWhole = relation == SkdRelation::Enclosure || relation == SkdRelation::ExactMatch;
  const bool asksPart = relation == SkdRelation::Containment || relation == SkdRelation::ExactMatch;
  if (this->TheKind == Kind::Plane)
  {
    return !asksWhole;
  }
  const skd::Box3& bounds = this->TheKind == Kind::Ball ? this->Bounds : this->Set.Bounds;
  const double margin = 2.0 * tree.AbsoluteEpsilon() + tolerance;
  const bool isWhole = tree.SafetyBoxOf(cell).Inflated(tolerance).Contains(bounds);
  const bool isPart = tree.Cells().ShapeOf(cell) == SkdShape::Generic ||
    bounds.Inflated(margin).Contains(tree.Cells().BoundsOf(cell));
  return (!asksWhole || isWhole) && (!asksPart || isPart);
}

//------------------------------------------------------------------------------
bool SkdQueryShape::IsSureToHold(const skd::Box3& box) const
{
  if (this->TheKind == Kind::Ball)
  {
    return skd::MaxDistance2(this->Ball.Centre, box) <= this->Ball.Radius * this->Ball.Radius;
  }
  return this->IsAligned && this->Bounds.Contains(box);
}
