// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdEdgeTable_h
#define SkdEdgeTable_h

#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/EdgeTable.h"

#include <type_traits>

namespace skdtree
{
/// The table of Core/Geometry, sorted in parallel: what the core, which knows no VTK, leaves to its
/// caller.
template <class Triangle>
auto SkdMakeEdgeTable(const std::vector<Triangle>& triangles, std::size_t numberOfPoints)
{
  using Index = std::decay_t<decltype(triangles[0][0])>;
  return skd::EdgeTable<Index>(
    triangles, numberOfPoints, [](std::size_t n, const auto& body) { SkdForEach(n, body); });
}
}

#endif
