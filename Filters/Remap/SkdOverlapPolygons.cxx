// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapReader.h"

#include "Remap/SkdRemapTolerances.h"

#include "Core/Geometry/Overlap/LonLatOutline.h"
#include "Core/Geometry/Overlap/PolygonOverlap.h"
#include "Core/Geometry/Overlap/SegmentOverlap.h"
#include "Core/Geometry/Polygons/EarClipping.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Of corners in a frame, counter-clockwise as a whole.
bool IsConvex(const std::vector<Vector3>& seen)
{
  const std::size_t size = seen.size();
  double turned = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector3& at = seen[i + 1 < size ? i + 1 : 0];
    const Vector3 way = at - seen[i];
    const Vector3 next = seen[i + 2 < size ? i + 2 : i + 2 - size] - at;
    const double cross = way[0] * next[1] - way[1] * next[0];
    const double dot = way[0] * next[0] + way[1] * next[1];
    if (cross < -remap_tolerances::StraightAngle * std::sqrt(Norm2(way) * Norm2(next)) ||
      (cross <= 0.0 && dot < 0.0))
    {
      return false;
    }
    turned += std::atan2(cross, dot);
  }
  return turned < 3.0 * HalfTurn; // once around, not twice
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
    piece.Reach = 0.5 * own.Measure;
    piece.Own = own;
  }
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
  const Vector3 area = AreaOf(corners);
  Vector3 middle = MeanOf(corners);
  const bool isSphere = this->Ground.GetSpace() == SkdOverlapSpace::Sphere;
  if (!isSphere)
  {
    if (area[2] < 0.0)
    {
      std::reverse(corners.begin(), corners.end());
    }
    this->AddSeen(skd::PlanarFrame(middle), corners);
    return;
  }
  if (Norm(middle) > remap_tolerances::Hemisphere)
  {
    if (Dot(area, middle) < 0.0)
    {
      std::reverse(corners.begin(), corners.end());
    }
  }
  else
  {
    middle = area;
  }
  if (!(Norm2(middle) > 0.0) ||
    (this->Reading.IsLonLat && !this->Reading.IntoSimplices && this->AddLonLat(corners)))
  {
    return;
  }
  middle = (1.0 / Norm(middle)) * middle;
  const bool isLarge = std::any_of(corners.begin(), corners.end(),
    [&](const Corner& corner) { return Dot(corner.X, middle) < 0.2; });
  if (isLarge)
  {
    this->AddFan(corners, this->Reading.IntoSimplices ? corners[0] : Corner{ middle, -1 });
  }
  else
  {
    this->AddSeen(skd::SphericalFrame(middle), corners);
  }
}

//------------------------------------------------------------------------------
// What is about as large as a hemisphere: triangles about its middle, or a corner.
void SkdOverlapReader::AddFan(const Corners& corners, const Corner& middle)
{
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    Corners triangle{ middle, corners[i], corners[(i + 1) % corners.size()] };
    const double side = Dot(middle.X, Cross(triangle[1].X, triangle[2].X));
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
template <class Frame>
void SkdOverlapReader::AddSeen(const Frame& frame, Corners& corners)
{
  std::vector<Vector3>& seen = this->Flat;
  seen.clear();
  for (const Corner& corner : corners)
  {
    const Vector3 x = frame.Seen(corner.X);
    seen.push_back({ { x[0] / x[2], x[1] / x[2], 0.0 } });
  }
  const bool isTriangle = corners.size() == 3;
  if (isTriangle || (!this->Reading.IntoSimplices && IsConvex(seen)))
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
  skd::EarClipping<std::vector<Vector3>> ears(seen, static_cast<int>(seen.size()));
  ears.ForEachTriangle(
    [&](int a, int b, int c)
    {
      const Vector3 turn = Cross(seen[b] - seen[a], seen[c] - seen[a]);
      Corners triangle{ corners[a], corners[b], corners[c] };
      if (turn[2] < 0.0)
      {
        std::swap(triangle[1], triangle[2]);
      }
      this->template AddPiece<Frame>(triangle, turn[2] < 0.0 ? -1 : 1);
    });
}

//------------------------------------------------------------------------------
template <class Frame>
void SkdOverlapReader::AddPiece(const Corners& corners, std::int8_t sign)
{
  const Vector3 mean = MeanOf(corners);
  const Frame frame(
    this->Ground.GetSpace() == SkdOverlapSpace::Sphere ? (1.0 / Norm(mean)) * mean : mean);
  skd::ConvexPolygon polygon;
  double reach2 = 0.0;
  for (const Corner& corner : corners)
  {
    const Vector3 seen = frame.Seen(corner.X);
    polygon.Add({ { seen[0] / seen[2], seen[1] / seen[2] } });
    reach2 = std::max(reach2, Distance2(corner.X, frame.Origin));
  }
  const skd::Moments own = frame.Moments(polygon);
  if (own.Measure > 0.0)
  {
    SkdOverlapPiece& piece = this->Add(corners.data(), corners.size());
    piece.Sign = sign;
    piece.Reference = frame.Origin;
    piece.Reach = std::sqrt(reach2);
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
    piece.Reach = bounds.Diagonal();
    piece.Own = own;
  }
}
