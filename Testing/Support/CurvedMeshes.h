// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedMeshes.h
 * @brief blocks of curved cells of every type, whose neighbours share all points of their faces
 */
#ifndef skdtest_CurvedMeshes_h
#define skdtest_CurvedMeshes_h

#include "Support/CellZoo.h"

namespace skdtest
{

/// Every nonlinear type of VTK's that has a volume.
std::vector<int> CurvedVolumeTypes();

/// Every nonlinear type of VTK's that is a surface of triangles or quadrilaterals.
std::vector<int> CurvedSurfaceTypes();

/// The linear type with the corners of a curved one.
int LinearTypeOf(int type);

/// Cells of a curved type with the corners of the cells of a linear mesh of LinearTypeOf(type), and
/// straight: their other points are where linear cells have them. Points in the same place are one.
Mesh Elevated(const Mesh& linear, int type, int order = 2);

/// The cube [0, n]^3 as linear cells of such a type, or its surface.
Mesh LinearBlock(int linearType, int n);

/// The same as cells of a curved type.
inline Mesh CurvedBlock(int type, int n, int order = 2)
{
  return Elevated(LinearBlock(LinearTypeOf(type), n), type, order);
}

/// A smooth map that bends all faces of a cube of a few units.
Point Bowed(const Point& p);

}

#endif
