// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where in its cube a trilinear map is zero.
#ifndef skd_Geometry_Cells_TrilinearRoot_h
#define skd_Geometry_Cells_TrilinearRoot_h

#include "../Tolerances.h"
#include "PrunedBox.h"

#include <optional>

namespace skd
{

/// A root near to `start` to within `tolerance`, by Newton's steps, shortened until they lead down.
/// It may lie outside of the cube. Digits beyond the tolerance are taken where they come for free.
inline std::optional<Vector3> NewtonRoot(const TrilinearMap& map, Vector3 start, double tolerance)
{
  PaddedVector value = map.At(start);
  double size = MaxNorm(value);
  for (int iteration = 0; iteration < 24 && size > 0.125 * tolerance; ++iteration)
  {
    Vector3 step = map.Jacobian(start).Solve(value);
    Vector3 next = start - step;
    PaddedVector nextValue = map.At(next);
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

/// The axis along which the image of the box is longest, of those along which it bends; -1 when the
/// map is linear in the box.
inline int AxisToSplit(const TrilinearMap& map, const ParameterBox& box)
{
  const TrilinearMap part = map.Restricted(box.Centre, box.Half);
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
/// `isWanted(u)` returns whether a root there is accepted, `mayHold(box)` whether a box may have
/// one. It gives up only on maps that are nearly singular wherever they are nearly zero.
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
    const std::optional<Vector3> root =
      pruned.IsTight ? NewtonRoot(map, pruned.Rest.Centre, tolerance) : std::nullopt;
    if (root && isWanted(*root))
    {
      return root;
    }
    if (root && box.Surrounds(*root))
    {
      continue; // the only one in this box, and not wanted
    }
    const int axis = pruned.Shrunk < 0.6 ? -1 : AxisToSplit(map, pruned.Rest);
    if (axis >= 0)
    {
      stack[size++] = pruned.Rest.SplitOffUpper(axis);
    }
    if (MaxNorm(pruned.Rest.Half) > tolerances::LeastBox)
    {
      stack[size++] = pruned.Rest;
    }
  }
  return std::nullopt;
}

}

#endif
