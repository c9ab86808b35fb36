// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFaceTriangles_h
#define SkdFaceTriangles_h

#include "Cells/Kernels/SkdQuadSplit.h"

namespace skdtree
{
/// The triangles of a volume cell's faces, of a quad two (SkdQuadSplit): for boxes and for other
/// cells it is what they enclose. Calls visit(a, b, c) with the numbers of the cell's points.
template <class Shape, class Visit>
void SkdForEachFaceCorners(const skd::Vector3* p, Visit visit)
{
  for (const auto& face : Shape::Faces)
  {
    if (face[3] < 0)
    {
      visit(face[0], face[1], face[2]);
      continue;
    }
    const skd::Vector3 quad[4] = { p[face[0]], p[face[1]], p[face[2]], p[face[3]] };
    for (const auto& i : SkdQuadSplit(quad).Triangles)
    {
      visit(face[i[0]], face[i[1]], face[i[2]]);
    }
  }
}

/// The same with the points themselves.
template <class Shape, class Visit>
void SkdForEachFaceTriangle(const skd::Vector3* p, Visit visit)
{
  SkdForEachFaceCorners<Shape>(p, [&](int a, int b, int c) { visit(p[a], p[b], p[c]); });
}
}

#endif
