// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_PointArray_h
#define skd_Geometry_PointArray_h

#include "Vector.h"

#include <cstddef>

namespace skd
{

/// A view of points one after the other, in single or in double precision.
struct PointArray
{
  const float* Floats = nullptr; ///< one of the two
  const double* Doubles = nullptr;

  Vector3 At(std::size_t point) const
  {
    const std::size_t at = 3 * point;
    return this->Floats
      ? Vector3{ { this->Floats[at], this->Floats[at + 1], this->Floats[at + 2] } }
      : Vector3{ { this->Doubles[at], this->Doubles[at + 1], this->Doubles[at + 2] } };
  }
};

}

#endif
