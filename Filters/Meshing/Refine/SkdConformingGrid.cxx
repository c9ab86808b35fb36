// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridOutput.h"

#include "Meshing/Refine/SkdGridPoints.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkUnstructuredGrid.h"

namespace skdtree
{
namespace
{
/// The points around a leaf of a flat grid, hanging ones too.
class LeafOutlines
{
public:
  LeafOutlines(const SkdGrid& grid, const SkdGridPoints& points)
    : Grid(grid)
    , Points(points)
    , U(grid.Lattice.IsFlat(0) ? 1 : 0)
    , V(grid.Lattice.IsFlat(2) ? 1 : 2)
  {
  }

  std::vector<vtkIdType> Of(const SkdGridCell& leaf) const
  {
    const skd::LatticePoint position = this->Grid.Forest.LatticePointOf(leaf.Level, leaf.Index);
    const unsigned u = 1u << this->U;
    const unsigned v = 1u << this->V;
    const unsigned corners[5] = { 0, u, u | v, v, 0 };
    std::vector<vtkIdType> outline;
    for (int side = 0; side < 4; ++side)
    {
      const skd::LatticePoint from = this->Points.CornerOf(leaf.Level, position, corners[side]);
      outline.push_back(this->Points.FindId(from));
      this->AddBetween(
        from, this->Points.CornerOf(leaf.Level, position, corners[side + 1]), outline);
    }
    return outline;
  }

private:
  /// Where a neighbour is finer it has points where a refined cell is cut, and
  /// perhaps between these.
  void AddBetween(const skd::LatticePoint& from, const skd::LatticePoint& to,
    std::vector<vtkIdType>& outline) const
  {
    const int axis = from[this->U] != to[this->U] ? this->U : this->V;
    const std::int64_t parts = this->Grid.Lattice.GetBranch()[axis];
    const std::int64_t step = (to[axis] - from[axis]) / parts;
    skd::LatticePoint cut = from;
    cut[axis] += step;
    if (step == 0 || this->Points.FindId(cut) < 0)
    {
      return;
    }
    skd::LatticePoint last = from;
    for (std::int64_t part = 1; part <= parts; ++part, cut[axis] += step)
    {
      this->AddBetween(last, cut, outline);
      if (part < parts)
      {
        outline.push_back(this->Points.FindId(cut));
      }
      last = cut;
    }
  }

  const SkdGrid& Grid;
  const SkdGridPoints& Points;
  const int U;
  const int V;
};

void AddCorners(const SkdGrid& grid, const std::vector<SkdGridCell>& leaves, SkdGridPoints& points)
{
  const std::vector<unsigned> corners = points.Corners();
  for (const SkdGridCell& leaf : leaves)
  {
    const skd::LatticePoint position = grid.Forest.LatticePointOf(leaf.Level, leaf.Index);
    for (const unsigned corner : corners)
    {
      points.IdOf(points.CornerOf(leaf.Level, position, corner));
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<SkdGridCell> SkdMakeConformingGrid(const SkdGrid& grid, vtkUnstructuredGrid* output)
{
  const std::vector<SkdGridCell> leaves = grid.Leaves();
  SkdGridPoints points(grid);
  AddCorners(grid, leaves, points);
  const LeafOutlines outlines(grid, points);
  const vtkSmartPointer<vtkPoints> all = points.MakePoints();
  std::vector<SkdGridCell> leafOfCell;
  output->Initialize();
  output->SetPoints(all);
  output->Allocate(static_cast<vtkIdType>(leaves.size()));
  for (const SkdGridCell& leaf : leaves)
  {
    const std::vector<vtkIdType> outline = outlines.Of(leaf);
    if (outline.size() == 4)
    {
      output->InsertNextCell(VTK_QUAD, 4, outline.data());
      leafOfCell.push_back(leaf);
      continue;
    }
    const vtkIdType middle = all->InsertNextPoint(grid.BoxOf(leaf.Level, leaf.Index).Centroid().X);
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const vtkIdType triangle[3] = { outline[i], outline[(i + 1) % outline.size()], middle };
      output->InsertNextCell(VTK_TRIANGLE, 3, triangle);
      leafOfCell.push_back(leaf);
    }
  }
  return leafOfCell;
}
}
