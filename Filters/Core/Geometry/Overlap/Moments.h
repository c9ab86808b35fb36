// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_Moments_h
#define skd_Geometry_Overlap_Moments_h

#include "../Vector.h"

namespace skd
{

/// How large a piece is, and the integral of x - (a reference point) over it.
struct Moments
{
  double Measure = 0.0; ///< length, area or volume
  Vector3 First{ { 0.0, 0.0, 0.0 } };

  /// The same about a reference point that is `shift` farther.
  Moments Moved(const Vector3& shift) const
  {
    return { this->Measure, this->First - this->Measure * shift };
  }

  void Add(const Moments& other, double sign)
  {
    this->Measure += sign * other.Measure;
    this->First = this->First + sign * other.First;
  }
};

}

#endif
