// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdFaceSource_h
#define SkdFaceSource_h

#include "Cells/Read/SkdRawCells.h"
#include "vtkSkdTreeVersion.h"

#include "vtkIdTypeArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <optional>

namespace skdtree
{
/// A fast set of the ids of one cell: of ids with equal hashes only the last is marked.
class SkdIdMarks
{
public:
  template <class Id>
  void Mark(vtkIdType cell, const Id* ids, vtkIdType size)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Marks[SlotOf(ids[i])] = { ids[i], cell };
    }
  }

  bool IsMarked(vtkIdType cell, vtkIdType id) const
  {
    const Entry& entry = this->Marks[SlotOf(id)];
    return entry.Id == id && entry.Cell == cell;
  }

private:
  struct Entry
  {
    vtkIdType Id = -1;
    vtkIdType Cell = -1;
  };
  static std::size_t SlotOf(vtkIdType id) { return static_cast<std::size_t>(id) % 256; }

  std::array<Entry, 256> Marks;
};

/// The storage of the faces of polyhedra in a vtkUnstructuredGrid, which may be invalid.
class SkdFaceSource
{
public:
  SkdFaceSource() = default;
  explicit SkdFaceSource(vtkUnstructuredGrid* grid);

  /// Whether a polyhedron with these points has faces, each of three of them or more.
  template <class Id>
  bool AreOf(vtkIdType cell, const Id* ids, vtkIdType size, SkdIdMarks& marks) const
  {
    marks.Mark(cell, ids, size);
    const auto isPoint = [&](vtkIdType id)
    { return marks.IsMarked(cell, id) || std::find(ids, ids + size, id) != ids + size; };
    bool areAll = true;
    const bool hasFaces = this->VisitFaces(cell,
      [&](const auto* face, vtkIdType faceSize)
      { areAll = areAll && faceSize >= 3 && std::all_of(face, face + faceSize, isPoint); });
    return hasFaces && areAll;
  }

private:
  /// Calls visit(ids, size) for each face. False where some are not there, or there is none.
  template <class Visit>
  bool VisitFaces(vtkIdType cell, const Visit& visit) const;

#if VTK_SKD_FACES_ARE_CELLS
  std::optional<SkdRawCells> Faces;
  std::optional<SkdRawCells> OfCells; // the faces of each cell
#else
  vtkIdTypeArray* Faces = nullptr; // a stream
  vtkIdTypeArray* Locations = nullptr;
#endif
};

#if VTK_SKD_FACES_ARE_CELLS
inline SkdFaceSource::SkdFaceSource(vtkUnstructuredGrid* grid)
{
  if (grid->GetPolyhedronFaces() && grid->GetPolyhedronFaceLocations())
  {
    this->Faces.emplace(grid->GetPolyhedronFaces());
    this->OfCells.emplace(grid->GetPolyhedronFaceLocations());
  }
}

template <class Visit>
bool SkdFaceSource::VisitFaces(vtkIdType cell, const Visit& visit) const
{
  vtkIdType missing = 1;
  if (this->OfCells && cell < this->OfCells->NumberOfCells())
  {
    this->OfCells->VisitCell(cell,
      [&](const auto* faces, vtkIdType number)
      {
        missing = std::max<vtkIdType>(number, 1);
        for (vtkIdType i = 0; i < number; ++i)
        {
          const auto face = static_cast<vtkIdType>(faces[i]);
          if (face >= 0 && face < this->Faces->NumberOfCells())
          {
            this->Faces->VisitCell(face,
              [&](const auto* ids, vtkIdType size)
              {
                --missing;
                visit(ids, size);
              });
          }
        }
      });
  }
  return missing == 0;
}
#else
inline SkdFaceSource::SkdFaceSource(vtkUnstructuredGrid* grid)
  : Faces(grid->GetFaces())
  , Locations(grid->GetFaceLocations())
{
}

template <class Visit>
bool SkdFaceSource::VisitFaces(vtkIdType cell, const Visit& visit) const
{
  if (!this->Faces || !this->Locations || cell >= this->Locations->GetNumberOfValues())
  {
    return false;
  }
  const vtkIdType* const stream = this->Faces->GetPointer(0);
  const vtkIdType end = this->Faces->GetNumberOfValues();
  vtkIdType at = this->Locations->GetValue(cell);
  if (at < 0 || at >= end || stream[at] < 1)
  {
    return false;
  }
  for (vtkIdType faces = stream[at++]; faces > 0; --faces)
  {
    if (at >= end || stream[at] < 0 || stream[at] > end - at - 1)
    {
      return false;
    }
    visit(stream + at + 1, stream[at]);
    at += stream[at] + 1;
  }
  return true;
}
#endif
}

#endif
