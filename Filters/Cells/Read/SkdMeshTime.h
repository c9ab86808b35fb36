// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMeshTime_h
#define SkdMeshTime_h

#include "vtkDataSet.h"

#include <atomic>

namespace skdtree
{
/// When a mesh was last modified in what a tree depends on: for each query, cheaply.
///
/// vtkDataSet::GetMTime() asks every array of point, cell and field data, about ten instructions
/// each, and of a vtkUnstructuredGrid it does not ask the cells. Of a vtkPolyData and a
/// vtkUnstructuredGrid without ghosts and higher-order degrees or weights this asks the data set,
/// its points, its cells, and which arrays there are. All other meshes are asked by GetMTime().
class SkdMeshTime
{
public:
  /// From now on Of() is asked about this mesh, or about any with nullptr. Thread-safe, as is Of().
  void Watch(vtkDataSet* mesh);

  vtkMTimeType Of(vtkDataSet* mesh) const
  {
    return this->Ask.load(std::memory_order_relaxed)(mesh);
  }

private:
  static vtkMTimeType OfAll(vtkDataSet* mesh) { return mesh->GetMTime(); }

  std::atomic<vtkMTimeType (*)(vtkDataSet*)> Ask{ OfAll };
};
}

#endif
