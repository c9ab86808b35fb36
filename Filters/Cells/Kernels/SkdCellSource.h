// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCellSource_h
#define SkdCellSource_h

#include "vtkType.h"

class vtkCell;
class vtkDataSet;
class vtkGenericCell;

/// The data set, and a thread-local cell into which cells are loaded.
struct SkdCellSource
{
  vtkDataSet* Data;
  vtkGenericCell* Scratch;

  vtkCell* Load(vtkIdType id) const;
};

#endif
