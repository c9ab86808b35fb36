// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanFaces_h
#define SkdBooleanFaces_h

#include "Boolean/SkdBooleanFacets.h"

/// The faces of an output: polygons by the points of an arrangement, each with a facet that it
/// contains.
struct SkdBooleanFaces
{
  std::vector<std::uint32_t> Facets; ///< the first of each face
  std::vector<std::uint32_t> Starts; ///< of the corners of each face, and the end
  std::vector<std::uint32_t> Corners;
};

/// The facets of a boundary, in its orientation. With `isPolygon` (of a cell's place in the set's
/// list of cells) the facets of a cell become one face if all of the cell is there, not split, and
/// has one outline.
SkdBooleanFaces SkdMakeBooleanFaces(const SkdTriangleSet& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const std::vector<bool>& isPolygon);

#endif
