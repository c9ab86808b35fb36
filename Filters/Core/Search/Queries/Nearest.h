// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_Nearest_h
#define skd_Queries_Nearest_h

#include "../Tree/Tolerances.h"
#include "../Tree/Walk.h"

namespace skd
{

/// A point as the boxes of a tree see it: its distances to a packet of boxes (section 4.1), in the
/// frame, squared. In single precision the point itself is a small box: that keeps least distances
/// on the low side and greatest ones on the high side. The few roundings of the sum are covered by
/// the slack of Frame::UpperBound2.
template <int D>
class PointKeys
{
public:
  PointKeys(const Frame<D>& frame, const Vector<D>& point)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      this->Low[axis] = Spread(frame.Down(point[axis], axis));
      this->High[axis] = Spread(frame.Up(point[axis], axis));
    }
  }

  template <int W>
  Lanes<W> MinDistances2(const BoxPacket<D, W>& boxes) const
  {
    Lanes<W> sum(0.0f);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> below = boxes.Mins(axis) - Lanes<W>(this->High[axis]);
        const Lanes<W> above = Lanes<W>(this->Low[axis]) - boxes.Maxs(axis);
        const Lanes<W> gap = Max(Max(below, above), Lanes<W>(0.0f));
        sum = sum + gap * gap;
      });
    return sum;
  }

  template <int W>
  Lanes<W> MaxDistances2(const BoxPacket<D, W>& boxes) const
  {
    Lanes<W> sum(0.0f);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> fromMin = Lanes<W>(this->High[axis]) - boxes.Mins(axis);
        const Lanes<W> fromMax = boxes.Maxs(axis) - Lanes<W>(this->Low[axis]);
        const Lanes<W> maxDistance = Max(fromMin, fromMax);
        sum = sum + maxDistance * maxDistance;
      });
    constexpr float slack = 1.0f + 1.0f / (1 << 19);
    constexpr auto denormals = static_cast<float>(tolerances::Denormal2);
    return sum * Lanes<W>(slack) + Lanes<W>(denormals);
  }

private:
  Spread Low[D];
  Spread High[D];
};

/// Nearest element to a point (sections 4.1 and 5), with exact distances: boxes are visited by
/// their minimum distance (4.1) and skipped if they are farther than the best answer so far.
///
/// `visitor(element)` measures an element and returns the new limit of the search, a squared
/// distance in the world. This covers: the nearest (visitor returns the best so far), the k nearest
/// (the k-th best), all within a sphere (section 4.2: always the radius). A bound known beforehand
/// is the first limit: infinity, a radius, or the distance to a reference point. Elements at
/// exactly the limit are visited, so ties can go to the lowest index.
template <int D, class Visitor, class LeafFilter = NoLeafFilter>
class Nearest : public FilteredQuery<Nearest<D, Visitor, LeafFilter>, LeafFilter>
{
public:
  static constexpr bool Ordered = true;
  static constexpr bool ManyChildren = true;

  Nearest(const Frame<D>& frame, const Vector<D>& point, double limit2, Visitor& visitor,
    const LeafFilter& leafFilter = LeafFilter())
    : FilteredQuery<Nearest, LeafFilter>(frame.UpperBound2(limit2), leafFilter)
    , TheFrame(frame)
    , Point(frame, point)
    , TheVisitor(visitor)
  {
  }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<D, W>& boxes, float* keys) const
  {
    const Lanes<W> nearest = this->Point.MinDistances2(boxes);
    nearest.Store(keys);
    return LessEqual(nearest, Lanes<W>(this->TheLimit));
  }

  bool Visit(std::uint32_t element)
  {
    this->TheLimit = this->TheFrame.UpperBound2(this->TheVisitor(element));
    return true;
  }

private:
  const Frame<D>& TheFrame;
  PointKeys<D> Point;
  Visitor& TheVisitor;
};

/// Algorithm 5.1 without the exact test: calls `visitor(element)` for every element whose box may
/// hold the nearest point. The pessimistic distance falls as boxes are met: every node holds an
/// element, so the farthest point of its box bounds the nearest. Elements reached early may be
/// farther than what is known in the end: the caller drops those ("compress the list").
template <int D, class Visitor>
class NearestCandidates
{
public:
  static constexpr bool Ordered = true;

  NearestCandidates(const Frame<D>& frame, const Vector<D>& point, double limit2, Visitor& visitor)
    : Point(frame, point)
    , TheLimit(frame.UpperBound2(limit2))
    , TheVisitor(visitor)
  {
  }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<D, W>& boxes, float* keys)
  {
    float farthest[W];
    this->Point.MaxDistances2(boxes).Store(farthest);
    for (int lane = 0; lane < W; ++lane)
    {
      const bool isEmpty = boxes.Min[0][lane] > boxes.Max[0][lane];
      if (!isEmpty && farthest[lane] < this->TheLimit)
      {
        this->TheLimit = farthest[lane];
      }
    }
    const Lanes<W> nearest = this->Point.MinDistances2(boxes);
    nearest.Store(keys);
    return LessEqual(nearest, Lanes<W>(this->TheLimit));
  }

  float Limit() const { return this->TheLimit; }

  bool Visit(std::uint32_t element)
  {
    this->TheVisitor(element);
    return true;
  }

private:
  PointKeys<D> Point;
  float TheLimit;
  Visitor& TheVisitor;
};

}

#endif
