// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRoundedPlane_h
#define SkdRoundedPlane_h

#include "Solids/Surfaces/SkdPlacement.h"

#include <array>

namespace skdtree
{
/// The least height of a triangle.
double SkdWidthOf(const std::array<skd::Vector3, 3>& corners);

/// The plane of a triangle, to within what rounding does to it: that grows with the distance from
/// the triangle.
class SkdRoundedPlane
{
public:
  /// `tolerance` is of points.
  SkdRoundedPlane(const std::array<skd::Vector3, 3>& corners, double tolerance);

  bool Contains(const skd::Vector3& x) const;
  bool Contains(const std::array<skd::Vector3, 3>& corners) const;

private:
  skd::Vector3 Origin;
  skd::Vector3 Normal;
  double Area;
  double Width;
  double Tolerance;
};

/// How far rounding may take points from where they are to be, on a triangle with these corners: 64
/// units in the last place of its largest coordinate, so that much smaller triangles elsewhere are
/// told apart by what they need.
double SkdToleranceOf(const std::array<skd::Vector3, 3>& corners);
}

#endif
