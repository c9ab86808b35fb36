// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRemapTolerances_h
#define SkdRemapTolerances_h

/// The tolerances of remapping, and what they are relative to.
namespace remap_tolerances
{
constexpr double LonLatBox = 1e-15;     ///< absolute, on the unit sphere: rounding of boxes
constexpr double OutOfPlane = 1e-6;     ///< of the diagonal: distances of points from the plane
constexpr double UnitRadius = 1e-6;     ///< absolute: a mean radius as near to 1 is 1
constexpr double StraightAngle = 1e-13; ///< the sine of a reflex angle that counts as straight
constexpr double Hemisphere = 1e-3;     ///< of the radius: the mean corner of half a sphere
}

#endif
