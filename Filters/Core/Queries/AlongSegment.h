// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_AlongSegment_h
#define skd_Queries_AlongSegment_h

#include "../Geometry/Segment.h"
#include "NoSieve.h"

namespace skd
{

/// Elements along a segment (Algorithm 5.2), by the parameter at which it enters their boxes.
///
/// `leaf(element)` intersects an element and returns the parameter (0..1 along the segment) beyond
/// which nothing is wanted any more: the first hit so far, or 1 for all hits.
///
/// The segment is first clipped in double precision, so that a far end costs no accuracy, to the
/// bounds of the tree and as much room again: no new end comes near a box. `margin` (world units)
/// widens every box, for searches with a tolerance.
/// `InOrder`: whether the nearest comes first. Where all is wanted, any order will do.
template <int D, class Leaf, class Sieve = NoSieve, bool InOrder = true>
class AlongSegment
{
public:
  static constexpr bool Ordered = InOrder;
  static constexpr bool SkipsBottoms = Sieve::SkipsBottoms;

  AlongSegment(const Frame<D>& frame, const Box<D>& bounds, const Segment<D>& segment,
    double margin, Leaf& leaf, const Sieve& sieve = Sieve())
    : TheLeaf(leaf)
    , TheSieve(sieve)
  {
    const std::optional<Interval> inside =
      Clip(segment, bounds.Inflated(margin + 1.0 / frame.Scale));
    if (!inside || !(margin >= 0.0))
    {
      return;
    }
    this->Begin = inside->Min;
    this->Length = inside->Max - inside->Min;
    const Segment<D> local{ frame.Local(segment.A), frame.Local(segment.B) };
    const Segment<D> clipped{ local.At(inside->Min), local.At(inside->Max) };
    const double reach = margin * frame.Scale + RoundingOf(local);
    this->SetLocal(clipped.A, clipped.B, reach);
    this->TheSieve.Aim(clipped, reach);
    this->TheLimit = 1.0f + Slack;
  }

  template <int W>
  SKD_IN_ONE_PIECE unsigned Reach(const Bundle<D, W>& boxes, float* keys) const
  {
    Lanes<W> enter(0.0f);
    Lanes<W> leave(1.0f);
    ForEachAxis<D>(
      [&](int axis)
      {
        const Lanes<W> inverse(this->Inverse[axis]);
        const Lanes<W> near = boxes.Side(axis, !this->IsForward[axis]);
        const Lanes<W> far = boxes.Side(axis, this->IsForward[axis]);
        enter = Max((near - Lanes<W>(this->NearOrigin[axis])) * inverse, enter);
        leave = Min((far - Lanes<W>(this->FarOrigin[axis])) * inverse, leave);
      });
    enter.Store(keys);
    return LessEqual(enter, Min(leave + Lanes<W>(Slack), Lanes<W>(this->TheLimit)));
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

  float Limit() const { return this->TheLimit; }

  bool Visit(std::uint32_t element)
  {
    const double parameter = this->TheLeaf(element);
    const double local = (parameter - this->Begin) / this->Length;
    if (local < 1.0)
    {
      this->TheLimit = Frame<D>::RoundUp(std::max(local, 0.0)) + Slack;
    }
    return true;
  }

private:
  /// Above the rounding of a parameter in [0, 1]: a handful of operations of 2^-24 each.
  static constexpr float Slack = 4e-6f;

  /// What points along a segment with these ends are off by, at most.
  static double RoundingOf(const Segment<D>& local)
  {
    double largest = 0.0;
    for (int axis = 0; axis < D; ++axis)
    {
      largest = std::max({ largest, std::abs(local.A[axis]), std::abs(local.B[axis]) });
    }
    return 4.0 * std::numeric_limits<double>::epsilon() * largest;
  }

  /// Without a branch: which way a segment runs is anyone's guess.
  void SetLocal(const Vector<D>& from, const Vector<D>& to, double margin)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      const double direction = to[axis] - from[axis];
      const double sign = std::copysign(1.0, direction);
      this->IsForward[axis] = sign > 0.0;
      this->Inverse[axis] = Spread(static_cast<float>(1.0 / Widened(direction)));
      this->NearOrigin[axis] = Spread(Beside(from[axis], sign, margin));
      this->FarOrigin[axis] = Spread(Beside(from[axis], -sign, margin));
    }
  }

  /// A margin away to that side, rounded away, too.
  static float Beside(double place, double side, double margin)
  {
    return static_cast<float>(side) * Frame<D>::RoundUp(side * place + margin);
  }

  /// "Insure width of L in each coordinate direction": no division by zero, no infinity below.
  static double Widened(double direction)
  {
    constexpr double least = 1e-30;
    return std::copysign(std::max(std::abs(direction), least), direction);
  }

  double Begin = 0.0;
  double Length = 0.0;
  bool IsForward[D];
  Spread NearOrigin[D];
  Spread FarOrigin[D];
  Spread Inverse[D];
  float TheLimit = -1.0f; // less than every key: a segment that misses the tree reaches nothing
  Leaf& TheLeaf;
  Sieve TheSieve;
};

}

#endif
