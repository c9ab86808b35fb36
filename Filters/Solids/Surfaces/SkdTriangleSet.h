// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTriangleSet.h
 * @brief All surfaces of a data object as one set of triangles with a tree, reused while unchanged.
 */

#ifndef SkdTriangleSet_h
#define SkdTriangleSet_h

#include "Core/Geometry/RigidMotion.h"
#include "Core/Geometry/Rows.h"
#include "Core/Geometry/Vector.h"
#include "Core/Parallel/Processes.h"
#include "Pipeline/SkdBlockSnapshots.h"
#include "Pipeline/SkdBlocks.h"
#include "Solids/Surfaces/SkdCopies.h"
#include "Solids/Surfaces/SkdTriangleReader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace skd
{
template <int D>
class LazyTree;
}

namespace skdtree
{
/// The surface cells of all blocks and the outer faces of their volume cells, triangulated without
/// new points (polygons by SkdTriangulation, so that adjacent cells still match). Ghost cells are
/// ignored.
///
/// A set is first only read; only a completed set has a tree and merged points of equal
/// coordinates, also of different blocks. Points can be merged without a tree.
class SkdTriangleSet
{
public:
  using Corners = SkdReadTriangles::Corners;
  using Cell = SkdTriangleCell;
  using PointList = skd::RawVector<skd::Vector3>;
  using TriangleList = skd::RawVector<Corners>;

  SkdTriangleSet();
  ~SkdTriangleSet();
  SkdTriangleSet(SkdTriangleSet&& other) noexcept;
  SkdTriangleSet& operator=(SkdTriangleSet&& other) noexcept;

  /// Of triangles that were made, instead of read. Their bounds are found, and what else depends on
  /// coordinates; these are such as have been read.
  explicit SkdTriangleSet(SkdReadTriangles made);

  /// Updates the set to `blocks`, with curved faces as facets within a chordal deviation relative
  /// to the diagonal of all (see SkdChordalLength). Returns whether it was read or is unchanged.
  /// With processes each has a piece, and what is relative to the largest coordinate is so to that
  /// of all.
  bool Update(const std::vector<SkdBlock>& blocks, double chordalDeviation,
    const skd::Processes* processes = nullptr);

  /// A copy in which the blocks from `firstBlock` on are moved, and their points rounded. Triangles
  /// two corners of which have become one are left out; a reflection turns them, so that outside
  /// stays outside. Points of this set must not be merged; cells and origins are the same. Empty if
  /// points are no longer finite. O(n).
  std::optional<SkdTriangleSet> Moved(int firstBlock, const skd::RigidMotion& motion) const;

  /// Moves all points, which must not be merged. Triangles two corners of which have become one are
  /// left out. O(n).
  void PutPoints(PointList points);

  /// Some triangles, ascending, as a set of their own, with the points that they have in the same
  /// order (`points`: in this set) and the extents of all: placements and thresholds are the same,
  /// and so is what depends on the order of triangles and points. O(n) for n of them, and a bit for
  /// each point of this set.
  SkdTriangleSet Subset(
    const std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& points) const;

  /// What depends on where points are.
  struct Extents
  {
    skd::Box3 Bounds;
    double LeastCoordinate; ///< other than 0
    double LeastArea;       ///< see SkdReadTriangles
  };

  /// Moves the points from one on, merged ones, to where a motion takes others, and finds their
  /// bounds. `extents` are those of the points before, and a bound of all areas. Returns whether
  /// all are finite. O(n).
  bool PlacePoints(std::uint32_t first, const PointList& from, const skd::RigidMotion& motion,
    const Extents& extents, skd::Box3& bounds);
  Extents FindExtents(std::uint32_t end) const; ///< of the points before one, and all areas

  /// The deviation as a length; 0 if no cell is curved.
  double GetChordalLength() const { return this->ChordalLength; }

  /// See SkdBlockSurface.
  vtkIdType GetNumberOfCoarseFaces() const { return this->Read.CoarseFaces; }

  /// Merges equal points, unless done before. O(n).
  void MergePoints();

  /// Leaves triangles of which there are very many out of all searches, and of the pieces that the
  /// set is split into: all but the first `kept` of each (SkdFindCopies). Merges points, too.
  /// Returns them.
  const std::vector<SkdDuplicate>& LeaveOutCopies(std::size_t mostCopies);

  const std::vector<SkdDuplicate>& GetCopiesLeftOut() const { return this->Copies; }

  /// @{ The triangles that are searched, ascending; empty if these are all.
  const std::vector<std::uint32_t>& GetSearched() const { return this->Searched; }
  bool IsSearched(std::uint32_t triangle) const
  {
    return this->Searched.empty() ||
      std::binary_search(this->Searched.begin(), this->Searched.end(), triangle);
  }
  ///@}

  /// @{ Merges equal points, leaves out copies but for SkdManyCopies of each, and begins the tree,
  /// unless done before. O(n).
  void Complete();
  bool IsComplete() const { return this->Tree != nullptr; }
  ///@}

  /// Merges points as Complete() does, but only the corners of some triangles: those of equal
  /// coordinates are replaced by the first of them. The order of point numbers does not change, so
  /// results in that order are the same. About a nanosecond a point of the set, without a hash
  /// table of all.
  void MakeCornersOne(const std::vector<std::uint32_t>& triangles);

  /// The point that one that was read, or made, has become. Points must be merged.
  std::uint32_t GetPointOf(std::uint32_t read) const { return this->PointOf[read]; }
  const std::vector<std::uint32_t>& GetMerging() const { return this->PointOf; } ///< of all

  /// Whether a point that was read is of a block, or of one after it.
  bool IsOfBlocksFrom(std::uint32_t read, int block) const
  {
    return this->Read.Origins[read].Block >= block;
  }

  const PointList& GetPoints() const { return this->Read.Points; }
  const TriangleList& GetTriangles() const { return this->Read.Triangles; }
  /// Of those that are searched. The set must be complete.
  const skd::LazyTree<3>& GetTree() const { return *this->Tree; }

  /// @{ The cells that have triangles, by ascending (block, id), and the index of each triangle's
  /// cell. Triangles are in the order of their cells.
  const skd::RawVector<Cell>& GetCells() const { return this->Read.Cells; }
  std::uint32_t GetCellOf(std::uint32_t triangle) const { return this->Read.CellOf[triangle]; }
  ///@}

  /// The point of a block that corresponds to a point of the set; -1 for one that its surface has
  /// added.
  struct Origin
  {
    int Block;
    vtkIdType Id;

    bool operator<(const Origin& o) const
    {
      return this->Block != o.Block ? this->Block < o.Block : this->Id < o.Id;
    }
  };

  /// The origins of each point of a complete set: all points merged into it, ascending. O(n) at the
  /// first call, as most points have one origin; they are kept. Not thread-safe.
  const skd::Rows<Origin>& GetOrigins() const;

  /// How many points from one on follow each other in one data set, too, by the first origin of
  /// each that a data set has; 1 if it has none. GetOrigins() comes first.
  std::uint32_t CountInRun(std::uint32_t point) const
  {
    return *std::upper_bound(this->EndsOfRuns.begin(), this->EndsOfRuns.end(), point) - point;
  }

  /// Faces that have points that are not finite, or fewer than three different ones.
  vtkIdType GetNumberOfFacesLeftOut() const { return this->Read.LeftOut; }

  /// Points with coordinates that were taken as 0: see SkdTriangleReader.
  vtkIdType GetNumberOfTinyPoints() const { return this->Read.TinyPoints; }

  /// The least magnitude of coordinates other than 0.
  double GetLeastCoordinate() const { return this->Read.LeastCoordinate; }

  const skd::Box3& GetBounds() const { return this->Read.Bounds; }

  /// The largest magnitude of a coordinate, of all processes.
  double GetLargestCoordinate() const;

  /// A lower bound of the width of triangles, smaller than most where triangles are small.
  double GetLeastWidth() const;

private:
  void BuildTree();
  void FindRuns() const;

  SkdBlockSnapshots Meshes;
  double ChordalLength = 0.0;
  double LargestElsewhere = 0.0; // coordinate of other processes
  SkdReadTriangles Read;
  std::vector<std::uint32_t> PointOf; // of each point that was read, when merged
  bool IsRead = false;
  bool IsMerged = false;
  bool AreCopiesKnown = false;
  std::vector<SkdDuplicate> Copies;              // that are not searched
  std::vector<std::uint32_t> Searched;           // the others, if there are copies
  mutable skd::Rows<Origin> Origins;             // of each point, once they are asked for
  mutable std::vector<std::uint32_t> EndsOfRuns; // of points, see CountInRun
  std::unique_ptr<const skd::LazyTree<3>> Tree;  // of a complete set
};
}

#endif
