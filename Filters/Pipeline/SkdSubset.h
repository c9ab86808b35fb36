// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSubset_h
#define SkdSubset_h

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

/// Some cells or points of a mesh as a grid of their own, with no more points than they use.
class SkdSubset
{
public:
  explicit SkdSubset(vtkDataSet* mesh);

  void AddCell(vtkIdType cell);

  /// Adds a point as a cell of type VTK_VERTEX. For subsets of points alone.
  void AddPoint(vtkIdType point);

  /// Gives the grid the mesh's point data, and cell data if it has cells of the mesh.
  void CopyData();

  vtkUnstructuredGrid* Get() const { return this->Grid; }

private:
  vtkIdType NewPoint(vtkIdType point);
  void Renumber(vtkIdType first, vtkIdType last);
  void RenumberFaces();

  vtkDataSet* Mesh;
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkIdList> Ids;
  std::vector<vtkIdType> NewIds; // of each point of the mesh, -1: not used
  vtkNew<vtkIdList> PointIds;    // of the mesh
  vtkNew<vtkIdList> CellIds;
};

#endif
