// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// How the points and cells of a data set get into a store.
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdStoredValues.h"
#include "Cells/Search/SkdCellStore.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>

namespace skdtree
{
namespace
{
/// Tells which cells of a data set belong in the tree. Constant: threads may share it.
class CellSelection
{
public:
  CellSelection(vtkDataSet* data, bool skipGhosts)
    : CellGhosts(data->GetCellGhostArray())
    , PointGhosts(IsStructured(data) ? data->GetPointGhostArray() : nullptr)
    , Unwanted(vtkDataSetAttributes::HIDDENCELL)
  {
    if (skipGhosts)
    {
      this->Unwanted |= vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL;
    }
  }

  template <class Id>
  bool Keeps(vtkIdType cellId, const Id* pointIds, std::size_t size) const
  {
    if (this->CellGhosts && (this->CellGhosts->GetValue(cellId) & this->Unwanted) != 0)
    {
      return false;
    }
    return !this->PointGhosts || !this->HasHiddenPoint(pointIds, size);
  }

private:
  // Structured data are blanked by points, too: a cell with a hidden point is not visible.
  static bool IsStructured(vtkDataSet* data)
  {
    return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data) ||
      vtkStructuredGrid::SafeDownCast(data);
  }

  template <class Id>
  bool HasHiddenPoint(const Id* pointIds, std::size_t size) const
  {
    return std::any_of(pointIds, pointIds + size,
      [this](Id id)
      {
        const unsigned char mark = this->PointGhosts->GetValue(static_cast<vtkIdType>(id));
        return (mark & vtkDataSetAttributes::HIDDENPOINT) != 0;
      });
  }

  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  int Unwanted;
};

bool IsWhole(SkdShape shape, std::size_t size)
{
  const auto expected = static_cast<std::size_t>(SkdNumberOfPoints(shape));
  return shape != SkdShape::None && size > 0 && (expected == 0 || size == expected);
}

/// The largest of some numbers, without their signs, by its bits: these are in the same order, and
/// those of infinity and NaN above all others.
template <class Bits, class Real>
Real LargestOf(const Real* values, vtkIdType count)
{
  static_assert(sizeof(Bits) == sizeof(Real));
  Bits largest = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    Bits bits;
    std::memcpy(&bits, values + i, sizeof(bits));
    largest = std::max(largest, bits & std::numeric_limits<Bits>::max() >> 1);
  }
  Real value;
  std::memcpy(&value, &largest, sizeof(value));
  return value;
}

/// The result of the first check of a cell: its shape, None to ignore it, or this value to ignore
/// and count it.
constexpr auto NotFinite = static_cast<SkdShape>(255);

/// Cells one after the other that one thread reads.
struct Block
{
  static constexpr vtkIdType Size = 8192;

  std::uint32_t Cells = 0;    // that are kept; then: where the next one goes
  std::uint64_t PointIds = 0; // of these, likewise
  vtkIdType Bad = 0;          // points that are not finite
  vtkIdType Other = 0;
  SkdShape Least = NotFinite; // of the shapes of those that are kept
  SkdShape Most = SkdShape::Vertex;

  void Count(SkdShape shape, std::size_t size)
  {
    if (shape >= SkdShape::None)
    {
      ++(shape == NotFinite ? this->Bad : this->Other);
      return;
    }
    ++this->Cells;
    this->PointIds += size;
    this->Least = std::min(this->Least, shape);
    this->Most = std::max(this->Most, shape);
  }
};

/// Prefix sums: sets the index of the first cell and point id of each block. Returns the totals.
Block AddUp(std::vector<Block>& blocks)
{
  Block total;
  for (Block& block : blocks)
  {
    const Block before = total;
    total.Cells += block.Cells;
    total.PointIds += block.PointIds;
    total.Bad += block.Bad;
    total.Other += block.Other;
    total.Least = std::min(total.Least, block.Least);
    total.Most = std::max(total.Most, block.Most);
    block.Cells = before.Cells;
    block.PointIds = before.PointIds;
  }
  return total;
}

/// All cells of a data set in blocks, in parallel.
class BlockLoop
{
public:
  BlockLoop(const SkdCellReader& reader, vtkIdType numberOfCells)
    : Blocks(static_cast<std::size_t>((numberOfCells + Block::Size - 1) / Block::Size))
    , Reader(reader)
    , NumberOfCells(numberOfCells)
  {
  }

  /// Calls body(block, cell id, point ids, their number).
  template <class Body>
  void Run(const Body& body)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Blocks.size()), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->RunBlock(i, body);
        }
      });
  }

  std::vector<Block> Blocks;

private:
  template <class Body>
  void RunBlock(vtkIdType i, const Body& body)
  {
    vtkIdList* list = this->Lists.Local();
    Block& block = this->Blocks[static_cast<std::size_t>(i)];
    const vtkIdType end = std::min(this->NumberOfCells, (i + 1) * Block::Size);
    this->Reader.VisitCells(i * Block::Size, end, list,
      [&](vtkIdType id, const auto* ids, std::size_t size) { body(block, id, ids, size); });
  }

  const SkdCellReader& Reader;
  vtkIdType NumberOfCells;
  vtkSMPThreadLocalObject<vtkIdList> Lists;
};
}

//------------------------------------------------------------------------------
void SkdCellStore::ReadPoints(vtkDataSet* data)
{
  this->NumberOfPoints = data->GetNumberOfPoints();
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  vtkDataArray* points = pointSet ? pointSet->GetPoints()->GetData() : nullptr;
  this->Points = SkdStoredPoints(points);
  if (this->Points.Floats || this->Points.Doubles)
  {
    this->SharedPoints = pointSet->GetPoints();
    this->SharedCoordinates = points;
    return;
  }
  this->OwnPoints.resize(3 * static_cast<std::size_t>(this->NumberOfPoints));
  double* own = this->OwnPoints.data();
  this->Points.Doubles = own;
  double x[3];
  data->GetPoint(0, x); // what is made at the first call must not be made by many threads
  vtkSMPTools::For(0, this->NumberOfPoints,
    [=](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        data->GetPoint(id, own + 3 * id);
      }
    });
}

//------------------------------------------------------------------------------
// As SkdMagnitudes has it: where all are too small, none is taken.
bool SkdCellStore::ArePointsFinite()
{
  std::atomic<std::uint64_t> largestBits(0);
  vtkSMPTools::For(0, this->NumberOfPoints,
    [&](vtkIdType begin, vtkIdType end)
    {
      const vtkIdType first = 3 * begin, count = 3 * (end - begin);
      const double largest = this->Points.Floats
        ? LargestOf<std::uint32_t>(this->Points.Floats + first, count)
        : LargestOf<std::uint64_t>(this->Points.Doubles + first, count);
      std::uint64_t here;
      std::memcpy(&here, &largest, sizeof(here));
      std::uint64_t known = largestBits;
      while (known < here && !largestBits.compare_exchange_weak(known, here))
      {
      }
    });
  const std::uint64_t bits = largestBits;
  double largest;
  std::memcpy(&largest, &bits, sizeof(largest));
  if (0.0 < largest && largest < this->Magnitudes.Least)
  {
    this->Magnitudes.Largest = -1.0;
  }
  return largest <= this->Magnitudes.Largest;
}

//------------------------------------------------------------------------------
// Twice over the cells: what they are, then, when it is known where each goes, their points. Of a
// mesh of one shape, all of whose cells are kept, that is known at once.
void SkdCellStore::ReadCells(const SkdCellReader& reader, vtkDataSet* data, bool skipGhosts)
{
  const CellSelection selection(data, skipGhosts);
  const bool areFinite = this->ArePointsFinite();
  const vtkIdType numberOfCells = data->GetNumberOfCells();
  const int usualType = reader.TypeOf(0);
  const SkdShape usual = SkdShapeOfCellType(usualType);
  const auto usualSize = static_cast<std::size_t>(SkdNumberOfPoints(usual));
  this->PointIds.resize(static_cast<std::size_t>(numberOfCells) * usualSize);
  skd::RawVector<SkdShape> shapes(static_cast<std::size_t>(numberOfCells));
  BlockLoop loop(reader, numberOfCells);
  loop.Run(
    [&](Block& block, vtkIdType id, const auto* ids, std::size_t size)
    {
      const int type = reader.TypeOf(id);
      SkdShape shape = type == usualType ? usual : SkdShapeOfCellType(type);
      const bool isKept = selection.Keeps(id, ids, size);
      if (!areFinite && isKept && !this->ArePointsFinite(ids, size))
      {
        shape = NotFinite;
      }
      else if (!isKept || !IsWhole(shape, size))
      {
        shape = SkdShape::None;
      }
      else if (shape == usual && usualSize > 0)
      {
        this->PutPoints(static_cast<std::uint64_t>(id) * usualSize, ids, usualSize);
      }
      shapes[static_cast<std::size_t>(id)] = shape;
      block.Count(shape, size);
    });
  const Block total = AddUp(loop.Blocks);
  this->Missing = { total.Bad, total.Other };
  if (total.Cells == numberOfCells && total.Least == usual && total.Most == usual && usualSize > 0)
  {
    this->SizeFor(total.Cells, total.PointIds, usual, usual);
    return;
  }
  skd::RawVector<std::uint32_t>().swap(this->PointIds);
  this->SizeFor(total.Cells, total.PointIds, total.Least, total.Most);
  loop.Run(
    [&](Block& block, vtkIdType id, const auto* ids, std::size_t size)
    {
      const SkdShape shape = shapes[static_cast<std::size_t>(id)];
      if (shape < SkdShape::None)
      {
        this->Put(block.Cells++, id, shape, block.PointIds, ids, size);
        block.PointIds += size;
      }
    });
}

//------------------------------------------------------------------------------
/// Whether these points are finite, as SkdMagnitudes has it.
template <class Id>
bool SkdCellStore::ArePointsFinite(const Id* ids, std::size_t size) const
{
  return std::all_of(ids, ids + size,
    [this](Id id)
    { return SkdIsWithin(this->Point(static_cast<std::uint32_t>(id)), this->Magnitudes.Largest); });
}

//------------------------------------------------------------------------------
// Meshes of one shape are the rule: these need neither shapes nor offsets.
void SkdCellStore::SizeFor(
  std::uint32_t cells, std::uint64_t pointIds, SkdShape least, SkdShape most)
{
  this->Count = cells;
  this->PointIds.resize(pointIds);
  if (this->Missing.NotFinite + this->Missing.Other > 0)
  {
    this->Ids.resize(cells);
  }
  const int size = cells > 0 && least == most ? SkdNumberOfPoints(least) : 0;
  if (size > 0)
  {
    this->CommonShape = least;
    this->CommonSize = static_cast<std::uint32_t>(size);
    return;
  }
  this->Shapes.resize(cells);
  this->Offsets.resize(std::size_t(cells) + 1);
  this->Offsets[0] = 0;
}

//------------------------------------------------------------------------------
template <class Id>
void SkdCellStore::Put(std::uint32_t cell, vtkIdType id, SkdShape shape, std::uint64_t first,
  const Id* ids, std::size_t size)
{
  this->PutPoints(first, ids, size);
  if (!this->Ids.empty())
  {
    this->Ids[cell] = static_cast<std::uint32_t>(id);
  }
  if (this->CommonSize == 0)
  {
    this->Shapes[cell] = shape;
    this->Offsets[std::size_t(cell) + 1] = first + size;
  }
}

//------------------------------------------------------------------------------
template <class Id>
void SkdCellStore::PutPoints(std::uint64_t first, const Id* ids, std::size_t size)
{
  std::transform(ids, ids + size, this->PointIds.data() + first,
    [](Id pointId) { return static_cast<std::uint32_t>(pointId); });
}
}
