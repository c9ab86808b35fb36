// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCurvedFaces.h
 * @brief The curved cells of a data set that are surfaces, and the faces of its curved volume cells
 * that no other of them has: read from the cells themselves, whose type says which points a face
 * has.
 *
 * Two faces are the same when they have the same points, those within their edges and themselves
 * included. Ghost cells (DUPLICATECELL) hide the faces that they share and show none; hidden cells
 * are not there.
 */

#ifndef SkdCurvedFaces_h
#define SkdCurvedFaces_h

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkCell;
class vtkDataSet;

/// Of a VTK cell type: 0 to 3; 0 of a type that VTK does not know.
int SkdDimensionOfCellType(int cellType);

/// Whether the type is one of VTK's nonlinear ones.
bool SkdIsCurvedCellType(int cellType);

/// Whether some cell of the data set is of such a type. O(n) in a grid, else O(1).
bool SkdHasCurvedCells(vtkDataSet* mesh);

/// A face, or a cell.
struct SkdCurvedFace
{
  vtkIdType CellId;
  int Face; ///< -1: the cell itself
};

/// By ascending cell id and face. O(n log n).
std::vector<SkdCurvedFace> SkdFindCurvedFaces(vtkDataSet* mesh);

/// Calls visit(face, cell, isInward) for each, the cell being that face as VTK has it, its point
/// ids those of the data set. Valid until the next one. VTK's types do not agree on the sense in
/// which faces turn, so it is told whether the face of a volume cell turns inward.
void SkdVisitFaces(vtkDataSet* mesh, const std::vector<SkdCurvedFace>& faces,
  const std::function<void(const SkdCurvedFace&, vtkCell*, bool)>& visit);

#endif
