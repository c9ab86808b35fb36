// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridFields.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"

#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
SkdGridField TakeLeaves(
  const SkdGrid& grid, const std::vector<SkdGridCell>& leaves, vtkDoubleArray* array)
{
  SkdGridField field{ array->GetName(), array->GetNumberOfComponents(), {} };
  for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
  {
    field.Values.emplace_back(
      grid.Forest.NumberOfCells(level) * static_cast<std::size_t>(field.Components),
      std::numeric_limits<double>::quiet_NaN());
  }
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    std::vector<double>& row = field.Values[static_cast<std::size_t>(leaves[i].Level)];
    for (int c = 0; c < field.Components; ++c)
    {
      row[leaves[i].Index * static_cast<std::size_t>(field.Components) +
        static_cast<std::size_t>(c)] = array->GetComponent(static_cast<vtkIdType>(i), c);
    }
  }
  return field;
}

/// The mean of the children of a cell, all of which have the same measure.
class FamilyMean
{
public:
  FamilyMean(const SkdGrid& grid, const SkdGridField* weights)
    : Grid(grid)
    , Weights(weights)
  {
  }

  double Find(const SkdGridField& field, int level, std::uint32_t cell, int component) const
  {
    double sum = 0.0, weights = 0.0;
    const std::uint32_t first = this->Grid.Forest.FirstChild(level, cell);
    for (std::uint32_t k = 0; k < this->Grid.Forest.FamilySize(); ++k)
    {
      const auto child = static_cast<std::size_t>(first + k);
      const double value = field.Values[static_cast<std::size_t>(level) + 1]
                                       [child * static_cast<std::size_t>(field.Components) +
                                         static_cast<std::size_t>(component)];
      const double weight =
        this->Weights ? this->Weights->Values[static_cast<std::size_t>(level) + 1][child] : 1.0;
      const bool counts = weight > 0.0 && !std::isnan(value);
      sum += counts ? weight * value : 0.0;
      weights += counts ? weight : 0.0;
    }
    return weights > 0.0 ? sum / weights : std::numeric_limits<double>::quiet_NaN();
  }

private:
  const SkdGrid& Grid;
  const SkdGridField* Weights; // nullptr: all count alike
};

void FillRefined(const SkdGrid& grid, const SkdGridField* weights, SkdGridField& field)
{
  const FamilyMean mean(grid, weights);
  for (int level = grid.Forest.NumberOfLevels() - 2; level >= 0; --level)
  {
    for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); ++cell)
    {
      for (int c = 0; !grid.Forest.IsLeaf(level, cell) && c < field.Components; ++c)
      {
        field.Values[static_cast<std::size_t>(
          level)][cell * static_cast<std::size_t>(field.Components) + static_cast<std::size_t>(c)] =
          mean.Find(field, level, cell, c);
      }
    }
  }
}
}

std::vector<SkdGridField> SkdSpreadFields(const SkdGrid& grid,
  const std::vector<SkdGridCell>& leaves, vtkCellData* ofLeaves, const char* coverage)
{
  std::vector<SkdGridField> fields;
  auto* covered = vtkDoubleArray::SafeDownCast(ofLeaves->GetArray(coverage));
  if (!covered)
  {
    return fields; // nothing was mapped
  }
  fields.push_back(TakeLeaves(grid, leaves, covered));
  FillRefined(grid, nullptr, fields.front());
  for (int i = 0; i < ofLeaves->GetNumberOfArrays(); ++i)
  {
    auto* array = vtkDoubleArray::SafeDownCast(ofLeaves->GetAbstractArray(i));
    if (array && array != covered)
    {
      SkdGridField field = TakeLeaves(grid, leaves, array);
      FillRefined(grid, &fields.front(), field);
      fields.push_back(std::move(field));
    }
  }
  return fields;
}
}
