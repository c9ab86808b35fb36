// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BruteForce.h
 * @brief every question answered by a look at every cell
 */
#ifndef skdtest_BruteForce_h
#define skdtest_BruteForce_h

#include "Support/CellShape.h"

#include "vtkGenericCell.h"

namespace skdtest
{

/// A data set's cells by value. Only cells without a shape of their own (CellShape) go through VTK,
/// and the question whether a hexahedron, wedge or pyramid contains a point.
class BruteForce
{
public:
  struct Nearest
  {
    double Distance = std::numeric_limits<double>::infinity();
    vtkIdType Cell = -1;
  };

  struct Hit
  {
    double T;
    vtkIdType Cell;
    bool operator<(const Hit& o) const
    {
      return this->T < o.T || (this->T == o.T && this->Cell < o.Cell);
    }
  };

  explicit BruteForce(
    vtkDataSet* data, const std::function<bool(vtkIdType)>& keep = [](vtkIdType) { return true; })
    : Data(data)
    , Whole(EmptyBounds())
  {
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      data->GetCell(cell, this->Cell);
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

  const Ids& GetCells() const { return this->Cells; }
  const Bounds& GetBounds() const { return this->Whole; }
  const Bounds& Box(vtkIdType cell) const { return this->Shapes[cell].Box; }

  /// Rounding errors of distances are within this.
  double Tolerance() const { return 1e-12 * Scale(this->Whole); }

  /// The nearest of all cells, of equally near ones the lowest id.
  Nearest FindNearest(const Point& x)
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

  double DistanceTo(vtkIdType cell, const Point& x)
  {
    const CellShape& shape = this->Shapes[cell];
    if (!shape.IsKnown)
    {
      return this->DistanceByVtk(cell, x);
    }
    return shape.IsSolid && this->IsInside(cell, x) ? 0.0 : BoundaryDistance(shape, x);
  }

  /// As vtkCell::EvaluatePosition sees it; infinite where that fails.
  double DistanceByVtk(vtkIdType cell, const Point& x)
  {
    Point closest, pcoords;
    double dist2 = 0.0;
    return this->Evaluate(cell, x, closest, pcoords, dist2) >= 0 && dist2 >= 0
      ? std::sqrt(dist2)
      : std::numeric_limits<double>::infinity();
  }

  /// Whether a cell of volume holds x. Where x is on its boundary either may be the answer.
  bool IsInside(vtkIdType cell, const Point& x)
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

  /// All cells of volume that hold x, ascending.
  Ids FindContaining(const Point& x)
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

  Ids FindWithinBounds(const Bounds& box) const
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

  /// The first hit of the segment with each cell of dimension 2 or 3, sorted.
  std::vector<Hit> Intersect(const Point& p1, const Point& p2) const
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

private:
  int Evaluate(vtkIdType cell, const Point& x, Point& closest, Point& pcoords, double& dist2)
  {
    int subId = 0;
    this->Data->GetCell(cell, this->Cell);
    this->Weights.resize(this->Cell->GetNumberOfPoints() + 1);
    return this->Cell->EvaluatePosition(
      x.data(), closest.data(), subId, pcoords.data(), dist2, this->Weights.data());
  }

  // VTK calls a hexahedron's or wedge's surroundings of a thousandth its inside: look closer.
  bool IsInsideByVtk(vtkIdType cell, const Point& x)
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

  vtkSmartPointer<vtkDataSet> Data;
  Bounds Whole;
  std::vector<CellShape> Shapes;
  Ids Cells;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Weights;
};

}

#endif
