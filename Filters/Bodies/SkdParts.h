// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdParts.h
 * @brief The parts of a geometry, one data set and one tree each; trees are reused while a part is
 * unchanged.
 */

#ifndef SkdParts_h
#define SkdParts_h

#include "Cells/Read/SkdMeshSnapshot.h"
#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Simplices/SimplexSet.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdSourceTrees.h"

#include <map>
#include <memory>
#include <vector>

namespace skdtree
{
/// When to build the tree of a part: testing all cells once takes a fraction of the time of a
/// build.
enum class SkdTreeWanted
{
  AtOnce,
  IfUsedBefore ///< until then the tree is bare
};

class SkdParts
{
public:
  /// Of what blocks are parts of, by block index: Epsilon is relative to its diagonal.
  using Wholes = std::map<int, SkdMeshExtent>;

  /// Updates the trees to the blocks that have cells. Returns the number of trees built. Throws
  /// std::length_error if a part has more cells or points than a tree can hold. A block that is not
  /// in `wholes` is the whole.
  int Update(const std::vector<SkdBlock>& blocks, double epsilon, const SkdMagnitudes& magnitudes,
    SkdTreeWanted wanted = SkdTreeWanted::AtOnce, const Wholes& wholes = {});

  std::uint32_t GetNumberOfParts() const { return static_cast<std::uint32_t>(this->Parts.size()); }
  std::vector<int> GetBlockIndices() const; // one a part
  const SkdCellTree& GetTree(std::uint32_t part) const { return *this->Parts[part].Tree; }

  /// The working memory of the calling thread's queries.
  SkdCellSource GetSource(std::uint32_t part) const;

  /// Of all cells that are in the trees; empty if there are none.
  skd::Box3 GetBounds() const;

  /// The distance from a point to the nearest cell, infinity if none is within `limit`.
  /// Thread-safe.
  double FindDistance(const skd::Vector3& x, double limit) const;

  /// Whether the distance between a set and some cell is at most `maxDistance`; curved cells are
  /// approximated as in SkdCellTree::GetSimplices. Thread-safe.
  bool AreWithin(const skd::SimplexSet& set, double maxDistance) const;

  SkdTreeCounts GetCounts() const;

private:
  struct Part
  {
    int BlockIndex = 0;
    double Epsilon = 0.0;
    SkdMeshExtent Whole;
    SkdMeshSnapshot Mesh;
    std::shared_ptr<const SkdCellTree> Tree;

    /// Whether a tree was built.
    bool Update(const SkdBlock& block, double epsilon, const SkdMeshExtent& whole,
      const SkdMagnitudes& magnitudes, SkdTreeWanted wanted);
  };
  std::vector<Part> Parts;
};
}

#endif
