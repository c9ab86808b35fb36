// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPointOrder_h
#define SkdPointOrder_h

#include "Cells/Search/SkdBatch.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <optional>

namespace skdtree
{
/// The points of a data set sorted along a space-filling curve, so that the data of a query are
/// still in the processor's caches for the next one. For a million scattered points in a million
/// cells, cache misses are most of the time. The points of images and rectilinear grids remain in
/// their order, row by row. The order depends on the points alone.
class SkdPointOrder
{
public:
  explicit SkdPointOrder(vtkDataSet* mesh)
    : Mesh(mesh)
  {
    auto* points = vtkPointSet::SafeDownCast(mesh);
    if (points && points->GetPoints())
    {
      this->Scattered.emplace(points->GetPoints()->GetData(), SkdBatchOf::Points);
    }
  }

  /// The point at an index of the order. Thread-safe.
  vtkIdType GetPoint(vtkIdType index) const
  {
    return this->Scattered ? this->Scattered->GetSlot(index) : index;
  }

  /// The same, with its coordinates.
  vtkIdType GetPoint(vtkIdType index, double x[3]) const
  {
    const vtkIdType id = this->GetPoint(index);
    if (this->Scattered)
    {
      this->Scattered->Read(id, x);
    }
    else
    {
      this->Mesh->GetPoint(id, x);
    }
    return id;
  }

private:
  vtkSmartPointer<vtkDataSet> Mesh;
  std::optional<SkdBatch> Scattered;
};
}

#endif
