// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSheet_h
#define SkdSheet_h

#include "Solids/Boolean/SkdWindingNumbers.h"

namespace skdtree
{
/// What an open surface does not divide as it should.
struct SkdSheetFaults
{
  vtkIdType Undivided = 0;     ///< parts of the first solid that it is within without dividing them
  vtkIdType Contradictory = 0; ///< parts of which it says both that they are in front and behind
};

/// Makes an open surface of an arrangement a solid, of what is behind it: its winding numbers
/// differ by 1 from in front of each of its facets to behind it, and are 0 in the parts of the
/// first solid that are in front of all of it. Facets that have the same part of space on both
/// sides divide nothing and count for nothing. Parts that it does not touch are on the side of its
/// nearest triangle. `parts` are of SkdFindPartsOfSpace.
SkdSheetFaults SkdPlaceSheet(const SkdMovedTriangles& set, const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& parts, const std::vector<std::uint32_t>& surfaceOf,
  std::uint32_t sheet, std::vector<SkdRegionWindings>& windings);
}

#endif
