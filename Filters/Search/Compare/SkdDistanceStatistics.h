// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdDistanceStatistics.h
 * @brief Means and quantiles of distances over a surface, with estimates of their errors.
 *
 * A triangle is integrated by its centroid and corners, weights 3/4 and 1/12 each, which is exact
 * for polynomials of the second degree. A SampledTriangle is divided into four and integrated both
 * ways, as a whole (coarse) and by its four parts (fine). Where the integrand has a kink, as a
 * distance has, the error of the fine sum is a third of the difference or less. Values are the fine
 * ones; their errors are estimated by half of the difference of the sums, for what all triangles
 * have in common, and twice the root of the sum of squares of the differences, for what they have
 * not.
 */

#ifndef SkdDistanceStatistics_h
#define SkdDistanceStatistics_h

#include "Core/Geometry/Vector.h"
#include "Search/Compare/SkdReduction.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace skdtree
{
/// The shares of the area that quantiles are given of.
constexpr std::array<double, 4> SkdQuantileShares = { 0.5, 0.9, 0.95, 0.99 };

inline skd::Vector3 SkdCentroidOf(const std::array<skd::Vector3, 3>& corners)
{
  return (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
}

/// Distances, negative inside, at the corners of a triangle, the middles of its edges (k is between
/// corners k and k + 1), and the centroids of its four parts (k is at corner k, 3 in the middle).
struct SkdSampledTriangle
{
  static constexpr int Samples = 10;
  std::array<skd::Vector3, 3> Corners;
  std::array<double, 3> AtCorners;
  std::array<double, 3> AtMiddles;
  std::array<double, 4> AtCentroids;
  double Area;

  skd::Vector3 GetMiddle(int k) const
  {
    return skd::Lerp(this->Corners[k], this->Corners[(k + 1) % 3], 0.5);
  }

  /// Of a part: see AtCentroids.
  skd::Vector3 GetCentroid(int k) const
  {
    return k == 3
      ? SkdCentroidOf(this->Corners)
      : SkdCentroidOf({ this->Corners[k], this->GetMiddle(k), this->GetMiddle((k + 2) % 3) });
  }

  /// Calls visit(distance, its share of the area in the fine sum, and in the coarse sum).
  template <class Visit>
  void ForEachSample(const Visit& visit) const
  {
    for (int k = 0; k < 3; ++k)
    {
      visit(this->AtCorners[k], this->Area / 48.0, this->Area / 12.0);
      visit(this->AtMiddles[k], this->Area / 16.0, 0.0);
      visit(this->AtCentroids[k], this->Area * 3.0 / 16.0, 0.0);
    }
    visit(this->AtCentroids[3], this->Area * 3.0 / 16.0, this->Area * 0.75);
  }

  /// The difference of the fine and the coarse sum of a function of the distance.
  template <class Function>
  double GetDifference(const Function& function) const
  {
    double difference = 0.0;
    this->ForEachSample([&](double distance, double fine, double coarse)
      { difference += (fine - coarse) * function(distance); });
    return difference;
  }
};

/// NaN where there are no samples.
struct SkdDistanceStatistic
{
  double Value = std::numeric_limits<double>::quiet_NaN();
  double Error = Value; // estimated, absolute
};

/// Weighted by area.
struct SkdDistanceStatistics
{
  SkdDistanceStatistic Mean; // of the unsigned distances
  SkdDistanceStatistic RootMeanSquare;
  SkdDistanceStatistic SignedMean;
  std::array<SkdDistanceStatistic, 4> Quantiles; // of the unsigned distances
  double Measure = 0.0; // the area, or the number of points of a set of points
};

/// Of the triangles of all processes, or of their points, each of which is one sample of weight 1;
/// quantiles, which cost most, only if wanted. All processes must call it together. It does not
/// depend on which process has which triangle, nor on their order.
SkdDistanceStatistics SkdStatisticsOf(const std::vector<SkdSampledTriangle>& triangles,
  const std::vector<double>& points, bool wantsQuantiles, const SkdReduction& all);

/// How far the errors may be reduced: relative to a value (of a quantile, to the mean if that is
/// larger), but not below an absolute one.
struct SkdStatisticsTolerance
{
  double Relative;
  double Absolute;
};

/// Those of this process's triangles that contribute most to errors that exceed the tolerance; none
/// on any process if no error does. All processes must call it together.
std::vector<std::size_t> SkdTrianglesToDivide(const std::vector<SkdSampledTriangle>& triangles,
  const SkdDistanceStatistics& statistics, const SkdStatisticsTolerance& tolerance,
  const SkdReduction& all);
}

#endif
