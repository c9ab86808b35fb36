// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdDirectionBoxes_h
#define SkdDirectionBoxes_h

#include "Core/Geometry/Box.h"
#include "vtkDataSet.h"

#include <vector>

namespace skdtree
{
/// Of each cell of a mesh a box of all directions from the origin to it: of corners that edges join
/// along great circles, or meridians and parallels. `inDegrees`: points are longitudes and
/// latitudes. Empty ones of cells without a corner that has a direction.
std::vector<skd::Box3> SkdDirectionBoxesOfCells(vtkDataSet* mesh, bool inDegrees);

/// The same of its points.
std::vector<skd::Box3> SkdDirectionBoxesOfPoints(vtkDataSet* mesh, bool inDegrees);
}

#endif
