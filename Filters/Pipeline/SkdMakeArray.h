// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMakeArray_h
#define SkdMakeArray_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

namespace skdtree
{
/// A named array of n tuples, values not set.
template <typename Array>
vtkSmartPointer<Array> SkdMakeArray(const char* name, int components, vtkIdType n)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(n);
  return array;
}

/// The same, all `none`.
template <typename Array>
vtkSmartPointer<Array> SkdMakeArray(const char* name, int components, vtkIdType n, double none)
{
  auto array = SkdMakeArray<Array>(name, components, n);
  array->Fill(none);
  return array;
}
}

#endif
