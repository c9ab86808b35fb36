// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdLeafFilters_h
#define SkdLeafFilters_h

#include "Cells/Search/SkdCellStore.h"
#include "Core/Search/LeafFilters/LeafPackets.h"
#include "Core/Search/Tree/Tree.h"

#include <memory>

namespace skdtree
{
/// The cells of leaves on 16-bit grids, eight at once, which exclude most candidates of a query
/// before exact tests. Leaf filters never change an answer: excluded cells are proven not to be
/// one, including rounding.
///
/// Triangles are kept as they are, 24 bytes each; volume cells as the planes along their faces, 8
/// bytes a plane. Where all cells are triangles, their corners are stored beside them, each once a
/// leaf: 15 bytes a triangle for points in single precision, else 30. A line then finds all data of
/// a leaf together. Where all are such volume cells, their boxes are kept on the grid, too, 14
/// bytes each. Immutable once built and thread-safe.
class SkdLeafFilters
{
public:
  SkdLeafFilters();
  /// `rounding`: the distance from a cell up to which a point counts as inside. Tags the leaves
  /// that can be filtered: those with only triangles, or only such volume cells. Drops leaves of
  /// the tree if they all are, and all of the same kind.
  SkdLeafFilters(const SkdCellStore& store, skd::Tree<3>& tree, double rounding);
  SkdLeafFilters(SkdLeafFilters&&) noexcept;
  SkdLeafFilters& operator=(SkdLeafFilters&&) noexcept;
  ~SkdLeafFilters();

  /// For the leaf filters of Core/Search/LeafFilters/TriangleLeafFilters.h.
  const skd::TrianglePackets& GetTriangles() const { return this->Triangles; }

  /// For skd::CompactTree: of trees whose leaves were dropped.
  const skd::LeafCorners& GetCorners() const { return this->Corners; }

  /// For skd::PlaneLeafFilter.
  const skd::PlanePackets& GetPlanes() const { return this->Planes; }

  std::size_t MemorySize() const;

private:
  class Arrays;

  std::unique_ptr<const Arrays> Stored;
  skd::TrianglePackets Triangles;
  skd::PlanePackets Planes;
  skd::LeafCorners Corners;
};
}

#endif
