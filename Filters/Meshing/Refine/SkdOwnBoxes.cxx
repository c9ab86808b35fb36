// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdOwnBoxes.h"

#include "Core/Meshing/Grid/Balance.h"
#include "Pipeline/SkdMakeMesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace skdtree
{
namespace
{
/// The boxes of rows of neighbours along the first axis.
std::vector<skd::Box3> RowsOf(const SkdGrid& grid, const std::vector<char>& marks)
{
  std::vector<skd::Box3> rows;
  bool isGoing = false;
  const auto along = static_cast<std::uint32_t>(grid.Lattice.NumberOfBaseCells(0));
  for (std::uint32_t cell = 0; cell < marks.size(); ++cell)
  {
    isGoing = isGoing && cell % along != 0;
    if (marks[cell] && !isGoing)
    {
      rows.emplace_back();
    }
    if (marks[cell])
    {
      rows.back().Add(grid.BoxOf(0, cell));
    }
    isGoing = marks[cell] != 0;
  }
  return rows;
}

bool AreThose(vtkPolyData* boxes, const std::vector<skd::Box3>& rows)
{
  bool areThose = boxes->GetNumberOfPoints() == static_cast<vtkIdType>(2 * rows.size());
  for (std::size_t i = 0; areThose && i < rows.size(); ++i)
  {
    const auto first = static_cast<vtkIdType>(2 * i);
    areThose = std::equal(rows[i].Min.X, rows[i].Min.X + 3, boxes->GetPoint(first)) &&
      std::equal(rows[i].Max.X, rows[i].Max.X + 3, boxes->GetPoint(first + 1));
  }
  return areThose;
}
}

void SkdUpdateOwnBoxes(const SkdGrid& grid, int layers, vtkSmartPointer<vtkPolyData>& boxes)
{
  std::vector<char> marks(grid.Forest.NumberOfCells(0), 0);
  std::fill(marks.begin() + grid.FirstOwn, marks.begin() + grid.LastOwn, 1);
  const std::vector<skd::Box3> rows = RowsOf(grid, skd::Grown(grid.Forest, 0, marks, layers));
  if (boxes && AreThose(boxes, rows))
  {
    return;
  }
  std::vector<std::array<vtkIdType, 2>> lines;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto first = static_cast<vtkIdType>(2 * i);
    lines.push_back({ first, first + 1 });
  }
  boxes = vtkSmartPointer<vtkPolyData>::New();
  boxes->SetPoints(SkdMakePoints(
    static_cast<vtkIdType>(2 * rows.size()), [&rows](vtkIdType i) -> const auto& {
      const skd::Box3& box = rows[static_cast<std::size_t>(i / 2)];
      return i % 2 == 0 ? box.Min : box.Max;
    }));
  boxes->SetLines(SkdMakeCells(
    2, lines, [](const std::array<vtkIdType, 2>& ids) -> const auto& { return ids; }));
}
}
