// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBatchOutputs.h
 * @brief Validation, allocation and filling of the arrays of batches.
 */

#ifndef SkdBatchOutputs_h
#define SkdBatchOutputs_h

#include "Cells/Search/SkdBatch.h"
#include "Cells/Search/SkdLocatorState.h"

#include "vtkMath.h"
#include "vtkObject.h"

#include <string>
#include <vector>

namespace skdtree
{
using SkdOutputs = std::vector<vtkDataArray*>;

/// The reason why a batch is invalid; empty if it is valid.
inline std::string SkdReasonAgainst(
  vtkDataArray* queries, const std::string& what, SkdBatchOf kind, const SkdOutputs& outputs)
{
  if (!queries)
  {
    return "the array of " + what + " is missing";
  }
  const int components = SkdNumberOfComponents(kind);
  if (queries->GetNumberOfComponents() != components)
  {
    return "the " + what + " have " + std::to_string(queries->GetNumberOfComponents()) +
      " components instead of " + std::to_string(components);
  }
  const auto isDouble = [&](vtkDataArray* array)
  { return array && (array == queries || std::count(outputs.begin(), outputs.end(), array) > 1); };
  return std::any_of(outputs.begin(), outputs.end(), isDouble) ? "the same array is passed twice"
                                                               : "";
}

/// Reports an error if there is a reason.
inline bool SkdIsRefused(vtkObject* locator, const char* method, const std::string& reason)
{
  if (!reason.empty())
  {
    vtkErrorWithObjectMacro(locator, << method << ": " << reason << ".");
  }
  return !reason.empty();
}

inline bool SkdIsRefused(vtkObject* locator, const char* method, vtkDataArray* queries,
  SkdBatchOf kind, const SkdOutputs& outputs)
{
  return SkdIsRefused(locator, method, SkdReasonAgainst(queries, "queries", kind, outputs));
}

/// Resizes an output and returns its values, or nullptr if it is not requested.
template <class Array>
auto SkdPrepare(Array* array, const char* name, int components, vtkIdType size)
  -> decltype(array->GetPointer(0))
{
  if (!array)
  {
    return nullptr;
  }
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  return array->GetPointer(0);
}

template <class Value>
void SkdStoreAt(Value* values, vtkIdType i, Value value)
{
  if (values)
  {
    values[i] = value;
  }
}

inline void SkdStoreAt(double* values, vtkIdType i, const skd::Vector3& value)
{
  if (values)
  {
    SkdStore(value, values + 3 * i);
  }
}

inline skd::Vector3 SkdNoPoint()
{
  return { { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() } };
}
}

#endif
