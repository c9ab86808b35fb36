// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMeshAssembly_h
#define SkdMeshAssembly_h

#include "Exchange/SkdJoinedMesh.h"
#include "Exchange/SkdPieceArrays.h"
#include "vtkPointSet.h"

#include <functional>
#include <vector>

namespace skdtree
{
/// What a mesh is made of, once it is decided which cells and points of which pieces are in it.
struct SkdMeshParts
{
  const SkdPieces& Pieces;
  const std::vector<SkdPieceCell>& Cells;              // in the order of their ids
  const std::vector<std::vector<vtkIdType>>& PointIds; // by piece and point
  const std::vector<SkdPieceTuples>& Points;           // what of each piece they are taken from
  vtkIdType NumberOfPoints;
};

/// A vtkUnstructuredGrid with all arrays. O(n).
vtkSmartPointer<vtkPointSet> SkdAssembleGrid(const SkdMeshParts& parts);

/// A vtkPolyData with all arrays; kindOf returns the kind of a cell, and they are in the order of
/// these. O(n).
vtkSmartPointer<vtkPointSet> SkdAssembleSurface(
  const SkdMeshParts& parts, const std::function<int(const SkdPieceCell& cell)>& kindOf);
}

#endif
