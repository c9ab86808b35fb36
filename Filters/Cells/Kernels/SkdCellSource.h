// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellSource_h
#define SkdCellSource_h

#include "vtkType.h"

class vtkCell;
class vtkDataSet;
class vtkGenericCell;

namespace skdtree
{
/// A thread-local cell.
vtkGenericCell* SkdScratchCell();

/// The data set, and a cell into which cells are loaded: a thread-local one if it is nullptr.
struct SkdCellSource
{
  vtkDataSet* Data;
  vtkGenericCell* Cell = nullptr;

  vtkCell* Load(vtkIdType id) const;
};
}

#endif
