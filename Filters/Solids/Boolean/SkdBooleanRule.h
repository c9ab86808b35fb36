// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBooleanRule_h
#define SkdBooleanRule_h

#include "Solids/Boolean/SkdWindingNumbers.h"

#include <algorithm>

namespace skdtree
{
enum class SkdBooleanOperation
{
  Union,
  Intersection,
  Difference,
  ReverseDifference,
  SymmetricDifference,
  AtLeast,
  Imprint,
  Split
};

/// The winding numbers of what is inside of a surface.
enum class SkdInsideRule
{
  NonZero,
  Odd,
  Positive
};

/// Which regions are solid after an operation on several solids; the differences are between the
/// first and the others.
struct SkdBooleanRule
{
  SkdBooleanOperation Operation;
  SkdInsideRule Inside;
  std::uint32_t NumberOfSolids;
  std::uint32_t Least;   ///< the number of solids of AtLeast
  bool HasSheet = false; ///< the second solid is an open surface
  int Part = 0;          ///< of Split: the part that is solid

  bool IsInside(int number) const
  {
    switch (this->Inside)
    {
      case SkdInsideRule::Odd:
        return number % 2 != 0;
      case SkdInsideRule::Positive:
        return number > 0;
      default:
        return number != 0;
    }
  }

  bool IsInside(const SkdRegionWindings& windings, std::uint32_t solid) const
  {
    return std::any_of(windings.begin(), windings.end(),
      [&](const SkdWindingOf& winding)
      { return winding.Surface == solid && this->IsInside(winding.Number); });
  }

  /// The number of solids that a region is in.
  std::uint32_t CountSolids(const SkdRegionWindings& windings) const
  {
    return static_cast<std::uint32_t>(std::count_if(windings.begin(), windings.end(),
      [&](const SkdWindingOf& winding) { return this->IsInside(winding.Number); }));
  }

  /// The part of the first solid that a region is in, after a split: how many of the others are
  /// there, or how many sheets it is behind; -1 outside of the first solid.
  int PartOf(const SkdRegionWindings& windings) const
  {
    if (!this->IsInside(windings, 0))
    {
      return -1;
    }
    if (!this->HasSheet)
    {
      return static_cast<int>(this->CountSolids(windings)) - 1;
    }
    const auto isSheet = [](const SkdWindingOf& winding) { return winding.Surface == 1; };
    const auto sheet = std::find_if(windings.begin(), windings.end(), isSheet);
    return sheet == windings.end() ? 0 : sheet->Number;
  }

  bool IsSolid(const SkdRegionWindings& windings) const
  {
    if (this->Operation == SkdBooleanOperation::Split)
    {
      return this->PartOf(windings) == this->Part;
    }
    const std::uint32_t count = this->CountSolids(windings);
    const bool isInFirst = this->IsInside(windings, 0);
    switch (this->Operation)
    {
      case SkdBooleanOperation::Intersection:
        return count == this->NumberOfSolids;
      case SkdBooleanOperation::Difference:
        return isInFirst && count == 1;
      case SkdBooleanOperation::ReverseDifference:
        return !isInFirst && count > 0;
      case SkdBooleanOperation::SymmetricDifference:
        return count % 2 == 1;
      case SkdBooleanOperation::AtLeast:
        return count >= this->Least;
      default:
        return count > 0;
    }
  }
};

/// For each facet of an arrangement 1 if it bounds a part of space as it is, -1 if reversed, 0 if
/// it does not.
using SkdFacetSigns = std::vector<signed char>;

/// The boundary of the regions for which `isSolid` (of their winding numbers) returns true.
template <class IsSolid>
SkdFacetSigns SkdFindBoundary(const SkdArrangement& arrangement,
  const std::vector<SkdRegionWindings>& windings, const IsSolid& isSolid)
{
  std::vector<signed char> solid(windings.size());
  for (std::size_t region = 0; region < windings.size(); ++region)
  {
    solid[region] = isSolid(windings[region]) ? 1 : 0;
  }
  SkdFacetSigns signs(arrangement.Facets.GetNumberOfFacets());
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    signs[facet] = static_cast<signed char>(
      solid[arrangement.GetBack(facet)] - solid[arrangement.GetFront(facet)]);
  }
  return signs;
}

/// The volume within a boundary, and its area. Volumes of parts of one that is open itself are sums
/// from a point that all parts have in common.
struct SkdBoundaryMeasures
{
  double Volume = 0.0;
  double Area = 0.0;
};
SkdBoundaryMeasures SkdMeasureBoundary(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const std::optional<skd::Vector3>& common = std::nullopt);
}

#endif
