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

/// Queries that are not supported.
class Nothing : public Structure
{
public:
  bool Build(vtkDataSet*) override { return false; }
  bool Ask(QueryKind, const Query&, Answer&) override { return false; }
};

struct Series
{
  const char* Name;
  double Factor; // of the size, to that power, are so many cells
  double Power;
  vtkSmartPointer<vtkDataSet> (*Make)(int);
  std::vector<std::string> Works;
};

std::vector<Kind> KindsFor(std::vector<Kind> kinds, double cells)
{
  for (Kind& kind : kinds)
  {
    if (cells > kind.MostCells)
    {
      kind.Make = [] { return std::make_unique<Nothing>(); };
    }
  }
  return kinds;
}

Results MeasureSeries(const Series& series, const std::vector<Kind>& kinds, const Options& options)
{
  Results growth;
  std::copy_if(kinds.begin(), kinds.end(), std::back_inserter(growth.Kinds),
    [](const Kind& kind) { return kind.ForMillions; });
  for (double wanted = 1e4; wanted <= 1.1 * options.GrowthUntil; wanted *= std::sqrt(10.0))
  {
    const double size = std::pow(wanted / series.Factor, 1.0 / series.Power);
    const auto data = series.Make(static_cast<int>(std::lround(size)));
    Touch(data);
    std::vector<Work> works = MakeWorks(data, options.Queries);
    const auto isLeftOut = [&](const Work& work) {
      return std::find(series.Works.begin(), series.Works.end(), work.Name) == series.Works.end();
    };
    works.erase(std::remove_if(works.begin(), works.end(), isLeftOut), works.end());
    const auto number = static_cast<double>(data->GetNumberOfCells());
    growth.Scenes.push_back(
      Measure(series.Name, data, works, KindsFor(growth.Kinds, number), options));
  }
  return growth;
}

}

std::vector<Results> MeasureGrowth(const std::vector<Kind>& kinds, const Options& options)
{
  const Series all[] = {
    { "noisy sphere", 12.0, 2.0, NoisySphere,
      { "closest point, near", "first hit, across the box", "cells in a small box" } },
    { "structured tetrahedra", 6.0, 3.0, TurnedTetrahedra, { "find cell, random in the box" } }
  };
  std::vector<Results> growths;
  for (const Series& series : all)
  {
    if (Passes(series.Name, options.OnlyScene))
    {
      growths.push_back(MeasureSeries(series, kinds, options));
    }
  }
  return growths;
}

}
