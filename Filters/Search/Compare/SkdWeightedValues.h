// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWeightedValues.h
 * @brief Quantiles of values with weights, of which several processes have some each.
 *
 * Few values all processes get: then nothing more is told, for each message takes its time. Of many
 * no process gets those of another: they are counted in bins, then in ever narrower ones around
 * what is looked for. Weights are integers, so that no order of adding them matters.
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
    const Extent own(forEach);
    const std::vector<double> numbers = all.Gather({ static_cast<double>(own.Number) });
    if (!AreFew(numbers))
    {
      this->Fill(forEach, own);
      return;
    }
    std::vector<SkdWeightedDistance> values;
    forEach([&values](const SkdWeightedDistance& value) { values.push_back(value); });
    this->GatherAll(numbers, values);
    const auto forEachOfAll = [&values](const auto& visit)
    { std::for_each(values.begin(), values.end(), visit); };
    this->Fill(forEachOfAll, Extent(forEachOfAll));
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

  /// How many values there are, and the largest.
  struct Extent
  {
    template <class ForEach>
    explicit Extent(const ForEach& forEach)
    {
      forEach(
        [this](const SkdWeightedDistance& value)
        {
          ++this->Number;
          this->Largest = std::max(this->Largest, value.Value);
        });
    }

    long long Number = 0;
    double Largest = 0.0;
  };

  template <class ForEach>
  void Fill(const ForEach& forEach, const Extent& own)
  {
    this->MakeBins(own.Number, own.Largest);
    forEach([this](const SkdWeightedDistance& value) { this->Count(value); });
    this->AddUpBins();
    forEach([this](const SkdWeightedDistance& value)
      { this->Values[this->Ends[this->BinOf(value.Value)]++] = value; });
  }

  /// Whether all of several processes may have the values of all; their number by process.
  static bool AreFew(const std::vector<double>& numbers);

  /// To the own values those of the others, which need not be asked any more.
  void GatherAll(const std::vector<double>& numbers, std::vector<SkdWeightedDistance>& values);

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

  SkdReduction All;
  double Scale = 0.0;
  skd::RawVector<SkdWeightedDistance> Values; // own, or few of all, bin after bin
  std::vector<std::size_t> Ends;
  std::vector<long long> Sums; // of all, both weights of each bin and those before
};
}

#endif
