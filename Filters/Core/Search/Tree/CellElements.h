// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_CellElements_h
#define skd_Tree_CellElements_h

#include "../../Geometry/CellPoints.h"
#include "Element.h"
#include "OutwardRounding.h"

#include <cstddef>
#include <cstdint>

namespace skd
{

/// The elements of cells that are in the box of their points: safety boxes are wider than these by
/// `margin` on each side.
class CellElements
{
public:
  CellElements(const CellPoints& cells, const Frame<3>& frame, double margin)
    : Cells(cells)
    , Rounding(frame, margin)
  {
  }

  void Read(const std::uint32_t* cells, std::size_t count, Element<3>* to) const
  {
    const PointArray& points = this->Cells.Points;
    points.Floats ? this->Read(points.Floats, cells, count, to)
                  : this->Read(points.Doubles, cells, count, to);
  }

private:
  /// Most meshes are of triangles, tetrahedra or hexahedra.
  template <class Number>
  void Read(
    const Number* points, const std::uint32_t* cells, std::size_t count, Element<3>* to) const
  {
    switch (this->Cells.Offsets ? 0 : this->Cells.Size)
    {
      case 3:
        return this->ReadEach(OfSize<3>{ this->Cells.Ids }, points, cells, count, to);
      case 4:
        return this->ReadEach(OfSize<4>{ this->Cells.Ids }, points, cells, count, to);
      case 8:
        return this->ReadEach(OfSize<8>{ this->Cells.Ids }, points, cells, count, to);
      default:
        return this->ReadEach(OfAnySize{ this->Cells }, points, cells, count, to);
    }
  }

  template <class PointIds, class Number>
  void ReadEach(const PointIds& pointIds, const Number* points, const std::uint32_t* cells,
    std::size_t count, Element<3>* to) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      PointBounds bounds;
      pointIds.ForEach(
        cells[i], [&](std::uint32_t id) { bounds.Add(points + 3 * static_cast<std::size_t>(id)); });
      this->Rounding.Round(bounds, to[i].Box);
      to[i].Index = cells[i];
    }
  }

  template <int Size>
  struct OfSize
  {
    template <class Visit>
    void ForEach(std::uint32_t cell, const Visit& visit) const
    {
      const std::uint32_t* const ids = this->Ids + std::size_t(Size) * cell;
      ForEachAxis<Size>([&](int i) { visit(ids[i]); });
    }

    const std::uint32_t* Ids;
  };

  struct OfAnySize
  {
    template <class Visit>
    void ForEach(std::uint32_t cell, const Visit& visit) const
    {
      const std::uint64_t* const offsets = this->Cells.Offsets;
      const std::uint64_t size = this->Cells.Size;
      const std::uint64_t last = offsets ? offsets[cell + 1] : size * cell + size;
      for (std::uint64_t i = offsets ? offsets[cell] : size * cell; i < last; ++i)
      {
        visit(this->Cells.Ids[i]);
      }
    }

    const CellPoints& Cells;
  };

  CellPoints Cells;
  OutwardRounding Rounding;
};

}

#endif
