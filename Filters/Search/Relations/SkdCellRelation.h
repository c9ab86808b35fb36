// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCellRelation.h
 * @brief Whether a cell itself, not only its box, has a relation to a shape; their distances.
 *
 * For balls, including points, cells have the geometry of vtkSkdTreeCellLocator; for other shapes
 * that of SkdCellTree::GetSimplices().
 */

#ifndef SkdCellRelation_h
#define SkdCellRelation_h

#include "Search/Relations/SkdCellOutline.h"
#include "Search/Relations/SkdQueryShape.h"

#include <optional>

namespace skdtree
{
struct SkdDistances
{
  double Min;
  double Max;
};

struct SkdRelationRules
{
  SkdRelation Relation = SkdRelation::Overlap;
  SkdSharedPart SharedPart = SkdSharedPart::Point; ///< of neighbours of cells
  double Tolerance = 0.0;                          ///< at least what rounding makes of coordinates
};

/// For one shape, which the caller keeps. Thread-safe.
class SkdCellRelation
{
public:
  SkdCellRelation(const SkdQueryShape& shape, const SkdRelationRules& rules)
    : Shape(shape)
    , Rules(rules)
  {
  }

  /// The minimum and maximum distances of a cell and the shape (for a plane, the maximum over the
  /// cell) if they are related; for Nearest always. Distances up to the tolerance are 0.
  std::optional<SkdDistances> Ask(
    const SkdCellTree& tree, std::uint32_t cell, const SkdCellSource& source) const;

private:
  struct Candidate; // a cell

  double MinDistance(const Candidate& candidate) const;
  double FindMinDistance(const Candidate& candidate) const;
  double MaxDistance(const Candidate& candidate) const;
  bool IsRelated(const Candidate& candidate) const;
  bool IsContained(const Candidate& candidate) const;
  bool IsEnclosing(const Candidate& candidate) const;
  bool Touches(const Candidate& candidate) const;
  bool IsNeighbour(const Candidate& candidate) const;
  bool TouchesBall(const Candidate& candidate) const;

  const SkdQueryShape& Shape;
  SkdRelationRules Rules;
};
}

#endif
