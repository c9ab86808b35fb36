// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdStoredCells_h
#define SkdStoredCells_h

#include "vtkCellArray.h"
#include "vtkType.h"

#include <cstddef>

namespace skdtree
{
/// The cells of a vtkCellArray whose offsets and ids are stored contiguously, in 32 or 64 bits. The
/// array must outlive it unchanged.
class SkdStoredCells
{
public:
  explicit SkdStoredCells(vtkCellArray* cells);

  /// False for implicit offsets, and others that are not stored: then use VTK's own access.
  bool AreStored() const { return this->Ids32 || this->Ids64; }

  /// Calls visit(cell, ids, size) for the cells begin .. end - 1, ids of whatever type is stored.
  template <class Visit>
  void VisitEach(vtkIdType begin, vtkIdType end, const Visit& visit) const
  {
    this->VisitArrays(
      [&](const auto* offsets, const auto* ids)
      {
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          const auto first = offsets[cell];
          visit(cell, ids + first, static_cast<std::size_t>(offsets[cell + 1] - first));
        }
      });
  }

  /// Calls visit(offsets, ids) once, with the arrays themselves.
  template <class Visit>
  void VisitArrays(const Visit& visit) const
  {
    if (this->Ids64)
    {
      visit(this->Offsets64, this->Ids64);
    }
    else
    {
      visit(this->Offsets32, this->Ids32);
    }
  }

private:
  const vtkTypeInt32* Offsets32 = nullptr; // these, or the others
  const vtkTypeInt32* Ids32 = nullptr;
  const vtkTypeInt64* Offsets64 = nullptr;
  const vtkTypeInt64* Ids64 = nullptr;
};

/// Calls visit(cell, ids, size) for all cells of an array, however they are stored.
template <class Visit>
void SkdForEachCell(vtkCellArray* cells, const Visit& visit)
{
  const vtkIdType count = cells->GetNumberOfCells();
  const SkdStoredCells stored(cells);
  if (stored.AreStored())
  {
    stored.VisitEach(0, count, visit);
    return;
  }
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, size, ids);
    visit(cell, ids, static_cast<std::size_t>(size));
  }
}
}

#endif
