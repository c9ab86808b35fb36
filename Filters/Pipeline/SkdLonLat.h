// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdLonLat.h
 * @brief Longitudes and latitudes, in degrees, and positions on a sphere about the origin.
 */

#ifndef SkdLonLat_h
#define SkdLonLat_h

#include "Core/Geometry/Vector.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
/// A longitude and a latitude (the third number does not count) as a direction of length 1. A pole
/// is one point, whatever the longitude.
inline skd::Vector3 SkdDirectionOfLonLat(const skd::Vector3& lonLat)
{
  const double longitude = vtkMath::RadiansFromDegrees(lonLat[0]);
  const double latitude = vtkMath::RadiansFromDegrees(lonLat[1]);
  const double across = std::abs(lonLat[1]) == 90.0 ? 0.0 : std::cos(latitude);
  return { { across * std::cos(longitude), across * std::sin(longitude), std::sin(latitude) } };
}

/// The longitude, from 0 to 360, and the latitude of a direction; its length.
inline skd::Vector3 SkdLonLatOf(const skd::Vector3& x)
{
  const double longitude = vtkMath::DegreesFromRadians(std::atan2(x[1], x[0]));
  const double latitude = vtkMath::DegreesFromRadians(std::atan2(x[2], std::hypot(x[0], x[1])));
  return { { longitude < 0.0 ? longitude + 360.0 : longitude, latitude, skd::Norm(x) } };
}

/// Along the parallel and the meridian, of length 1. A pole's are those of longitude 0.
struct SkdLonLatAxes
{
  skd::Vector3 East;
  skd::Vector3 North;
};

inline SkdLonLatAxes SkdLonLatAxesAt(const skd::Vector3& x)
{
  const double across = std::hypot(x[0], x[1]);
  const double cosine = across > 0.0 ? x[0] / across : 1.0;
  const double sine = across > 0.0 ? x[1] / across : 0.0;
  const skd::Vector3 east{ { -sine, cosine, 0.0 } };
  return { east, Cross((1.0 / Norm(x)) * x, east) };
}

/// The weight of samples at the poles: as good as nothing, but not nothing.
constexpr double SkdWeightOfPoles = 1e-12;

/// What a sample of a grid of longitudes and latitudes weighs. Poles count for as good as nothing,
/// but not nothing; what has no direction, as one.
inline double SkdCosineOfLatitude(const skd::Vector3& x)
{
  const double cosine = std::hypot(x[0], x[1]) / skd::Norm(x);
  return std::isfinite(cosine) ? std::max(cosine, SkdWeightOfPoles) : 1.0;
}
}

#endif
