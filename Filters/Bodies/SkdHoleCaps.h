// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdHoleCaps_h
#define SkdHoleCaps_h

#include "Bodies/SkdTriangulation.h"
#include "Core/Geometry/Vector.h"

#include <vector>

namespace skdtree
{
/// Triangles that close the holes of a surface: with them an even number of triangles has each
/// edge. The edges of an odd number are divided into simple loops. One of three edges gets a
/// triangle, so that a missing one is restored; others a fan about the centre of their edges.
/// Triangles are oriented like their neighbours, if these are oriented alike. O(n log n).
class SkdHoleCaps
{
public:
  SkdHoleCaps(
    const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles);

  /// Of the surface, and the centres of fans after them.
  const std::vector<skd::Vector3>& GetPoints() const { return this->Points; }
  const std::vector<SkdTriangleIds>& GetTriangles() const { return this->Triangles; }

private:
  struct Edge
  {
    vtkIdType From; // as most of its triangles have it
    vtkIdType To;
  };

  std::vector<Edge> FindOpen(const std::vector<SkdTriangleIds>& triangles) const;
  void CloseAll(const std::vector<Edge>& edges);
  void Close(const std::vector<Edge>& loop);

  std::vector<skd::Vector3> Points;
  std::vector<SkdTriangleIds> Triangles;
};
}

#endif
