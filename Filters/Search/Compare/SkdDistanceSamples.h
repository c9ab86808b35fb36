// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdDistanceSamples.h
 * @brief Distances of a surface from another at points spread over it, as many as statistics need.
 */

#ifndef SkdDistanceSamples_h
#define SkdDistanceSamples_h

#include "Pipeline/SkdLoop.h"
#include "Search/Compare/SkdComparedSet.h"
#include "Search/Compare/SkdDistanceStatistics.h"

#include <vector>

namespace skdtree
{
/// How many samples are taken.
struct SkdSampling
{
  double Spacing; // of the first ones, about, a length
  SkdStatisticsTolerance Tolerance;
};

class SkdDistanceSamples
{
public:
  /// Triangles are bisected until samples are about as close as the spacing, and then divided into
  /// four where that reduces the errors of the statistics most, until these are within the
  /// tolerance; with 2 million triangles the spacing grows, and no more are divided. Of points,
  /// each is a sample of weight 1. Reported as going from `first` to `last` of the algorithm's
  /// progress. Each process takes those of its own elements, and where more are taken is decided
  /// by those of all, who must call it together. The statistics are the same for any number of
  /// threads and processes. Returns whether it was aborted on none of them.
  bool Add(const SkdComparedSet& from, const SkdComparedSet& to, const SkdSampling& sampling,
    const SkdReduction& all, vtkAlgorithm* self, double first, double last);

  /// Appends those of another, and evaluates all.
  void Add(const SkdDistanceSamples& other, const SkdReduction& all);

  /// Of this process.
  vtkIdType GetNumberOfSamples() const
  {
    return static_cast<vtkIdType>(
      SkdSampledTriangle::Samples * this->Triangles.size() + this->Points.size());
  }

  const SkdDistanceStatistics& GetStatistics() const { return this->Statistics; }

private:
  bool FindTrianglesToDivide(const SkdStatisticsTolerance& tolerance, const SkdReduction& all,
    std::vector<std::size_t>& chosen);
  bool Divide(const std::vector<std::size_t>& chosen, const SkdComparedSet& to,
    const SkdReduction& all, SkdLoop loop);
  void Evaluate(bool wantsQuantiles, const SkdReduction& all)
  {
    this->Statistics = SkdStatisticsOf(this->Triangles, this->Points, wantsQuantiles, all);
  }

  std::vector<SkdSampledTriangle> Triangles;
  std::vector<double> Points; // of a set of points, their distances
  SkdDistanceStatistics Statistics;
};
}

#endif
