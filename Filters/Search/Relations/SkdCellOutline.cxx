// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Relations/SkdCellOutline.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkPoints.h"

#include <algorithm>

namespace skdtree
{
//------------------------------------------------------------------------------
SkdCellOutline::SkdCellOutline(vtkCell* cell)
  : Dimension(cell->GetCellDimension())
  , Points(static_cast<std::size_t>(cell->GetNumberOfPoints()))
{
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    cell->GetPoints()->GetPoint(static_cast<vtkIdType>(i), this->Points[i].X);
  }
  for (int i = 0; this->Dimension > 1 && i < cell->GetNumberOfEdges(); ++i)
  {
    this->AddPart(this->Edges, cell->GetEdge(i), cell);
  }
  for (int i = 0; this->Dimension > 2 && i < cell->GetNumberOfFaces(); ++i)
  {
    this->AddPart(this->Faces, cell->GetFace(i), cell);
  }
  if (this->Dimension == 2)
  {
    this->AddPart(this->Faces, cell, cell);
  }
  if (cell->GetCellType() == VTK_POLY_LINE)
  {
    this->AddSteps();
  }
  else if (this->Dimension == 1)
  {
    this->AddPart(this->Edges, cell, cell);
  }
}

//------------------------------------------------------------------------------
void SkdCellOutline::AddPart(std::vector<Part>& parts, vtkCell* part, vtkCell* cell)
{
  Part slots;
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    const vtkIdType slot = cell->GetPointIds()->IsId(part->GetPointId(static_cast<int>(i)));
    if (slot >= 0)
    {
      slots.push_back(static_cast<int>(slot));
    }
  }
  std::sort(slots.begin(), slots.end());
  parts.push_back(std::move(slots));
}

//------------------------------------------------------------------------------
void SkdCellOutline::AddSteps()
{
  for (int i = 1; i < static_cast<int>(this->Points.size()); ++i)
  {
    this->Edges.push_back({ i - 1, i });
  }
}

//------------------------------------------------------------------------------
bool SkdCellOutline::Shares(const SkdCellOutline& other, SkdSharedPart part, double tolerance) const
{
  // The first point of the other at the same position as each of ours.
  std::vector<int> same;
  for (const skd::Vector3& x : this->Points)
  {
    const auto found = std::find_if(other.Points.begin(), other.Points.end(),
      [&](const skd::Vector3& y) { return skd::Distance2(x, y) <= tolerance * tolerance; });
    const bool isFound = found != other.Points.end();
    same.push_back(isFound ? static_cast<int>(found - other.Points.begin()) : -1);
  }
  const auto isShared = [](int slot) { return slot >= 0; };
  const bool isWhole = std::all_of(same.begin(), same.end(), isShared);
  if (isWhole && this->Dimension == other.Dimension && this->Points.size() == other.Points.size())
  {
    return false;
  }
  if (part == SkdSharedPart::Point || !this->HasParts() || !other.HasParts())
  {
    const int needed = part == SkdSharedPart::Point ? 1 : (part == SkdSharedPart::Edge ? 2 : 3);
    return std::count_if(same.begin(), same.end(), isShared) >= needed;
  }
  const std::vector<Part>& ours = part == SkdSharedPart::Edge ? this->Edges : this->Faces;
  const std::vector<Part>& theirs = part == SkdSharedPart::Edge ? other.Edges : other.Faces;
  return std::any_of(ours.begin(), ours.end(),
    [&](const Part& one)
    {
      Part moved;
      for (const int slot : one)
      {
        moved.push_back(same[static_cast<std::size_t>(slot)]);
      }
      std::sort(moved.begin(), moved.end());
      return std::find(theirs.begin(), theirs.end(), moved) != theirs.end();
    });
}
}
