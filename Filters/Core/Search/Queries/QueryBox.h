// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_QueryBox_h
#define skd_Queries_QueryBox_h

#include "../Tree/Node.h"

namespace skd
{

/// Bit i is set where `test(axis)`, lane by lane, is true of all axes.
template <int D, class Test>
unsigned OnAllAxes(const Test& test)
{
  auto truths = test(0);
  ForEachAxis<D - 1>([&](int axis) { truths = truths & test(axis + 1); });
  return truths.Bits();
}

/// Bit i is set where the box of lane i overlaps that from min(axis) to max(axis), for all lanes.
template <int D, int W, class Min, class Max>
unsigned OverlappingLanes(const BoxPacket<D, W>& boxes, const Min& min, const Max& max)
{
  using L = Lanes<W>;
  return OnAllAxes<D>(
    [&](int axis)
    {
      return L::AreLessEqual(boxes.Mins(axis), max(axis)) &
        L::AreLessEqual(min(axis), boxes.Maxs(axis));
    });
}

/// A query box, in a tree's frame: each of its sides for all lanes of a packet.
template <int D>
class QueryBox
{
public:
  QueryBox() = default; ///< to be set

  void Set(int axis, float min, float max)
  {
    this->Min[axis] = Spread(min);
    this->Max[axis] = Spread(max);
  }

  /// Bit i is set where the box of lane i overlaps.
  template <int W>
  unsigned Overlapping(const BoxPacket<D, W>& boxes) const
  {
    return OverlappingLanes(
      boxes, [&](int axis) { return Lanes<W>(this->Min[axis]); },
      [&](int axis) { return Lanes<W>(this->Max[axis]); });
  }

  /// The same of this box with each side moved inward by `inset`.
  template <int W>
  unsigned Overlapping(const BoxPacket<D, W>& boxes, const Lanes<W>& inset) const
  {
    return OverlappingLanes(
      boxes, [&](int axis) { return Lanes<W>(this->Min[axis]) + inset; },
      [&](int axis) { return Lanes<W>(this->Max[axis]) - inset; });
  }

  /// Bit i is set where the box of lane i is within this one.
  template <int W>
  unsigned Holding(const BoxPacket<D, W>& boxes) const
  {
    using L = Lanes<W>;
    return OnAllAxes<D>(
      [&](int axis)
      {
        return L::AreLessEqual(L(this->Min[axis]), boxes.Mins(axis)) &
          L::AreLessEqual(boxes.Maxs(axis), L(this->Max[axis]));
      });
  }

private:
  Spread Min[D];
  Spread Max[D];
};

/// Sets both: whatever overlaps the box overlaps `outer`, and what `inner` holds is within it.
template <int D>
SKD_FLATTEN void SetAround(
  const Frame<D>& frame, const Box<D>& box, QueryBox<D>& outer, QueryBox<D>& inner)
{
  ForEachAxis<D>(
    [&](int axis)
    {
      outer.Set(axis, frame.Down(box.Min[axis], axis), frame.Up(box.Max[axis], axis));
      inner.Set(axis, frame.Up(box.Min[axis], axis), frame.Down(box.Max[axis], axis));
    });
}

/// The least box of floats about a point in the frame that has it inside: boxes begin and end
/// within the range of floats, so far outside it does not matter where the point is.
template <int D>
SKD_FLATTEN QueryBox<D> AboutPoint(const Vector<D>& local)
{
  constexpr double far = 1e38;
  QueryBox<D> box;
  ForEachAxis<D>(
    [&](int axis)
    {
      const double at = std::min(std::max(local[axis], -far), far);
      box.Set(axis, -Frame<D>::RoundUpInRange(-at), Frame<D>::RoundUpInRange(at));
    });
  return box;
}

/// The first of them.
template <int D>
SKD_FLATTEN QueryBox<D> OuterBox(const Frame<D>& frame, const Box<D>& box)
{
  QueryBox<D> outer;
  ForEachAxis<D>([&](int axis)
    { outer.Set(axis, frame.Down(box.Min[axis], axis), frame.Up(box.Max[axis], axis)); });
  return outer;
}

}

#endif
