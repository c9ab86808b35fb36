// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSheet_h
#define SkdSheet_h

#include "Boolean/SkdWindingNumbers.h"

/// Makes an open surface of an arrangement a solid, of what is behind it: a region at its back side
/// gets the winding number 1 of it. Regions that it does not touch are on the side of its nearest
/// triangle. Returns the number of regions of the first solid that it does not divide although
/// it is within them; they are in front of it.
vtkIdType SkdPlaceSheet(const SkdPlacedTriangles& set, const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t sheet,
  std::vector<SkdRegionWindings>& windings);

#endif
