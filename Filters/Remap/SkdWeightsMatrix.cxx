// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdWeightsMatrix.h"

#include "Pipeline/SkdLonLat.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <utility>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// The integral of (x - centroid) along the parallel and along the meridian, of the unit sphere.
std::array<double, 2> AlongAxes(const Vector3& moment, const Vector3& centroid)
{
  const SkdLonLatAxes axes = SkdLonLatAxesAt(centroid);
  return { Dot(moment, axes.East), Dot(moment, axes.North) };
}
}

void SkdWeightsMatrix::Resize(std::size_t entries)
{
  this->Rows.resize(entries);
  this->Columns.resize(entries);
  this->Measures.resize(entries);
  this->Weights.resize(entries * this->WeightsPerEntry);
}

void SkdWeightsMatrix::Sort()
{
  std::vector<std::size_t> order(this->Size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [this](std::size_t a, std::size_t b) {
      return std::tie(this->Rows[a], this->Columns[a]) < std::tie(this->Rows[b], this->Columns[b]);
    });
  SkdWeightsMatrix sorted;
  sorted.WeightsPerEntry = this->WeightsPerEntry;
  sorted.Resize(this->Size());
  Numbers entry;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    entry.clear();
    this->TransferEntry(order[i], [&entry](const auto& number) { entry.push_back(number); });
    std::size_t at = 0;
    sorted.TransferEntry(
      i, [&](auto& number) { number = static_cast<std::decay_t<decltype(number)>>(entry[at++]); });
  }
  *this = std::move(sorted);
}

void SkdWeightsMatrix::Add(
  const SkdOverlapWeights& weights, SkdNormalization normalization, std::size_t firstRow)
{
  const SkdOverlapTable& table = weights.GetTable();
  const SkdOverlapCells& target = weights.GetTarget();
  for (std::size_t row = 0; row + 1 < table.Rows.size(); ++row)
  {
    const double by =
      normalization == SkdNormalization::Whole ? target.Measures[row] : target.Covered[row];
    for (std::size_t k = table.Rows[row]; k < table.Rows[row + 1]; ++k)
    {
      const auto column = static_cast<std::size_t>(table.Columns[k]);
      this->Rows.push_back(static_cast<int>(firstRow + row + 1));
      this->Columns.push_back(static_cast<int>(column + 1));
      this->Weights.push_back(table.Measures[k] / by);
      if (this->WithMeasures)
      {
        this->Measures.push_back(table.Measures[k]);
      }
      if (this->WeightsPerEntry == 3)
      {
        const auto [east, north] =
          AlongAxes(table.Moments[k], weights.GetDonor().Centroids[column]);
        this->Weights.push_back(north / (weights.GetRadius() * by));
        this->Weights.push_back(east / (weights.GetRadius() * by));
      }
    }
  }
}
}
