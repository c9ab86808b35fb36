// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdShare.h
 * @brief What a process gives of an answer that each of several processes has found as a whole.
 */

#ifndef SkdShare_h
#define SkdShare_h

#include "vtkType.h"

class vtkInformationVector;
class vtkPolyData;
class vtkTable;

/// Processes have each a row of the answer, in their order; together they have it once.
class SkdShare
{
public:
  /// The share that is asked for of any of the outputs; all of it, if none is asked for in pieces.
  static SkdShare Of(vtkInformationVector* outputs);

  bool IsAll() const { return this->Pieces == 1; }

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

#endif
