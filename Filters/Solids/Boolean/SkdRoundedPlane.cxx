// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdRoundedPlane.h"

#include "Solids/Surfaces/SkdSplitPoints.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
double SkdWidthOf(const std::array<skd::Vector3, 3>& corners)
{
  const skd::Vector3 first = corners[1] - corners[0];
  const skd::Vector3 last = corners[2] - corners[0];
  const skd::Vector3 other = corners[2] - corners[1];
  const skd::Vector3 area = Cross(first, last);
  const double side = std::max({ Dot(first, first), Dot(last, last), Dot(other, other) });
  return side > 0.0 ? std::sqrt(Dot(area, area) / side) : 0.0;
}

SkdRoundedPlane::SkdRoundedPlane(const std::array<skd::Vector3, 3>& corners, double tolerance)
  : Origin(corners[0])
  , Normal(Cross(corners[1] - corners[0], corners[2] - corners[0]))
  , Area(Norm(this->Normal))
  , Width(SkdWidthOf(corners))
  , Tolerance(tolerance)
{
}

bool SkdRoundedPlane::Contains(const skd::Vector3& x) const
{
  const skd::Vector3 to = x - this->Origin;
  const double error = this->Tolerance * (1.0 + Norm(to) / this->Width);
  return std::abs(Dot(this->Normal, to)) <= error * this->Area;
}

bool SkdRoundedPlane::Contains(const std::array<skd::Vector3, 3>& corners) const
{
  return std::all_of(corners.begin(), corners.end(),
    [this](const skd::Vector3& corner) { return this->Contains(corner); });
}

double SkdToleranceOf(const std::array<skd::Vector3, 3>& corners)
{
  double largest = 0.0;
  for (const skd::Vector3& x : corners)
  {
    largest = std::max({ largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  }
  return 4.0 * SkdSplitPoints::ErrorOf(largest);
}
}
