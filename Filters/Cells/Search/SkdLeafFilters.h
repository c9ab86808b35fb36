// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdLeafFilters_h
#define SkdLeafFilters_h

#include "Cells/Search/SkdCellStore.h"
#include "Core/Search/LeafFilters/PlaneLeafFilter.h"
#include "Core/Search/LeafFilters/TriangleLeafFilters.h"
#include "Core/Search/Tree/Tree.h"

#include <vector>

namespace skdtree
{
/// The cells of leaves on 16-bit grids, eight at once, which exclude most candidates of a query
/// before exact tests. Leaf filters never change an answer: excluded cells are proven not to be
/// one, including rounding.
///
/// Triangles are kept as they are, 24 bytes each; volume cells as the planes along their faces, 8
/// bytes a plane. Where all cells are triangles, their corners are stored beside them, each once a
/// leaf: 15 bytes a triangle for points in single precision, else 30. A line then finds all data of
/// a leaf together. Immutable once built and thread-safe.
class SkdLeafFilters
{
public:
  SkdLeafFilters() = default;
  /// `rounding`: the distance from a cell up to which a point counts as inside. Tags the leaves
  /// that can be filtered: those with only triangles, or only such volume cells.
  SkdLeafFilters(const SkdCellStore& store, skd::Tree<3>& tree, double rounding);

  /// For the leaf filters of Core/Search/LeafFilters/TriangleLeafFilters.h.
  skd::TrianglePackets Packets() const
  {
    return { this->Triangles.data(),
      { this->FloatPoints.empty() ? nullptr : this->FloatPoints.data(),
        this->Points.empty() ? nullptr : this->Points.data() } };
  }

  /// For skd::PlaneLeafFilter.
  skd::PlanePackets Planes() const
  {
    return { this->PlanePackets.data(), this->Rows.data(), this->CommonRows };
  }

  std::size_t MemorySize() const;

private:
  // A tag is twice the number of a packet of triangles, or of a packet of planes and 1 more. If all
  // leaves have packets, or all packets of planes, these have the numbers of the nodes, and inner
  // nodes have a note about those of their children.

  /// Of leaves, and of those that have a packet of either kind.
  struct Counts
  {
    std::uint32_t Leaves = 0;
    std::uint32_t Packets = 0;
    std::uint32_t PlanePackets = 0;
  };

  /// Tags leaves for a packet, or with the number of rows that they need.
  static Counts Census(const SkdCellStore& store, skd::Tree<3>& tree);
  static void CountIn(
    const SkdCellStore& store, skd::Tree<3>& tree, std::uint32_t index, Counts& counts);
  /// Gives packets their numbers, but packets of all leaves, which take theirs when
  /// they are filled. Whether the numbers are those of the leaves.
  bool Number(skd::Tree<3>& tree, const Counts& counts);
  void NumberRows();
  void FillTriangles(const SkdCellStore& store, const skd::Tree<3>& tree, const skd::Node<3>& leaf);
  void FillPoints(const SkdCellStore& store, const skd::Tree<3>& tree);
  /// `firsts`: where the points of each piece of the packets begin.
  template <class Real>
  void CopyPoints(const SkdCellStore& store, const skd::Tree<3>& tree,
    const std::vector<std::uint64_t>& firsts, skd::RawVector<Real>& points);
  void FillPlanes(
    const SkdCellStore& store, const skd::Tree<3>& tree, const skd::Node<3>& leaf, double rounding);

  skd::RawVector<skd::TrianglePacket> Triangles;
  skd::RawVector<float> FloatPoints; // of the packets, in turn, if all leaves have one: in
  skd::RawVector<double> Points;     // single precision or, where that is not enough, in double
  skd::RawVector<skd::PlanePacket> PlanePackets;
  skd::RawVector<skd::PlaneRow> Rows; // those of a packet in turn
  std::uint32_t CommonRows = 0;       // of each packet, or 0
};
}

#endif
