// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWeightedValues.h
 * @brief Quantiles of values with weights, of which several processes have some each.
 *
 * No process gets the values of another: they are counted in bins, then in ever narrower ones
 * around what is looked for. Weights are integers, so that no order of adding them matters.
 */

#ifndef SkdWeightedValues_h
#define SkdWeightedValues_h

#include "Core/Search/Tree/RawVector.h"
#include "Search/Compare/SkdReduction.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skdtree
{
/// A value that is not negative, with two weights; the sums of each of all are below 2^63.
struct SkdWeightedDistance
{
  double Value;
  long long Fine;
  long long Coarse;
};

class SkdWeightedValues
{
public:
  /// forEach(visit) calls visit(SkdWeightedDistance) for each value that this process has; it is
  /// called three times, and must give the same each time. O(n). All processes must call it
  /// together, and Find(), too.
  template <class ForEach>
  SkdWeightedValues(const ForEach& forEach, const SkdReduction& all)
    : All(all)
  {
    long long number = 0;
    double largest = 0.0;
    forEach(
      [&](const SkdWeightedDistance& value)
      {
        ++number;
        largest = std::max(largest, value.Value);
      });
    this->MakeBins(number, largest);
    forEach([this](const SkdWeightedDistance& value) { this->Count(value); });
    this->AddUpBins();
    forEach([this](const SkdWeightedDistance& value)
      { this->Values[this->Ends[this->BinOf(value.Value)]++] = value; });
  }

  /// Which quantile: the least value up to which the weights of all add up to a part. At least 1 of
  /// it is looked for, and at most all.
  struct Query
  {
    long long Part;
    long long SkdWeightedDistance::*Weight;
  };

  /// The values of some queries; 0 if there are no values.
  std::vector<double> Find(const std::vector<Query>& queries) const;

private:
  /// A quantile as far as it is known: its bin, bounds of it, and its part of what is between them.
  struct Search
  {
    Query Wanted;
    std::size_t Bin;
    std::uint64_t Low;
    std::uint64_t High;
  };

  std::size_t BinOf(double value) const
  {
    return static_cast<std::size_t>(
      std::min(this->Scale * value, static_cast<double>(this->Ends.size() - 1)));
  }
  void MakeBins(long long number, double largest);
  void Count(const SkdWeightedDistance& value)
  {
    const std::size_t bin = this->BinOf(value.Value);
    ++this->Ends[bin];
    this->Sums[2 * bin] += value.Fine;
    this->Sums[2 * bin + 1] += value.Coarse;
  }
  void AddUpBins();
  Search StartIn(const Query& query) const;
  void FindBounds(std::vector<Search>& searches) const;
  bool Narrow(std::vector<Search>& searches) const;
  template <class Visit>
  void ForEachIn(const Search& search, const Visit& visit) const;

  const SkdReduction& All;
  double Scale = 0.0;
  skd::RawVector<SkdWeightedDistance> Values; // own, bin after bin
  std::vector<std::size_t> Ends;
  std::vector<long long> Sums; // of all, both weights of each bin and those before
};
}

#endif
