// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdDistanceStatistics.h"

#include "Search/Compare/SkdWeightedValues.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using Triangles = std::vector<SkdSampledTriangle>;

/// The area of all in units of the weights that are added up: a sample's weight is a multiple of a
/// 48th of its triangle's area, and all are below 2^63.
constexpr double WeightOfAll = 0x1p56;
constexpr long long PartsOfTriangle = 48;

/// Relative: what 2^21 triangles lose where their areas are rounded to units, half a unit each, is
/// 1.5e-11. Without it a quantile of equal weights may be the next sample's.
constexpr double WeightRounding = 1e-10;

// Objects, of a type each, so that templates inline them.
constexpr auto Magnitude = [](double distance) { return std::abs(distance); };
constexpr auto Signed = [](double distance) { return distance; };
constexpr auto Square = [](double distance) { return distance * distance; };

/// Appends three sums of a function of the distance: its integral, the difference of the fine and
/// the coarse one, and the squares of each triangle's difference.
template <class Function>
void AppendSums(const Triangles& triangles, const std::vector<double>& points,
  const Function& function, std::vector<SkdCompensatedSum>& sums)
{
  SkdCompensatedSum integral;
  SkdCompensatedSum difference;
  SkdCompensatedSum squares;
  for (const SkdSampledTriangle& triangle : triangles)
  {
    double part = 0.0;
    triangle.ForEachSample(
      [&](double distance, double fine, double) { part += fine * function(distance); });
    integral.Add(part);
    const double own = triangle.GetDifference(function);
    difference.Add(own);
    squares.Add(own * own);
  }
  for (const double distance : points)
  {
    integral.Add(function(distance));
  }
  sums.insert(sums.end(), { integral, difference, squares });
}

/// From the three sums.
SkdDistanceStatistic MeanOf(const double* sums, double measure)
{
  return { sums[0] / measure, (0.5 * std::abs(sums[1]) + 2.0 * std::sqrt(sums[2])) / measure };
}

double MeasureOf(
  const Triangles& triangles, const std::vector<double>& points, const SkdReduction& all)
{
  SkdCompensatedSum measure;
  measure.Add(static_cast<double>(points.size()));
  for (const SkdSampledTriangle& triangle : triangles)
  {
    measure.Add(triangle.Area);
  }
  return all.Sum(std::vector<SkdCompensatedSum>{ measure })[0];
}

/// Of the unsigned distances of samples.
class Distribution
{
public:
  Distribution(const Triangles& triangles, const std::vector<double>& points, double measure,
    const SkdReduction& all);

  using Shares = std::vector<double>;

  ///@{
  /// The distances that are not exceeded on some shares of the area, in the fine and the coarse
  /// sum.
  Shares GetFine(const Shares& shares) const
  {
    return this->Find(shares, &SkdWeightedDistance::Fine);
  }
  Shares GetCoarse(const Shares& shares) const
  {
    return this->Find(shares, &SkdWeightedDistance::Coarse);
  }
  ///@}

private:
  template <class Visit>
  void ForEachSample(const Visit& visit) const;
  Shares Find(const Shares& shares, long long SkdWeightedDistance::*weight) const;

  const Triangles& Of;
  const std::vector<double>& Points;
  double Unit; // of weights, in an area
  SkdWeightedValues Values;
};

Distribution::Distribution(const Triangles& triangles, const std::vector<double>& points,
  double measure, const SkdReduction& all)
  : Of(triangles)
  , Points(points)
  , Unit(measure / WeightOfAll)
  , Values([this](const auto& visit) { this->ForEachSample(visit); }, all)
{
}

template <class Visit>
void Distribution::ForEachSample(const Visit& visit) const
{
  for (const SkdSampledTriangle& triangle : this->Of)
  {
    const long long part = std::llround(triangle.Area / this->Unit);
    const auto visitSample = [&](double distance, long long fine, long long coarse) {
      visit(SkdWeightedDistance{ std::abs(distance), fine * part, coarse * part });
    };
    for (int k = 0; k < 3; ++k)
    {
      visitSample(triangle.AtCorners[k], 1, 4);
      visitSample(triangle.AtMiddles[k], 3, 0);
      visitSample(triangle.AtCentroids[k], 9, 0);
    }
    visitSample(triangle.AtCentroids[3], 9, 36);
  }
  const long long ofPoint = std::llround(PartsOfTriangle / this->Unit);
  for (const double distance : this->Points)
  {
    visit(SkdWeightedDistance{ std::abs(distance), ofPoint, ofPoint });
  }
}

Distribution::Shares Distribution::Find(
  const Shares& shares, long long SkdWeightedDistance::*weight) const
{
  std::vector<SkdWeightedValues::Query> queries;
  for (const double share : shares)
  {
    const double part = share * (1.0 - WeightRounding) * PartsOfTriangle * WeightOfAll;
    queries.push_back({ std::llround(part), weight });
  }
  return this->Values.Find(queries);
}

/// The area on which a distance is not exceeded, in the fine sum less the coarse one.
double DifferenceBelow(const SkdSampledTriangle& triangle, double limit)
{
  return triangle.GetDifference(
    [limit](double distance) { return std::abs(distance) <= limit ? 1.0 : 0.0; });
}

std::array<SkdDistanceStatistic, 4> QuantilesOf(const Distribution& distances,
  const Triangles& triangles, double measure, const SkdReduction& all)
{
  const std::vector<double> shares(SkdQuantileShares.begin(), SkdQuantileShares.end());
  const std::vector<double> values = distances.GetFine(shares);
  const std::vector<double> coarse = distances.GetCoarse(shares);
  std::vector<SkdCompensatedSum> sums(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    for (const SkdSampledTriangle& triangle : triangles)
    {
      const double own = DifferenceBelow(triangle, values[i]);
      sums[i].Add(own * own);
    }
  }
  std::vector<double> ends;
  const std::vector<double> squares = all.Sum(sums);
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    const double random = 2.0 * std::sqrt(squares[i]) / measure;
    ends.push_back(std::max(shares[i] - random, 0.0));
    ends.push_back(std::min(shares[i] + random, 1.0));
  }
  const std::vector<double> around = distances.GetFine(ends);
  std::array<SkdDistanceStatistic, 4> quantiles;
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    quantiles[i] = { values[i],
      0.5 * std::abs(values[i] - coarse[i]) +
        std::max(around[2 * i + 1] - values[i], values[i] - around[2 * i]) };
  }
  return quantiles;
}

/// What each triangle contributes to the errors that are too large, in tolerances.
class Contributions
{
public:
  Contributions(
    const Triangles& triangles, const SkdStatisticsTolerance& tolerance, const SkdReduction& all)
    : Of(triangles)
    , Tolerance(tolerance)
    , All(all)
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
    this->Errors.push_back({ own, statistic.Error / limit });
  }

  /// The fewest that contribute a part of the sum.
  std::vector<std::size_t> GetLargest(double part) const;

private:
  /// An error in tolerances, and what it is shared out by.
  struct Error
  {
    std::vector<double> Differences;
    double Size;
  };

  static SkdCompensatedSum AddUp(const std::vector<double>& own)
  {
    SkdCompensatedSum sum;
    for (const double number : own)
    {
      sum.Add(number);
    }
    return sum;
  }
  std::vector<double> GetEach() const;

  std::vector<Error> Errors;
  const Triangles& Of;
  SkdStatisticsTolerance Tolerance;
  const SkdReduction& All;
};

std::vector<double> Contributions::GetEach() const
{
  std::vector<SkdCompensatedSum> own;
  for (const Error& error : this->Errors)
  {
    own.push_back(AddUp(error.Differences));
  }
  std::vector<double> each(this->Of.size(), 0.0);
  const std::vector<double> sums = own.empty() ? std::vector<double>() : this->All.Sum(own);
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const double scale = sums[i] > 0.0 ? this->Errors[i].Size / sums[i] : 0.0;
    std::transform(this->Errors[i].Differences.begin(), this->Errors[i].Differences.end(),
      each.begin(), each.begin(),
      [scale](double difference, double before) { return before + scale * difference; });
  }
  return each;
}

// What is below the least of them makes no more than the rest.
std::vector<std::size_t> Contributions::GetLargest(double part) const
{
  const std::vector<double> contribution = this->GetEach();
  const double sum = this->All.Sum(std::vector<SkdCompensatedSum>{ AddUp(contribution) })[0];
  std::vector<std::size_t> largest;
  if (!(sum > 0.0))
  {
    return largest;
  }
  constexpr double all = 0x1p62;
  const SkdWeightedValues contributions(
    [&](const auto& visit)
    {
      for (const double each : contribution)
      {
        visit(SkdWeightedDistance{ each, std::llround(each / sum * all), 0 });
      }
    },
    this->All);
  const auto rest = static_cast<long long>((1.0 - part) * all);
  const double least = contributions.Find({ { rest + 1, &SkdWeightedDistance::Fine } })[0];
  for (std::size_t i = 0; least > 0.0 && i < contribution.size(); ++i)
  {
    if (contribution[i] >= least)
    {
      largest.push_back(i);
    }
  }
  return largest;
}
}

SkdDistanceStatistics SkdStatisticsOf(const std::vector<SkdSampledTriangle>& triangles,
  const std::vector<double>& points, bool wantsQuantiles, const SkdReduction& all)
{
  SkdDistanceStatistics statistics;
  const double measure = MeasureOf(triangles, points, all);
  statistics.Measure = measure;
  if (!(measure > 0.0))
  {
    return statistics;
  }
  std::vector<SkdCompensatedSum> own;
  AppendSums(triangles, points, Magnitude, own);
  AppendSums(triangles, points, Signed, own);
  AppendSums(triangles, points, Square, own);
  const std::vector<double> sums = all.Sum(own);
  statistics.Mean = MeanOf(&sums[0], measure);
  statistics.SignedMean = MeanOf(&sums[3], measure);
  const SkdDistanceStatistic square = MeanOf(&sums[6], measure);
  const double root = std::sqrt(square.Value);
  statistics.RootMeanSquare = { root,
    root - std::sqrt(std::max(0.0, square.Value - square.Error)) };
  if (wantsQuantiles)
  {
    const Distribution distances(triangles, points, measure, all);
    statistics.Quantiles = QuantilesOf(distances, triangles, measure, all);
  }
  return statistics;
}

std::vector<std::size_t> SkdTrianglesToDivide(const std::vector<SkdSampledTriangle>& triangles,
  const SkdDistanceStatistics& statistics, const SkdStatisticsTolerance& tolerance,
  const SkdReduction& all)
{
  constexpr double part = 0.7;
  const double mean = statistics.Mean.Value;
  Contributions contributions(triangles, tolerance, all);
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
