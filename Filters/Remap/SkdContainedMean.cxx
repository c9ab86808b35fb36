// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdContainedMean.h"

#include "Remap/SkdNearestSamples.h"
#include "vtkMath.h"

#include <cmath>
#include <utility>

namespace skdtree
{
SkdContainedMean::SkdContainedMean(
  std::vector<skd::Vector3> points, std::vector<double> weights, bool isOnSphere)
  : Tree(std::move(points), isOnSphere)
  , Weights(std::move(weights))
{
}

void SkdContainedMean::FindContained(
  const SkdTargetCells::Cell& cell, std::vector<std::uint32_t>& points) const
{
  this->Tree.FindWithin(cell.GetBox(), points);
  const auto isBeyond = [&](std::uint32_t i) { return !cell.Contains(this->Tree.GetPoint(i)); };
  points.erase(std::remove_if(points.begin(), points.end(), isBeyond), points.end());
  std::sort(points.begin(), points.end());
}

std::vector<double> SkdContainedMean::GetMeans(const SkdTargetCells& cells,
  const std::vector<double>& values, SkdEmptyCells empty, SkdLoop& loop) const
{
  std::vector<double> means(static_cast<std::size_t>(cells.GetNumberOfCells()), vtkMath::Nan());
  const auto hasValue = [&](std::uint32_t i) { return !std::isnan(values[i]); };
  this->ForEachCell(cells, loop,
    [&](const SkdTargetCells::Cell& cell, vtkIdType id, std::vector<std::uint32_t>& points)
    {
      points.erase(
        std::remove_if(points.begin(), points.end(), [&](std::uint32_t i) { return !hasValue(i); }),
        points.end());
      if (points.empty())
      {
        this->FindSubstitutes(cell, empty, hasValue, points);
      }
      thread_local std::vector<SkdWeightedValue> samples; // keeps its memory
      samples.clear();
      for (const std::uint32_t i : points)
      {
        samples.push_back({ values[i], this->GetWeight(i) });
      }
      if (!samples.empty())
      {
        means[static_cast<std::size_t>(id)] = SkdStatisticOf(SkdStatistic::Mean, samples);
      }
    });
  return means;
}
}
