// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_OverlappingPairs_h
#define skd_Queries_OverlappingPairs_h

#include "../Tree/Node.h"

namespace skd
{

/// Pairs of elements of two trees whose boxes overlap (Algorithm 5.4).
///
/// `toFirst(Box<D>)` gives a box of the second tree's world as a box of the first's, bounds of the
/// moved box: the identity, or a rigid motion. `leaf(a, b)` returns false to end the search.
template <int D, class ToFirstWorld, class Leaf>
class OverlappingPairs
{
public:
  static constexpr int Dimension = D;

  OverlappingPairs(
    const Frame<D>& first, const Frame<D>& second, const ToFirstWorld& toFirst, Leaf& leaf)
    : First(first)
    , Second(second)
    , TheMotion(toFirst)
    , TheLeaf(leaf)
  {
  }

  FloatBox<D> ToFirst(const FloatBox<D>& box) const
  {
    Box<D> world;
    for (int axis = 0; axis < D; ++axis)
    {
      const double low = box.Min[axis] / this->Second.Scale;
      const double high = box.Max[axis] / this->Second.Scale;
      const double centre = this->Second.Centre[axis];
      const double rounding = 2.0 * std::numeric_limits<double>::epsilon() *
        (std::abs(centre) + std::max(std::abs(low), std::abs(high)));
      world.Min[axis] = centre + low - rounding;
      world.Max[axis] = centre + high + rounding;
    }
    return this->First.Outward(this->TheMotion(world));
  }

  bool IsWanted(const FloatBox<D>& a, const FloatBox<D>& b) const
  {
    for (int axis = 0; axis < D; ++axis)
    {
      if (!(a.Min[axis] <= b.Max[axis] && b.Min[axis] <= a.Max[axis]))
      {
        return false;
      }
    }
    return true;
  }

  bool Visit(std::uint32_t a, std::uint32_t b) { return this->TheLeaf(a, b); }

private:
  const Frame<D>& First;
  const Frame<D>& Second;
  const ToFirstWorld& TheMotion;
  Leaf& TheLeaf;
};

}

#endif
