// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdUniformCells.h"

#include "Cells/Read/SkdEnclose.h"
#include "Cells/Read/SkdIdRange.h"
#include "Cells/Read/SkdStoredCells.h"
#include "Cells/Read/SkdStoredTypes.h"
#include "Cells/Read/SkdStoredValues.h"
#include "Core/Geometry/PointBounds.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeVersion.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace skdtree
{
namespace
{
/// The cells of a mesh that may be uniform, and what all of them must be like.
struct Candidates
{
  vtkCellArray* Cells = nullptr; // or nullptr: they are not
  int Type = VTK_EMPTY_CELL;
  const unsigned char* Types = nullptr;
  vtkPolyData* Surface = nullptr; // if it has a table of types
  vtkSmartPointer<vtkUnsignedCharArray> OwnTypes;

  /// Whether the cells begin .. end - 1 are of this type.
  bool AreOfType(vtkIdType begin, vtkIdType end) const
  {
    const auto are = [&](const auto& typeOf)
    {
      int others = 0;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        others |= typeOf(cell) ^ this->Type;
      }
      return others == 0;
    };
    return (!this->Types || are([this](vtkIdType cell) { return this->Types[cell]; })) &&
      (!this->Surface ||
        are([this](vtkIdType cell) { return this->Surface->vtkPolyData::GetCellType(cell); }));
  }
};

Candidates CandidatesOf(vtkUnstructuredGrid* grid)
{
  Candidates found;
  vtkDataArray* types = grid->VTK_SKD_GET_CELL_TYPES();
  const vtkIdType number = grid->GetNumberOfCells();
  if (grid->GetCells() && types && types->GetNumberOfValues() >= number)
  {
    found.Types = SkdStoredTypes(types, found.OwnTypes);
    found.Type = found.Types[0];
    found.Cells = grid->GetCells();
  }
  return found;
}

/// Polygons alone. A table of types, if there is one, tells which cells were deleted.
Candidates CandidatesOf(vtkPolyData* mesh)
{
  Candidates found;
  vtkCellArray* polygons = mesh->GetPolys();
  if (polygons && polygons->GetNumberOfCells() == mesh->GetNumberOfCells())
  {
    const vtkIdType size = polygons->GetConnectivityArray()->GetNumberOfValues();
    const vtkIdType number = polygons->GetNumberOfCells();
    found.Type = size == 3 * number ? VTK_TRIANGLE : size == 4 * number ? VTK_QUAD : VTK_EMPTY_CELL;
    found.Surface = mesh->NeedToBuildCells() ? nullptr : mesh;
    found.Cells = polygons;
  }
  return found;
}

Candidates CandidatesOf(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return CandidatesOf(grid);
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return mesh ? CandidatesOf(mesh) : Candidates();
}

/// Reads blocks of cells.
class Reading
{
public:
  Reading(const Candidates& candidates, const SkdStoredCells& cells, int size,
    const skd::PointArray& points, vtkIdType numberOfPoints, SkdUniformCells& to)
    : TheCandidates(candidates)
    , Cells(cells)
    , Size(size)
    , Points(points)
    , NumberOfPoints(numberOfPoints)
    , To(to)
  {
  }

  /// Whether all are as they must be.
  bool Run()
  {
    const vtkIdType number = this->TheCandidates.Cells->GetNumberOfCells();
    this->To.PointIds.resize(static_cast<std::size_t>(number * this->Size));
    this->To.Bounds = SkdEnclose(static_cast<std::size_t>((number + Block - 1) / Block),
      [&](std::size_t i)
      {
        const vtkIdType begin = static_cast<vtkIdType>(i) * Block;
        return this->Read(begin, std::min(begin + Block, number));
      });
    return this->AreWhole;
  }

private:
  /// So few that their ids are still in the cache when their points are read.
  static constexpr vtkIdType Block = 2048;

  /// The bounds of the cells begin .. end - 1.
  skd::Box3 Read(vtkIdType begin, vtkIdType end)
  {
    bool areWhole = this->AreWhole && this->TheCandidates.AreOfType(begin, end);
    if (areWhole)
    {
      this->Cells.VisitArrays([&](const auto* offsets, const auto* ids)
        { areWhole = this->HaveSize(offsets, begin, end) && this->Copy(ids, begin, end); });
    }
    skd::PointBounds bounds;
    if (areWhole)
    {
      bounds.Add(this->Points, this->To.PointIds.data() + begin * this->Size,
        static_cast<std::size_t>((end - begin) * this->Size));
    }
    else
    {
      this->AreWhole = false;
    }
    return bounds.Box();
  }

  template <class Offset>
  bool HaveSize(const Offset* offsets, vtkIdType begin, vtkIdType end) const
  {
    const auto size = static_cast<Offset>(this->Size);
    auto expected = static_cast<Offset>(begin * this->Size);
    Offset others = offsets[begin] ^ expected;
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      expected += size;
      others |= offsets[cell + 1] ^ expected;
    }
    return others == 0;
  }

  template <class Id>
  bool Copy(const Id* ids, vtkIdType begin, vtkIdType end)
  {
    SkdIdRange<Id> range(this->NumberOfPoints);
    std::uint32_t* const to = this->To.PointIds.data();
    const vtkIdType last = end * this->Size;
    for (vtkIdType i = begin * this->Size; i < last; ++i)
    {
      range.Add(ids[i]);
      to[i] = static_cast<std::uint32_t>(ids[i]);
    }
    return range.HasAll();
  }

  const Candidates& TheCandidates;
  const SkdStoredCells& Cells;
  int Size;
  skd::PointArray Points;
  vtkIdType NumberOfPoints;
  SkdUniformCells& To;
  std::atomic<bool> AreWhole{ true };
};

/// Whether there are some, and so few that 32-bit offsets count the points of as many hexahedra.
bool IsInRange(vtkIdType number)
{
  return number > 0 && number < std::numeric_limits<std::int32_t>::max() / 8;
}
}

//------------------------------------------------------------------------------
SkdUniformCells SkdReadUniformCells(vtkDataSet* data)
{
  auto* mesh = vtkPointSet::SafeDownCast(data);
  if (!mesh || !IsInRange(mesh->GetNumberOfCells()) || !IsInRange(mesh->GetNumberOfPoints()) ||
    mesh->GetCellGhostArray())
  {
    return {};
  }
  const skd::PointArray points = SkdStoredPoints(mesh->GetPoints()->GetData());
  const Candidates candidates = CandidatesOf(mesh);
  const SkdShape shape = SkdShapeOfCellType(candidates.Type);
  const int size = SkdNumberOfPoints(shape);
  if (!(points.Floats || points.Doubles) || !candidates.Cells || size == 0)
  {
    return {};
  }
  const SkdStoredCells cells(candidates.Cells);
  SkdUniformCells uniform;
  const bool areStored = cells.AreStored() &&
    candidates.Cells->GetConnectivityArray()->GetNumberOfValues() ==
      size * candidates.Cells->GetNumberOfCells();
  if (!areStored ||
    !Reading(candidates, cells, size, points, mesh->GetNumberOfPoints(), uniform).Run())
  {
    return {};
  }
  uniform.Shape = shape;
  return uniform;
}
}
