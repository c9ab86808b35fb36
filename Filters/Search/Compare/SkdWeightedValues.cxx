// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Compare/SkdWeightedValues.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace skdtree
{
namespace
{
/// How many values share a bin, on average, and how many bins there are.
constexpr long long ValuesInBin = 16;
constexpr std::size_t FewestBins = std::size_t(1) << 8;
constexpr std::size_t MostBins = std::size_t(1) << 16;

/// Which all processes may have, if there are no more: 1.5 megabytes.
constexpr double FewValues = 65536.0;

/// Of a value with its weights, as it is sent.
constexpr std::size_t NumbersOfValue = sizeof(SkdWeightedDistance) / sizeof(double);

/// Into which the bounds of a quantile are divided, again and again.
constexpr std::uint64_t Buckets = 1024;

/// The order of numbers that are not negative is that of their bits.
std::uint64_t KeyOf(double value)
{
  std::uint64_t key = 0;
  std::memcpy(&key, &value, sizeof(key));
  return key;
}

double ValueOf(std::uint64_t key)
{
  double value = 0.0;
  std::memcpy(&value, &key, sizeof(value));
  return value;
}

/// Of each bucket, between two bounds.
std::uint64_t WidthOf(std::uint64_t low, std::uint64_t high)
{
  return (high - low) / Buckets + 1;
}
}

bool SkdWeightedValues::AreFew(const std::vector<double>& numbers)
{
  return numbers.size() > 1 && std::accumulate(numbers.begin(), numbers.end(), 0.0) <= FewValues;
}

void SkdWeightedValues::GatherAll(
  const std::vector<double>& numbers, std::vector<SkdWeightedDistance>& values)
{
  std::vector<double> own(values.size() * NumbersOfValue);
  if (!values.empty())
  {
    std::memcpy(own.data(), values.data(), values.size() * sizeof(values[0]));
  }
  std::vector<double> lengths(numbers);
  for (double& length : lengths)
  {
    length *= static_cast<double>(NumbersOfValue);
  }
  const std::vector<double> all = this->All.Gather(own, lengths);
  values.resize(all.size() / NumbersOfValue);
  if (!values.empty())
  {
    std::memcpy(values.data(), all.data(), values.size() * sizeof(values[0]));
  }
  this->All = SkdReduction();
}

void SkdWeightedValues::MakeBins(long long number, double largest)
{
  const long long all = this->All.Sum(number);
  std::size_t bins = FewestBins;
  while (bins < MostBins && static_cast<long long>(bins) * ValuesInBin < all)
  {
    bins *= 2;
  }
  largest = this->All.Largest(largest);
  this->Scale = largest > 0.0 ? static_cast<double>(bins) / largest : 0.0;
  this->Ends.assign(bins, 0);
  this->Sums.assign(2 * bins, 0);
  this->Values.resize(static_cast<std::size_t>(number));
}

void SkdWeightedValues::AddUpBins()
{
  this->All.AddUp(this->Sums);
  for (std::size_t i = 2; i < this->Sums.size(); ++i)
  {
    this->Sums[i] += this->Sums[i - 2];
  }
  std::size_t first = 0;
  for (std::size_t& end : this->Ends)
  {
    first += std::exchange(end, first);
  }
}

SkdWeightedValues::Search SkdWeightedValues::StartIn(const Query& query) const
{
  const std::size_t kind = query.Weight == &SkdWeightedDistance::Fine ? 0 : 1;
  const std::size_t bins = this->Ends.size();
  const long long most = this->Sums[2 * (bins - 1) + kind];
  const long long part = std::max(1LL, std::min(query.Part, most));
  std::size_t bin = 0;
  std::size_t after = bins - 1;
  while (bin < after)
  {
    const std::size_t middle = (bin + after) / 2;
    if (this->Sums[2 * middle + kind] < part)
    {
      bin = middle + 1;
    }
    else
    {
      after = middle;
    }
  }
  const long long before = bin > 0 ? this->Sums[2 * (bin - 1) + kind] : 0;
  return { { part - before, query.Weight }, bin, 0, ~std::uint64_t(0) };
}

/// Calls visit(key, weight) for the own values of its bin that are within its bounds.
template <class Visit>
void SkdWeightedValues::ForEachIn(const Search& search, const Visit& visit) const
{
  const std::size_t begin = search.Bin > 0 ? this->Ends[search.Bin - 1] : 0;
  for (std::size_t i = begin; i < this->Ends[search.Bin]; ++i)
  {
    const std::uint64_t key = KeyOf(this->Values[i].Value);
    if (search.Low <= key && key <= search.High)
    {
      visit(key, this->Values[i].*search.Wanted.Weight);
    }
  }
}

// The least and the largest value of each bin.
void SkdWeightedValues::FindBounds(std::vector<Search>& searches) const
{
  std::vector<double> bounds;
  for (const Search& search : searches)
  {
    double low = std::numeric_limits<double>::max();
    double high = -1.0;
    this->ForEachIn(search,
      [&](std::uint64_t key, long long)
      {
        low = std::min(low, ValueOf(key));
        high = std::max(high, ValueOf(key));
      });
    bounds.push_back(-low);
    bounds.push_back(high);
  }
  this->All.TakeLargest(bounds);
  for (std::size_t i = 0; i < searches.size(); ++i)
  {
    const bool isEmpty = bounds[2 * i + 1] < 0.0;
    searches[i].Low = isEmpty ? 0 : KeyOf(std::abs(bounds[2 * i]));
    searches[i].High = isEmpty ? 0 : KeyOf(bounds[2 * i + 1]);
  }
}

// Divides the bounds of each into buckets and takes the one that it is in. Returns whether any has
// bounds that differ still.
bool SkdWeightedValues::Narrow(std::vector<Search>& searches) const
{
  std::vector<long long> weights(Buckets * searches.size(), 0);
  for (std::size_t i = 0; i < searches.size(); ++i)
  {
    const Search& search = searches[i];
    const std::uint64_t width = WidthOf(search.Low, search.High);
    this->ForEachIn(search,
      [&](std::uint64_t key, long long weight)
      { weights[Buckets * i + (key - search.Low) / width] += weight; });
  }
  this->All.AddUp(weights);
  bool isWide = false;
  for (std::size_t i = 0; i < searches.size(); ++i)
  {
    Search& search = searches[i];
    const std::uint64_t width = WidthOf(search.Low, search.High);
    const std::uint64_t last = (search.High - search.Low) / width;
    std::uint64_t bucket = 0;
    for (; bucket < last && weights[Buckets * i + bucket] < search.Wanted.Part; ++bucket)
    {
      search.Wanted.Part -= weights[Buckets * i + bucket];
    }
    search.Low += bucket * width;
    search.High = std::min(search.High, search.Low + (width - 1));
    isWide = isWide || search.Low < search.High;
  }
  return isWide;
}

std::vector<double> SkdWeightedValues::Find(const std::vector<Query>& queries) const
{
  std::vector<Search> searches;
  for (const Query& query : queries)
  {
    searches.push_back(this->StartIn(query));
  }
  this->FindBounds(searches);
  while (this->Narrow(searches))
  {
  }
  std::vector<double> values;
  for (const Search& search : searches)
  {
    values.push_back(ValueOf(search.Low));
  }
  return values;
}
}
