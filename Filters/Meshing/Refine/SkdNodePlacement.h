// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNodePlacement_h
#define SkdNodePlacement_h

#include "Core/Meshing/Mesh/RefinedMesh.h"

namespace skdtree
{
class SkdSource;

/// Puts new nodes at the mean distance from a centre of the nodes they are made of, in the
/// direction of their mean: on a sphere if these are on it, or between two spheres.
skd::RefinedMesh::Placement SkdPutOnSphere(const skd::Vector3& centre);

/// Puts new nodes of lines, surfaces and of the boundary of volumes at the point of the surface
/// nearest to their mean. The source must outlive it.
skd::RefinedMesh::Placement SkdPutOnSurface(const SkdSource& surface);
}

#endif
