// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Cells_PolyhedronView_h
#define skd_Geometry_Cells_PolyhedronView_h

#include "../Box.h"

#include <cstdint>

namespace skd
{

/// A face: point i of the polyhedron's points is Points[Ids[i]].
struct PolyhedronFace
{
  const Vector3* Points;
  const std::uint32_t* Ids;
  int Size;

  const Vector3& operator[](int i) const { return this->Points[this->Ids[i]]; }
};

/// A polyhedron. Faces is a stream: the number of points of a face, then their numbers; the next
/// face.
struct PolyhedronView
{
  const Vector3* Points;
  int Size;
  const std::uint32_t* Faces;
  const std::uint32_t* End;

  /// Calls visit(face).
  template <class Visit>
  void ForEachFace(Visit visit) const
  {
    for (const std::uint32_t* at = this->Faces; at < this->End; at += 1 + *at)
    {
      visit(PolyhedronFace{ this->Points, at + 1, static_cast<int>(*at) });
    }
  }

  Box3 Bounds() const
  {
    Box3 bounds;
    for (int i = 0; i < this->Size; ++i)
    {
      bounds.Add(this->Points[i]);
    }
    return bounds;
  }
};

}

#endif
