// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdExtrapolation.h"

#include "Cells/Read/SkdForEach.h"
#include "Remap/SkdNearestSamples.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// The mean of samples; the value of one that is where it is wanted.
void TakeMean(
  const std::vector<SkdSampleTree::Near>& samples, const SkdDonorField& field, double* tuple)
{
  const bool isThere = !samples.empty() && samples.front().Distance2 == 0.0;
  double sum = 0.0;
  for (const SkdSampleTree::Near& sample : samples)
  {
    sum += isThere ? 1.0 : samples.front().Distance2 / sample.Distance2;
  }
  for (int c = 0; c < field.Components && !samples.empty(); ++c)
  {
    const double first = field.Get(samples.front().Id, c);
    double more = 0.0; // relative to the nearest, so that constants stay
    for (const SkdSampleTree::Near& sample : samples)
    {
      const double weight = isThere ? 0.0 : samples.front().Distance2 / sample.Distance2;
      more += weight * (field.Get(sample.Id, c) - first);
    }
    tuple[c] = first + more / sum;
  }
}
}

void SkdExtrapolate(const SkdExtrapolationRules& rules, const SkdSampleTree& samples,
  const SkdDonorField& field, const std::vector<skd::Vector3>& positions,
  const std::vector<unsigned char>& isWanted, std::vector<double>& values)
{
  const auto components = static_cast<std::size_t>(field.Components);
  const auto counts = [&](std::uint32_t i)
  {
    const double* tuple = field.Tuple(i);
    return field.Counts[i] != 0 &&
      std::none_of(tuple, tuple + components, [](double value) { return std::isnan(value); });
  };
  const bool isOfOne = rules.Method == SkdExtrapolationMethod::Nearest;
  SkdForEach(positions.size(),
    [&](std::size_t at)
    {
      double* tuple = values.data() + at * components;
      if (isWanted[at] == 0)
      {
        return;
      }
      if (rules.Method == SkdExtrapolationMethod::Constant)
      {
        std::fill_n(tuple, components, rules.Constant);
        return;
      }
      thread_local std::vector<SkdSampleTree::Near> near; // keeps its memory
      samples.FindNearest(positions[at], isOfOne ? 1 : rules.Neighbours, counts, near);
      TakeMean(near, field, tuple);
    });
}
}
