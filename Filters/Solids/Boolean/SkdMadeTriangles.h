// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMadeTriangles_h
#define SkdMadeTriangles_h

#include "Solids/Boolean/SkdFlatFace.h"
#include "Solids/Boolean/SkdPieceParts.h"

namespace skdtree
{
/// A triangle that is made of pieces, and the part that it is of, as parts were before they were
/// merged.
struct SkdMadeTriangle
{
  std::uint32_t Part;
  SkdTriangleSet::Corners Points;

  bool operator<(const SkdMadeTriangle& other) const { return this->Part < other.Part; }
};

/// The triangles of a part, ascending. Each is of the part that has a piece where its middle is, or
/// nearest to that, and faces as it does. O(n), and O(n log n) if several parts that face alike
/// were merged.
std::vector<SkdMadeTriangle> SkdListMade(
  const SkdPieceParts& parts, std::uint32_t part, const SkdFlatFace::Triangles& triangles);
}

#endif
