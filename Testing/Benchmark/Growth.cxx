// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Growth.h"

#include "Works.h"

#include <algorithm>
#include <cmath>

namespace skdbench
{
namespace
{

/// The few works that are shown against the number of cells.
std::vector<Work> GrowthWorks(vtkDataSet* data, int count)
{
  std::vector<Work> works = MakeWorks(data, count);
  const auto isLeftOut = [](const Work& work)
  {
    return work.Name != "closest point, near" && work.Name != "first hit, across the box" &&
      work.Name != "cells in a small box";
  };
  works.erase(std::remove_if(works.begin(), works.end(), isLeftOut), works.end());
  return works;
}

}

Results MeasureGrowth(const std::vector<Kind>& kinds, const Options& options)
{
  Results growth;
  std::copy_if(kinds.begin(), kinds.end(), std::back_inserter(growth.Kinds),
    [](const Kind& kind) { return kind.ForMillions; });
  for (double wanted = 1e4; wanted <= 1.01 * options.GrowthUntil; wanted *= std::sqrt(10.0))
  {
    const auto data = NoisySphere(static_cast<int>(std::lround(std::sqrt(wanted / 12))));
    Touch(data);
    const std::vector<Work> works = GrowthWorks(data, options.Queries);
    growth.Scenes.push_back(Measure("noisy sphere", data, works, growth.Kinds, options));
  }
  return growth;
}

}
