// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BruteForce.h
 * @brief every query by testing every cell
 */
#ifndef skdtest_BruteForce_h
#define skdtest_BruteForce_h

#include "Support/CellShape.h"

#include "vtkGenericCell.h"

namespace skdtest
{

/// A data set's cells by value. VTK is used only for cells without a shape of their own
/// (CellShape), and to test whether a hexahedron, wedge or pyramid contains a point.
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
    vtkDataSet* data, const std::function<bool(vtkIdType)>& keep = [](vtkIdType) { return true; });

  const Ids& GetCells() const { return this->Cells; }
  const Bounds& GetBounds() const { return this->Whole; }
  const Bounds& Box(vtkIdType cell) const { return this->Shapes[cell].Box; }

  /// Rounding errors of distances are within this.
  double Tolerance() const { return 1e-12 * Scale(this->Whole); }

  /// The nearest of all cells, of equally near ones the lowest id.
  Nearest FindNearest(const Point& x);

  double DistanceTo(vtkIdType cell, const Point& x);

  /// As vtkCell::EvaluatePosition sees it; infinite where that fails.
  double DistanceByVtk(vtkIdType cell, const Point& x);

  /// Whether a cell of volume holds x. Where x is on its boundary either may be the answer.
  bool IsInside(vtkIdType cell, const Point& x);

  /// All cells of volume that hold x, ascending.
  Ids FindContaining(const Point& x);

  Ids FindWithinBounds(const Bounds& box) const;

  /// The first hit of the segment with each cell of dimension 2 or 3, sorted.
  std::vector<Hit> Intersect(const Point& p1, const Point& p2) const;

private:
  int Evaluate(vtkIdType cell, const Point& x, Point& closest, Point& pcoords, double& dist2);

  // VTK calls a hexahedron's or wedge's surroundings of a thousandth its inside: look closer.
  bool IsInsideByVtk(vtkIdType cell, const Point& x);

  vtkSmartPointer<vtkDataSet> Data;
  Bounds Whole;
  std::vector<CellShape> Shapes;
  Ids Cells;
  vtkNew<vtkGenericCell> Cell;
  std::vector<double> Weights;
};

}

#endif
