// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MakeOf.h
 * @brief a filter of two inputs
 */
#ifndef skdtest_MakeOf_h
#define skdtest_MakeOf_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

namespace skdtest
{

/// A filter with an input and a Source.
template <class Filter>
vtkSmartPointer<Filter> MakeOf(vtkDataObject* input, vtkDataObject* source)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputDataObject(0, input);
  if (source)
  {
    filter->SetInputDataObject(1, source);
  }
  return filter;
}

}

#endif
