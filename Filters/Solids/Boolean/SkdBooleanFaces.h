// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanFaces_h
#define SkdBooleanFaces_h

#include "Core/Search/Tree/RawVector.h"
#include "Solids/Boolean/SkdBooleanRule.h"

#include <array>
#include <cstring>

namespace skdtree
{
/// The faces of an output: polygons by the points of an arrangement, each with a facet that it
/// contains.
struct SkdBooleanFaces
{
  using Numbers = skd::RawVector<std::uint32_t>;

  Numbers Facets;    ///< the first of each face
  Numbers Corners;   ///< of one face after the other; none if each is a facet
  Numbers Ends{ 0 }; ///< of these, before the first and of each face

  bool AreFacets() const { return this->Corners.empty(); }

  /// Calls visit(first, last) for consecutive facets of one sign other than 0. Mostly they are
  /// many.
  template <class Visit>
  static void ForEachRun(const SkdFacetSigns& signs, const Visit& visit)
  {
    constexpr std::size_t step = sizeof(std::uint64_t);
    const std::size_t n = signs.size();
    for (std::size_t first = 0; first < n;)
    {
      std::array<signed char, step> alike;
      alike.fill(signs[first]);
      std::size_t last = first + 1;
      while (last + step <= n && std::memcmp(signs.data() + last, alike.data(), step) == 0)
      {
        last += step;
      }
      while (last < n && signs[last] == signs[first])
      {
        ++last;
      }
      if (signs[first] != 0)
      {
        visit(first, last);
      }
      first = last;
    }
  }

  /// Calls visit(a, b, c) for each face, if each is a facet of the boundary.
  template <class Visit>
  static void ForEachFacet(const SkdFacets& facets, const SkdFacetSigns& signs, Visit visit)
  {
    const SkdTriangleSet::Corners* const corners = facets.Corners.data();
    ForEachRun(signs,
      [&](std::size_t first, std::size_t last)
      {
        const bool isReversed = signs[first] < 0;
        for (std::size_t facet = first; facet < last; ++facet)
        {
          const auto& [a, b, c] = corners[facet];
          visit(a, isReversed ? c : b, isReversed ? b : c);
        }
      });
  }

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
