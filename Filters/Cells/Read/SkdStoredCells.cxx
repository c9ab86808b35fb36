// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdStoredCells.h"

#include "Cells/Read/SkdStoredValues.h"

namespace skdtree
{
SkdStoredCells::SkdStoredCells(vtkCellArray* cells)
{
  const auto* offsets32 = SkdStoredValues<vtkTypeInt32>(cells->GetOffsetsArray());
  const auto* offsets64 = SkdStoredValues<vtkTypeInt64>(cells->GetOffsetsArray());
  const auto* ids32 = SkdStoredValues<vtkTypeInt32>(cells->GetConnectivityArray());
  const auto* ids64 = SkdStoredValues<vtkTypeInt64>(cells->GetConnectivityArray());
  if (offsets32 && ids32)
  {
    this->Offsets32 = offsets32;
    this->Ids32 = ids32;
  }
  else if (offsets64 && ids64)
  {
    this->Offsets64 = offsets64;
    this->Ids64 = ids64;
  }
}
}
