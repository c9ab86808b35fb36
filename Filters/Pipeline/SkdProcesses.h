// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdProcesses.h
 * @brief The processes that a pipeline runs in: how they tell each other, and what each gives of an
 * answer that all have found as a whole.
 */

#ifndef SkdProcesses_h
#define SkdProcesses_h

#include "Core/Parallel/Processes.h"
#include "vtkType.h"

#include <memory>
#include <string>

class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;
class vtkTable;

namespace skdtree
{
/// The global controller, if it has several processes and this one's own piece is requested of this
/// output or input; else nullptr.
vtkMultiProcessController* SkdControllerOf(vtkInformation* requested);

/// The processes of the global controller, if there are several and each one requests its own
/// piece; else nullptr.
std::unique_ptr<skd::Processes> SkdProcessesOf(vtkInformation* output);

/// Each process outputs a consecutive range of rows; together they output each row once.
class SkdShare
{
public:
  /// The share requested of any of the outputs; the whole result if no pieces are requested.
  static SkdShare Of(vtkInformationVector* outputs);

  bool IsAll() const { return this->Pieces == 1; }

  /// A file of this share: the name as it is, or with the share's number before the extension.
  std::string NameOf(const std::string& fileName) const;

  /// The rows of a list of n that are of the share: from the first to before the last.
  vtkIdType FirstOf(vtkIdType n) const { return n * this->Piece / this->Pieces; }
  vtkIdType LastOf(vtkIdType n) const { return n * (this->Piece + 1) / this->Pieces; }

  ///@{
  /// Blocks a share of the cells, with the points that they use, or of the rows. O(size).
  void Keep(vtkPolyData* cells) const;
  void Keep(vtkTable* rows) const;
  ///@}

private:
  vtkIdType Piece = 0;
  vtkIdType Pieces = 1;
};
}

#endif
