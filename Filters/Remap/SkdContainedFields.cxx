// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdContainedFields.h"

#include "Remap/SkdNearestSamples.h"
#include "vtkMath.h"

namespace skdtree
{
namespace
{
/// The results of one field.
class FieldMapper
{
public:
  FieldMapper(const SkdContainedMean& samples, const SkdDonorField& field, SkdStatistic statistic,
    SkdEmptyCells empty, std::vector<double>& values)
    : Samples(samples)
    , Field(field)
    , Statistic(statistic)
    , Empty(empty)
    , Values(values)
  {
  }

  void Map(
    const SkdTargetCells::Cell& cell, vtkIdType id, const std::vector<std::uint32_t>& points) const
  {
    thread_local std::vector<std::uint32_t> counted; // keep their memory
    thread_local std::vector<SkdWeightedValue> values;
    const auto counts = [this](std::uint32_t i) { return this->Field.Counts[i] != 0; };
    counted.clear();
    std::copy_if(points.begin(), points.end(), std::back_inserter(counted), counts);
    const auto n = static_cast<std::size_t>(this->Field.Components);
    double* tuple = this->Values.data() + static_cast<std::size_t>(id) * n;
    if (counted.empty() && this->Statistic == SkdStatistic::Sum)
    {
      std::fill(tuple, tuple + n, 0.0);
      return;
    }
    if (counted.empty())
    {
      this->Samples.FindSubstitutes(cell, this->Empty, counts, counted);
    }
    for (std::size_t c = 0; c < n && !counted.empty(); ++c)
    {
      values.clear();
      for (const std::uint32_t i : counted)
      {
        values.push_back({ this->Field.Get(i, static_cast<int>(c)), this->Samples.GetWeight(i) });
      }
      tuple[c] = SkdStatisticOf(this->Statistic, values);
    }
  }

private:
  const SkdContainedMean& Samples;
  const SkdDonorField& Field;
  SkdStatistic Statistic;
  SkdEmptyCells Empty;
  std::vector<double>& Values;
};
}

SkdContainedResult SkdMapContained(const SkdContainedMean& samples,
  const std::vector<SkdDonorField>& fields, const SkdTargetCells& cells, SkdStatistic statistic,
  SkdEmptyCells empty, SkdLoop& loop)
{
  const auto n = static_cast<std::size_t>(cells.GetNumberOfCells());
  SkdContainedResult result;
  result.Counts.assign(n, 0);
  result.Values.resize(fields.size());
  std::vector<FieldMapper> mappers;
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    result.Values[f].assign(n * static_cast<std::size_t>(fields[f].Components), vtkMath::Nan());
    mappers.emplace_back(samples, fields[f], statistic, empty, result.Values[f]);
  }
  samples.ForEachCell(cells, loop,
    [&](const SkdTargetCells::Cell& cell, vtkIdType id, const std::vector<std::uint32_t>& points)
    {
      result.Counts[static_cast<std::size_t>(id)] = static_cast<vtkIdType>(points.size());
      for (const FieldMapper& mapper : mappers)
      {
        mapper.Map(cell, id, points);
      }
    });
  return result;
}
}
