// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdLumpedPoints.h"

#include "Cells/Read/SkdCellReader.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <cmath>

namespace skdtree
{
std::vector<double> SkdLumpToPoints(vtkDataSet* mesh, const std::vector<double>& values,
  int components, const std::vector<double>& measures)
{
  const auto n = static_cast<std::size_t>(components);
  std::vector<double> sums(static_cast<std::size_t>(mesh->GetNumberOfPoints()) * n, 0.0);
  std::vector<double> masses(sums.size(), 0.0);
  const SkdCellReader reader(mesh);
  vtkNew<vtkIdList> list;
  reader.VisitCells(0, mesh->GetNumberOfCells(), list,
    [&](vtkIdType cell, const auto* ids, std::size_t size)
    {
      const double* tuple = values.data() + static_cast<std::size_t>(cell) * n;
      const double share = measures[static_cast<std::size_t>(cell)] / static_cast<double>(size);
      for (std::size_t k = 0; k < size * n && share > 0.0; ++k)
      {
        const double value = tuple[k % n];
        const std::size_t at = static_cast<std::size_t>(ids[k / n]) * n + k % n;
        masses[at] += std::isnan(value) ? 0.0 : share;
        sums[at] += std::isnan(value) ? 0.0 : share * value;
      }
    });
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    sums[i] = masses[i] > 0.0 ? sums[i] / masses[i] : vtkMath::Nan();
  }
  return sums;
}
}
