// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPolyCell_h
#define SkdPolyCell_h

#include "Cells/Read/SkdShape.h"
#include "Core/Geometry/Cells/PolyhedronView.h"

#include <cstdint>

namespace skdtree
{
/// A cell of any number of points, its points gathered. Faces and FacesEnd are those of
/// PolyhedronView.
struct SkdPolyCell
{
  SkdShape Shape;
  const skd::Vector3* Points;
  int Size; ///< at least 1
  const std::uint32_t* Faces;
  const std::uint32_t* FacesEnd;

  skd::PolyhedronView AsPolyhedron() const
  {
    return { this->Points, this->Size, this->Faces, this->FacesEnd };
  }
};
}

#endif
