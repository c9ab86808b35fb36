// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSieves_h
#define SkdSieves_h

#include "Cells/SkdCellStore.h"
#include "Core/Sieves/PlaneRow.h"
#include "Core/Sieves/TriangleSieves.h"
#include "Core/Tree/Tree.h"

/// What the cells of bottom nodes look like on 16-bit rasters, eight at once: enough to see of
/// most candidates of a query that they need no exact test. Sieves never change an answer: what
/// they leave out is proven to be no answer, rounding included.
///
/// Triangles are kept as they are, 20 bytes each; volume cells as the planes along their faces, 8
/// bytes a plane. Constant once built: any number of threads may use it.
class SkdSieves
{
public:
  SkdSieves() = default;
  /// `rounding`: at what distance from a cell a point still counts as inside. Tags the bottom nodes
  /// that can be sieved: those with nothing but triangles, or nothing but such volume cells.
  SkdSieves(const SkdCellStore& store, skd::Tree<3>& tree, double rounding);

  /// For the sieves of Core/Sieves/TriangleSieves.h.
  skd::TrianglePacks Packs() const { return skd::TrianglePacks(this->Triangles.data()); }

  /// Which volume cells may hold a point.
  class Point
  {
  public:
    Point(const SkdSieves& sieves, const skd::Vector3& local)
      : Rows(sieves.Rows.data())
      , Local(local)
    {
    }
    bool Knows(const skd::Node<3>& bottom) const { return HasPlanes(bottom); }
    unsigned Pass(const skd::Node<3>& bottom, float* keys) const;

  private:
    const skd::PlaneRow* Rows;
    const skd::Vector3& Local;
  };

  std::size_t MemorySize() const;

private:
  /// Lies in the bottom node itself, which is in the caches when its rows are asked for.
  struct PlaneNote
  {
    skd::Raster Raster;
    std::uint32_t Count; ///< of rows
  };

  // A tag is twice the number of a pack of triangles, or of a row of planes and 1 more.
  static bool HasPlanes(const skd::Node<3>& bottom)
  {
    return (bottom.Tag & 1u) != 0 && bottom.Tag != skd::Node<3>::NoTag;
  }

  void Number(const SkdCellStore& store, skd::Tree<3>& tree);
  void FillTriangles(
    const SkdCellStore& store, const skd::Tree<3>& tree, const skd::Node<3>& bottom);
  PlaneNote FillPlanes(const SkdCellStore& store, const skd::Tree<3>& tree,
    const skd::Node<3>& bottom, double rounding);

  skd::RawVector<skd::TrianglePack> Triangles;
  skd::RawVector<skd::PlaneRow> Rows; // those of a bottom node in turn
};

//------------------------------------------------------------------------------
inline unsigned SkdSieves::Point::Pass(const skd::Node<3>& bottom, float*) const
{
  const skd::PlaneRow* row = this->Rows + (bottom.Tag >> 1);
  const auto note = bottom.Read<PlaneNote>();
  const skd::Vector3 x = note.Raster.Of(this->Local);
  const float place[3] = { static_cast<float>(x[0]), static_cast<float>(x[1]),
    static_cast<float>(x[2]) };
  unsigned passed = bottom.Occupied();
  for (std::uint32_t i = 0; i < note.Count && passed != 0; ++i)
  {
    passed &= row[i].MayHold(place);
  }
  return passed;
}

#endif
