// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdParallelLoop_h
#define SkdParallelLoop_h

#include "vtkSMPTools.h"

#include <cstddef>

/// The parallel loop for building a tree of the core.
struct SkdParallelLoop
{
  template <class Body>
  void operator()(std::size_t count, const Body& body) const
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1,
      [&body](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          body(static_cast<std::size_t>(i));
        }
      });
  }
};

#endif
