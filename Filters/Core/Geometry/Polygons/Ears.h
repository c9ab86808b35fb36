// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Polygons_Ears_h
#define skd_Geometry_Polygons_Ears_h

#include "../Vector.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace skd
{

/// A vector across a polygon of `size` corners, its largest component 1; 0 of one of no area.
inline Vector3 DirectionAcross(const Vector3* p, std::size_t size)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (std::size_t i = 1; i + 1 < size; ++i)
  {
    sum = sum + Cross(p[i] - p[0], p[i + 1] - p[0]);
  }
  const double largest = std::max({ std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2]) });
  return largest > 0.0 ? (1.0 / largest) * sum : sum;
}

/// Cuts a polygon into well-shaped triangles between its corners, three numbers a triangle: of all
/// ears, corners that can be cut off, the one with the shortest cut goes first. Where any triangles
/// will do, EarClipping.h is cheaper and exact. Empty if there comes a
/// time when there is none, as with a polygon that crosses itself. O(n^3) for n corners.
inline std::vector<std::uint32_t> CutOffEars(const std::vector<Vector3>& polygon)
{
  const Vector3 normal = DirectionAcross(polygon.data(), polygon.size());
  std::vector<std::uint32_t> ring(polygon.size());
  for (std::uint32_t i = 0; i < ring.size(); ++i)
  {
    ring[i] = i;
  }
  const auto orientationOf = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  { return Dot(Cross(polygon[b] - polygon[a], polygon[c] - polygon[a]), normal); };
  const auto isEar = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    return orientationOf(a, b, c) > 0.0 &&
      std::none_of(ring.begin(), ring.end(),
        [&](std::uint32_t x)
        {
          return x != a && x != b && x != c && orientationOf(a, b, x) >= 0.0 &&
            orientationOf(b, c, x) >= 0.0 && orientationOf(c, a, x) >= 0.0;
        });
  };
  std::vector<std::uint32_t> triangles;
  while (ring.size() > 2)
  {
    std::size_t best = ring.size();
    double best2 = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::uint32_t before = ring[i == 0 ? ring.size() - 1 : i - 1];
      const std::uint32_t after = ring[i + 1 == ring.size() ? 0 : i + 1];
      const double cut2 = Distance2(polygon[before], polygon[after]);
      if (isEar(before, ring[i], after) && (best == ring.size() || cut2 < best2))
      {
        best = i;
        best2 = cut2;
      }
    }
    if (best == ring.size())
    {
      return {};
    }
    triangles.insert(triangles.end(),
      { ring[best == 0 ? ring.size() - 1 : best - 1], ring[best],
        ring[best + 1 == ring.size() ? 0 : best + 1] });
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return triangles;
}

}

#endif
