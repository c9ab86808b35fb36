// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdDistanceSamples.h
 * @brief Distances of a surface from another at places spread over it, and their statistics.
 */

#ifndef SkdDistanceSamples_h
#define SkdDistanceSamples_h

#include "Compare/SkdComparedSet.h"
#include "Pipeline/SkdLoop.h"

#include <array>
#include <limits>
#include <vector>

/// The shares of the area that quantiles are given of.
constexpr std::array<double, 4> SkdQuantileShares = { 0.5, 0.9, 0.95, 0.99 };

/// Weighted by area. NaN where there are no samples.
struct SkdDistanceStatistics
{
  double Mean = std::numeric_limits<double>::quiet_NaN(); // of the unsigned distances
  double RootMeanSquare = Mean;
  double SignedMean = Mean;
  std::array<double, 4> Quantiles{ Mean, Mean, Mean, Mean }; // of the unsigned distances
  double Measure = 0.0; // the area, or the number of points of a set of points
};

class SkdDistanceSamples
{
public:
  /// Each triangle is divided into n * n of its shape, n the least for which edges are no longer
  /// than the spacing (a length), and evaluated at their centroids: an error of the second order.
  /// With more than 16 million samples the spacing grows. Of points, each is a sample of weight 1.
  bool Add(const SkdComparedSet& from, const SkdComparedSet& to, double spacing, SkdLoop& loop);

  /// Appends those of another.
  void Add(const SkdDistanceSamples& other);

  vtkIdType GetNumberOfSamples() const { return static_cast<vtkIdType>(this->Samples.size()); }

  /// The same for any number of threads. Cost: a sort.
  SkdDistanceStatistics GetStatistics() const;

private:
  struct Sample
  {
    double Distance; // negative inside
    double Weight;
  };
  std::vector<Sample> Samples;
};

#endif
