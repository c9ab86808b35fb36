// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanFaces_h
#define SkdBooleanFaces_h

#include "Core/Search/Tree/RawVector.h"
#include "Solids/Boolean/SkdBooleanRule.h"

namespace skdtree
{
/// The faces of an output: polygons by the points of an arrangement, each with a facet that it
/// contains.
struct SkdBooleanFaces
{
  using Numbers = skd::RawVector<std::uint32_t>;

  Numbers Facets;    ///< the first of each face
  Numbers Corners;   ///< of one face after the other
  Numbers Ends{ 0 }; ///< of these, before the first and of each face

  template <class Iterator>
  void Add(std::uint32_t facet, Iterator first, Iterator last)
  {
    this->Facets.push_back(facet);
    this->Corners.insert(this->Corners.end(), first, last);
    this->Ends.push_back(static_cast<std::uint32_t>(this->Corners.size()));
  }
};

/// What becomes of facets.
struct SkdFaceOptions
{
  std::vector<bool> IsPolygon; ///< of each cell: all of it, if not split, becomes one face; or none
  bool IsMerged;               ///< pieces of one triangle become convex polygons
};

/// The facets of a boundary, in its orientation.
SkdBooleanFaces SkdMakeBooleanFaces(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const SkdFaceOptions& options);
}

#endif
