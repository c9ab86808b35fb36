// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRawCells_h
#define SkdRawCells_h

#include "Cells/Read/SkdStoredCells.h"

#include <vector>

namespace skdtree
{
/// A vtkCellArray whose offsets and ids may be invalid: reads nothing out of range.
class SkdRawCells
{
public:
  explicit SkdRawCells(vtkCellArray* cells);

  vtkIdType NumberOfCells() const { return this->Count; }
  vtkIdType NumberOfIds() const { return this->IdCount; }

  /// Calls visit(offsets, ids) with the arrays: 32 or 64 bit. Of no cells there may be none.
  template <class Visit>
  void VisitArrays(const Visit& visit) const
  {
    if (this->Stored.AreStored())
    {
      this->Stored.VisitArrays(visit);
    }
    else
    {
      visit(this->Offsets.data(), this->Ids.data());
    }
  }

  /// Calls visit(ids, size) if the cell's ids are all in the array.
  template <class Visit>
  void VisitCell(vtkIdType cell, const Visit& visit) const
  {
    this->VisitArrays(
      [&](const auto* offsets, const auto* ids)
      {
        const auto first = static_cast<vtkIdType>(offsets[cell]);
        const auto last = static_cast<vtkIdType>(offsets[cell + 1]);
        if (first >= 0 && last >= first && last <= this->IdCount)
        {
          visit(ids + first, last - first);
        }
      });
  }

private:
  SkdStoredCells Stored;
  std::vector<vtkTypeInt64> Offsets; // copies of what is not stored in a row
  std::vector<vtkTypeInt64> Ids;
  vtkIdType Count;
  vtkIdType IdCount;
};
}

#endif
