// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ValuesOf.h
 * @brief an array of numbers by value
 */
#ifndef skdtest_ValuesOf_h
#define skdtest_ValuesOf_h

#include "vtkDataArray.h"
#include "vtkVariant.h"

#include <vector>

namespace skdtest
{

/// The values of an array, all components in a row; empty if there is none.
inline std::vector<double> ValuesOf(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    values.push_back(array->GetVariantValue(i).ToDouble());
  }
  return values;
}

}

#endif
