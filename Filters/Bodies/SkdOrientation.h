// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOrientation_h
#define SkdOrientation_h

#include "Bodies/SkdTriangulation.h"

#include <functional>

namespace skdtree
{
/// The triangles to be reversed so that normals point outward: one value a triangle. Triangles that
/// share an edge with no third one are oriented consistently; then each component is oriented by
/// its largest triangle, one side of which is inside and the other outside. Components without such
/// a difference are not changed. O(n log n).
std::vector<bool> SkdFindReversed(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles,
  const std::function<bool(const skd::Vector3&)>& isInside);
}

#endif
