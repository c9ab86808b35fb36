// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdQueryPoints_h
#define SkdQueryPoints_h

#include "Pipeline/SkdPointOrder.h"

namespace skdtree
{
/// The query points of a mesh: its points, or the centres of its cells (the mean of their points).
class SkdQueryPoints
{
public:
  enum class At
  {
    Points,
    Middles
  };

  SkdQueryPoints(vtkDataSet* mesh, At at);

  vtkIdType GetNumber() const;

  /// The query point at an index of the processing order, see SkdPointOrder. Thread-safe.
  vtkIdType GetQueryPoint(vtkIdType index) const
  {
    return this->Order ? this->Order->GetPoint(index) : index;
  }

  /// The coordinates of query point i; NaN for a cell without points. Thread-safe.
  void GetPoint(vtkIdType i, double x[3]) const;

  /// The number of query points in each row of images and rectilinear grids, which is a straight
  /// line; 0 if there are no rows.
  vtkIdType GetRowLength() const { return this->RowLength; }

private:
  void FindRows();

  vtkSmartPointer<vtkDataSet> Mesh;
  At Where;
  std::optional<SkdPointOrder> Order; // of points
  vtkIdType RowLength = 0;
};
}

#endif
