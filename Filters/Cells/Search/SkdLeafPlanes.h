// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdLeafPlanes_h
#define SkdLeafPlanes_h

#include "Cells/Search/SkdCellStore.h"
#include "Core/Search/LeafFilters/PlaneRow.h"
#include "Core/Search/Tree/Frame.h"

#include <cstdint>

namespace skdtree
{
/// Of a cell, at most SkdMostPlanes: of a polyhedron's faces the others are left out.
constexpr int SkdMostPlanes = 16;
int SkdNumberOfPlanes(const SkdCellStore& store, std::uint32_t cell);

/// Whether all cells are hexahedra, and slabs nearly as tight as planes around nearly all of them.
bool SkdFillSlabs(const SkdCellStore& store);

/// Makes the planes of one leaf's cells on its grid.
class SkdLeafPlanes
{
public:
  SkdLeafPlanes(const SkdCellStore& store, const skd::Frame<3>& frame,
    const skd::QuantizationGrid& grid, double margin)
    : Store(store)
    , Frame(frame)
    , Grid(grid)
    , Margin(margin)
  {
  }

  /// Of the cells whose bits are set, in as many rows as there are planes of one.
  void Set(const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const;
  /// Of hexahedra.
  void Set(const std::uint32_t* cells, unsigned lanes, skd::SlabPacket& packet) const;

private:
  unsigned SetLike(
    int first, const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const;
  template <class Shape>
  void SetEach(const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const;
  template <class Shape>
  void SetTogether(const std::uint32_t* cells, unsigned lanes, skd::PlaneRow* rows) const;
  void SetPolyhedron(int lane, std::uint32_t cell, skd::PlaneRow* rows) const;
  template <class Shape>
  skd::CornerLanes<Shape> CornersOf(const std::uint32_t* cells, unsigned lanes) const;
  template <class Visit>
  void Gather(std::uint32_t cell, int count, const Visit& visit) const;

  const SkdCellStore& Store;
  const skd::Frame<3>& Frame;
  skd::QuantizationGrid Grid;
  double Margin;
};
}

#endif
