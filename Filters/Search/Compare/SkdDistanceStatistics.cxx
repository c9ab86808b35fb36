// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdDistanceStatistics.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace skdtree
{
namespace
{
using Triangles = std::vector<SkdSampledTriangle>;

/// Relative: what rounding takes from a sum of 2^24 weights, at random (the square root of their
/// number times 2^-53 is 4.5e-13). Without it a quantile of equal weights may be the next sample's.
constexpr double WeightRounding = 1e-12;

double Magnitude(double distance)
{
  return std::abs(distance);
}

double Signed(double distance)
{
  return distance;
}

double Square(double distance)
{
  return distance * distance;
}

/// The mean of a function of the distance.
template <class Function>
SkdDistanceStatistic MeanOf(const Triangles& triangles, const std::vector<double>& points,
  double measure, const Function& function)
{
  double sum = 0.0;
  double difference = 0.0;
  double squares = 0.0;
  for (const SkdSampledTriangle& triangle : triangles)
  {
    triangle.ForEachSample(
      [&](double distance, double fine, double) { sum += fine * function(distance); });
    const double own = triangle.GetDifference(function);
    difference += own;
    squares += own * own;
  }
  for (const double distance : points)
  {
    sum += function(distance);
  }
  return { sum / measure, (0.5 * std::abs(difference) + 2.0 * std::sqrt(squares)) / measure };
}

/// Quantiles of distances, which are distributed to bins; only bins that hold one are sorted.
class Distribution
{
public:
  Distribution(const Triangles& triangles, const std::vector<double>& points, double measure);

  double GetFine(double share) { return this->Find(share, &Step::Fine); }
  double GetCoarse(double share) { return this->Find(share, &Step::Coarse); }

private:
  /// A sample, or the sums of a bin and those before.
  struct Step
  {
    double Distance;
    double Fine;
    double Coarse;
  };

  static constexpr std::size_t Bins = 1 << 16;

  std::size_t BinOf(double distance) const
  {
    return static_cast<std::size_t>(std::min(this->Scale * distance, Bins - 1.0));
  }
  template <class Visit>
  void ForEachStep(const Visit& visit) const;
  double Find(double share, double Step::*weight);
  double FindIn(std::size_t bin, double rest, double Step::*weight);

  const Triangles& Of;
  const std::vector<double>& Points;
  double Measure;
  double Scale = 0.0;
  std::vector<Step> Steps; // bin after bin
  std::vector<std::size_t> Ends;
  std::vector<Step> Sums;
  std::vector<bool> IsSorted;
};

template <class Visit>
void Distribution::ForEachStep(const Visit& visit) const
{
  for (const SkdSampledTriangle& triangle : this->Of)
  {
    triangle.ForEachSample(
      [&visit](double distance, double fine, double coarse) {
        visit(Step{ std::abs(distance), fine, coarse });
      });
  }
  for (const double distance : this->Points)
  {
    visit(Step{ std::abs(distance), 1.0, 1.0 });
  }
}

Distribution::Distribution(
  const Triangles& triangles, const std::vector<double>& points, double measure)
  : Of(triangles)
  , Points(points)
  , Measure(measure)
  , Steps(SkdSampledTriangle::Samples * triangles.size() + points.size())
  , Ends(Bins, 0)
  , Sums(Bins, Step{ 0.0, 0.0, 0.0 })
  , IsSorted(Bins, false)
{
  double largest = 0.0;
  this->ForEachStep([&](const Step& step) { largest = std::max(largest, step.Distance); });
  this->Scale = largest > 0.0 ? Bins / largest : 0.0;
  this->ForEachStep(
    [this](const Step& step)
    {
      const std::size_t bin = this->BinOf(step.Distance);
      ++this->Ends[bin];
      this->Sums[bin].Fine += step.Fine;
      this->Sums[bin].Coarse += step.Coarse;
    });
  std::size_t first = 0;
  for (std::size_t bin = 0; bin < Bins; ++bin)
  {
    first += std::exchange(this->Ends[bin], first);
    this->Sums[bin].Fine += bin > 0 ? this->Sums[bin - 1].Fine : 0.0;
    this->Sums[bin].Coarse += bin > 0 ? this->Sums[bin - 1].Coarse : 0.0;
  }
  this->ForEachStep(
    [this](const Step& step) { this->Steps[this->Ends[this->BinOf(step.Distance)]++] = step; });
}

double Distribution::Find(double share, double Step::*weight)
{
  const double part = share * this->Measure * (1.0 - WeightRounding);
  const auto found = std::lower_bound(this->Sums.begin(), this->Sums.end(), part,
    [weight](const Step& sums, double below) { return sums.*weight < below; });
  const auto bin = static_cast<std::size_t>(found - this->Sums.begin());
  return this->FindIn(
    std::min(bin, Bins - 1), part - (bin > 0 ? this->Sums[bin - 1].*weight : 0.0), weight);
}

// Of a bin without samples, and where rounding leaves a rest, the last one before.
double Distribution::FindIn(std::size_t bin, double rest, double Step::*weight)
{
  const auto begin = this->Steps.begin() + (bin > 0 ? this->Ends[bin - 1] : 0);
  const auto end = this->Steps.begin() + this->Ends[bin];
  if (!this->IsSorted[bin])
  {
    std::sort(begin, end,
      [](const Step& a, const Step& b)
      { return std::tie(a.Distance, a.Fine, a.Coarse) < std::tie(b.Distance, b.Fine, b.Coarse); });
    this->IsSorted[bin] = true;
  }
  double sum = 0.0;
  for (auto step = begin; step != end; ++step)
  {
    sum += (*step).*weight;
    if (sum >= rest)
    {
      return step->Distance;
    }
  }
  return end == this->Steps.begin() ? begin->Distance : std::prev(end)->Distance;
}

/// The area on which a distance is not exceeded, in the fine sum less the coarse one.
double DifferenceBelow(const SkdSampledTriangle& triangle, double limit)
{
  return triangle.GetDifference(
    [limit](double distance) { return std::abs(distance) <= limit ? 1.0 : 0.0; });
}

SkdDistanceStatistic QuantileOf(
  Distribution& distances, const Triangles& triangles, double share, double measure)
{
  SkdDistanceStatistic quantile;
  quantile.Value = distances.GetFine(share);
  double squares = 0.0;
  for (const SkdSampledTriangle& triangle : triangles)
  {
    const double own = DifferenceBelow(triangle, quantile.Value);
    squares += own * own;
  }
  const double random = 2.0 * std::sqrt(squares) / measure;
  const double common = std::abs(quantile.Value - distances.GetCoarse(share));
  quantile.Error = 0.5 * common +
    std::max(distances.GetFine(std::min(share + random, 1.0)) - quantile.Value,
      quantile.Value - distances.GetFine(std::max(share - random, 0.0)));
  return quantile;
}

/// What each triangle contributes to the errors that are too large, in tolerances.
class Contributions
{
public:
  Contributions(const Triangles& triangles, const SkdStatisticsTolerance& tolerance)
    : Each(triangles.size(), 0.0)
    , Of(triangles)
    , Tolerance(tolerance)
  {
  }

  /// Of an error, relative to a value; difference(triangle) is to be scaled so that their sum of
  /// magnitudes is the error.
  template <class Difference>
  void Add(const SkdDistanceStatistic& statistic, double value, const Difference& difference)
  {
    const double limit =
      std::max(this->Tolerance.Relative * std::abs(value), this->Tolerance.Absolute);
    if (!(statistic.Error > limit))
    {
      return;
    }
    std::vector<double> own(this->Of.size());
    std::transform(this->Of.begin(), this->Of.end(), own.begin(),
      [&](const SkdSampledTriangle& triangle) { return std::abs(difference(triangle)); });
    const double sum = std::accumulate(own.begin(), own.end(), 0.0);
    const double scale = sum > 0.0 ? statistic.Error / limit / sum : 0.0;
    std::transform(own.begin(), own.end(), this->Each.begin(), this->Each.begin(),
      [scale](double part, double before) { return before + scale * part; });
  }

  /// The fewest that contribute a part of the sum.
  std::vector<std::size_t> GetLargest(double part) const;

private:
  std::vector<double> Each;
  const Triangles& Of;
  SkdStatisticsTolerance Tolerance;
};

std::vector<std::size_t> Contributions::GetLargest(double part) const
{
  std::vector<double> sorted = this->Each;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  const double enough = part * std::accumulate(sorted.begin(), sorted.end(), 0.0);
  double sum = 0.0;
  double least = 0.0;
  for (std::size_t i = 0; i < sorted.size() && sum < enough; ++i)
  {
    least = sorted[i];
    sum += least;
  }
  std::vector<std::size_t> largest;
  for (std::size_t i = 0; least > 0.0 && i < this->Each.size(); ++i)
  {
    if (this->Each[i] >= least)
    {
      largest.push_back(i);
    }
  }
  return largest;
}
}

SkdDistanceStatistics SkdStatisticsOf(const std::vector<SkdSampledTriangle>& triangles,
  const std::vector<double>& points, bool wantsQuantiles)
{
  SkdDistanceStatistics statistics;
  statistics.Measure = static_cast<double>(points.size());
  for (const SkdSampledTriangle& triangle : triangles)
  {
    statistics.Measure += triangle.Area;
  }
  const double measure = statistics.Measure;
  if (!(measure > 0.0))
  {
    return statistics;
  }
  statistics.Mean = MeanOf(triangles, points, measure, Magnitude);
  statistics.SignedMean = MeanOf(triangles, points, measure, Signed);
  const SkdDistanceStatistic square = MeanOf(triangles, points, measure, Square);
  const double root = std::sqrt(square.Value);
  statistics.RootMeanSquare = { root,
    root - std::sqrt(std::max(0.0, square.Value - square.Error)) };

  if (!wantsQuantiles)
  {
    return statistics;
  }
  Distribution distances(triangles, points, measure);
  for (std::size_t i = 0; i < SkdQuantileShares.size(); ++i)
  {
    statistics.Quantiles[i] = QuantileOf(distances, triangles, SkdQuantileShares[i], measure);
  }
  return statistics;
}

std::vector<std::size_t> SkdTrianglesToDivide(const std::vector<SkdSampledTriangle>& triangles,
  const SkdDistanceStatistics& statistics, const SkdStatisticsTolerance& tolerance)
{
  constexpr double part = 0.7;
  const double mean = statistics.Mean.Value;
  Contributions contributions(triangles, tolerance);
  contributions.Add(statistics.Mean, mean,
    [](const SkdSampledTriangle& triangle) { return triangle.GetDifference(Magnitude); });
  contributions.Add(statistics.RootMeanSquare, statistics.RootMeanSquare.Value,
    [](const SkdSampledTriangle& triangle) { return triangle.GetDifference(Square); });
  contributions.Add(statistics.SignedMean, mean,
    [](const SkdSampledTriangle& triangle) { return triangle.GetDifference(Signed); });
  for (const SkdDistanceStatistic& quantile : statistics.Quantiles)
  {
    contributions.Add(quantile, std::max(quantile.Value, mean),
      [&](const SkdSampledTriangle& triangle)
      { return DifferenceBelow(triangle, quantile.Value); });
  }
  return contributions.GetLargest(part);
}
}
