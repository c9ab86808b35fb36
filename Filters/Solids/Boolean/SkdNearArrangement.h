// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdNearArrangement.h
 * @brief The arrangement of two closed surfaces, made only where they are near each other.
 */

#ifndef SkdNearArrangement_h
#define SkdNearArrangement_h

#include "Solids/Boolean/SkdBadEdges.h"
#include "Solids/Boolean/SkdFaceSets.h"
#include "Solids/Boolean/SkdNearSides.h"
#include "Solids/Boolean/SkdRigidPair.h"
#include "Solids/Boolean/SkdRoundedFacets.h"

namespace skdtree
{
/// The boundary of what is solid, of triangles of the whole set.
struct SkdNearBoundary
{
  SkdRoundedFacets Facets; ///< without an edge table; others than these may have the sign 0
  SkdBadEdges Bad;         ///< of it before pieces are joined
  SkdBoundaryMeasures Measures;
};

/// Beyond these the arrangement of all triangles may be another one (SkdCombineInPairs).
struct SkdNearLimits
{
  std::size_t Pairs;      ///< of triangles
  std::size_t MoreEvents; ///< points where segments meet each other, than there are pairs
};

/// Two surfaces of a SkdRigidPair where they are. Triangles that are near the other surface are
/// arranged (SkdArrangement.h); the others are on the side of it that facets beside them have, and
/// what is connected to no such facet on that which a line through it tells. What results is to the
/// last bit what the arrangement of all triangles results in, or nothing.
class SkdNearArrangement
{
public:
  /// The placement is of the pair's set. nullptr if all triangles must be arranged, as rounding may
  /// concern others, too, or triangles share an area; and after an abort. O(n) with few operations
  /// for each triangle that is not near the other surface.
  static std::unique_ptr<SkdNearArrangement> Make(const SkdRigidPair& pair,
    const SkdPlacement& placement, const SkdNearLimits& limits, vtkAlgorithm* filter);

  /// The facets that an operation keeps; pieces of one face are joined with `joins`. `faces` are of
  /// the placement's triangles.
  SkdNearBoundary Select(const SkdBooleanRule& rule, bool joins, SkdFaceSets& faces) const;

  vtkIdType GetNumberSplit() const { return this->Part.NumberSplit; } ///< triangles in pieces
  vtkIdType GetNumberArranged() const { return static_cast<vtkIdType>(this->Triangles.size()); }

private:
  class SignCache;
  struct Merging;

  SkdNearArrangement(const SkdRigidPair& pair, const SkdPlacement& placement)
    : Pair(pair)
    , Whole(placement)
  {
  }

  bool Arrange(const SkdNearLimits& limits, vtkAlgorithm* filter);
  signed char SignOf(const SkdBooleanRule& rule, std::uint32_t component, int other) const;
  SkdFacetSigns FindSigns(const SkdBooleanRule& rule) const;
  SkdBadEdges FindBadEdges(const SkdFacetSigns& signs) const;
  SkdNearBoundary Merge(
    const SkdFacets& facets, const SkdFacetSigns& signs, const SkdBooleanRule& rule) const;
  void AddWhole(std::uint32_t end, Merging& merging) const;
  std::pair<std::uint32_t, int> KindOf(std::uint32_t triangle) const;
  std::vector<SkdSplitPoint> PointsOfWhole(std::vector<SkdSplitPoint> points) const;
  SkdBoundaryMeasures Measure(const SkdFacets& facets, const SkdFacetSigns& signs,
    const std::array<SkdAreaSum, 2>& others) const;
  std::uint32_t PointOf(std::uint32_t point) const; // in the whole

  const SkdRigidPair& Pair;
  const SkdPlacement& Whole;
  std::vector<std::uint32_t> Triangles; // that are arranged, ascending
  std::vector<std::uint32_t> Points;    // of these, ascending
  SkdTriangleSet Set;                   // of these
  std::optional<SkdPlacement> Placement;
  SkdArrangedPart Part;
  SkdNearSides Sides;
};
}

#endif
