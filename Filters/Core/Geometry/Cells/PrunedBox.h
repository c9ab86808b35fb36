// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_PrunedBox_h
#define skd_Geometry_Cells_PrunedBox_h

#include "TrilinearMap.h"

namespace skd
{

/// A box in the cube of a trilinear map.
struct ParameterBox
{
  Vector3 Centre;
  Vector3 Half;

  /// The corner with the least coordinates.
  Vector3 Lowest() const { return this->Centre - this->Half; }

  /// Whether u is in the box, or so near outside that a tight box (see below) has no other root.
  bool Surrounds(const Vector3& u) const
  {
    bool isNear = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isNear = isNear && std::abs(u[axis] - this->Centre[axis]) <= 1.1 * this->Half[axis];
    }
    return isNear;
  }

  /// Shortens this to the lower half along an axis, and returns the upper.
  ParameterBox SplitOffUpper(int axis)
  {
    this->Half[axis] *= 0.5;
    ParameterBox upper(*this);
    upper.Centre[axis] += this->Half[axis];
    this->Centre[axis] -= this->Half[axis];
    return upper;
  }
};

/// What is left of a box when the map cannot be zero in the rest of it.
///
/// Multiplied by the inverse of its matrix at the centre the map is v + n + (products of v), with v
/// in [-1, 1]^3. The products are bounded by their coefficients, so a root v lies within them of
/// -n.
struct PrunedBox
{
  bool IsEmpty = false;
  bool IsZero = false;  ///< the map is zero at the centre of the box
  bool IsTight = false; ///< the products are small: the map is one to one, slightly beyond, too
  ParameterBox Rest;
  double Shrunk = 1.0; ///< the longest side of the rest relative to that of the box

  PrunedBox(const TrilinearMap& map, const ParameterBox& box, double rounding)
    : Rest(box)
  {
    const TrilinearMap part = map.Restricted(box.Centre, box.Half);
    const PaddedVector* c = part.Term;
    this->IsZero = MaxNorm(c[0]) <= rounding;
    this->IsEmpty = part.IsApartFromZero(rounding);
    if (this->IsEmpty)
    {
      return;
    }
    const PaddedVector rows[3] = { Cross(c[2], c[4]), Cross(c[4], c[1]), Cross(c[1], c[2]) };
    const double sizes[3] = { MaxNorm(c[1]), MaxNorm(c[2]), MaxNorm(c[4]) };
    const double volume = Dot(c[1], rows[0]);
    double widest = 0.0;
    double shrunk = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const PaddedVector& row = rows[axis];
      const double products = std::abs(Dot(row, c[3])) + std::abs(Dot(row, c[5])) +
        std::abs(Dot(row, c[6])) + std::abs(Dot(row, c[7]));
      // Not less where the row is small by cancellation: it is not known better than this.
      const double slack = 6.0 * rounding * sizes[(axis + 1) % 3] * sizes[(axis + 2) % 3];
      const double spread = (products + slack) / std::abs(volume);
      const double middle = -Dot(row, c[0]) / volume;
      widest = std::max(widest, products / std::abs(volume));
      shrunk = std::max(shrunk, this->Cut(axis, middle - spread, middle + spread));
    }
    this->IsTight = widest < 0.25;
    this->Shrunk = shrunk;
  }

private:
  /// Cuts the box to [min, max] of [-1, 1]; comparisons with NaN leave it as it is.
  double Cut(int axis, double min, double max)
  {
    this->IsEmpty = this->IsEmpty || min > 1.0 || max < -1.0;
    min = min > -1.0 ? min : -1.0;
    max = max < 1.0 ? max : 1.0;
    this->Rest.Centre[axis] += 0.5 * (min + max) * this->Rest.Half[axis];
    this->Rest.Half[axis] *= 0.5 * (max - min);
    return 0.5 * (max - min);
  }
};

}

#endif
