// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdChordalDeviation_h
#define SkdChordalDeviation_h

#include "Core/Geometry/Vector.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <map>
#include <vector>

class vtkCell;
class vtkDataArray;
class vtkDataSet;
class vtkGenericCell;

namespace skdtree
{
/// The chordal deviation of a data set's curved cells: how far they extend beyond the boxes of
/// their points. For one thread.
///
/// A cell is the straight cell of its corners plus the weighted displacements of its other points
/// from those of the straight cell. So no point of it is farther from the corners' box than the
/// largest displacement times the largest sum of absolute weights, which is 0 for a straight cell.
/// The sum is computed once for each kind of cell.
class SkdChordalDeviation
{
public:
  explicit SkdChordalDeviation(vtkDataSet* data);
  ~SkdChordalDeviation();

  /// The factor, at least 1, by which the half lengths of the box of the cell's points grow so that
  /// the box holds the cell. 1 for cells that are not curved, and for Bezier cells, which are
  /// inside the hull of their points.
  double FactorOf(vtkIdType cellId, int cellType, const skd::Vector3* points, int size);

private:
  /// All cells of the same type, number of points and degrees.
  struct Kind
  {
    int Corners = 0;
    std::vector<double> Straight; ///< for each point that is no corner: the corners' weights there
    double Sum = 0.0;
  };

  static Kind MakeKind(vtkCell* cell);
  const Kind& KindOf(vtkIdType cellId, int cellType, int size);
  static double FactorOf(const Kind& kind, const skd::Vector3* points, int size);

  vtkDataSet* Data;
  vtkDataArray* Degrees; // of Lagrange cells, where they differ by direction
  vtkNew<vtkGenericCell> Scratch;
  std::map<std::vector<int>, Kind> Kinds;
};
}

#endif
