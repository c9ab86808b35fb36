// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells of the unit sphere between two meridians and two parallels.
#ifndef skd_Geometry_Overlap_LonLatCell_h
#define skd_Geometry_Overlap_LonLatCell_h

#include "../Box.h"
#include "Moments.h"

#include <cmath>
#include <limits>
#include <optional>

namespace skd
{

/// Longitudes and latitudes in radians. At most a third of a turn wide; a parallel at a pole is
/// that point.
struct LonLatCell
{
  double West;
  double East;
  double South;
  double North;

  double Width() const { return this->East - this->West; }
  double MiddleLongitude() const { return 0.5 * (this->West + this->East); }

  Vector3 At(double longitude, double latitude) const
  {
    const double r = std::cos(latitude);
    return { { r * std::cos(longitude), r * std::sin(longitude), std::sin(latitude) } };
  }
  Vector3 Centre() const
  {
    return this->At(this->MiddleLongitude(), 0.5 * (this->South + this->North));
  }

  /// Of all of the cell.
  Box3 Bounds() const
  {
    Box3 bounds;
    const auto addParallel = [&](double latitude)
    {
      bounds.Add(this->At(this->West, latitude));
      bounds.Add(this->At(this->East, latitude));
      constexpr double quarter = 1.57079632679489661923;
      for (double at = quarter * std::ceil(this->West / quarter); at <= this->East; at += quarter)
      {
        bounds.Add(this->At(at, latitude));
      }
    };
    addParallel(this->South);
    addParallel(this->North);
    if (this->South < 0.0 && this->North > 0.0)
    {
      addParallel(0.0);
    }
    return bounds;
  }
};

namespace detail
{

/// x - sin(x) to rounding, also of small x.
inline double LessItsSine(double x)
{
  const double x2 = x * x;
  return x2 < 0.1 ? x * x2 / 6.0 *
      (1.0 -
        x2 / 20.0 * (1.0 - x2 / 42.0 * (1.0 - x2 / 72.0 * (1.0 - x2 / 110.0 * (1.0 - x2 / 156.0)))))
                  : x - std::sin(x);
}

}

/// Area, and the integral of x - reference; in closed form.
inline Moments MomentsOf(const LonLatCell& cell, const Vector3& reference)
{
  const double width = cell.Width();
  const double height = cell.North - cell.South;
  const double middle = 0.5 * (cell.North + cell.South);
  const double area = width * 2.0 * std::cos(middle) * std::sin(0.5 * height);
  const double cosine = std::cos(middle);
  const double along = (detail::LessItsSine(height) + 2.0 * std::sin(height) * cosine * cosine) *
    std::sin(0.5 * width);
  const double up = 0.5 * std::sin(height) * std::sin(2.0 * middle) * width;
  const Vector3 first{ { along * std::cos(cell.MiddleLongitude()),
    along * std::sin(cell.MiddleLongitude()), up } };
  return { area, first - area * reference };
}

/// What two cells have in common: again one, or nothing.
inline std::optional<LonLatCell> CommonCell(const LonLatCell& one, LonLatCell other)
{
  constexpr double fullCircle = 6.28318530717958647692;
  const double circles =
    fullCircle * std::round((one.MiddleLongitude() - other.MiddleLongitude()) / fullCircle);
  other.West += circles;
  other.East += circles;
  const LonLatCell common{ std::max(one.West, other.West), std::min(one.East, other.East),
    std::max(one.South, other.South), std::min(one.North, other.North) };
  constexpr double least = 8.0 * std::numeric_limits<double>::epsilon();
  return common.Width() > least * fullCircle && common.North - common.South > least
    ? std::make_optional(common)
    : std::nullopt;
}

}

#endif
