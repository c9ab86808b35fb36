// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdPieceRuns.h"
#include "Cells/Kernels/SkdPolyKernels.h"
#include "Cells/Read/SkdTolerances.h"

#include "Core/Geometry/Distance/Distance.h"

#include <algorithm>

namespace skdtree
{
namespace
{
constexpr std::uint32_t Many = 64; // pieces; fewer are looked through as fast

/// The points of a piece of such a cell; 0 of others.
std::uint32_t SizeOfPiece(SkdShape shape)
{
  return shape == SkdShape::Strip ? 3
    : shape == SkdShape::PolyLine ? 2
                                  : (shape == SkdShape::PolyVertex ? 1 : 0);
}
}

//------------------------------------------------------------------------------
SkdPieceRuns::SkdPieceRuns(const SkdCellStore& store, double rounding)
{
  const SkdShape first = store.ShapeOf(0);
  if (SizeOfPiece(first) == 0 && store.IsAllOf(first))
  {
    return;
  }
  for (std::uint32_t cell = 0; cell < store.NumberOfCells(); ++cell)
  {
    const std::uint32_t size = SizeOfPiece(store.ShapeOf(cell));
    if (size > 0 && store.SizeOf(cell) >= Many + size - 1)
    {
      this->Add(store, cell, store.SizeOf(cell) - size + 1, rounding);
    }
  }
}

//------------------------------------------------------------------------------
void SkdPieceRuns::Add(
  const SkdCellStore& store, std::uint32_t cell, std::uint32_t pieces, double rounding)
{
  Row row{ cell, pieces, { this->Boxes.size() } };
  const std::uint32_t* const ids = store.PointIdsOf(cell);
  for (std::uint32_t first = 0; first < pieces; first += Width)
  {
    skd::Box3 box;
    std::for_each(ids + first, ids + std::min(first + Width + 2, store.SizeOf(cell)),
      [&](std::uint32_t id) { box.Add(store.Point(id)); });
    this->Boxes.push_back(box.Inflated(rounding));
  }
  row.Levels.push_back(this->Boxes.size());
  for (std::size_t begin = row.Levels[0]; row.Levels.back() - begin > 1;)
  {
    const std::size_t end = row.Levels.back();
    for (std::size_t first = begin; first < end; first += Width)
    {
      skd::Box3 box;
      for (std::size_t i = first; i < std::min<std::size_t>(first + Width, end); ++i)
      {
        box.Add(this->Boxes[i]);
      }
      this->Boxes.push_back(box);
    }
    row.Levels.push_back(this->Boxes.size());
    begin = end;
  }
  this->Rows.push_back(std::move(row));
}

//------------------------------------------------------------------------------
const SkdPieceRuns::Row* SkdPieceRuns::Find(std::uint32_t cell) const
{
  const auto found = std::lower_bound(this->Rows.begin(), this->Rows.end(), cell,
    [](const Row& row, std::uint32_t wanted) { return row.Cell < wanted; });
  return found != this->Rows.end() && found->Cell == cell ? &*found : nullptr;
}

//------------------------------------------------------------------------------
/// For the nearest piece, ties to the first.
class SkdPieceRuns::Search
{
public:
  Search(const SkdPieceRuns& runs, const Row& row, const SkdCellStore& store, const skd::Vector3& x,
    double limit2)
    : Boxes(runs.Boxes)
    , TheRow(row)
    , Store(store)
    , X(x)
    , Limit2(limit2)
  {
  }

  /// Looks at what is below a box of a level, the nearest first.
  void Visit(std::size_t level, std::size_t box)
  {
    if (level == 0)
    {
      this->Measure(static_cast<std::uint32_t>(box - this->TheRow.Levels[0]));
      return;
    }
    const std::size_t first =
      this->TheRow.Levels[level - 1] + Width * (box - this->TheRow.Levels[level]);
    const std::size_t count = std::min<std::size_t>(Width, this->TheRow.Levels[level] - first);
    double keys[Width];
    for (std::size_t i = 0; i < count; ++i)
    {
      // Less than what rounding makes of the distance of any piece in it.
      keys[i] =
        (1.0 - SkdTolerances::PieceDistance2) * skd::MinDistance2(this->X, this->Boxes[first + i]);
    }
    for (std::size_t visited = 0; visited < count; ++visited)
    {
      double* const least = std::min_element(keys, keys + count);
      if (!(*least <= this->Limit2))
      {
        return;
      }
      *least = std::numeric_limits<double>::infinity();
      this->Visit(level - 1, first + static_cast<std::size_t>(least - keys));
    }
  }

  SkdCellPoint Found{ {}, { { 0.0, 0.0, 0.0 } }, std::numeric_limits<double>::infinity() };

private:
  void Measure(std::uint32_t run)
  {
    const std::uint32_t begin = run * Width;
    const SkdShape shape = this->Store.ShapeOf(this->TheRow.Cell);
    const std::uint32_t size =
      std::min(Width, this->TheRow.Pieces - begin) + SizeOfPiece(shape) - 1;
    const std::uint32_t* const ids = this->Store.PointIdsOf(this->TheRow.Cell) + begin;
    skd::Vector3 points[Width + 2];
    for (std::uint32_t i = 0; i < size; ++i)
    {
      points[i] = this->Store.Point(ids[i]);
    }
    SkdCellPoint nearest = SkdPolyKernels::Closest(
      { shape, points, static_cast<int>(size), nullptr, nullptr }, this->X, this->Limit2);
    nearest.SubId += static_cast<int>(begin);
    const bool isEarlier = nearest.Dist2 == this->Found.Dist2 && nearest.SubId < this->Found.SubId;
    if (nearest.Dist2 < this->Found.Dist2 || isEarlier)
    {
      this->Found = nearest;
      this->Limit2 = std::min(this->Limit2, nearest.Dist2);
    }
  }

  const std::vector<skd::Box3>& Boxes;
  const Row& TheRow;
  const SkdCellStore& Store;
  const skd::Vector3& X;
  double Limit2;
};

//------------------------------------------------------------------------------
SkdCellPoint SkdPieceRuns::Closest(
  const SkdCellStore& store, std::uint32_t cell, const skd::Vector3& x, double limit2) const
{
  const Row& row = *this->Find(cell);
  Search search(*this, row, store, x, limit2);
  search.Found.Point = x;
  const std::size_t top = row.Levels.size() - 2;
  search.Visit(top, row.Levels[top]);
  return search.Found;
}

//------------------------------------------------------------------------------
std::size_t SkdPieceRuns::MemorySize() const
{
  return this->Boxes.capacity() * sizeof(skd::Box3) + this->Rows.capacity() * sizeof(Row);
}
}
