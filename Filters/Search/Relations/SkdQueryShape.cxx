// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Relations/SkdQueryShape.h"

#include "Core/Geometry/Simplices/SimplexDistance.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
constexpr double Rounding = 8.0 * std::numeric_limits<double>::epsilon();

skd::Box3 BoundsOf(const skd::Sphere<3>& ball)
{
  return skd::Box3(ball.Centre, ball.Centre).Inflated(ball.Radius);
}

/// Sorts distinct numbers less than `end`; many numbers by a bit set.
void SortNumbers(std::vector<std::uint32_t>& numbers, std::uint32_t end)
{
  if (numbers.size() < end / 64)
  {
    std::sort(numbers.begin(), numbers.end());
    return;
  }
  std::vector<std::uint32_t> rows(end / 32 + 1, 0u);
  for (const std::uint32_t number : numbers)
  {
    rows[number / 32] |= 1u << number % 32;
  }
  std::uint32_t* to = numbers.data();
  for (std::uint32_t row = 0; row < rows.size(); ++row)
  {
    for (std::uint32_t marks = rows[row]; marks != 0; marks &= marks - 1)
    {
      *to++ = 32 * row + static_cast<std::uint32_t>(skd::LowestBit(marks));
    }
  }
}

bool IsMeasurable(const skd::Vector3& x)
{
  return SkdIsWithin(x, SkdMeasurable.Largest);
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
  shape.Usable = radius >= 0.0 && IsMeasurable(shape.Bounds.Min) && IsMeasurable(shape.Bounds.Max);
  shape.Largest = skd::LargestCoordinate(shape.Bounds);
  return shape;
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakePlane(const skd::Vector3& origin, const skd::Vector3& normal)
{
  SkdQueryShape shape;
  shape.TheKind = Kind::Plane;
  shape.Plane = { origin, (1.0 / skd::Norm(normal)) * normal };
  shape.Usable = IsMeasurable(origin) && skd::IsFinite(shape.Plane.Normal);
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
  const auto map = [&](const skd::Vector3& x)
  { return corner + x[0] * edges[0] + x[1] * edges[1] + x[2] * edges[2]; };
  return MakeSet(Kind::Box, skd::MakeBox(shares, map));
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakeCell(const SkdCellTree& tree, std::uint32_t cell,
  const SkdCellSource& source, std::shared_ptr<const SkdCellOutline> outline)
{
  skd::SimplexSet set;
  tree.GetSimplices(cell, source, set);
  SkdQueryShape shape = MakeSet(Kind::Cell, std::move(set));
  shape.Bounds = tree.Cells().ExtentOf(cell);
  shape.SafetyMargin = 2.0 * tree.AbsoluteEpsilon();
  shape.Outline = std::move(outline);
  return shape;
}

//------------------------------------------------------------------------------
SkdQueryShape SkdQueryShape::MakeSet(Kind kind, skd::SimplexSet set)
{
  SkdQueryShape shape;
  shape.TheKind = kind;
  shape.Usable = std::all_of(set.Points.begin(), set.Points.end(), IsMeasurable);
  shape.Bounds = set.Bounds;
  shape.Largest = skd::LargestCoordinate(set.Bounds);
  shape.Set = std::move(set);
  return shape;
}

//------------------------------------------------------------------------------
double SkdQueryShape::Rounding(const SkdCellTree& tree) const
{
  return std::max(skdtree::Rounding * this->Largest, tree.Rounding());
}

//------------------------------------------------------------------------------
// The query is the line itself, not its bounding box, where safety boxes allow for the distance.
bool SkdQueryShape::IsAsSegment(const SkdCellTree& tree, double maxDistance) const
{
  return this->TheKind == Kind::Line && maxDistance <= tree.AbsoluteEpsilon();
}

//------------------------------------------------------------------------------
bool SkdQueryShape::IsNear(
  const SkdCellTree& tree, const skd::Box3& safetyBox, double maxDistance) const
{
  switch (this->TheKind)
  {
    case Kind::Ball:
    {
      const double radius = this->Ball.Radius + maxDistance;
      return skd::MinDistance2(this->Ball.Centre, safetyBox) <= radius * radius;
    }
    case Kind::Plane:
      return skd::Overlaps(this->Plane, safetyBox, maxDistance);
    default:
      return this->IsAsSegment(tree, maxDistance)
        ? skd::Clip(skd::Segment<3>{ this->Set.Points.front(), this->Set.Points.back() }, safetyBox)
            .has_value()
        : safetyBox.Overlaps(this->Bounds.Inflated(maxDistance));
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdQueryShape::FindMaybeNear(
  const SkdCellTree& tree, double maxDistance) const
{
  std::vector<std::uint32_t> cells;
  if (this->TheKind == Kind::Ball)
  {
    tree.FindMaybeWithin(this->Ball.Centre, this->Ball.Radius + maxDistance, cells);
  }
  else if (this->TheKind == Kind::Plane || this->IsAsSegment(tree, maxDistance))
  {
    vtkNew<vtkIdList> ids;
    if (this->TheKind == Kind::Plane)
    {
      tree.FindSafetyBoxesAlong(this->Plane, maxDistance, ids);
    }
    else
    {
      tree.FindSafetyBoxesAlong({ this->Set.Points.front(), this->Set.Points.back() }, ids);
    }
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      cells.push_back(static_cast<std::uint32_t>(tree.Cells().CellOfId(ids->GetId(i))));
    }
  }
  else
  {
    tree.FindMaybeWithin(this->Bounds.Inflated(maxDistance), cells);
  }
  SortNumbers(cells, tree.Cells().NumberOfCells());
  return cells;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdQueryShape::FindNear(
  const SkdCellTree& tree, double maxDistance) const
{
  std::vector<std::uint32_t> cells = this->FindMaybeNear(tree, maxDistance);
  const auto isFar = [&](std::uint32_t cell)
  { return !this->IsNear(tree, tree.SafetyBoxOf(cell), maxDistance); };
  cells.erase(std::remove_if(cells.begin(), cells.end(), isFar), cells.end());
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
  const bool isReversed =
    this->TheKind == Kind::Line || (this->TheKind == Kind::Box && !this->IsAligned);
  return isReversed ? std::max(bound, std::sqrt(skd::MinDistance2(this->Set, skd::MakeBox(box))))
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
  if (this->IsAligned)
  {
    return this->PessimisticFromCorners(box); // the same as of each corner
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
// being within others is not requested.
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

//------------------------------------------------------------------------------
// The farthest point of a box is, along each axis, on the farther of its sides.
SkdQueryShape::Corner SkdQueryShape::LookAt(const skd::Vector3& x) const
{
  if (this->TheKind == Kind::Ball)
  {
    const double dist2 = skd::Distance2(x, this->Ball.Centre);
    return { dist2, dist2 <= this->Ball.Radius * this->Ball.Radius };
  }
  return { skd::MaxDistance2(x, this->Bounds), this->Bounds.Contains(x) };
}

//------------------------------------------------------------------------------
std::optional<SkdQueryShape::Corners> SkdQueryShape::LookAtCorners(
  const SkdCellTree& tree, std::uint32_t cell, const Corner* known) const
{
  const SkdCellStore& cells = tree.Cells();
  if (!this->LooksAtCorners() || cells.HasCurvedExtents() ||
    cells.ShapeOf(cell) == SkdShape::Generic)
  {
    return std::nullopt;
  }
  const std::uint32_t* const ids = cells.PointIdsOf(cell);
  Corners corners{ false, true, 0.0, 0.0 };
  double most2 = 0.0;
  std::for_each(ids, ids + cells.SizeOf(cell),
    [&](std::uint32_t id)
    {
      const Corner corner = known ? known[id] : this->LookAt(cells.Point(id));
      corners.AreSomeIn |= corner.IsIn;
      corners.AreAllIn &= corner.IsIn;
      most2 = std::max(most2, corner.Farthest2);
    });
  const skd::Box3 box = cells.BoundsOf(cell).Inflated(2.0 * tree.AbsoluteEpsilon());
  corners.Farthest = std::sqrt(most2) + this->Ball.Radius; // 0 if it is a box
  corners.Pessimistic = this->PessimisticFromCorners(box);
  return corners;
}

//------------------------------------------------------------------------------
// As skd::MaxDistance2(), of which compilers make loads that wait for stores.
double SkdQueryShape::PessimisticFromCorners(const skd::Box3& box) const
{
  const bool isBall = this->TheKind == Kind::Ball;
  const skd::Vector3& low = isBall ? this->Ball.Centre : this->Bounds.Min;
  const skd::Vector3& high = isBall ? this->Ball.Centre : this->Bounds.Max;
  return skd::Norm(skd::Greatest(box.Max - low, high - box.Min)) + this->Ball.Radius;
}

//------------------------------------------------------------------------------
// A bit for each side of the bounds that a point is beyond.
unsigned char SkdQueryShape::SidesOf(const skd::Vector3& x, double maxDistance) const
{
  unsigned sides = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    sides |= static_cast<unsigned>(x[axis] < this->Bounds.Min[axis] - maxDistance) << 2 * axis |
      static_cast<unsigned>(x[axis] > this->Bounds.Max[axis] + maxDistance) << (2 * axis + 1);
  }
  return static_cast<unsigned char>(sides);
}
}
