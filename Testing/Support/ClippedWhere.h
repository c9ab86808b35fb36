// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClippedWhere.h
 * @brief what a half space leaves of a convex polygon; for tests with VTK and without
 */
#ifndef skdtest_ClippedWhere_h
#define skdtest_ClippedWhere_h

#include <cstddef>
#include <vector>

namespace skdtest
{

/// The part of a convex polygon in which height(p) is not negative (Sutherland and Hodgman);
/// between(p, q, t) is the point from p (t = 0) to q (t = 1) where the height is 0.
template <class Point, class Height, class Between>
std::vector<Point> ClippedWhere(
  const std::vector<Point>& polygon, const Height& height, const Between& between)
{
  std::vector<Point> left;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& p = polygon[i];
    const Point& q = polygon[(i + 1) % polygon.size()];
    const double ofP = height(p);
    const double ofQ = height(q);
    if (ofP >= 0.0)
    {
      left.push_back(p);
    }
    if ((ofP > 0.0 && ofQ < 0.0) || (ofP < 0.0 && ofQ > 0.0))
    {
      left.push_back(between(p, q, ofP / (ofP - ofQ)));
    }
  }
  return left;
}

}

#endif
