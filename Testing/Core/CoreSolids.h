// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Polygons and polyhedra that tests of their geometry share: convex, concave, scaled, turned.
#ifndef coretest_CoreSolids_h
#define coretest_CoreSolids_h

#include "CoreScenes.h"

#include "Core/Geometry/Cells/PolyhedronView.h"
#include "Core/Geometry/Distance/Distance.h"

#include <numeric>

namespace coretest
{

using skd::Vector3;
using Polygon = std::vector<Vector3>;

/// The factors that geometry without an absolute length is tried at.
inline const std::vector<double>& Factors()
{
  static const std::vector<double> factors{ 1.0, std::ldexp(1.0, -100), std::ldexp(1.0, 100) };
  return factors;
}

inline Vector3 Rotated(const Vector3& p)
{
  return { { 0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2], -0.8 * p[0] + 0.6 * p[1],
    0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2] } };
}

/// The outline of a U: the square of side 3 without the notch above (1, 1) to (2, 3).
inline Polygon Notched()
{
  return { { { 0, 0, 0 } }, { { 3, 0, 0 } }, { { 3, 3, 0 } }, { { 2, 3, 0 } }, { { 2, 1, 0 } },
    { { 1, 1, 0 } }, { { 1, 3, 0 } }, { { 0, 3, 0 } } };
}

inline Polygon RotatedNotched(double factor)
{
  Polygon polygon = Notched();
  for (Vector3& p : polygon)
  {
    p = factor * Rotated(p);
  }
  return polygon;
}

/// What the U consists of, `height` high.
inline Boxes<3> PartsOfNotched(double height)
{
  return { { { { 0, 0, 0 } }, { { 3, 1, height } } }, { { { 0, 1, 0 } }, { { 1, 3, height } } },
    { { { 2, 1, 0 } }, { { 3, 3, height } } } };
}

inline Polygon Regular(int corners)
{
  Polygon polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / corners;
    polygon.push_back({ { std::cos(angle), std::sin(angle), 0.0 } });
  }
  return polygon;
}

inline double LeastDistance2(const Boxes<3>& boxes, const Vector3& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (const skd::Box3& box : boxes)
  {
    least = std::min(least, skd::MinDistance2(x, box));
  }
  return least;
}

/// The point that weights make of points.
inline Vector3 Mean(const std::vector<double>& weights, const Polygon& points)
{
  Vector3 mean{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mean = mean + weights[i] * points[i];
  }
  return mean;
}

/// Points and the stream of faces.
struct Solid
{
  Polygon Points;
  std::vector<std::uint32_t> Faces;

  skd::PolyhedronView View() const
  {
    return { this->Points.data(), static_cast<int>(this->Points.size()), this->Faces.data(),
      this->Faces.data() + this->Faces.size() };
  }

  template <class Function>
  Solid& Map(Function function)
  {
    for (Vector3& p : this->Points)
    {
      p = function(p);
    }
    return *this;
  }
};

/// The prism over a polygon, from z = 0 up to `height`.
inline Solid Prism(const Polygon& base, double height)
{
  const auto n = static_cast<std::uint32_t>(base.size());
  Solid solid;
  solid.Points = base;
  for (const Vector3& p : base)
  {
    solid.Points.push_back(p + Vector3{ { 0.0, 0.0, height } });
  }
  solid.Faces.push_back(n);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    solid.Faces.push_back(n - 1 - i);
  }
  solid.Faces.push_back(n);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    solid.Faces.push_back(n + i);
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const std::uint32_t next = (i + 1) % n;
    solid.Faces.insert(solid.Faces.end(), { 4, i, next, n + next, n + i });
  }
  return solid;
}

}

#endif
