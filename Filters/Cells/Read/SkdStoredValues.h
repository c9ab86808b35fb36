// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdStoredValues_h
#define SkdStoredValues_h

#include "Core/Geometry/PointArray.h"

#include "vtkAOSDataArrayTemplate.h"

namespace skdtree
{
/// The values of an array of such numbers that are stored one after the other, else nullptr.
template <class Number>
Number* SkdStoredValues(vtkDataArray* array)
{
  auto* stored = vtkAOSDataArrayTemplate<Number>::FastDownCast(array);
  return stored ? stored->GetPointer(0) : nullptr;
}

/// Points that are stored so as floats or doubles, else none.
inline skd::PointArray SkdStoredPoints(vtkDataArray* array)
{
  return { SkdStoredValues<float>(array), SkdStoredValues<double>(array) };
}
}

#endif
