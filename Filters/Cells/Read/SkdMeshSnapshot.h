// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMeshSnapshot.h
 * @brief The structure of the mesh that a tree was built on, kept to decide whether the tree is
 * still valid.
 *
 * A pipeline provides a new data set in each execution. In a time series its points and cells are
 * often the same arrays, or new arrays with the same values, and only point and cell data change. A
 * tree depends on points and cells alone, on the ghost marks, and for higher-order cells on their
 * rational weights and degrees: together the "structure" below.
 */

#ifndef SkdMeshSnapshot_h
#define SkdMeshSnapshot_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <optional>

namespace skdtree
{
class SkdMeshSnapshot
{
public:
  /// Stores the structure of `mesh`, by reference, without its other data, and a checksum of its
  /// values: to notice those that are changed in place without Modified() of their array. O(n).
  void Keep(vtkDataSet* mesh);

  /// The same without the checksum, where arrays are Modified() if their values change. O(1).
  void KeepArrays(vtkDataSet* mesh);

  /// Whether `mesh` has the stored structure: the same arrays, not modified since, or others with
  /// equal values. O(n) if values must be compared, as after Keep() of a data set that was
  /// Modified() since. Conservative: false for unknown types of data sets, for polyhedra in new
  /// arrays, and when a stored array was modified by whoever shares it, because what it held is not
  /// known any more.
  bool IsSameAs(vtkDataSet* mesh) const;

  /// A data set of the type of the original with its structure alone; nullptr before Keep(). It
  /// stays the same object until the next Keep().
  vtkDataSet* Get() const { return this->Mesh; }

private:
  vtkSmartPointer<vtkDataSet> Mesh;
  vtkMTimeType Time = 0;
  std::optional<std::size_t> Checksum;
};
}

#endif
