// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where in its cube a trilinear map is zero.
#ifndef skd_Geometry_TrilinearRoot_h
#define skd_Geometry_TrilinearRoot_h

#include "TrilinearMap.h"

#include <optional>

namespace skd
{

/// A root near to `start` to within `tolerance`, by Newton's steps, shortened until they lead down.
/// It may lie outside of the cube. Digits beyond the tolerance are taken where they come for free.
inline std::optional<Vector3> NewtonRoot(const TrilinearMap& map, Vector3 start, double tolerance)
{
  Vector3 value = map.At(start);
  double size = MaxNorm(value);
  for (int iteration = 0; iteration < 24 && size > 0.125 * tolerance; ++iteration)
  {
    Vector3 step = map.Jacobian(start).Solve(value);
    Vector3 next = start - step;
    Vector3 nextValue = map.At(next);
    for (int halving = 0; halving < 4 && size > tolerance && !(MaxNorm(nextValue) < size);
         ++halving)
    {
      step = 0.5 * step;
      next = start - step;
      nextValue = map.At(next);
    }
    if (!(MaxNorm(nextValue) < size && MaxNorm(next) < 8.0))
    {
      break;
    }
    start = next;
    value = nextValue;
    size = MaxNorm(value);
  }
  return size <= tolerance ? std::optional<Vector3>(start) : std::nullopt;
}

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
    const TrilinearMap part = map.Part(box.Centre, box.Half);
    const Vector3* c = part.Term;
    this->IsZero = MaxNorm(c[0]) <= rounding;
    this->IsEmpty = part.IsApartFromZero(rounding);
    if (this->IsEmpty)
    {
      return;
    }
    const Vector3 rows[3] = { Cross(c[2], c[4]), Cross(c[4], c[1]), Cross(c[1], c[2]) };
    const double sizes[3] = { MaxNorm(c[1]), MaxNorm(c[2]), MaxNorm(c[4]) };
    const double volume = Dot(c[1], rows[0]);
    double widest = 0.0;
    double shrunk = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3& row = rows[axis];
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

/// The axis along which the image of the box is longest, of those along which it bends; -1 when the
/// map is linear in the box.
inline int AxisToSplit(const TrilinearMap& map, const ParameterBox& box)
{
  const TrilinearMap part = map.Part(box.Centre, box.Half);
  int longest = -1;
  double length = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = (1 << axis) | (1 << (axis + 1) % 3);
    const int second = (1 << axis) | (1 << (axis + 2) % 3);
    const double bend =
      MaxNorm(part.Term[first]) + MaxNorm(part.Term[second]) + MaxNorm(part.Term[7]);
    const double lengthAlong = bend + MaxNorm(part.Term[1 << axis]);
    if (bend > 0.0 && lengthAlong > length)
    {
      longest = axis;
      length = lengthAlong;
    }
  }
  return longest;
}

/// The search of the whole cube for a root, by halving boxes and cutting off what holds none.
/// `isWanted(u)` tells whether a root there will do, `mayHold(box)` whether a box is of interest.
/// It gives up only on maps that are nearly singular wherever they are nearly zero.
template <class IsWanted, class MayHold>
std::optional<Vector3> SearchRoot(
  const TrilinearMap& map, double tolerance, IsWanted&& isWanted, MayHold&& mayHold)
{
  constexpr int limit = 160;
  ParameterBox stack[limit + 1];
  stack[0] = { { { 0.0, 0.0, 0.0 } }, { { 1.0, 1.0, 1.0 } } };
  int size = 1;
  for (int budget = 2000; size > 0 && size < limit && budget > 0; --budget)
  {
    const ParameterBox box = stack[--size];
    PrunedBox pruned(map, box, tolerance);
    if (pruned.IsEmpty || !mayHold(pruned.Rest))
    {
      continue;
    }
    if (pruned.IsZero && isWanted(box.Centre))
    {
      return box.Centre;
    }
    if (pruned.IsTight)
    {
      const std::optional<Vector3> root = NewtonRoot(map, pruned.Rest.Centre, tolerance);
      if (root && isWanted(*root))
      {
        return root;
      }
      if (root && box.Surrounds(*root))
      {
        continue;
      }
    }
    const int axis = pruned.Shrunk < 0.6 ? -1 : AxisToSplit(map, pruned.Rest);
    if (axis >= 0)
    {
      stack[size++] = pruned.Rest.SplitOffUpper(axis);
    }
    if (MaxNorm(pruned.Rest.Half) > 1e-14)
    {
      stack[size++] = pruned.Rest;
    }
  }
  return std::nullopt;
}

}

#endif
