// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_LonLatOverlap_h
#define skd_Geometry_Overlap_LonLatOverlap_h

#include "LonLatCell.h"
#include "PolygonOverlap.h"

namespace skd
{

/// A polygon of great circles that lies between two meridians, less what is beyond two parallels:
/// area and first moment by integrals along its edges and the parallels, exact but for rounding.
///
/// The parallels' part of the border needs no geometry: it goes from where the edges leave through
/// a parallel to where they come back, in whatever order, and its integrals are differences of a
/// function of the longitude. So nothing has to be decided where edges touch parallels.
class BetweenParallels
{
public:
  /// Latitudes; the polygon is within a half turn about longitude 0.
  BetweenParallels(double south, double north)
    : IsNorthern(south + north >= 0.0)
    , HasLevel{ south > -Pole, north < Pole }
    , Level{ std::sin(south), std::sin(north) }
    , Radius{ std::cos(south), std::cos(north) }
  {
  }

  /// About the sphere's centre.
  Moments Measure(const Vector3* corners, int size)
  {
    for (int i = 0; i < size; ++i)
    {
      this->AddEdge(corners[i], corners[i + 1 == size ? 0 : i + 1]);
    }
    this->Cross(corners[0], this->StateAtFirst);
    return this->Sum;
  }

private:
  static constexpr double Pole = 1.57079632679489;

  /// -1 south of the cell, 1 north of it.
  int StateOf(const Vector3& x) const
  {
    return this->HasLevel[0] && x[2] < this->Level[0]
      ? -1
      : (this->HasLevel[1] && x[2] > this->Level[1] ? 1 : 0);
  }

  void AddEdge(const Vector3& a, const Vector3& b)
  {
    const Vector3 normal = skd::Cross(a, b);
    const double sine = Norm(normal);
    if (!(sine > 0.0))
    {
      return;
    }
    const double angle = std::atan2(sine, Dot(a, b));
    const Vector3 tangent = skd::Cross((1.0 / sine) * normal, a);
    const auto at = [&](double t) { return std::cos(t) * a + std::sin(t) * tangent; };
    std::array<double, 6> latitudes;
    const int number = this->FindCrossings(a[2], tangent[2], angle, latitudes);
    Vector3 from = a;
    for (int i = 1; i < number; ++i)
    {
      const Vector3 to = i + 1 == number ? b : at(latitudes[i]);
      this->AddArc(from, to, this->StateOf(at(0.5 * (latitudes[i - 1] + latitudes[i]))));
      from = to;
    }
  }

  /// 0, where the arc crosses parallels, ascending, and its angle.
  int FindCrossings(double z, double slope, double angle, std::array<double, 6>& latitudes) const
  {
    int number = 1;
    latitudes[0] = 0.0;
    const double most = std::hypot(z, slope);
    const double top = std::atan2(slope, z);
    for (int level = 0; level < 2; ++level)
    {
      if (!this->HasLevel[level] || !(std::abs(this->Level[level]) < most))
      {
        continue;
      }
      constexpr double fullCircle = 6.28318530717958647692;
      const double side = std::acos(this->Level[level] / most);
      for (const double latitude : { top - side, top + side })
      {
        const double t = latitude < 0.0
          ? latitude + fullCircle
          : (latitude >= fullCircle ? latitude - fullCircle : latitude);
        if (t > 0.0 && t < angle)
        {
          Insert(latitudes, number++, t);
        }
      }
    }
    latitudes[number++] = angle;
    return number;
  }

  /// Keeps them ascending.
  static void Insert(std::array<double, 6>& latitudes, int number, double t)
  {
    for (; latitudes[number - 1] > t; --number)
    {
      latitudes[number] = latitudes[number - 1];
    }
    latitudes[number] = t;
  }

  void AddArc(const Vector3& from, const Vector3& to, int state)
  {
    if (this->IsFirst)
    {
      this->IsFirst = false;
      this->StateAtFirst = state;
    }
    else
    {
      this->Cross(from, state);
    }
    this->State = state;
    if (state != 0)
    {
      return;
    }
    const Vector3 normal = skd::Cross(from, to);
    const double side = this->IsNorthern ? 1.0 : -1.0;
    this->Sum.Measure +=
      2.0 * std::atan2(side * normal[2], 1.0 + side * (from[2] + to[2]) + Dot(from, to));
    const double sine2 = Norm2(normal);
    const double share = 0.5 * (1.0 + detail::ArcExcess(sine2, Dot(from, to)));
    this->Sum.First = this->Sum.First + (sine2 > 0.0 ? share : 0.0) * normal;
  }

  /// The border goes on in another state: along a parallel it has begun or ended.
  void Cross(const Vector3& x, int state)
  {
    const bool wasNorth = this->State > 0;
    const bool wasSouth = this->State < 0;
    if (wasSouth != (state < 0))
    {
      this->AddEnd(x, 0, wasSouth ? 1.0 : -1.0);
    }
    if (wasNorth != (state > 0))
    {
      this->AddEnd(x, 1, wasNorth ? 1.0 : -1.0);
    }
  }

  void AddEnd(const Vector3& x, int level, double sign)
  {
    const double longitude = std::atan2(x[1], x[0]);
    const double z = this->Level[level];
    const double r = this->Radius[level];
    this->Sum.Measure += sign * longitude * (this->IsNorthern ? 1.0 - z : -1.0 - z);
    this->Sum.First = this->Sum.First +
      (0.5 * sign * r) *
        Vector3{ { -z * std::sin(longitude), z * std::cos(longitude), r * longitude } };
  }

  bool IsNorthern;
  bool HasLevel[2];
  double Level[2];
  double Radius[2];
  bool IsFirst = true;
  int StateAtFirst = 0;
  int State = 0;
  Moments Sum;
};

namespace detail
{

inline Vector3 RotatedAboutAxis(const Vector3& x, double cosine, double sine)
{
  return { { cosine * x[0] - sine * x[1], sine * x[0] + cosine * x[1], x[2] } };
}

}

/// What of a convex polygon of great circles is between the meridians of a cell, in its own frame.
inline ClipResult ClipToMeridians(const SphericalFrame& frame, const PolygonView& polygon,
  const LonLatCell& cell, ConvexPolygon& part)
{
  part.Size = 0;
  for (int i = 0; i < polygon.Size; ++i)
  {
    const Vector3 projected = frame.Projected(polygon.Corners[i]);
    part.Add({ { projected[0] / projected[2], projected[1] / projected[2] } });
  }
  const auto keep = [&](double sine, double cosine)
  {
    const Vector3 normal{ { -sine, cosine, 0.0 } };
    return Clip(part,
      { Dot(normal, frame.E1), Dot(normal, frame.E2), Dot(normal, frame.Origin), ClipTolerance });
  };
  const ClipResult west = keep(std::sin(cell.West), std::cos(cell.West));
  return west == ClipResult::Nothing ? west : keep(-std::sin(cell.East), -std::cos(cell.East));
}

/// Area and first moment, about the polygon's point `origin`, of what a convex polygon of great
/// circles and a cell have in common.
inline Moments FindOverlap(
  const Vector3& origin, const PolygonView& polygon, const LonLatCell& cell)
{
  const SphericalFrame frame(origin);
  ConvexPolygon part;
  if (ClipToMeridians(frame, polygon, cell, part) == ClipResult::Nothing)
  {
    return {};
  }
  const double cosine = std::cos(cell.MiddleLongitude());
  const double sine = std::sin(cell.MiddleLongitude());
  std::array<Vector3, ConvexPolygon::Most> corners;
  for (int i = 0; i < part.Size; ++i)
  {
    corners[i] = detail::RotatedAboutAxis(frame.FromFrame(part.Corners[i]), cosine, -sine);
  }
  Moments moments = BetweenParallels(cell.South, cell.North).Measure(corners.data(), part.Size);
  moments.First = detail::RotatedAboutAxis(moments.First, cosine, sine);
  return moments.Moved(origin);
}

}

#endif
