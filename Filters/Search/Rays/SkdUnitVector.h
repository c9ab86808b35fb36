// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdUnitVector_h
#define SkdUnitVector_h

#include "Core/Geometry/Vector.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
/// A vector divided by its length, whatever its magnitude; 0 if it is 0 or not finite.
inline skd::Vector3 SkdUnit(const skd::Vector3& vector)
{
  const double largest =
    std::max({ std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2]) });
  if (!(largest > 0.0) || !skd::IsFinite(vector))
  {
    return { { 0.0, 0.0, 0.0 } };
  }
  // Divided by the largest first, so that no square overflows or vanishes.
  const skd::Vector3 scaled{ { vector[0] / largest, vector[1] / largest, vector[2] / largest } };
  return (1.0 / skd::Norm(scaled)) * scaled;
}
}

#endif
