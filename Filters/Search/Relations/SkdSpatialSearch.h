// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSpatialSearch.h
 * @brief All cells of a mesh related to a shape, or to each of many.
 */

#ifndef SkdSpatialSearch_h
#define SkdSpatialSearch_h

#include "Bodies/SkdParts.h"
#include "Core/Search/Tree/RawVector.h"
#include "Pipeline/SkdLoop.h"
#include "Search/Relations/SkdCellRelation.h"

#include <functional>

namespace skdtree
{
struct SkdSearchRules : SkdRelationRules
{
  bool IsExact = true;    ///< else the boxes decide: candidates
  std::size_t Number = 1; ///< of nearest cells
  bool HasTies = false;   ///< and all others that are as near as the last of these
};

/// A cell that is related to a shape.
struct SkdRelatedCell
{
  vtkIdType Query;    ///< which shape
  std::uint32_t Part; ///< of the mesh, and the cell there
  vtkIdType CellId;
  SkdDistances OfBoxes; ///< section 4's: optimistic and pessimistic
  SkdDistances OfCells; ///< exact ones; NaN if boxes decided
};

using SkdRelatedCells = skd::RawVector<SkdRelatedCell>;

class SkdSpatialSearch
{
public:
  /// Both must outlive it. Trees may be bare only for one shape and relations other than Nearest.
  SkdSpatialSearch(const SkdParts& mesh, const SkdSearchRules& rules);

  using MakeShape = std::function<SkdQueryShape(vtkIdType query)>;

  /// Of each of n shapes, one after the other, the related cells by (part, cell id), the nearest
  /// first by distance. Nearest are `Number` cells of all parts together, ties to the lowest, or
  /// all of them: what is farther by no more than the tolerance or rounding is as near. If boxes
  /// decide, all whose optimistic distance is not more than the Number-th least pessimistic
  /// one (Algorithm 5.1), among them those cells. In parallel; the same whatever the number of
  /// threads.
  SkdRelatedCells Find(vtkIdType n, const MakeShape& make, vtkAlgorithm* owner) const;

private:
  struct Candidate; // a part and a cell
  using Cells = SkdRelatedCells;
  /// The relation of the parts' points to a shape, if known.
  using CornersOfParts = std::vector<skd::RawVector<SkdQueryShape::Corner>>;

  Cells FindOfOne(const SkdQueryShape& shape, vtkAlgorithm* owner) const;
  skd::RawVector<std::uint32_t> LookThrough(
    const SkdCellTree& tree, const SkdQueryShape& shape, vtkAlgorithm* owner) const;
  Cells FindRelated(const SkdQueryShape& shape) const;
  Cells FindNearest(const SkdQueryShape& shape) const;
  Cells FindNearestToPoint(const SkdQueryShape& shape) const;
  Cells FindNearestBoxes(const SkdQueryShape& shape) const;

  std::vector<Candidate> FindCandidates(const SkdQueryShape& shape, double maxDistance) const;
  template <class Finder>
  std::vector<Candidate> FindInParts(const Finder& find) const;
  Cells MeasureNearest(const SkdQueryShape& shape, std::vector<Candidate>& candidates) const;
  double FindLimit(const SkdQueryShape& shape, double distance) const;
  /// @{ Whether a cell is related; if so the result is written in place, because moving it costs as
  /// much as finding it.
  bool Ask(const SkdQueryShape& shape, const Candidate& candidate, const CornersOfParts& known,
    SkdRelatedCell& related) const;
  bool AskCorners(const SkdQueryShape& shape, const Candidate& candidate,
    const CornersOfParts& known, SkdRelatedCell& related) const;
  ///@}
  bool AsksCorners() const;
  CornersOfParts LookAtPoints(
    const SkdQueryShape& shape, const std::vector<Candidate>& candidates) const;
  SkdRelatedCell MakeCell(const SkdQueryShape& shape, const Candidate& candidate) const;
  template <class Search>
  Cells FindWidening(const SkdQueryShape& shape, const Search& search) const;

  const SkdParts& Mesh;
  const SkdSearchRules& Rules;
  skd::Box3 Bounds;
  std::size_t NumberOfCells = 0;
};
}

#endif
