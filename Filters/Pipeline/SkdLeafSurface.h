// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdLeafSurface_h
#define SkdLeafSurface_h

#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// The outer faces of one data set, its surface cells among them, and where its cells and points
/// come from. Polydata are their own surface.
class SkdLeafSurface
{
public:
  explicit SkdLeafSurface(vtkDataSet* mesh);

  vtkPolyData* Get() const { return this->Surface; }

  /// The data set's cell that a cell of the surface comes from, and whether it has a volume.
  vtkIdType GetCellId(vtkIdType cell) const;
  bool IsOfVolume(vtkIdType cell);

  /// A point of the surface, exactly where it is in the data set.
  void GetPoint(vtkIdType point, double x[3]) const;

private:
  vtkDataSet* Mesh;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkIdTypeArray* CellIds = nullptr;
  vtkIdTypeArray* PointIds = nullptr;
  vtkNew<vtkGenericCell> Cell;
};

#endif
