// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRemapTolerances.h
 * @brief The tolerances of remapping, and what they are relative to.
 */

#ifndef SkdRemapTolerances_h
#define SkdRemapTolerances_h

namespace remap_tolerances
{
/// Rounding of longitude-latitude boxes on the unit sphere, absolute.
constexpr double LonLatBox = 1e-15;

/// How far points may be from the plane of both meshes, relative to the diagonal.
constexpr double OutOfPlane = 1e-6;

/// A mean radius that differs less from 1 is 1.
constexpr double UnitRadius = 1e-6;

/// The sine of a reflex angle that counts as straight.
constexpr double StraightAngle = 1e-13;

/// A polygon whose mean corner is nearer to the sphere's centre covers about half of the sphere;
/// relative to the radius.
constexpr double Hemisphere = 1e-3;
}

#endif
