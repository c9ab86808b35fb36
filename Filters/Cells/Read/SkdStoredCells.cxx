// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdStoredCells.h"

#include "vtkAOSDataArrayTemplate.h"

namespace skdtree
{
namespace
{
/// The values of an array of such numbers that are stored one after the other, else nullptr.
template <class Integer>
const Integer* StoredValues(vtkDataArray* array)
{
  auto* stored = vtkAOSDataArrayTemplate<Integer>::FastDownCast(array);
  return stored ? stored->GetPointer(0) : nullptr;
}
}

SkdStoredCells::SkdStoredCells(vtkCellArray* cells)
{
  const auto* offsets32 = StoredValues<vtkTypeInt32>(cells->GetOffsetsArray());
  const auto* offsets64 = StoredValues<vtkTypeInt64>(cells->GetOffsetsArray());
  const auto* ids32 = StoredValues<vtkTypeInt32>(cells->GetConnectivityArray());
  const auto* ids64 = StoredValues<vtkTypeInt64>(cells->GetConnectivityArray());
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
