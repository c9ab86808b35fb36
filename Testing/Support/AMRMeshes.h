// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AMRMeshes.h
 * @brief an AMR data set of two levels, and what is shown of it
 */
#ifndef skdtest_AMRMeshes_h
#define skdtest_AMRMeshes_h

#include "Support/FilterRun.h"

#include "vtkAMRBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkOverlappingAMR.h"
#include "vtkStructuredData.h"
#include "vtkUniformGrid.h"

#include <array>

namespace skdtest
{

constexpr double HiddenValue = 99.0; // of all that is not shown

/// The cells from `first` to `last` of a lattice, with the array "f", and "c" of cells. Those whose
/// numbers are all below `hidden` are marked as refined.
inline vtkSmartPointer<vtkUniformGrid> MakeAMRBlock(
  const vtkAMRBox& box, const Point& origin, double spacing, int hidden)
{
  int dimensions[3];
  box.GetNumberOfNodes(dimensions);
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->SetDimensions(dimensions);
  grid->SetSpacing(spacing, spacing, spacing);
  const int* low = box.GetLoCorner();
  grid->SetOrigin(
    origin[0] + spacing * low[0], origin[1] + spacing * low[1], origin[2] + spacing * low[2]);
  const auto isRefined = [hidden](const int at[3])
  { return at[0] < hidden && at[1] < hidden && at[2] < hidden; };
  grid->GetPointData()->AddArray(MakeArray("f", grid->GetNumberOfPoints(),
    [&](vtkIdType id)
    {
      int at[3];
      vtkStructuredData::ComputePointStructuredCoords(id, dimensions, at);
      const double* x = grid->GetPoint(id);
      return isRefined(at) ? HiddenValue : Linear({ x[0], x[1], x[2] });
    }));
  Ids refined;
  grid->GetCellData()->AddArray(MakeArray("c", grid->GetNumberOfCells(),
    [&](vtkIdType id)
    {
      int at[3];
      vtkStructuredData::ComputeCellStructuredCoords(id, dimensions, at);
      Bounds bounds;
      grid->GetCellBounds(id, bounds.data());
      if (isRefined(at))
      {
        refined.push_back(id);
      }
      return isRefined(at) ? HiddenValue : Linear(Center(bounds));
    }));
  MarkGhosts(grid, refined, vtkDataSetAttributes::REFINEDCELL);
  return grid;
}

/// A cube of 2.4 from about the origin on, in 4^3 cells, of which 2^3 at the corner are refined:
/// so many of its points are of no cell that is shown.
inline vtkSmartPointer<vtkOverlappingAMR> MakeAMR()
{
  const Point origin{ 0.02, 0.03, 0.01 };
  const double coarse[3] = { 0.6, 0.6, 0.6 };
  const double fine[3] = { 0.3, 0.3, 0.3 };
  const int blocks[2] = { 1, 1 };
  auto amr = vtkSmartPointer<vtkOverlappingAMR>::New();
  amr->Initialize(2, blocks);
  amr->SetGridDescription(VTK_XYZ_GRID);
  amr->SetOrigin(origin.data());
  amr->SetSpacing(0, coarse);
  amr->SetSpacing(1, fine);
  const vtkAMRBox boxes[2] = { vtkAMRBox(0, 0, 0, 3, 3, 3), vtkAMRBox(0, 0, 0, 3, 3, 3) };
  for (unsigned int level = 0; level < 2; ++level)
  {
    amr->SetAMRBox(level, 0, boxes[level]);
    amr->SetDataSet(level, 0,
      MakeAMRBlock(boxes[level], origin, level == 0 ? coarse[0] : fine[0], level == 0 ? 2 : 0));
  }
  return amr;
}

/// The cells of composite data that are not marked as refined or hidden, as one grid, in the same
/// order, with their data; each block has points of its own.
inline GridPointer ShownCellsOf(vtkCompositeDataSet* blocks)
{
  constexpr int hidden = vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
  Mesh mesh;
  std::vector<double> ofPoints;
  std::vector<double> ofCells;
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(blocks->NewIterator());
  vtkNew<vtkIdList> list;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    std::map<vtkIdType, vtkIdType> points;
    for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
    {
      if ((block->GetCellGhostArray()->GetValue(cell) & hidden) != 0)
      {
        continue;
      }
      block->GetCellPoints(cell, list);
      Ids ids;
      for (vtkIdType id : *list)
      {
        const auto [known, isNew] = points.emplace(id, static_cast<vtkIdType>(mesh.Points.size()));
        if (isNew)
        {
          std::array<double, 3> x;
          block->GetPoint(id, x.data());
          mesh.Add(x);
          ofPoints.push_back(block->GetPointData()->GetArray("f")->GetComponent(id, 0));
        }
        ids.push_back(known->second);
      }
      mesh.Add(block->GetCellType(cell), ids);
      ofCells.push_back(block->GetCellData()->GetArray("c")->GetComponent(cell, 0));
    }
  }
  const auto at = [](const std::vector<double>& values)
  { return [&values](vtkIdType i) { return values[static_cast<std::size_t>(i)]; }; };
  GridPointer grid = MakeGrid(mesh);
  grid->GetPointData()->AddArray(MakeArray("f", grid->GetNumberOfPoints(), at(ofPoints)));
  grid->GetCellData()->AddArray(MakeArray("c", grid->GetNumberOfCells(), at(ofCells)));
  return grid;
}

}

#endif
