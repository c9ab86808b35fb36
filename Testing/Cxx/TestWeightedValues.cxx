// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// SkdWeightedValues: quantiles are those of sorted values, whatever their magnitudes and weights.

#include "Search/Compare/SkdWeightedValues.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace skdtree;

namespace
{

using Values = std::vector<SkdWeightedDistance>;
using Query = SkdWeightedValues::Query;

constexpr long long SkdWeightedDistance::*Fine = &SkdWeightedDistance::Fine;
constexpr long long SkdWeightedDistance::*Coarse = &SkdWeightedDistance::Coarse;

std::vector<double> FindIn(const Values& values, const std::vector<Query>& queries)
{
  const SkdReduction alone;
  const SkdWeightedValues found(
    [&](const auto& visit) { std::for_each(values.begin(), values.end(), visit); }, alone);
  return found.Find(queries);
}

double FindSorted(Values values, const Query& query)
{
  std::sort(values.begin(), values.end(),
    [](const SkdWeightedDistance& a, const SkdWeightedDistance& b) { return a.Value < b.Value; });
  long long sum = 0;
  double last = 0.0;
  for (const SkdWeightedDistance& value : values)
  {
    const long long weight = value.*query.Weight;
    sum += weight;
    last = weight > 0 ? value.Value : last;
    if (weight > 0 && sum >= query.Part)
    {
      return value.Value;
    }
  }
  return last;
}

/// Values over many orders of magnitude, or nearly all alike but for a few; some are zero, some
/// are there many times, some have no weight.
Values MakeValues(std::size_t number, double decades, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-decades, 0.0);
  std::uniform_int_distribution<int> weight(0, 1000);
  Values values;
  for (std::size_t i = 0; i < number; ++i)
  {
    const double value = i % 7 == 0 ? 0.0 : std::pow(10.0, exponent(random));
    values.push_back({ i % 3 == 0 ? std::ldexp(std::floor(std::ldexp(value, 10)), -10) : value,
      weight(random), i % 2 == 0 ? weight(random) : 0 });
  }
  return values;
}

}

TEST(WeightedValues, QuantilesAreThoseOfSortedValues)
{
  unsigned seed = 1;
  for (const std::size_t number : { 1, 2, 10, 1000, 30000 })
  {
    for (const double decades : { 0.0, 1e-7, 1.0, 20.0 })
    {
      const Values values = MakeValues(number, decades, seed++);
      std::vector<Query> queries;
      for (const long long part : { -5LL, 1LL, 2LL, 77LL, 1234LL, 250000LL, 7000000LL, 1LL << 60 })
      {
        queries.push_back({ part, Fine });
        queries.push_back({ part, Coarse });
      }
      const std::vector<double> found = FindIn(values, queries);
      for (std::size_t i = 0; i < queries.size(); ++i)
      {
        EXPECT_EQ(found[i], FindSorted(values, queries[i]))
          << number << " values, " << decades << " decades, part " << queries[i].Part;
      }
    }
  }
}

TEST(WeightedValues, AnOutlierLeavesTheOthersApart)
{
  Values values = MakeValues(5000, 1.0, 99);
  values.push_back({ 1e12, 3, 3 });
  for (const long long part : { 10LL, 100000LL, 2000000LL })
  {
    const Query query{ part, Fine };
    EXPECT_EQ(FindIn(values, { query })[0], FindSorted(values, query)) << part;
  }
}

TEST(WeightedValues, WithoutValuesThereIsZero)
{
  EXPECT_EQ(FindIn({}, { { 1, Fine }, { 0, Coarse } }), std::vector<double>(2, 0.0));
}
