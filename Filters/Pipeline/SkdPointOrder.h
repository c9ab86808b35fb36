// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPointOrder_h
#define SkdPointOrder_h

#include "Cells/SkdBatch.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <optional>

/// The points of a data set in an order in which neighbours in space follow each other, whatever
/// order they are in: what a query has read the next one finds in the processor's caches. On a
/// million scattered points in a million cells that is most of the time. The points of images and
/// of rectilinear grids come as they are, row by row. The order depends on the points alone.
class SkdPointOrder
{
public:
  explicit SkdPointOrder(vtkDataSet* mesh);

  /// The point at a place of the order. Thread-safe.
  vtkIdType GetPoint(vtkIdType place) const
  {
    return this->Scattered ? this->Scattered->GetSlot(place) : place;
  }

  /// The same, and where it is.
  vtkIdType GetPoint(vtkIdType place, double x[3]) const
  {
    const vtkIdType id = this->GetPoint(place);
    this->Scattered ? this->Scattered->Read(id, x) : this->Mesh->GetPoint(id, x);
    return id;
  }

private:
  vtkSmartPointer<vtkDataSet> Mesh;
  std::optional<SkdBatch> Scattered;
};

#endif
