// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdSampleStatistic.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
using Samples = std::vector<SkdWeightedValue>;

bool IsLess(const SkdWeightedValue& a, const SkdWeightedValue& b)
{
  return a.Value < b.Value;
}

/// The mean of function(value - the first value).
template <class Function>
double MeanOf(const Samples& samples, const Function& function)
{
  double sum = 0.0;
  double weights = 0.0;
  for (const SkdWeightedValue& sample : samples)
  {
    sum += sample.Weight * function(sample.Value - samples.front().Value);
    weights += sample.Weight;
  }
  return sum / weights;
}

double Mean(const Samples& samples)
{
  return samples.front().Value + MeanOf(samples, [](double value) { return value; });
}

double StandardDeviation(const Samples& samples)
{
  const double mean = Mean(samples) - samples.front().Value;
  return std::sqrt(
    MeanOf(samples, [mean](double value) { return (value - mean) * (value - mean); }));
}

double Sum(const Samples& samples)
{
  double sum = 0.0;
  for (const SkdWeightedValue& sample : samples)
  {
    sum += sample.Value;
  }
  return sum;
}

double Median(Samples& samples)
{
  std::stable_sort(samples.begin(), samples.end(), IsLess);
  double all = 0.0;
  for (const SkdWeightedValue& sample : samples)
  {
    all += sample.Weight;
  }
  double before = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
  {
    before += samples[i].Weight;
    if (2.0 * before == all)
    {
      return 0.5 * samples[i].Value + 0.5 * samples[i + 1].Value;
    }
    if (2.0 * before > all)
    {
      return samples[i].Value;
    }
  }
  return samples.back().Value;
}
}

double SkdStatisticOf(SkdStatistic statistic, Samples& samples)
{
  switch (statistic)
  {
    case SkdStatistic::Minimum:
      return std::min_element(samples.begin(), samples.end(), IsLess)->Value;
    case SkdStatistic::Maximum:
      return std::max_element(samples.begin(), samples.end(), IsLess)->Value;
    case SkdStatistic::Sum:
      return Sum(samples);
    case SkdStatistic::StandardDeviation:
      return StandardDeviation(samples);
    case SkdStatistic::Median:
      return Median(samples);
    default:
      return Mean(samples);
  }
}
}
