// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSieves_h
#define SkdSieves_h

#include "Cells/SkdCellStore.h"
#include "Core/Sieves/PlaneRow.h"
#include "Core/Sieves/TriangleSieves.h"
#include "Core/Tree/Tree.h"

#include <vector>

/// What the cells of leaves look like on 16-bit rasters, eight at once: enough to see of
/// most candidates of a query that they need no exact test. Sieves never change an answer: what
/// they leave out is proven to be no answer, rounding included.
///
/// Triangles are kept as they are, 24 bytes each; volume cells as the planes along their faces, 8
/// bytes a plane. Where all cells are triangles, their corners lie beside, too, each once a leaf:
/// 15 bytes a triangle of points in single precision, 30 of others. What a line needs of a
/// leaf is then at hand at once. Constant once built: any number of threads may use it.
class SkdSieves
{
public:
  SkdSieves() = default;
  /// `rounding`: at what distance from a cell a point still counts as inside. Tags the leaves
  /// that can be sieved: those with nothing but triangles, or nothing but such volume cells.
  SkdSieves(const SkdCellStore& store, skd::Tree<3>& tree, double rounding);

  /// For the sieves of Core/Sieves/TriangleSieves.h.
  skd::TrianglePacks Packs() const
  {
    return { this->Triangles.data(),
      { this->FloatPoints.empty() ? nullptr : this->FloatPoints.data(),
        this->Points.empty() ? nullptr : this->Points.data() } };
  }

  /// Which volume cells may hold a point.
  class Point
  {
  public:
    static constexpr bool SkipsLeaves = true;

    Point(const SkdSieves& sieves, const skd::Vector3& local)
      : Sieves(sieves)
      , Local(local)
    {
    }
    bool Knows(const skd::Node<3>& node) const { return HasPlanes(node); }
    unsigned Pass(const skd::Node<3>& leaf, float* keys) const
    {
      return this->Pass(leaf.Tag >> 1, leaf.Count, keys);
    }
    unsigned Pass(std::uint32_t number, std::uint32_t count, float* keys) const;
    void Fetch(std::uint32_t number) const;

  private:
    const SkdSieves& Sieves;
    const skd::Vector3& Local;
  };

  std::size_t MemorySize() const;

private:
  /// The planes of a leaf's cells: where they begin, and the raster that they are on.
  struct PlaneBlock
  {
    skd::Raster Raster;
    std::uint32_t FirstRow;
    std::uint32_t Count; ///< of rows
  };

  // A tag is twice the number of a pack of triangles, or of a block of planes and 1 more. If all
  // leaves have packs, or all blocks, these have the numbers of the nodes, and inner nodes
  // have a note about those of their children.
  static bool HasPlanes(const skd::Node<3>& node)
  {
    return (node.Tag & 1u) != 0 && node.Tag != skd::Node<3>::NoTag;
  }

  static std::uint32_t TagOfBlock(std::uint32_t block) { return 2 * block + 1; }

  /// Of leaves, and of those that have a pack or a block.
  struct Counts
  {
    std::uint32_t Leaves = 0;
    std::uint32_t Packs = 0;
    std::uint32_t Blocks = 0;
  };

  /// Tags leaves for a pack, or with the number of rows that they need.
  static Counts Census(const SkdCellStore& store, skd::Tree<3>& tree);
  static void CountIn(
    const SkdCellStore& store, skd::Tree<3>& tree, std::uint32_t index, Counts& counts);
  /// Gives packs and blocks their numbers, but packs of all leaves, which take theirs when
  /// they are filled. Whether the numbers are those of the leaves.
  bool Number(skd::Tree<3>& tree, const Counts& counts);
  void NumberRows();
  void FillTriangles(const SkdCellStore& store, const skd::Tree<3>& tree, const skd::Node<3>& leaf);
  void FillPoints(const SkdCellStore& store, const skd::Tree<3>& tree);
  /// `firsts`: where the points of each piece of the packs begin.
  template <class Real>
  void CopyPoints(const SkdCellStore& store, const skd::Tree<3>& tree,
    const std::vector<std::uint64_t>& firsts, skd::RawVector<Real>& points);
  void FillPlanes(
    const SkdCellStore& store, const skd::Tree<3>& tree, const skd::Node<3>& leaf, double rounding);

  skd::RawVector<skd::TrianglePack> Triangles;
  skd::RawVector<float> FloatPoints; // of the packs, in turn, if all leaves have one: in
  skd::RawVector<double> Points;     // single precision or, where that is not enough, in double
  skd::RawVector<PlaneBlock> Blocks;
  skd::RawVector<skd::PlaneRow> Rows; // those of a block in turn
  std::uint32_t CommonRows = 0;       // of each block, or 0
};

//------------------------------------------------------------------------------
inline unsigned SkdSieves::Point::Pass(std::uint32_t number, std::uint32_t count, float*) const
{
  const PlaneBlock& block = this->Sieves.Blocks[number];
  const skd::PlaneRow* row = this->Sieves.Rows.data() + block.FirstRow;
  const skd::Vector3 x = block.Raster.Of(this->Local);
  const float place[3] = { static_cast<float>(x[0]), static_cast<float>(x[1]),
    static_cast<float>(x[2]) };
  unsigned passed = skd::LowBits(count);
  for (std::uint32_t i = 0; i < block.Count && passed != 0; ++i)
  {
    passed &= row[i].MayHold(place);
  }
  return passed;
}

//------------------------------------------------------------------------------
inline void SkdSieves::Point::Fetch(std::uint32_t number) const
{
  skd::FetchLines<sizeof(PlaneBlock)>(&this->Sieves.Blocks[number]);
  const std::uint32_t rows = this->Sieves.CommonRows;
  for (std::uint32_t i = 0; i < rows; ++i)
  {
    skd::FetchLines<sizeof(skd::PlaneRow)>(&this->Sieves.Rows[number * std::uint64_t(rows) + i]);
  }
}

#endif
