// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdInputAround.h
 * @brief An input that stays in its pieces, with what of other pieces its cells touch: for filters
 * whose answer in a cell depends on those that it goes on in.
 */

#ifndef SkdInputAround_h
#define SkdInputAround_h

#include "Exchange/SkdNearbyInput.h"

#include <vector>

namespace skdtree
{
class SkdInputAround
{
public:
  /// The cells that count of this process's own piece (SkdOwnCellsOf), and those of other processes
  /// that may touch any that it has, as one mesh or composite data set, with joined ids. All
  /// processes must call it together. The same object again, without an exchange of data, if
  /// nothing has changed on any of them.
  vtkDataObject* Update(SkdTransport& transport, vtkDataObject* piece);

  /// Values of the cells of the object that Update() has returned, by block of it (SkdBlocksOf), as
  /// those of the cells of the piece, by block: also of cells that another process counts; 0 of
  /// ghosts, and of those that differ from a cell of another process by rounding alone. `ids`:
  /// SkdNumberCountedCells.
  std::vector<std::vector<vtkIdType>> TakeBack(const std::vector<std::vector<vtkIdType>>& values,
    vtkDataObject* piece, const std::vector<std::vector<vtkIdType>>& ids) const;

  /// Global ids with which pieces cannot be joined, on all processes the same.
  SkdRepeatedId FindRepeatedId() const { return this->Input.FindRepeatedId(); }

private:
  SkdNearbyInput Input;
  vtkDataObject* Around = nullptr; // of Input
};

/// The places of ids among those of all processes, in the order of lists and then of ids. Each
/// process has some, by list, and no other has the same ones. All processes must call it together.
std::vector<std::vector<vtkIdType>> SkdRankOverProcesses(
  SkdTransport& transport, const std::vector<std::vector<vtkIdType>>& ids);
}

#endif
