// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdQuadSplit_h
#define SkdQuadSplit_h

#include "Core/Geometry/Vector.h"

namespace skdtree
{
/// The two triangles of a quad in segment tests: divided along the shorter diagonal, as in VTK; of
/// equal ones along that of the vertex which is last in lexicographic order. So two cells that
/// share a quad have the same triangles, whatever its first vertex.
struct SkdQuadSplit
{
  int Triangles[2][3];

  explicit SkdQuadSplit(const skd::Vector3* p)
  {
    const double diagonal02 = skd::Distance2(p[0], p[2]);
    const double diagonal13 = skd::Distance2(p[1], p[3]);
    const bool cutsAt0 = diagonal02 != diagonal13 ? diagonal02 < diagonal13 : LastIsEven(p);
    const int first = cutsAt0 ? 0 : 1;
    for (int i = 0; i < 3; ++i)
    {
      this->Triangles[0][i] = (first + i) % 4;
      this->Triangles[1][i] = (first + 2 + i) % 4;
    }
  }

private:
  static bool LastIsEven(const skd::Vector3* p)
  {
    const skd::Vector3& even = p[0] < p[2] ? p[2] : p[0];
    const skd::Vector3& odd = p[1] < p[3] ? p[3] : p[1];
    return odd < even;
  }
};
}

#endif
