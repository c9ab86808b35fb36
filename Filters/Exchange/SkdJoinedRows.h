// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdJoinedRows.h
 * @brief One table of rows of cells, for what one process alone can do with it, as write a file.
 */

#ifndef SkdJoinedRows_h
#define SkdJoinedRows_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace skdtree
{
/// The cells of a process's piece in the whole, whose blocks' cells count on from block to block.
struct SkdJoinedRows
{
  /// By block of the piece (SkdBlocksOf): the row of each cell; -1 of those that are no part of the
  /// whole, or are that of another process.
  std::vector<std::vector<vtkIdType>> OfBlocks;
  vtkIdType Number = 0;                 ///< of the whole
  vtkSmartPointer<vtkDataObject> Whole; ///< see SkdWholeInput
  std::string Problem;                  ///< why pieces cannot be joined; else empty
};

/// All processes must call it together. Memory: that of the whole on each.
SkdJoinedRows SkdJoinRows(vtkDataObject* piece, vtkMultiProcessController* controller);

/// Sends numbers to one process, which takes those of all, its own included, in the processes'
/// order. All must call it together. Memory there: those of two processes.
void SkdGatherAt(int process, const std::vector<double>& own,
  const std::function<void(const std::vector<double>&)>& take,
  vtkMultiProcessController* controller);
}

#endif
