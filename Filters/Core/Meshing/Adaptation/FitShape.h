// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Adaptation_FitShape_h
#define skd_Adaptation_FitShape_h

#include "SurfaceShape.h"

#include <array>

namespace skd
{

namespace detail
{

template <class Measure>
std::size_t Farthest(const std::vector<Vector3>& points, const Measure& measure)
{
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double value = measure(points[i]);
    if (value > most)
    {
      most = value;
      best = i;
    }
  }
  return best;
}

/// Whether a measure of points is nowhere more than a limit.
template <class Measure>
bool IsWithin(const std::vector<Vector3>& points, const Measure& measure, double limit)
{
  return measure(points[Farthest(points, measure)]) <= limit;
}

/// Solves four equations in four unknowns by Gauss's and Jordan's elimination with row pivots; a
/// row is the four coefficients and the right side, of order 1. False of a matrix that has no
/// inverse but for rounding.
inline bool SolveFour(std::array<std::array<double, 5>, 4>& rows, std::array<double, 4>& x)
{
  constexpr double rounding = 1e-13; // what is left of a pivot that is 0, some hundred roundings
  for (int column = 0; column < 4; ++column)
  {
    int pivot = column;
    for (int row = column + 1; row < 4; ++row)
    {
      pivot = std::abs(rows[row][column]) > std::abs(rows[pivot][column]) ? row : pivot;
    }
    std::swap(rows[column], rows[pivot]);
    if (!(std::abs(rows[column][column]) > rounding))
    {
      return false;
    }
    for (int row = 0; row < 4; ++row)
    {
      const double factor = row == column ? 0.0 : rows[row][column] / rows[column][column];
      for (int k = column; k < 5; ++k)
      {
        rows[row][k] -= factor * rows[column][k];
      }
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    x[i] = rows[i][4] / rows[i][i];
  }
  return true;
}

}

/// The plane that all points are on, to `tolerance` of how far they are apart; false if there is
/// none, or more than one. A plane across an axis is found exactly.
///
/// It is that of a wide triangle: any point a; b, the farthest from it, so that no two points are
/// more than 2 |b - a| apart; and c, the farthest from the line through both.
inline bool FitPlane(const std::vector<Vector3>& points, double tolerance, SurfaceShape& shape)
{
  if (points.size() < 3)
  {
    return false;
  }
  const Vector3 a = points[0];
  const Vector3 b = points[detail::Farthest(points, [&](const Vector3& x) { return Norm(x - a); })];
  const auto cross = [&](const Vector3& x) { return Norm(Cross(b - a, x - a)); };
  const Vector3 c = points[detail::Farthest(points, cross)];
  const double diameter = Norm(b - a);
  Vector3 normal = Cross(b - a, c - a);
  if (!(Norm(normal) > tolerance * diameter * diameter))
  {
    return false;
  }
  normal = (1.0 / Norm(normal)) * normal;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (a[axis] == b[axis] && a[axis] == c[axis])
    {
      normal = { { 0.0, 0.0, 0.0 } };
      normal[axis] = 1.0;
    }
  }
  const auto off = [&](const Vector3& x) { return std::abs(Dot(normal, x - a)); };
  if (!detail::IsWithin(points, off, tolerance * diameter))
  {
    return false;
  }
  shape.What = SurfaceShape::Kind::Plane;
  shape.Centre = a;
  shape.Normal = normal;
  return true;
}

/// The sphere that all points are on, to `tolerance` of its radius, by least squares; false if
/// there is none. One about the origin is found exactly about the origin.
///
/// |y - c|^2 = r^2 is 2 c . y + (r^2 - c^2) = y^2, which is linear in c and in d = r^2 - c^2
/// (I. Kasa, IEEE Trans. Instrum. Meas. 25 (1976) 8-14): the normal equations of the rows
/// (2 y, 1 | y^2) are four, and r^2 = d + c^2. With y about the mean of the points and in units of
/// the farthest one's distance all coefficients are of order 1.
inline bool FitSphere(const std::vector<Vector3>& points, double tolerance, SurfaceShape& shape)
{
  if (points.size() < 4)
  {
    return false;
  }
  Vector3 mean{ { 0.0, 0.0, 0.0 } };
  for (const Vector3& x : points)
  {
    mean = mean + (1.0 / static_cast<double>(points.size())) * x;
  }
  const auto away = [&](const Vector3& x) { return Norm(x - mean); };
  const double scale = away(points[detail::Farthest(points, away)]);
  std::array<std::array<double, 5>, 4> rows{};
  for (const Vector3& x : points)
  {
    const Vector3 y = (1.0 / scale) * (x - mean);
    const double row[5] = { 2.0 * y[0], 2.0 * y[1], 2.0 * y[2], 1.0, Norm2(y) };
    for (int i = 0; i < 4; ++i)
    {
      for (int k = 0; k < 5; ++k)
      {
        rows[i][k] += row[i] * row[k] / static_cast<double>(points.size());
      }
    }
  }
  std::array<double, 4> x{};
  if (!detail::SolveFour(rows, x))
  {
    return false;
  }
  Vector3 centre = mean + scale * Vector3{ { x[0], x[1], x[2] } };
  const double radius =
    scale * std::sqrt(std::max(x[3] + x[0] * x[0] + x[1] * x[1] + x[2] * x[2], 0.0));
  if (Norm(centre) <= tolerance * radius)
  {
    centre = { { 0.0, 0.0, 0.0 } };
  }
  const auto off = [&](const Vector3& p) { return std::abs(Norm(p - centre) - radius); };
  if (!detail::IsWithin(points, off, tolerance * radius))
  {
    return false;
  }
  shape.What = SurfaceShape::Kind::Sphere;
  shape.Centre = centre;
  shape.Radius = radius;
  return true;
}

}

#endif
