// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapReader.h"

#include "Remap/SkdRemapTolerances.h"

#include "Core/Geometry/Distance/ClosestPointOnSegment.h"
#include "Core/Geometry/Overlap/LonLatOutline.h"
#include "Core/Geometry/Overlap/PolygonOverlap.h"
#include "Core/Geometry/Overlap/SegmentOverlap.h"
#include "Core/Geometry/Overlap/TangentFrame.h"
#include "Core/Geometry/Polygons/EarClipping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace skdtree
{
namespace
{
using skd::Vector3;

constexpr double Rounding = 4.0 * std::numeric_limits<double>::epsilon();
constexpr double HalfTurn = 3.14159265358979323846;

/// Two polygons must not have more than a ConvexPolygon has room for.
constexpr std::size_t MostCorners = skd::ConvexPolygon::Most / 2 - 2;

/// Twice the area and its direction.
template <class Corners>
Vector3 AreaOf(const Corners& corners)
{
  Vector3 area{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    area = area + Cross(corners[i - 1].X - corners[0].X, corners[i].X - corners[0].X);
  }
  return area;
}

template <class Corners>
Vector3 MeanOf(const Corners& corners)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (const auto& corner : corners)
  {
    sum = sum + (corner.X - corners[0].X);
  }
  return corners[0].X + (1.0 / static_cast<double>(corners.size())) * sum;
}

/// Corners that are where the one before is are dropped.
template <class Corners>
void DropRepeated(Corners& corners)
{
  double largest = 0.0;
  for (const auto& corner : corners)
  {
    largest = std::max(largest, Norm2(corner.X));
  }
  const double least2 = Rounding * Rounding * largest;
  const auto isSame = [&](const auto& a, const auto& b) { return Distance2(a.X, b.X) <= least2; };
  corners.erase(std::unique(corners.begin(), corners.end(), isSame), corners.end());
  while (corners.size() > 1 && isSame(corners.front(), corners.back()))
  {
    corners.pop_back();
  }
}

/// Twice the area of corners in a frame.
double AreaInFrame(const std::vector<Vector3>& projected)
{
  double area = 0.0;
  for (std::size_t i = 2; i < projected.size(); ++i)
  {
    area += Cross(projected[i - 1] - projected[0], projected[i] - projected[0])[2];
  }
  return area;
}

/// The cosine of how far from the middle of a piece on the sphere its corners may be.
constexpr double LeastCosine = 0.1;

/// The area of a triangle of the unit sphere, with a sign: less than half of the sphere.
double AreaOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double volume = Dot(a, Cross(b - a, c - a));
  return 2.0 * std::atan2(volume, 1.0 + Dot(a, b) + Dot(b, c) + Dot(c, a));
}

/// The area to the left of a simple polygon of the unit sphere: a full turn less the angles by
/// which its edges turn.
template <class Corners>
double AreaOnLeft(const Corners& corners)
{
  const std::size_t size = corners.size();
  double angle = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector3& at = corners[(i + 1) % size].X;
    const Vector3 from = Cross(corners[i].X, at);
    const Vector3 to = Cross(at, corners[(i + 2) % size].X);
    angle += std::atan2(Dot(at, Cross(from, to)), Dot(from, to));
  }
  return 2.0 * HalfTurn - angle;
}

/// Directions that are evenly about the sphere.
std::vector<Vector3> Directions()
{
  constexpr int number = 64;
  const double golden = HalfTurn * (3.0 - std::sqrt(5.0));
  std::vector<Vector3> directions;
  for (int i = 0; i < number; ++i)
  {
    const double z = (2.0 * i + 1.0) / number - 1.0;
    const double r = std::sqrt(1.0 - z * z);
    directions.push_back({ { r * std::cos(golden * i), r * std::sin(golden * i), z } });
  }
  return directions;
}

constexpr double FarEnough2 = 0.1; // squared, on the unit sphere: triangles are not too thin

/// A point about which triangles with the edges of a polygon on the sphere sum up to its area, with
/// its opposite far from the edges; zero if there is none.
template <class Corners>
Vector3 FindApex(const Corners& corners, double area)
{
  std::vector<Vector3> directions{ MeanOf(corners), AreaOf(corners) };
  const std::vector<Vector3> others = Directions();
  directions.insert(directions.end(), others.begin(), others.end());
  Vector3 best{ { 0.0, 0.0, 0.0 } };
  double farthest2 = 0.0;
  for (const Vector3& direction : directions)
  {
    const Vector3 apex = (1.0 / Norm(direction)) * direction;
    double sum = 0.0;
    double distance2 = 4.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Vector3& a = corners[i].X;
      const Vector3& b = corners[(i + 1) % corners.size()].X;
      sum += AreaOf(apex, a, b);
      distance2 = std::min(distance2, skd::ClosestPointOnSegment(a, b, -1.0 * apex).Dist2);
    }
    if (std::abs(sum - area) < remap_tolerances::SphereArea && distance2 > farthest2)
    {
      best = apex;
      farthest2 = distance2;
    }
    if (farthest2 > FarEnough2)
    {
      return best;
    }
  }
  return best;
}

/// Whether edges cross each other, in the inside of both and by more than rounding. The side of c
/// as seen from a to b is side(a, b, c).
template <class Side>
bool CrossesItself(std::size_t size, const Side& side)
{
  for (std::size_t a = 0; a + 2 < size; ++a)
  {
    const std::size_t b = a + 1;
    for (std::size_t c = a + 2; c < (a == 0 ? size - 1 : size); ++c)
    {
      const std::size_t d = (c + 1) % size;
      const int first = side(a, b, c);
      if (first != 0 && side(a, b, d) == -first && side(c, d, a) == -first &&
        side(c, d, b) == first)
      {
        return true;
      }
    }
  }
  return false;
}

/// The sign of a product of sines, 0 if rounding may have made it.
int SignOf(double product, double length2, double otherLength2)
{
  const double rounding = remap_tolerances::StraightAngle * std::sqrt(length2 * otherLength2);
  return product > rounding ? 1 : product < -rounding ? -1 : 0;
}

bool CrossesItselfInFrame(const std::vector<Vector3>& projected)
{
  return CrossesItself(projected.size(),
    [&](std::size_t a, std::size_t b, std::size_t c)
    {
      const Vector3 u = projected[b] - projected[a], v = projected[c] - projected[a];
      return SignOf(Cross(u, v)[2], Norm2(u), Norm2(v));
    });
}

template <class Corners>
bool CrossesItselfOnSphere(const Corners& corners)
{
  return CrossesItself(corners.size(),
    [&](std::size_t a, std::size_t b, std::size_t c)
    {
      const Vector3 u = corners[b].X - corners[a].X, v = corners[c].X - corners[a].X;
      return SignOf(Dot(corners[a].X, Cross(u, v)), Norm2(u), Norm2(v));
    });
}

/// Whether there are neighbours between which many arcs run.
template <class Corners>
bool HasOpposites(const Corners& corners)
{
  const auto isOpposite = [](const auto& a, const auto& b)
  { return Norm(a.X + b.X) < remap_tolerances::OppositeCorners; };
  return isOpposite(corners.front(), corners.back()) ||
    std::adjacent_find(corners.begin(), corners.end(), isOpposite) != corners.end();
}

/// The frame of a piece about its mean corner.
template <class Frame, class Corners>
Frame FrameOf(const Corners& corners)
{
  const Vector3 mean = MeanOf(corners);
  if constexpr (std::is_same_v<Frame, skd::TangentFrame>)
  {
    const Vector3 area = AreaOf(corners);
    return Frame(mean, (1.0 / Norm(area)) * area);
  }
  else
  {
    return Frame(std::is_same_v<Frame, skd::SphericalFrame> ? (1.0 / Norm(mean)) * mean : mean);
  }
}

template <class Frame, class Corners>
void SeeIn(const Frame& frame, const Corners& corners, std::vector<Vector3>& projected)
{
  projected.clear();
  for (const auto& corner : corners)
  {
    const Vector3 x = frame.Projected(corner.X);
    projected.push_back({ { x[0] / x[2], x[1] / x[2], 0.0 } });
  }
}

template <class Corners>
bool IsFlat(const skd::TangentFrame& frame, const Corners& corners)
{
  double extent = 0.0, height = 0.0;
  for (const auto& corner : corners)
  {
    extent = std::max(extent, Norm(corner.X - frame.Origin));
    height = std::max(height, std::abs(frame.HeightOf(corner.X)));
  }
  return corners.size() == 3 || height <= remap_tolerances::FlatPolygon * extent;
}

/// Of corners in a frame, counter-clockwise as a whole.
bool IsConvex(const std::vector<Vector3>& projected)
{
  const std::size_t size = projected.size();
  double angle = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector3& at = projected[i + 1 < size ? i + 1 : 0];
    const Vector3 forward = at - projected[i];
    const Vector3 next = projected[i + 2 < size ? i + 2 : i + 2 - size] - at;
    const double cross = forward[0] * next[1] - forward[1] * next[0];
    const double dot = forward[0] * next[0] + forward[1] * next[1];
    if (cross < -remap_tolerances::StraightAngle * std::sqrt(Norm2(forward) * Norm2(next)) ||
      (cross <= 0.0 && dot < 0.0))
    {
      return false;
    }
    angle += std::atan2(cross, dot);
  }
  return angle < 3.0 * HalfTurn; // once around, not twice
}
}

//------------------------------------------------------------------------------
void SkdOverlapReader::AddSegment(const Corner& a, const Corner& b)
{
  const Vector3 middle = Lerp(a.X, b.X, 0.5);
  const skd::Moments own = skd::MomentsOf(skd::Segment<3>{ a.X, b.X }, middle);
  if (own.Measure > 0.0)
  {
    const Corner corners[2] = { a, b };
    SkdOverlapPiece& piece = this->Add(corners, 2);
    piece.Reference = middle;
    piece.Radius = 0.5 * own.Measure;
    piece.Own = own;
  }
}

//------------------------------------------------------------------------------
// The points that were read, all of a cell. Of the two parts of a sphere that a polygon may be the
// smaller one is read: how it was ordered tells later if that was right.
void SkdOverlapReader::AddWholePolygon()
{
  const bool isSphere = this->Surface.GetSpace() == SkdOverlapSpace::Sphere;
  const std::size_t first = this->Block.Pieces.size();
  this->Mark.Orientation = isSphere ? 1 : 0;
  this->AddPolygon(this->CellPoints);
  double area = 0.0;
  for (std::size_t i = first; i < this->Block.Pieces.size(); ++i)
  {
    area += this->Block.Pieces[i].Sign * this->Block.Pieces[i].Own.Measure;
  }
  this->Mark.IsLarge = isSphere && area > 0.5 * HalfTurn * (1.0 + remap_tolerances::CoverGap);
}

void SkdOverlapReader::Reverse(Corners& corners)
{
  std::reverse(corners.begin(), corners.end());
  this->Mark.Orientation = static_cast<std::int8_t>(-this->Mark.Orientation);
}

//------------------------------------------------------------------------------
// A polygon on the sphere is the smaller part of what its edges divide, one in the plane is what it
// encloses: either is then counter-clockwise.
void SkdOverlapReader::AddPolygon(Corners& corners)
{
  DropRepeated(corners);
  if (corners.size() < 3)
  {
    return;
  }
  if (this->Surface.GetSpace() == SkdOverlapSpace::CurvedSurface)
  {
    this->AddFacets(corners);
    return;
  }
  const Vector3 area = AreaOf(corners);
  Vector3 middle = MeanOf(corners);
  const bool isSphere = this->Surface.GetSpace() == SkdOverlapSpace::Sphere;
  if (!isSphere)
  {
    if (area[2] < 0.0)
    {
      std::reverse(corners.begin(), corners.end());
    }
    this->AddVisible(skd::PlanarFrame(middle), corners);
    return;
  }
  if (Norm(middle) > remap_tolerances::Hemisphere)
  {
    if (Dot(area, middle) < 0.0)
    {
      this->Reverse(corners);
    }
  }
  else
  {
    middle = area;
  }
  if (this->Reading.IsLonLat && !this->Reading.IntoSimplices && this->AddLonLat(corners))
  {
    return;
  }
  middle = (1.0 / Norm(middle)) * middle;
  const bool isLarge = !IsFinite(middle) ||
    std::any_of(corners.begin(), corners.end(),
      [&](const Corner& corner) { return Dot(corner.X, middle) < 0.2; });
  if (isLarge)
  {
    this->AddLarge(corners);
  }
  else
  {
    this->AddVisible(skd::SphericalFrame(middle), corners);
  }
}

//------------------------------------------------------------------------------
// A polygon of a surface in space, with the side up from which it is counter-clockwise. A warped
// one is the triangles of its edges and the mean of its corners; those flipped over count negative.
void SkdOverlapReader::AddFacets(Corners& corners)
{
  const Vector3 area = AreaOf(corners);
  if (!(Norm2(area) > 0.0))
  {
    // What encloses nothing as a whole: two halves of opposite senses, if it is not in one line.
    this->Mark.CrossesItself =
      Norm2(Cross(corners[1].X - corners[0].X, corners[2].X - corners[0].X)) > 0.0;
    return;
  }
  const skd::TangentFrame frame(MeanOf(corners), (1.0 / Norm(area)) * area);
  if (IsFlat(frame, corners))
  {
    this->AddVisible(frame, corners);
    return;
  }
  SeeIn(frame, corners, this->Flat);
  this->Mark.CrossesItself = this->Mark.CrossesItself || CrossesItselfInFrame(this->Flat);
  const Corner middle{ frame.Origin, this->Reading.IntoSimplices ? this->AddMeanOf(corners) : -1 };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    const bool isOver = Dot(Cross(a.X - middle.X, b.X - middle.X), area) < 0.0;
    this->AddPiece<skd::TangentFrame>(
      { middle, isOver ? b : a, isOver ? a : b }, static_cast<std::int8_t>(isOver ? -1 : 1));
  }
}

//------------------------------------------------------------------------------
// What has corners that are not seen from its middle: triangles about a point, with signs.
// Triangles of less than half the sphere never have the point that is opposite to where they meet,
// so they sum up to the polygon if that is not in it, else to what is left of the sphere,
// negatively: their area tells.
void SkdOverlapReader::AddLarge(Corners& corners)
{
  const double area = AreaOnLeft(corners);
  if (area > HalfTurn * 2.0 * (1.0 + remap_tolerances::StraightAngle))
  {
    this->Reverse(corners);
  }
  const Vector3 apex = FindApex(corners, std::min(area, 4.0 * HalfTurn - area));
  this->Mark.CrossesItself =
    !(Norm2(apex) > 0.0) || HasOpposites(corners) || CrossesItselfOnSphere(corners);
  if (this->Mark.CrossesItself)
  {
    return;
  }
  const Corner middle{ apex, this->Reading.IntoSimplices ? this->AddMeanOf(corners) : -1 };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    Corners triangle{ middle, corners[i], corners[(i + 1) % corners.size()] };
    const double side = Dot(apex, Cross(triangle[1].X, triangle[2].X));
    if (std::abs(side) > Rounding)
    {
      const std::int8_t sign = side > 0.0 ? 1 : -1;
      if (sign < 0)
      {
        std::swap(triangle[1], triangle[2]);
      }
      this->AddPiece<skd::SphericalFrame>(triangle, sign);
    }
  }
}

//------------------------------------------------------------------------------
// Of what is too large to be seen from its middle: a polygon in triangles, a triangle in halves.
void SkdOverlapReader::AddSplit(const Corners& corners, std::int8_t sign)
{
  if (corners.size() > 3)
  {
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      this->AddPiece<skd::SphericalFrame>({ corners[0], corners[i - 1], corners[i] }, sign);
    }
    return;
  }
  const auto length2 = [&](std::size_t i)
  { return Distance2(corners[i].X, corners[(i + 1) % 3].X); };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
  {
    longest = length2(i) > length2(longest) ? i : longest;
  }
  const Corners edge{ corners[longest], corners[(longest + 1) % 3] };
  const Corner& tip = corners[(longest + 2) % 3];
  const Vector3 sum = edge[0].X + edge[1].X;
  if (!(Norm2(sum) > 0.0))
  {
    return; // of opposite ends any point is in the middle
  }
  const Corner middle{ (1.0 / Norm(sum)) * sum,
    this->Reading.IntoSimplices ? this->AddMeanOf(edge) : -1 };
  this->AddPiece<skd::SphericalFrame>({ edge[0], middle, tip }, sign);
  this->AddPiece<skd::SphericalFrame>({ middle, edge[1], tip }, sign);
}

//------------------------------------------------------------------------------
template <class Frame>
void SkdOverlapReader::AddVisible(const Frame& frame, Corners& corners)
{
  std::vector<Vector3>& projected = this->Flat;
  SeeIn(frame, corners, projected);
  if (this->Surface.GetSpace() == SkdOverlapSpace::Sphere && AreaInFrame(projected) < 0.0)
  {
    this->Reverse(corners);
    std::reverse(projected.begin(), projected.end());
  }
  const bool isTriangle = corners.size() == 3;
  if (isTriangle || (!this->Reading.IntoSimplices && IsConvex(projected)))
  {
    if (corners.size() <= MostCorners)
    {
      this->template AddPiece<Frame>(corners, 1);
      return;
    }
    for (std::size_t i = 1; i + 1 < corners.size(); i += MostCorners - 2)
    {
      Corners part{ corners[0] };
      const std::size_t last = std::min(i + MostCorners - 1, corners.size());
      part.insert(part.end(), corners.begin() + static_cast<std::ptrdiff_t>(i),
        corners.begin() + static_cast<std::ptrdiff_t>(last));
      this->template AddPiece<Frame>(part, 1);
    }
    return;
  }
  this->Mark.CrossesItself = this->Mark.CrossesItself || CrossesItselfInFrame(projected);
  skd::EarClipping<std::vector<Vector3>> ears(projected, static_cast<int>(projected.size()));
  ears.ForEachTriangle(
    [&](int a, int b, int c)
    {
      const Vector3 normal = Cross(projected[b] - projected[a], projected[c] - projected[a]);
      Corners triangle{ corners[a], corners[b], corners[c] };
      if (normal[2] < 0.0)
      {
        std::swap(triangle[1], triangle[2]);
      }
      this->template AddPiece<Frame>(triangle, normal[2] < 0.0 ? -1 : 1);
    });
}

//------------------------------------------------------------------------------
template <class Frame>
void SkdOverlapReader::AddPiece(const Corners& corners, std::int8_t sign)
{
  const Frame frame = FrameOf<Frame>(corners);
  if (std::is_same_v<Frame, skd::SphericalFrame> &&
    !std::all_of(corners.begin(), corners.end(),
      [&](const Corner& corner) { return Dot(corner.X, frame.Origin) > LeastCosine; }))
  {
    this->AddSplit(corners, sign);
    return;
  }
  skd::ConvexPolygon polygon;
  double radius2 = 0.0;
  for (const Corner& corner : corners)
  {
    const Vector3 projected = frame.Projected(corner.X);
    polygon.Add({ { projected[0] / projected[2], projected[1] / projected[2] } });
    radius2 = std::max(radius2, Distance2(corner.X, frame.Origin));
  }
  const skd::Moments own = frame.Moments(polygon);
  if (own.Measure > 0.0)
  {
    SkdOverlapPiece& piece = this->Add(corners.data(), corners.size());
    piece.Sign = sign;
    piece.Reference = frame.Origin;
    piece.Radius = std::sqrt(radius2);
    piece.Own = own;
  }
}

//------------------------------------------------------------------------------
bool SkdOverlapReader::AddLonLat(const Corners& corners)
{
  std::vector<Vector3> points;
  for (const Corner& corner : corners)
  {
    points.push_back(corner.X);
  }
  const auto cell = skd::LonLatOutline(points).Find();
  if (cell)
  {
    this->AddLonLatPieces(*cell);
  }
  return cell.has_value();
}

//------------------------------------------------------------------------------
// Wide ones in parts, and those that may have both poles.
void SkdOverlapReader::AddLonLatPieces(const skd::LonLatCell& whole)
{
  const int parts = std::max(1, static_cast<int>(std::ceil(whole.Width() / (0.6 * HalfTurn))));
  const bool isTall = whole.South < -1.0 && whole.North > 1.0;
  for (int i = 0; i < parts * (isTall ? 2 : 1); ++i)
  {
    const int part = i % parts;
    const auto meridian = [&](int k)
    { return k == parts ? whole.East : whole.West + whole.Width() * k / parts; };
    const skd::LonLatCell cell{ meridian(part), meridian(part + 1),
      isTall && i >= parts ? 0.0 : whole.South, isTall && i < parts ? 0.0 : whole.North };
    const Vector3 centre = cell.Centre();
    const skd::Moments own = skd::MomentsOf(cell, centre);
    if (!(own.Measure > 0.0))
    {
      continue;
    }
    const skd::Box3 bounds = cell.Bounds();
    const Corner corners[2] = { { { { cell.West, cell.East, 0.0 } }, -1 },
      { { { cell.South, cell.North, 0.0 } }, -1 } };
    SkdOverlapPiece& piece = this->Add(corners, 2);
    piece.IsLonLat = true;
    piece.Reference = centre;
    piece.Radius = bounds.Diagonal();
    piece.Own = own;
  }
}
}
