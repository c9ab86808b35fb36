// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdRawCells.h"

#include "vtkDataArray.h"

#include <algorithm>

namespace skdtree
{
namespace
{
std::vector<vtkTypeInt64> CopyOf(vtkDataArray* array)
{
  std::vector<vtkTypeInt64> values(static_cast<std::size_t>(array->GetNumberOfValues()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<vtkTypeInt64>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return values;
}
}

SkdRawCells::SkdRawCells(vtkCellArray* cells)
  : Stored(cells)
  , Count(std::max<vtkIdType>(cells->GetOffsetsArray()->GetNumberOfValues() - 1, 0))
  , IdCount(cells->GetConnectivityArray()->GetNumberOfValues())
{
  if (!this->Stored.AreStored())
  {
    this->Offsets = CopyOf(cells->GetOffsetsArray());
    this->Ids = CopyOf(cells->GetConnectivityArray());
  }
}
}
