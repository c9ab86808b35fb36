// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCompositePieces.h
 * @brief The data sets in a data object by their path in it, which is the same on all processes.
 */

#ifndef SkdCompositePieces_h
#define SkdCompositePieces_h

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace skdtree
{
class SkdTransport;

/// From the root to a data set: the indices of children. Empty if the data set is the object
/// itself; of AMR data the flat index. In lexicographic order they are in that of flat indices.
using SkdBlockPath = std::vector<int>;

struct SkdLeafBlock
{
  SkdBlockPath Path;
  vtkSmartPointer<vtkDataSet> Mesh;
};

/// The data sets in an object, composite or not.
std::vector<SkdLeafBlock> SkdLeafBlocksOf(vtkDataObject* object);

/// A copy of a composite data set without its data sets; nullptr of other objects.
vtkSmartPointer<vtkDataObject> SkdStructureOf(vtkDataObject* object);

/// Adds the children that a process has and another has not, and their names. Does nothing for AMR
/// data, whose structure all processes have.
void SkdUniteStructures(vtkDataObject* into, vtkDataObject* from);

/// Whether no process has a data set where another has blocks. All must call it together.
bool SkdAreNestedAlike(SkdTransport& transport, vtkDataObject* piece);

/// Puts a data set at its path.
void SkdSetBlock(vtkDataObject* composite, const SkdBlockPath& path, vtkDataSet* mesh);
}

#endif
