// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdEqualCells_h
#define SkdEqualCells_h

#include "Core/Geometry/Rows.h"
#include "Core/Search/Tree/Tree.h"

#include <cstdint>
#include <vector>

namespace skdtree
{
class SkdCellStore;

/// The cells of a store in groups of equal ones: of one shape, with the same coordinates in the
/// same order, so that every kernel gives the same answer for them to the last bit. No box tells
/// them apart, and a query that needs only one of them, that with the lowest id, would look at all.
/// Polyhedra and cells of shape Generic, whose coordinates do not say all, are equal to none.
class SkdEqualCells
{
public:
  /// O(N log N), in parallel for the most part.
  explicit SkdEqualCells(const SkdCellStore& store);

  /// Whether there may be so many at one position that it matters: some node has equal boxes only.
  /// Of large trees a sample of the nodes is looked at, in which no group of a thousandth of all
  /// cells is missed.
  static bool AreLikely(const skd::Tree<3>& tree);

  /// The first of each group, ascending: as many as the store has if no two are equal.
  const std::vector<std::uint32_t>& GetFirsts() const { return this->Firsts; }

  /// Calls visit(cell) for the cells of a group, ascending, until it returns false.
  template <class Visit>
  void VisitGroup(std::uint32_t group, const Visit& visit) const
  {
    const auto others = this->Others[group];
    bool isGoing = visit(this->Firsts[group]);
    for (const std::uint32_t* other = others.begin(); isGoing && other != others.end(); ++other)
    {
      isGoing = visit(*other);
    }
  }

  std::size_t MemorySize() const
  {
    return (this->Firsts.capacity() + this->Others.GetOffsets().capacity() +
             this->Others.GetItems().capacity()) *
      sizeof(std::uint32_t);
  }

private:
  void Group(const std::vector<std::uint32_t>& firstOf);

  std::vector<std::uint32_t> Firsts;
  skd::Rows<std::uint32_t, std::uint32_t> Others; // of each group
};
}

#endif
