// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/BruteForce.h"

#include "Support/FetchCell.h"

#include <algorithm>

namespace skdtest
{

BruteForce::BruteForce(vtkDataSet* data, const std::function<bool(vtkIdType)>& keep)
  : Data(data)
  , Whole(EmptyBounds())
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    FetchCell(data, cell, this->Cell);
    this->Shapes.push_back(MakeShape(this->Cell));
    if (keep(cell) && this->Shapes.back().Type != VTK_EMPTY_CELL)
    {
      this->Cells.push_back(cell);
      const Bounds& box = this->Box(cell);
      Extend(this->Whole, { box[0], box[2], box[4] });
      Extend(this->Whole, { box[1], box[3], box[5] });
    }
  }
}

BruteForce::Nearest BruteForce::FindNearest(const Point& x)
{
  Nearest nearest;
  for (vtkIdType cell : this->Cells)
  {
    if (Distance(this->Box(cell), x) <= nearest.Distance)
    {
      const double distance = this->DistanceTo(cell, x);
      nearest = distance < nearest.Distance ? Nearest{ distance, cell } : nearest;
    }
  }
  return nearest;
}

double BruteForce::DistanceTo(vtkIdType cell, const Point& x)
{
  const CellShape& shape = this->Shapes[cell];
  if (!shape.IsKnown)
  {
    return this->DistanceByVtk(cell, x);
  }
  return shape.IsSolid && this->IsInside(cell, x) ? 0.0 : BoundaryDistance(shape, x);
}

double BruteForce::DistanceByVtk(vtkIdType cell, const Point& x)
{
  Point closest, pcoords;
  double dist2 = 0.0;
  return this->Evaluate(cell, x, closest, pcoords, dist2) >= 0 && dist2 >= 0
    ? std::sqrt(dist2)
    : std::numeric_limits<double>::infinity();
}

bool BruteForce::IsInside(vtkIdType cell, const Point& x)
{
  const CellShape& shape = this->Shapes[cell];
  if (!shape.IsSolid || !Contains(shape.Box, x))
  {
    return false;
  }
  switch (shape.Type)
  {
    case VTK_VOXEL:
      return IsInsideVoxel(shape, x);
    case VTK_TETRA:
    case VTK_POLYHEDRON:
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
      return IsInsideByParity(shape, x);
    default:
      return this->IsInsideByVtk(cell, x);
  }
}

Ids BruteForce::FindContaining(const Point& x)
{
  Ids found;
  for (vtkIdType cell : this->Cells)
  {
    if (this->IsInside(cell, x))
    {
      found.push_back(cell);
    }
  }
  return found;
}

Ids BruteForce::FindWithinBounds(const Bounds& box) const
{
  Ids found;
  for (vtkIdType cell : this->Cells)
  {
    if (Overlap(this->Box(cell), box))
    {
      found.push_back(cell);
    }
  }
  return found;
}

std::vector<BruteForce::Hit> BruteForce::Intersect(const Point& p1, const Point& p2) const
{
  std::vector<Hit> hits;
  for (vtkIdType cell : this->Cells)
  {
    Hit first = { 2.0, cell };
    for (const auto& triangle : SeenTriangles(this->Shapes[cell]))
    {
      first.T = std::min(first.T, HitTriangle(p1, p2, triangle).value_or(2.0));
    }
    if (first.T <= 1.0)
    {
      hits.push_back(first);
    }
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

int BruteForce::Evaluate(
  vtkIdType cell, const Point& x, Point& closest, Point& pcoords, double& dist2)
{
  int subId = 0;
  FetchCell(this->Data, cell, this->Cell);
  this->Weights.resize(this->Cell->GetNumberOfPoints() + 1);
  return this->Cell->EvaluatePosition(
    x.data(), closest.data(), subId, pcoords.data(), dist2, this->Weights.data());
}

bool BruteForce::IsInsideByVtk(vtkIdType cell, const Point& x)
{
  Point closest, pcoords;
  double dist2 = 0.0;
  if (this->Evaluate(cell, x, closest, pcoords, dist2) != 1)
  {
    return false;
  }
  const bool isWedge = this->Shapes[cell].Type == VTK_WEDGE;
  const auto sides = std::minmax_element(pcoords.begin(), pcoords.end());
  return *sides.first >= -1e-9 && *sides.second <= 1 + 1e-9 &&
    (!isWedge || pcoords[0] + pcoords[1] <= 1 + 1e-9);
}

}
