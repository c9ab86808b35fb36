// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSurfaceNormals_h
#define SkdSurfaceNormals_h

#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace skdtree
{
struct SkdBlock;

/// The unit normal of a surface cell by its corners, to the side from which they go round
/// counterclockwise; of a strip that of the triangle nearest to x, of a curved cell that at the
/// point nearest to x. 0 of other cells, and of cells without area. Thread-safe after
/// SkdTouchCells().
skd::Vector3 SkdNormalOfCell(vtkDataSet* mesh, vtkIdType cell, const skd::Vector3& x);

/// The same of all cells; of a strip that of its first triangle, of a curved cell that in the
/// middle of its parameters.
std::vector<skd::Vector3> SkdNormalsOfCells(vtkDataSet* mesh);

/// Unit normals at points: the mean of those of the surface cells there, weighted by their angles,
/// so that the division into triangles does not matter (G. Thuermer, C. A. Wuethrich, "Computing
/// vertex normals from polygonal facets", Journal of Graphics Tools 3 (1998) 43-46). Of curved
/// cells they are those of the surface itself at the points' parameters. Of a mesh with volume
/// cells, the normals of its outer faces as well. 0 where there is none.
std::vector<skd::Vector3> SkdNormalsOfPoints(vtkDataSet* mesh);

/// The same of the blocks that are pieces of one mesh of volume cells (SkdPieceSurfaces.h): without
/// faces between pieces, but with those of all pieces at a point. None of other blocks, nor where
/// any has curved cells.
std::vector<std::vector<skd::Vector3>> SkdNormalsOfPieces(const std::vector<SkdBlock>& blocks);
}

#endif
