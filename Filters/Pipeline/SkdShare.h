// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdShare.h
 * @brief The share that a process outputs of a result that each process has computed as a whole.
 */

#ifndef SkdShare_h
#define SkdShare_h

#include "vtkType.h"

class vtkInformationVector;
class vtkPolyData;
class vtkTable;

/// Each process outputs a consecutive range of rows; together they output each row once.
class SkdShare
{
public:
  /// The share requested of any of the outputs; the whole result if no pieces are requested.
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
