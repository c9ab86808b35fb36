// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdKeptMesh.h
 * @brief What a tree was built on, kept to tell whether it still serves.
 *
 * A pipeline hands over a new data set on each execution. In a time series its points and cells are
 * often the old ones, the very arrays or new arrays of the same values, and only point and cell
 * data changed. A tree depends on points and cells alone, on the ghost marks, and for higher-order
 * cells on their rational weights and degrees: together the "structure" below.
 */

#ifndef SkdKeptMesh_h
#define SkdKeptMesh_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

class SkdKeptMesh
{
public:
  /// Keeps the structure of `mesh`, by reference, and none of its other data.
  void Keep(vtkDataSet* mesh);

  /// Whether `mesh` has the structure that is kept: the same arrays, not modified since, or others
  /// of equal values. O(n) where values must be compared. Never true in doubt: of a kind of data
  /// set that is not known here, and of polyhedra in new arrays.
  bool IsSameAs(vtkDataSet* mesh) const;

  /// A data set of the type of the original with its structure alone; nullptr before Keep(). It
  /// stays the same object until the next Keep().
  vtkDataSet* Get() const { return this->Mesh; }

private:
  vtkSmartPointer<vtkDataSet> Mesh;
  vtkMTimeType Time = 0;
};

#endif
