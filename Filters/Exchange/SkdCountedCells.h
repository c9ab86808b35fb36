// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCountedCells.h
 * @brief Of cells that several processes have, which of them counts each: for sums over an input
 * that stays in its pieces, and lists of what is found by its cells.
 */

#ifndef SkdCountedCells_h
#define SkdCountedCells_h

#include "Exchange/SkdStamp.h"
#include "vtkDataObject.h"

#include <vector>

class vtkInformationVector;
class vtkMultiProcessController;

namespace skdtree
{
class SkdCountedCells
{
public:
  SkdCountedCells() = default;

  /// The same of points, if the type is vtkDataObject::POINT: one process counts each, and none
  /// ghosts. Without an exchange between processes all are counted by each that has them.
  explicit SkdCountedCells(int type)
    : Type(type)
  {
  }

  /// Finds, by block of this process's piece (SkdBlocksOf), whether it counts each cell: one
  /// process does, and none counts ghosts (see SkdJoinPieces). Empty lists: all count. All
  /// processes must call it together. Nothing is exchanged if no piece has changed.
  const std::vector<std::vector<unsigned char>>& Update(
    vtkDataObject* piece, vtkMultiProcessController* controller);

private:
  int Type = vtkDataObject::CELL;
  SkdStamp Known;
  std::vector<std::vector<unsigned char>> OfBlocks;
};

class SkdTransport;

/// An input that stays in its pieces for a filter that lists what it finds by cells, each once: the
/// cells that other processes count are ghosts to it.
class SkdCountedInput
{
public:
  /// The piece with more cells marked as duplicates, or itself where it counts all. The same object
  /// as long as nothing changes. All processes must call it together.
  vtkDataObject* Update(vtkDataObject* piece, vtkMultiProcessController* controller);

  /// Which cells this process counts: see SkdCountedCells.
  const std::vector<std::vector<unsigned char>>& Find(
    vtkDataObject* piece, vtkMultiProcessController* controller)
  {
    return this->Counted.Update(piece, controller);
  }

  /// The ids of its cells in the joined mesh, by block, -1 of those that this process does not
  /// count. All processes must call it together. Nothing is exchanged if no piece has changed.
  const std::vector<std::vector<vtkIdType>>& FindIds(
    vtkDataObject* piece, vtkMultiProcessController* controller, SkdTransport& transport);

  /// Outputs that the filter has made of it: they get the marks that the piece has.
  void Restore(vtkInformationVector* outputs) const;

private:
  SkdCountedCells Counted;
  SkdStamp Known;
  std::vector<std::vector<unsigned char>> OfBlocks; // as it is marked
  vtkSmartPointer<vtkDataObject> Marked;            // nullptr: the piece itself
  SkdStamp Numbered;
  std::vector<std::vector<vtkIdType>> Ids;
};
}

#endif
