// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOrientation_h
#define SkdOrientation_h

#include "Pipeline/SkdFeatureNormals.h"

#include <functional>

/// Which triangles must be turned around for normals to point out of what they enclose: one value a
/// triangle. Triangles that share an edge with no third one are turned alike; then all that hang
/// together so are turned by their largest triangle, one side of which is inside and the other is
/// not. What has the same on both sides stays as it is. O(n log n).
std::vector<bool> SkdFindTurned(const std::vector<skd::Vector3>& points,
  const std::vector<SkdTriangleIds>& triangles,
  const std::function<bool(const skd::Vector3&)>& isInside);

#endif
