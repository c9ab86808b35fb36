// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdCellCheck.h"

#include "Cells/Read/SkdCellSizes.h"
#include "Cells/Read/SkdFaceSource.h"
#include "Cells/Read/SkdIdRange.h"
#include "Cells/Read/SkdRawCells.h"
#include "Cells/Read/SkdStoredTypes.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeVersion.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

namespace skdtree
{
namespace
{
/// Numbers of points for each type.
using SizeTable = std::array<SkdCellSizes, 256>;

/// Whether a cell may be broken though the number of its points and their ids are valid.
bool HasMoreRules(int cellType)
{
  return cellType == VTK_POLYHEDRON || cellType == VTK_QUADRATIC_POLYGON ||
    cellType >= VTK_LAGRANGE_CURVE;
}

/// Whether VTK can make a cell of this type.
bool HasClass(int cellType)
{
  const SkdCellSizes sizes = SkdSizesOfCellType(cellType);
  return sizes.Least <= sizes.Most;
}

SizeTable MakeSizes(bool lookAgain)
{
  constexpr SkdCellSizes none{ std::numeric_limits<vtkIdType>::max(), 0 };
  SizeTable sizes;
  for (int type = 0; type < static_cast<int>(sizes.size()); ++type)
  {
    sizes[static_cast<std::size_t>(type)] =
      lookAgain && HasMoreRules(type) ? none : SkdSizesOfCellType(type);
  }
  return sizes;
}

/// With those that make a second look at a cell needless, so none for types that have more rules.
const SizeTable& SizesThatSuffice()
{
  static const SizeTable table = MakeSizes(true);
  return table;
}

/// With those that all types may have.
const SizeTable& SizesOfTypes()
{
  static const SizeTable table = MakeSizes(false);
  return table;
}

/// Whether cells begin .. end - 1 are certainly valid. The signs of all differences are combined in
/// loops without branches. Accepts any numbers: none overflows, and ids are read only within the
/// array.
template <class Offset, class Id, class SizesOf>
bool AreCertainlyWhole(const Offset* offsets, const Id* ids, vtkIdType begin, vtkIdType end,
  vtkIdType numberOfIds, vtkIdType numberOfPoints, const SizesOf& sizesOf)
{
  const auto wide = [](vtkIdType value) { return static_cast<std::uint64_t>(value); };
  std::uint64_t bits =
    wide(offsets[begin]) | (wide(numberOfIds) - wide(std::max<vtkIdType>(offsets[end], 0)));
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    const SkdCellSizes sizes = sizesOf(cell);
    const std::uint64_t size = wide(offsets[cell + 1]) - wide(offsets[cell]);
    bits |= wide(offsets[cell + 1]) | size | (size - wide(sizes.Least)) | (wide(sizes.Most) - size);
  }
  if (bits >> 63 != 0)
  {
    return false;
  }
  SkdIdRange<Id> range(numberOfPoints);
  for (Offset i = offsets[begin]; i < offsets[end]; ++i)
  {
    range.Add(ids[i]);
  }
  return range.HasAll();
}

bool HasMark(vtkUnsignedCharArray* ghosts, vtkIdType id, int mark)
{
  return ghosts && id >= 0 && id < ghosts->GetNumberOfValues() &&
    (ghosts->GetValue(id) & mark) != 0;
}

/// The cells of one vtkCellArray of a data set.
class Part
{
public:
  /// For vtkPolyData, in which all cells of an array have one type, possibly with fewer points.
  Part(vtkDataSet* data, vtkCellArray* cells, vtkIdType first, int type, bool mayBeEmpty)
    : Marks(data->GetCellGhostArray())
    , Cells(cells)
    , NumberOfPoints(data->GetNumberOfPoints())
    , First(first)
    , CommonType(type)
    , MayBeEmpty(mayBeEmpty)
  {
  }

  explicit Part(vtkUnstructuredGrid* grid)
    : Part(grid, grid->GetCells(), 0, VTK_EMPTY_CELL, false)
  {
    this->Grid = grid;
    vtkDataArray* types = grid->VTK_SKD_GET_CELL_TYPES();
    this->Types = SkdStoredTypes(types, this->OwnTypes);
    this->NumberOfTypes = types ? types->GetNumberOfValues() : this->Size();
    this->Degrees = grid->GetCellData()->GetHigherOrderDegrees();
    this->Faces = SkdFaceSource(grid);
  }

  vtkIdType Size() const { return this->Cells.NumberOfCells(); }

  /// Appends the broken ones among cells begin .. end - 1, by their ids in the data set.
  void FindBroken(vtkIdType begin, vtkIdType end, std::vector<vtkIdType>& broken) const;

  /// Whether a broken cell is marked as hidden, or has no type since a point hides it.
  bool IsHidden(vtkIdType id) const;

  /// What is wrong with a cell; empty if nothing is.
  std::string FaultOf(vtkIdType id) const;

  bool Has(vtkIdType id) const { return id >= this->First && id < this->First + this->Size(); }

private:
  int TypeOf(vtkIdType cell) const
  {
    return !this->Grid ? this->CommonType
      : this->Types    ? this->Types[cell]
                       : this->Grid->GetCellType(cell);
  }
  bool AreCertainlyWhole(vtkIdType begin, vtkIdType end, const SizeTable& table) const;
  bool IsBroken(vtkIdType cell, SkdIdMarks& marks) const;
  bool HasItsPoints(vtkIdType cell, vtkIdType size) const;

  vtkUnsignedCharArray* Marks;
  SkdRawCells Cells;
  vtkIdType NumberOfPoints;
  vtkIdType First;
  int CommonType;
  bool MayBeEmpty;
  vtkUnstructuredGrid* Grid = nullptr;
  const unsigned char* Types = nullptr;
  vtkSmartPointer<vtkUnsignedCharArray> OwnTypes; // of a grid that stores them otherwise
  vtkIdType NumberOfTypes = std::numeric_limits<vtkIdType>::max();
  vtkDataArray* Degrees = nullptr;
  SkdFaceSource Faces;
};

bool Part::AreCertainlyWhole(vtkIdType begin, vtkIdType end, const SizeTable& table) const
{
  bool areWhole = false;
  this->Cells.VisitArrays(
    [&](const auto* offsets, const auto* ids)
    {
      const auto look = [&](const auto& sizesOf)
      {
        areWhole = skdtree::AreCertainlyWhole(
          offsets, ids, begin, end, this->Cells.NumberOfIds(), this->NumberOfPoints, sizesOf);
      };
      const SkdCellSizes common = table[static_cast<std::size_t>(this->CommonType)];
      if (this->Types)
      {
        look([&](vtkIdType cell) { return table[this->Types[cell]]; });
      }
      else
      {
        look([&](vtkIdType) { return common; });
      }
    });
  return areWhole;
}

void Part::FindBroken(vtkIdType begin, vtkIdType end, std::vector<vtkIdType>& broken) const
{
  const bool canBeSure = !this->Grid || (this->Types && end <= this->NumberOfTypes);
  if (canBeSure && this->AreCertainlyWhole(begin, end, SizesThatSuffice()))
  {
    return;
  }
  const bool areSimpleOnesWhole = canBeSure && this->AreCertainlyWhole(begin, end, SizesOfTypes());
  SkdIdMarks marks;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    const bool isWhole = areSimpleOnesWhole && !HasMoreRules(this->TypeOf(cell));
    if (!isWhole && this->IsBroken(cell, marks))
    {
      broken.push_back(this->First + cell);
    }
  }
}

bool Part::HasItsPoints(vtkIdType cell, vtkIdType size) const
{
  const int type = this->TypeOf(cell);
  if (this->MayBeEmpty && size == 0)
  {
    return true;
  }
  double degrees[3];
  const bool hasDegrees = type >= VTK_LAGRANGE_CURVE && this->Degrees;
  if (hasDegrees)
  {
    if (this->Degrees->GetNumberOfComponents() != 3 || cell >= this->Degrees->GetNumberOfTuples())
    {
      return false;
    }
    this->Degrees->GetTuple(cell, degrees);
  }
  return SkdFitsCellType(type, size, hasDegrees ? degrees : nullptr);
}

bool Part::IsBroken(vtkIdType cell, SkdIdMarks& marks) const
{
  bool isWhole = false;
  this->Cells.VisitCell(cell,
    [&](const auto* ids, vtkIdType size)
    {
      isWhole = cell < this->NumberOfTypes && this->HasItsPoints(cell, size) &&
        std::all_of(
          ids, ids + size, [this](vtkIdType id) { return id >= 0 && id < this->NumberOfPoints; }) &&
        (this->TypeOf(cell) != VTK_POLYHEDRON || this->Faces.AreOf(cell, ids, size, marks));
    });
  return !isWhole;
}

bool Part::IsHidden(vtkIdType id) const
{
  constexpr int hidden = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  const vtkIdType cell = id - this->First;
  if (HasMark(this->Marks, id, hidden))
  {
    return true;
  }
  if (!this->Grid || cell >= this->NumberOfTypes || this->TypeOf(cell) != VTK_EMPTY_CELL)
  {
    return false;
  }
  bool hasHiddenPoint = false;
  this->Cells.VisitCell(cell,
    [&](const auto* ids, vtkIdType size)
    {
      vtkUnsignedCharArray* marks = this->Grid->GetPointGhostArray();
      hasHiddenPoint = std::any_of(ids, ids + size,
        [marks](auto point) { return HasMark(marks, point, vtkDataSetAttributes::HIDDENPOINT); });
    });
  return hasHiddenPoint;
}

std::string Part::FaultOf(vtkIdType id) const
{
  const vtkIdType cell = id - this->First;
  std::ostringstream fault;
  fault << "has offsets that decrease or exceed the connectivity array";
  this->Cells.VisitCell(cell,
    [&](const auto* ids, vtkIdType size)
    {
      fault.str("");
      const auto* const bad = std::find_if(ids, ids + size,
        [this](vtkIdType point) { return point < 0 || point >= this->NumberOfPoints; });
      if (cell >= this->NumberOfTypes)
      {
        fault << "has no type";
      }
      else if (bad != ids + size)
      {
        fault << "uses point " << *bad << " of " << this->NumberOfPoints;
      }
      else if (!HasClass(this->TypeOf(cell)))
      {
        fault << "has the type " << this->TypeOf(cell) << ", of which VTK has no cells";
      }
      else if (!this->HasItsPoints(cell, size))
      {
        fault << "has " << size << " points, which its type (" << this->TypeOf(cell)
              << ") does not have";
      }
      else
      {
        fault << "has faces that are not polygons of its points";
      }
    });
  return fault.str();
}

std::vector<Part> PartsOf(vtkPolyData* mesh)
{
  constexpr int types[4] = { VTK_POLY_VERTEX, VTK_POLY_LINE, VTK_POLYGON, VTK_TRIANGLE_STRIP };
  vtkCellArray* const arrays[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  std::vector<Part> parts;
  vtkIdType first = 0;
  for (int kind = 0; kind < 4; ++kind)
  {
    parts.emplace_back(mesh, arrays[kind], first, types[kind], true);
    first += parts.back().Size();
  }
  return parts;
}

/// The cells that a file may have broken.
std::vector<Part> PartsOf(vtkDataSet* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return PartsOf(mesh);
  }
  std::vector<Part> parts;
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  auto* explicitGrid = vtkExplicitStructuredGrid::SafeDownCast(data);
  if (grid && grid->GetCells())
  {
    parts.emplace_back(grid);
  }
  if (explicitGrid && explicitGrid->GetCells())
  {
    parts.emplace_back(explicitGrid, explicitGrid->GetCells(), 0, VTK_HEXAHEDRON, false);
  }
  return parts;
}
}

//------------------------------------------------------------------------------
SkdBrokenCells SkdFindBrokenCells(vtkDataSet* data)
{
  constexpr vtkIdType size = 8192; // cells that a thread looks at in one go
  SkdBrokenCells all;
  for (const Part& part : PartsOf(data))
  {
    std::vector<std::vector<vtkIdType>> blocks(
      static_cast<std::size_t>((part.Size() + size - 1) / size));
    vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 8,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          part.FindBroken(
            i * size, std::min(part.Size(), (i + 1) * size), blocks[static_cast<std::size_t>(i)]);
        }
      });
    for (const std::vector<vtkIdType>& block : blocks)
    {
      all.Ids.insert(all.Ids.end(), block.begin(), block.end());
      for (const vtkIdType id : block)
      {
        const bool isFault = !part.IsHidden(id);
        all.FirstFault = isFault && all.Faults == 0 ? id : all.FirstFault;
        all.Faults += isFault ? 1 : 0;
      }
    }
    if (all.Fault.empty() && all.Faults > 0)
    {
      all.Fault = part.FaultOf(all.FirstFault);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
std::string SkdBrokenCells::Tell(vtkDataSet* data) const
{
  std::ostringstream text;
  text << this->Faults << " of " << data->GetNumberOfCells()
       << (this->Faults == 1 ? " cells is broken and ignored; it is cell "
                             : " cells are broken and ignored; the first is cell ")
       << this->FirstFault << (this->Faults == 1 ? ", which " : ", ") << this->Fault << ".";
  return text.str();
}
}
