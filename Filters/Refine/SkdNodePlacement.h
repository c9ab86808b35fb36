// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdNodePlacement_h
#define SkdNodePlacement_h

#include "Core/Mesh/RefinedMesh.h"

class SkdSource;

/// New nodes at the mean distance from a centre of those that they are made of, in the direction of
/// their mean: on the sphere if those are, on a shell between if they are on two.
skd::RefinedMesh::Placement SkdPutOnSphere(const skd::Vector3& centre);

/// New nodes of lines, surfaces and of the border of volumes at the point of the surface that is
/// nearest to the mean. The source must live.
skd::RefinedMesh::Placement SkdPutOnSurface(const SkdSource& surface);

#endif
