// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSectionFaces_h
#define SkdSectionFaces_h

#include "Solids/Boolean/SkdBooleanFaces.h"
#include "Solids/Boolean/SkdFaceSets.h"

namespace skdtree
{
/// The faces of a section, whose facets are those with a sign of 1: each connected part of a flat
/// face is one polygon if it has no holes, touches itself nowhere, and VTK can triangulate it. Of
/// others, and of those with more than 4000 corners, for which VTK takes long, the facets are the
/// faces. O(n log n), and O(k^2) for a polygon with k corners.
SkdBooleanFaces SkdMakeSectionFaces(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, SkdFaceSets& faces);
}

#endif
