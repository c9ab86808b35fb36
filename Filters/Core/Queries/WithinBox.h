// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_WithinBox_h
#define skd_Queries_WithinBox_h

#include "NoSieve.h"

namespace skd
{

/// Elements whose boxes overlap a box (Algorithm 5.3). A point is a box, too.
/// `leaf(element)` returns false to end the search.
template <int D, class Leaf, class Sieve = NoSieve>
class WithinBox
{
public:
  static constexpr bool Ordered = false;
  static constexpr bool SkipsBottoms = Sieve::SkipsBottoms;

  WithinBox(const Frame<D>& frame, const Box<D>& box, Leaf& leaf, const Sieve& sieve = Sieve())
    : TheLeaf(leaf)
    , TheSieve(sieve)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      this->Min[axis] = Spread(frame.Down(box.Min[axis], axis));
      this->Max[axis] = Spread(frame.Up(box.Max[axis], axis));
    }
  }

  template <int W>
  SKD_IN_ONE_PIECE unsigned Reach(const Bundle<D, W>& boxes, float*) const
  {
    unsigned overlapping = ~0u;
    ForEachAxis<D>(
      [&](int axis)
      {
        overlapping &= LessEqual(boxes.Mins(axis), Lanes<W>(this->Max[axis])) &
          LessEqual(Lanes<W>(this->Min[axis]), boxes.Maxs(axis));
      });
    return overlapping;
  }

  unsigned ReachElements(const Node<D>& bottom, float* keys) const
  {
    return this->TheSieve.Knows(bottom) ? this->TheSieve.Pass(bottom, keys)
                                        : this->Reach(bottom.Boxes, keys);
  }

  bool Knows(const Node<D>& inner) const { return this->TheSieve.Knows(inner); }
  unsigned ReachKnown(std::uint32_t bottom, std::uint32_t count, float* keys) const
  {
    return this->TheSieve.Pass(bottom, count, keys);
  }
  void FetchKnown(std::uint32_t bottom) const { this->TheSieve.Fetch(bottom); }

  float Limit() const { return 0.0f; }
  bool Visit(std::uint32_t element) { return this->TheLeaf(element); }

private:
  Spread Min[D];
  Spread Max[D];
  Leaf& TheLeaf;
  Sieve TheSieve;
};

}

#endif
