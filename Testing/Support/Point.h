// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Point.h
 * @brief points of tests, and the little arithmetic that references need
 */
#ifndef skdtest_Point_h
#define skdtest_Point_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace skdtest
{

using Point = std::array<double, 3>;
using Bounds = std::array<double, 6>;

inline Point operator+(const Point& a, const Point& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Point operator-(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point operator*(double factor, const Point& a)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Point& a)
{
  return std::sqrt(Dot(a, a));
}

inline double Distance(const Point& a, const Point& b)
{
  return Length(a - b);
}

inline Point Lerp(const Point& a, const Point& b, double t)
{
  return a + t * (b - a);
}

inline Bounds EmptyBounds()
{
  const double big = std::numeric_limits<double>::max();
  return { big, -big, big, -big, big, -big };
}

inline void Extend(Bounds& box, const Point& p)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] = std::min(box[2 * axis], p[axis]);
    box[2 * axis + 1] = std::max(box[2 * axis + 1], p[axis]);
  }
}

inline Bounds BoxOf(const Point& a, const Point& b)
{
  Bounds box = EmptyBounds();
  Extend(box, a);
  Extend(box, b);
  return box;
}

inline bool Overlap(const Bounds& a, const Bounds& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(a[2 * axis] <= b[2 * axis + 1] && b[2 * axis] <= a[2 * axis + 1]))
    {
      return false;
    }
  }
  return true;
}

inline bool Contains(const Bounds& box, const Point& p)
{
  return Overlap(box, { p[0], p[0], p[1], p[1], p[2], p[2] });
}

inline bool Contains(const Bounds& outer, const Bounds& inner)
{
  return Contains(outer, Point{ inner[0], inner[2], inner[4] }) &&
    Contains(outer, Point{ inner[1], inner[3], inner[5] });
}

inline Bounds Grown(Bounds box, double by)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] -= by;
    box[2 * axis + 1] += by;
  }
  return box;
}

inline Point Center(const Bounds& box)
{
  return { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]) };
}

inline double Diagonal(const Bounds& box)
{
  return Length({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
}

/// Distance of a point to a box, 0 inside.
inline double Distance(const Bounds& box, const Point& p)
{
  Point out;
  for (int axis = 0; axis < 3; ++axis)
  {
    out[axis] = std::max({ box[2 * axis] - p[axis], 0.0, p[axis] - box[2 * axis + 1] });
  }
  return Length(out);
}

/// The size that rounding errors are measured by: extent and magnitude of the coordinates.
inline double Scale(const Bounds& box)
{
  double largest = Diagonal(box);
  for (double side : box)
  {
    largest = std::max(largest, std::abs(side));
  }
  return largest;
}

/// A reproducible stream of numbers and points.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  double Between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() >> 11) * 0x1.0p-53);
  }

  int Index(int count) { return static_cast<int>(this->Engine() % count); }

  Point InBox(const Bounds& box)
  {
    return { this->Between(box[0], box[1]), this->Between(box[2], box[3]),
      this->Between(box[4], box[5]) };
  }

  /// Uniform on the unit sphere.
  Point Direction()
  {
    for (;;)
    {
      const Point p = this->InBox({ -1, 1, -1, 1, -1, 1 });
      const double length = Length(p);
      if (length > 0.1 && length <= 1.0)
      {
        return (1.0 / length) * p;
      }
    }
  }

private:
  std::mt19937_64 Engine;
};

}

#endif
