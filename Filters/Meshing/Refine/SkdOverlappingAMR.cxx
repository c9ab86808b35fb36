// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridOutput.h"

#include "Core/Meshing/Grid/LatticeBlocks.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkAMRBox.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkOverlappingAMR.h"
#include "vtkSkdTreeVersion.h"
#include "vtkStructuredData.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// How far planes may be from uniform spacing: relative to their coordinates (two units in the last
/// place), and to the size of cells.
constexpr double CoordinateRounding = 4e-16;
constexpr double SpacingRounding = 1e-12;

double SizeOfBaseCells(const skd::Lattice& lattice, int axis)
{
  const std::vector<double>& planes = lattice.GetPlanes(axis);
  return lattice.IsFlat(axis)
    ? 1.0 // any length but 0 does
    : (planes.back() - planes.front()) / static_cast<double>(planes.size() - 1);
}

skd::Vector3 SpacingOf(const skd::Lattice& lattice, int level)
{
  skd::Vector3 spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] =
      SizeOfBaseCells(lattice, axis) / static_cast<double>(lattice.CellsAcross(level, axis));
  }
  return spacing;
}

std::vector<skd::LatticeBlock> BlocksOf(const SkdGrid& grid, int level)
{
  if (level == 0)
  {
    const skd::Lattice& lattice = grid.Lattice;
    return { { { 0, 0, 0 },
      { lattice.NumberOfBaseCells(0), lattice.NumberOfBaseCells(1),
        lattice.NumberOfBaseCells(2) } } };
  }
  const std::uint32_t family = grid.Forest.FamilySize();
  std::vector<skd::LatticePoint> parents;
  for (std::uint32_t cell = 0; cell < grid.Forest.NumberOfCells(level); cell += family)
  {
    parents.push_back(grid.Forest.LatticePointOf(level - 1, grid.Forest.Parent(level, cell)));
  }
  std::vector<skd::LatticeBlock> ranges = skd::JoinIntoBlocks(parents);
  for (skd::LatticeBlock& range : ranges)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      range.Low[axis] *= grid.Lattice.GetBranch()[axis];
      range.High[axis] *= grid.Lattice.GetBranch()[axis];
    }
  }
  return ranges;
}

vtkAMRBox BoxOf(const skd::LatticeBlock& range, const skd::Lattice& lattice)
{
  int low[3];
  int high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = static_cast<int>(range.Low[axis]);
    high[axis] = static_cast<int>(range.High[axis]) - (lattice.IsFlat(axis) ? 2 : 1);
  }
  return vtkAMRBox(low, high); // along an axis without cells, high is low - 1
}

std::vector<SkdGridCell> CellsOf(const skd::LatticeBlock& range, const SkdGrid& grid, int level)
{
  std::vector<SkdGridCell> cells;
  cells.reserve(static_cast<std::size_t>(range.NumberOfPoints()));
  skd::LatticePoint position;
  for (position[2] = range.Low[2]; position[2] < range.High[2]; ++position[2])
  {
    for (position[1] = range.Low[1]; position[1] < range.High[1]; ++position[1])
    {
      for (position[0] = range.Low[0]; position[0] < range.High[0]; ++position[0])
      {
        cells.push_back({ level, grid.Forest.Find(level, position).Index });
      }
    }
  }
  return cells;
}

void MarkRefined(const SkdGridBlock& block, const SkdGrid& grid)
{
  auto marks = SkdMakeArray<vtkUnsignedCharArray>(
    vtkDataSetAttributes::GhostArrayName(), 1, static_cast<vtkIdType>(block.Cells.size()));
  for (std::size_t i = 0; i < block.Cells.size(); ++i)
  {
    const bool isLeaf = grid.Forest.IsLeaf(block.Cells[i].Level, block.Cells[i].Index);
    marks->SetValue(static_cast<vtkIdType>(i),
      isLeaf ? 0 : static_cast<unsigned char>(vtkDataSetAttributes::REFINEDCELL));
  }
  block.Grid->GetCellData()->AddArray(marks);
}

vtkSmartPointer<vtkUniformGrid> MakeMesh(
  const skd::LatticeBlock& range, const skd::Lattice& lattice, int level)
{
  int dimensions[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t cells = lattice.IsFlat(axis) ? 0 : range.High[axis] - range.Low[axis];
    dimensions[axis] = static_cast<int>(cells) + 1;
  }
  auto mesh = vtkSmartPointer<vtkUniformGrid>::New();
  mesh->SetOrigin(lattice.PointOf(level, range.Low).X);
  mesh->SetSpacing(SpacingOf(lattice, level).X);
  mesh->SetDimensions(dimensions);
  return mesh;
}

SkdGridBlock MakeBlock(const skd::LatticeBlock& range, const SkdGrid& grid, int level)
{
  SkdGridBlock block{ MakeMesh(range, grid.Lattice, level), CellsOf(range, grid, level) };
  MarkRefined(block, grid);
  return block;
}

void SetLevels(const SkdGrid& grid, const std::vector<std::vector<skd::LatticeBlock>>& ranges,
  vtkOverlappingAMR* output)
{
#if VTK_SKD_AMR_TAKES_VECTOR
  std::vector<unsigned int> blocks;
#else
  std::vector<int> blocks;
#endif
  for (const auto& level : ranges)
  {
    blocks.push_back(static_cast<decltype(blocks)::value_type>(level.size()));
  }
#if VTK_SKD_AMR_TAKES_VECTOR
  output->Initialize(blocks);
#else
  output->Initialize(static_cast<int>(blocks.size()), blocks.data());
#endif
  int dimensions[3];
  MakeMesh(ranges[0][0], grid.Lattice, 0)->GetDimensions(dimensions);
  output->SetGridDescription(vtkStructuredData::GetDataDescription(dimensions));
  const auto& branch = grid.Lattice.GetBranch();
  output->SetOrigin(grid.Lattice.PointOf(0, { 0, 0, 0 }).X);
  for (unsigned int level = 0; level < ranges.size(); ++level)
  {
    output->SetSpacing(level, SpacingOf(grid.Lattice, static_cast<int>(level)).X);
    output->SetRefinementRatio(level, *std::max_element(branch.begin(), branch.end()));
  }
}
}

//------------------------------------------------------------------------------
bool SkdIsUniform(const skd::Lattice& lattice)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& planes = lattice.GetPlanes(axis);
    const double size = SizeOfBaseCells(lattice, axis);
    const double rounding =
      CoordinateRounding * (std::abs(planes.front()) + std::abs(planes.back())) +
      SpacingRounding * size;
    for (std::size_t i = 1; i + 1 < planes.size(); ++i)
    {
      if (!(std::abs(planes[i] - (planes.front() + static_cast<double>(i) * size)) <= rounding))
      {
        return false;
      }
    }
  }
  return lattice.Dimension() >= 2;
}

std::vector<SkdGridBlock> SkdMakeOverlappingAMR(const SkdGrid& grid, vtkOverlappingAMR* output)
{
  std::vector<std::vector<skd::LatticeBlock>> ranges;
  for (int level = 0; level < grid.Forest.NumberOfLevels(); ++level)
  {
    ranges.push_back(BlocksOf(grid, level));
  }
  SetLevels(grid, ranges, output);
  std::vector<SkdGridBlock> blocks;
  int number = 0;
  for (unsigned int level = 0; level < ranges.size(); ++level)
  {
    for (unsigned int i = 0; i < ranges[level].size(); ++i)
    {
      const skd::LatticeBlock& range = ranges[level][i];
      output->SetAMRBox(level, i, BoxOf(range, grid.Lattice));
      if (number++ % grid.Pieces == grid.Piece)
      {
        blocks.push_back(MakeBlock(range, grid, static_cast<int>(level)));
        output->SetDataSet(level, i, blocks.back().Grid);
      }
    }
  }
  output->GenerateParentChildInformation();
  return blocks;
}
}
