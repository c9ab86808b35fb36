// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves that tests of curves and of patches share.
#ifndef coretest_CurveScenes_h
#define coretest_CurveScenes_h

#include "Core/Curves/BezierCurve.h"

#include <cmath>

namespace coretest
{

/// (t, side t, 0) plus (t - root)^degree + slope (t - root) along the axis: its control points are
/// the blossom's values.
inline skd::BezierCurve Power(int degree, double root, double slope, double side, int axis)
{
  skd::BezierCurve curve;
  curve.Degree = degree;
  for (int i = 0; i <= degree; ++i)
  {
    const double t = static_cast<double>(i) / degree;
    skd::Vector3 x{ { t, side * t, 0.0 } };
    x[axis] += std::pow(1.0 - root, i) * std::pow(-root, degree - i) + slope * (t - root);
    curve.Points[i] = skd::Weighted(x, 1.0);
  }
  return curve;
}

}

#endif
