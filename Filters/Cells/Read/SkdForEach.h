// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdForEach_h
#define SkdForEach_h

#include "vtkSMPTools.h"

#include <cstddef>

namespace skdtree
{
/// Calls body(i) for each i in [0, n), in parallel if n is large enough to start threads, for steps
/// of about ten to a thousand instructions. For expensive steps `grain` is the number of steps that
/// a thread takes at a time. Work that can be aborted uses Pipeline/SkdLoop.h instead.
template <class Index, class Body>
void SkdForEach(Index n, const Body& body, vtkIdType grain = 0)
{
  constexpr vtkIdType few = 1024;
  const auto each = [&body](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      body(static_cast<Index>(i));
    }
  };
  const auto count = static_cast<vtkIdType>(n);
  if (count > few || grain > 0)
  {
    vtkSMPTools::For(0, count, grain, each);
  }
  else
  {
    each(0, count);
  }
}

/// The parallel loop for building a tree of the core.
constexpr auto SkdTreeLoop = [](std::size_t n, const auto& body) { SkdForEach(n, body, 1); };
}

#endif
