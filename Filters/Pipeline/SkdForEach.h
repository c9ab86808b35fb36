// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdForEach_h
#define SkdForEach_h

#include "vtkSMPTools.h"

#include <cstddef>

/// Calls body(i) for each i in [0, n), in parallel if n is large enough to start threads, for steps
/// of about ten to a thousand instructions.
template <class Body>
void SkdForEach(std::size_t n, const Body& body)
{
  constexpr std::size_t few = 1024;
  const auto each = [&body](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      body(static_cast<std::size_t>(i));
    }
  };
  const auto count = static_cast<vtkIdType>(n);
  n > few ? vtkSMPTools::For(0, count, each) : each(0, count);
}

#endif
