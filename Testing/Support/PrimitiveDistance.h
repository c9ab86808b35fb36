// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrimitiveDistance.h
 * @brief distances from a point to segments, triangles and bilinear patches, written plainly
 */
#ifndef skdtest_PrimitiveDistance_h
#define skdtest_PrimitiveDistance_h

#include "Support/Point.h"

#include <utility>
#include <vector>

namespace skdtest
{

/// The nearest point of the segment a b.
Point NearestOnSegment(const Point& x, const Point& a, const Point& b);

double SegmentDistance(const Point& x, const Point& a, const Point& b);

/// Also right where the triangle is a segment or a point.
double TriangleDistance(const Point& x, const Point& a, const Point& b, const Point& c);

/// A quad with its corners in order around it: the surface that bilinear interpolation makes.
struct Patch
{
  Point A, B, C, D;

  Point At(double u, double v) const
  {
    return Lerp(Lerp(this->A, this->B, u), Lerp(this->D, this->C, u), v);
  }
};

/// From the three best of 9 x 9 samples downhill.
double PatchDistance(const Point& x, const Patch& patch);

}

#endif
