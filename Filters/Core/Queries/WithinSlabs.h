// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_WithinSlabs_h
#define skd_Queries_WithinSlabs_h

#include "Slab.h"

#include <array>

namespace skd
{

/// Elements whose boxes overlap each of N slabs: one for a plane, three for a turned box.
/// `visitor(element)` returns false to end the search.
template <int D, int N, class Visitor>
class WithinSlabs
{
public:
  static constexpr bool Ordered = false;

  WithinSlabs(const std::array<Slab<D>, N>& slabs, Visitor& visitor)
    : Slabs(slabs)
    , TheVisitor(visitor)
  {
  }

  template <int W>
  unsigned TestBoxes(const BoxPacket<D, W>& boxes, float*) const
  {
    unsigned overlapping = ~0u;
    for (const Slab<D>& slab : this->Slabs)
    {
      overlapping &= slab.Overlapping(boxes);
    }
    return overlapping;
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheVisitor(element); }

private:
  std::array<Slab<D>, N> Slabs;
  Visitor& TheVisitor;
};

}

#endif
