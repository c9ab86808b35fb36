// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurvedFaces.h
 * @brief The curved surface cells of a data set, and the faces of its curved volume cells that no
 * other of them shares, with the points that the cell type defines.
 *
 * Two faces are equal if they have the same points, including those within edges and faces. Ghost
 * cells (DUPLICATECELL) remove the faces that they share and contribute none; hidden cells are
 * ignored.
 */

#ifndef SkdCurvedFaces_h
#define SkdCurvedFaces_h

#include "Cells/Read/SkdFaceList.h"

#include <functional>
#include <vector>

class vtkCell;
class vtkDataSet;

namespace skdtree
{
/// Of a VTK cell type: 0 to 3; 0 of a type that VTK does not know.
int SkdDimensionOfCellType(int cellType);

/// Whether the type is one of VTK's nonlinear ones.
bool SkdIsCurvedCellType(int cellType);

/// Whether some cell of the data set is of such a type. O(n) in a grid, else O(1).
bool SkdHasCurvedCells(vtkDataSet* mesh);

/// By ascending cell id and face. O(n log n).
std::vector<SkdCellFace> SkdFindCurvedFaces(vtkDataSet* mesh);

/// Calls visit(face, cell, isInward) for each, the cell being that face as VTK has it, its point
/// ids those of the data set. Valid until the next one. VTK's types do not agree on the orientation
/// of faces, so `isInward` returns whether the face of a volume cell is oriented inward.
void SkdVisitFaces(vtkDataSet* mesh, const std::vector<SkdCellFace>& faces,
  const std::function<void(const SkdCellFace&, vtkCell*, bool)>& visit);
}

#endif
