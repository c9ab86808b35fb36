// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What closest points and inverse maps are compared with: the same computed in long
/// double, by dense sampling and local descent, with no thought for speed.
#ifndef coretest_GeometryReference_h
#define coretest_GeometryReference_h

#include "Core/Geometry/Cells/ClosestPointInCell.h"
#include "Dice.h"

#include <vector>

namespace coretest
{

using Real = long double;

/// The distance of x from the patch's point (r, s).
inline Real PatchDistance(const skd::Vector3* p, const skd::Vector3& x, Real r, Real s)
{
  const Real weights[4] = { (1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s };
  Real sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    Real difference = 0;
    for (int i = 0; i < 4; ++i)
    {
      difference += weights[i] * (static_cast<Real>(p[i][axis]) - x[axis]);
    }
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

/// Descent on a patch from (r, s) by steps that are halved when none of eight directions helps.
inline Real DescendOnPatch(const skd::Vector3* p, const skd::Vector3& x, Real r, Real s, Real step)
{
  const auto clamped = [](Real t) { return std::min(Real(1), std::max(Real(0), t)); };
  Real best = PatchDistance(p, x, r, s);
  for (int guard = 0; step > 1e-18L && guard < 2000; ++guard)
  {
    bool isBetter = false;
    for (int direction = 0; direction < 9; ++direction)
    {
      const Real nextR = clamped(r + step * (direction % 3 - 1));
      const Real nextS = clamped(s + step * (direction / 3 - 1));
      const Real distance = PatchDistance(p, x, nextR, nextS);
      if (distance < best * (1 - 1e-18L))
      {
        best = distance;
        r = nextR;
        s = nextS;
        isBetter = true;
      }
    }
    step = isBetter ? step * 1.5L : step * 0.5L;
  }
  return best;
}

/// The distance of x from a patch: from all places of a lattice that no neighbour is better than.
inline double PatchDistance(const skd::Vector3* p, const skd::Vector3& x)
{
  constexpr int n = 20;
  std::vector<Real> lattice((n + 1) * (n + 1));
  const auto at = [&](int i, int j) -> Real& { return lattice[i * (n + 1) + j]; };
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      at(i, j) = PatchDistance(p, x, Real(i) / n, Real(j) / n);
    }
  }
  Real best = at(0, 0);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const bool isLeast = (i == 0 || at(i, j) <= at(i - 1, j)) &&
        (i == n || at(i, j) <= at(i + 1, j)) && (j == 0 || at(i, j) <= at(i, j - 1)) &&
        (j == n || at(i, j) <= at(i, j + 1));
      if (isLeast)
      {
        best = std::min(best, DescendOnPatch(p, x, Real(i) / n, Real(j) / n, 0.5L / n));
      }
    }
  }
  return static_cast<double>(best);
}

/// The distance of x from a triangle: a patch whose last two points are one.
inline double TriangleDistance(const skd::Vector3* p, const skd::Vector3& x)
{
  const skd::Vector3 patch[4] = { p[0], p[1], p[2], p[2] };
  return PatchDistance(patch, x);
}

/// The distance of x from the faces of a cell.
template <class Shape>
double FacesDistance(const skd::Vector3* points, const skd::Vector3& x)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& face : Shape::Faces)
  {
    const skd::Vector3 patch[4] = { points[face[0]], points[face[1]], points[face[2]],
      points[face[face[3] < 0 ? 2 : 3]] };
    nearest = std::min(nearest, PatchDistance(patch, x));
  }
  return nearest;
}

/// Whether one of many Newton iterations, started all over the cell, ends at x inside of it.
template <class Shape>
bool IsInsideByNewton(const skd::Vector3* points, const skd::Vector3& x)
{
  constexpr int n = 5;
  for (int start = 0; start < n * n * n; ++start)
  {
    skd::Vector3 p{ { (start % n + 0.5) / n, (start / n % n + 0.5) / n,
      (start / n / n + 0.5) / n } };
    for (int iteration = 0; iteration < 40 && skd::MaxNorm(p) < 100.0; ++iteration)
    {
      double derivatives[3 * Shape::Size];
      Shape::Derivatives(p, derivatives);
      skd::Matrix3 jacobian{};
      for (int i = 0; i < 3 * Shape::Size; ++i)
      {
        skd::Vector3& column = jacobian.Columns[i / Shape::Size];
        column = column + derivatives[i] * (points[i % Shape::Size] - x);
      }
      p = p - jacobian.Solve(skd::Evaluate<Shape>(points, p, x));
    }
    if (Shape::InDomain(p) && skd::Norm(skd::Evaluate<Shape>(points, p, x)) < 1e-13)
    {
      return true;
    }
  }
  return false;
}

/// A random place in a shape's domain; one in four is on its border.
template <class Shape>
skd::Vector3 MoveIntoDomain(Dice& dice)
{
  skd::Vector3 p{ { dice.Between(0.0, 1.0), dice.Between(0.0, 1.0), dice.Between(0.0, 1.0) } };
  if (dice.Below(4) == 0)
  {
    p[dice.Below(3)] = dice.Below(2);
  }
  return Shape::ClampToDomain(p);
}

/// A cell spanned by three edges, its points moved at random by up to `warp`.
template <class Shape>
std::vector<skd::Vector3> CellFromEdges(
  Dice& dice, const skd::Vector3& origin, const skd::Vector3 (&edges)[3], double warp)
{
  std::vector<skd::Vector3> points;
  for (const auto& corner : Shape::Corners)
  {
    points.push_back(origin + corner[0] * edges[0] + corner[1] * edges[1] + corner[2] * edges[2] +
      dice.Point(warp));
  }
  return points;
}

/// A sheared cell, half of them inverted.
template <class Shape>
std::vector<skd::Vector3> RandomCell(Dice& dice, double warp)
{
  const skd::Vector3 origin = dice.Point(1.0);
  const skd::Vector3 edges[3] = { dice.Point(1.0), dice.Point(1.0), dice.Point(1.0) };
  return CellFromEdges<Shape>(dice, origin, edges, warp);
}

/// A cell of about unit size, near to a cube.
template <class Shape>
std::vector<skd::Vector3> PlainCell(Dice& dice, const skd::Vector3& origin, double warp)
{
  const skd::Vector3 edges[3] = { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } };
  return CellFromEdges<Shape>(dice, origin, edges, warp);
}

}

#endif
