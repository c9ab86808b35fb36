// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanFaces_h
#define SkdBooleanFaces_h

#include "Core/Geometry/Rows.h"
#include "Solids/Boolean/SkdBooleanRule.h"

namespace skdtree
{
/// The faces of an output: polygons by the points of an arrangement, each with a facet that it
/// contains.
struct SkdBooleanFaces
{
  std::vector<std::uint32_t> Facets; ///< the first of each face
  skd::IndexRows Corners;            ///< of each face
};

/// What becomes of facets.
struct SkdFaceOptions
{
  std::vector<bool> IsPolygon; ///< of each cell: all of it, if not split, becomes one face
  bool IsMerged;               ///< pieces of one triangle become convex polygons
};

/// The facets of a boundary, in its orientation.
SkdBooleanFaces SkdMakeBooleanFaces(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const SkdFaceOptions& options);
}

#endif
