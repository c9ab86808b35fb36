// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRepairedMesh_h
#define SkdRepairedMesh_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace skdtree
{
/// A valid version of a data set: itself or, if cells are broken (SkdCellCheck.h), one of the same
/// type, points and data in which these are empty. All cells keep their ids. One that has cells but
/// no vtkPoints gets an empty one, without a word, for cells without points are valid.
struct SkdRepairedMesh
{
  vtkSmartPointer<vtkDataSet> Mesh;
  std::string Fault; ///< the warning about broken cells; empty if there is none
};

/// `given` must not be nullptr. Copies connectivity only if cells are broken.
SkdRepairedMesh SkdRepair(vtkDataSet* given);

/// The mesh itself, with its broken cells, where VTK can fetch the others; else as SkdRepair()
/// does.
vtkSmartPointer<vtkDataSet> SkdFetchable(vtkDataSet* given);
}

#endif
