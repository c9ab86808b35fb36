// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdQueryPoints_h
#define SkdQueryPoints_h

#include "Pipeline/SkdPointOrder.h"

/// Where a mesh asks: at its points, or at the middles of its cells (the mean of their points).
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

  /// The query point at a place of an order that is good to ask in, see SkdPointOrder. Thread-safe.
  vtkIdType GetQueryPoint(vtkIdType place) const
  {
    return this->Order ? this->Order->GetPoint(place) : place;
  }

  /// Where query point i is; NaN for a cell without points. Thread-safe.
  void GetPoint(vtkIdType i, double x[3]) const;

  /// So many query points, from number 0 on and again and again, are on a straight line, in their
  /// order: the rows of images and of rectilinear grids. 0: there are no rows.
  vtkIdType GetRowLength() const { return this->RowLength; }

private:
  void FindRows();

  vtkSmartPointer<vtkDataSet> Mesh;
  At Where;
  std::optional<SkdPointOrder> Order; // of points
  vtkIdType RowLength = 0;
};

#endif
