// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSampleStatistic_h
#define SkdSampleStatistic_h

#include <vector>

namespace skdtree
{
/// What is made of the samples of a cell.
enum class SkdStatistic
{
  Mean,
  Minimum,
  Maximum,
  Sum,               ///< of values, whatever they weigh
  StandardDeviation, ///< of all that there are, not an estimate: 0 of one sample
  Median             ///< the weights up to it are half of all; between two, their mean
};

struct SkdWeightedValue
{
  double Value;
  double Weight; ///< positive
};

/// At least one sample. What is summed is summed in the order given; equal values have their own
/// value as their mean, to the last bit. A median sorts them.
double SkdStatisticOf(SkdStatistic statistic, std::vector<SkdWeightedValue>& samples);
}

#endif
