// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_WithinSlabs_h
#define skd_Queries_WithinSlabs_h

#include "Slab.h"

#include <array>

namespace skd
{

/// Elements whose boxes overlap each of N slabs: one for a plane, three for a turned box.
/// `leaf(element)` returns false to end the search.
template <int D, int N, class Leaf>
class WithinSlabs
{
public:
  static constexpr bool Ordered = false;

  WithinSlabs(const std::array<Slab<D>, N>& slabs, Leaf& leaf)
    : Slabs(slabs)
    , TheLeaf(leaf)
  {
  }

  template <int W>
  void Keys(const Bundle<D, W>& boxes, float* keys) const
  {
    for (int lane = 0; lane < W; ++lane)
    {
      bool overlaps = true;
      for (const Slab<D>& slab : this->Slabs)
      {
        overlaps &= slab.Overlaps(boxes, lane);
      }
      keys[lane] = overlaps ? 0.0f : 1.0f;
    }
  }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheLeaf(element); }

private:
  std::array<Slab<D>, N> Slabs;
  Leaf& TheLeaf;
};

}

#endif
