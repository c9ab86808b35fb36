// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdStoredTypes_h
#define SkdStoredTypes_h

#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

namespace skdtree
{
/// The types of a grid's cells one by one: where they are stored, or in a copy, which is made of an
/// array of another kind (since 9.6 VTK keeps one value for cells that are all of one type).
/// nullptr without an array.
inline const unsigned char* SkdStoredTypes(
  vtkDataArray* types, vtkSmartPointer<vtkUnsignedCharArray>& copy)
{
  auto* stored = vtkUnsignedCharArray::FastDownCast(types);
  if (types && !stored)
  {
    copy = vtkSmartPointer<vtkUnsignedCharArray>::New();
    copy->DeepCopy(types);
    stored = copy;
  }
  return stored ? stored->GetPointer(0) : nullptr;
}
}

#endif
