// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRepresentation_h
#define SkdRepresentation_h

class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPolyData;

namespace skd
{
struct RigidMotion;
}

namespace skdtree
{
class SkdCellTree;

///@{
/// The arrays S and L of the paper's tree (Algorithm 3.1), see
/// vtkSkdTreeCellLocator::GetSafetyBoxes.
void SkdCopySafetyBoxes(const SkdCellTree& tree, vtkDoubleArray* S);
void SkdCopyLinks(const SkdCellTree& tree, vtkIdTypeArray* L);
///@}

/// The boxes of a level of the paper's tree as quads, transformed by the motion unless nullptr. A
/// level below 0 or below the deepest gives the leaves. Cell arrays Level and CellId.
void SkdRepresent(
  const SkdCellTree& tree, int level, const skd::RigidMotion* motion, vtkPolyData* output);
}

#endif
