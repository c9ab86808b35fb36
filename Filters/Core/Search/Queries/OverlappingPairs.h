// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_OverlappingPairs_h
#define skd_Queries_OverlappingPairs_h

#include "../../Geometry/RigidMotion.h"
#include "../Tree/Tolerances.h"
#include "QueryBox.h"

#include <array>
#include <cfloat>
#include <limits>
#include <type_traits>

namespace skd
{

/// The worlds of two trees are one: boxes of the second are as they are, grown by a margin.
struct SameWorld
{
  double Margin = 0.0;

  template <class Box>
  Box operator()(const Box& box) const
  {
    return box.Inflated(this->Margin);
  }
};

/// The second's world is moved, and boxes are grown by a margin.
struct MovedWorld
{
  const RigidMotion& Motion;
  double Margin = 0.0;

  Box3 operator()(const Box3& box) const
  {
    return this->Motion.Forward(box).Inflated(this->Margin);
  }
};

/// Pairs of elements of two trees whose boxes overlap (Algorithm 5.4).
///
/// `toFirst(Box<D>)` gives a box of the second tree's world as a box of the first's, bounds of the
/// moved box: SameWorld, fastest, MovedWorld, or any other motion. `visitor(a, b)` returns false to
/// end the search.
///
/// Pairs of elements whose own boxes overlap, not only those of the trees: a visitor that is called
/// as visitor(a, b, isSure) has to find that out only where it is not sure. The trees' boxes are
/// wider than these by at most `excess` (world units) on each side, both trees' together.
template <int D, class ToFirstWorld, class Visitor>
class OverlappingPairs
{
public:
  static constexpr int Dimension = D;
  static constexpr int Width = Node<D>::Width;

  OverlappingPairs(const Frame<D>& first, const Frame<D>& second, const ToFirstWorld& toFirst,
    Visitor& visitor, double excess = std::numeric_limits<double>::infinity())
    : First(first)
    , Second(second)
    , TheMotion(toFirst)
    , TheVisitor(visitor)
  {
    if constexpr (std::is_same_v<ToFirstWorld, SameWorld>)
    {
      this->Map = FrameMap(first, second, toFirst.Margin);
      const double rounding =
        tolerances::BoxPairExcess * (1.0 + this->Map.Factor) + 4.0 * this->Map.Margin;
      this->Excess = Frame<D>::RoundUp(excess * first.Scale + rounding);
    }
    else if constexpr (std::is_same_v<ToFirstWorld, MovedWorld>)
    {
      this->Map = MotionMap(first, second, toFirst);
    }
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

  BoxPacket<D, Width> ToFirst(const BoxPacket<D, Width>& boxes) const
  {
    if (this->Map.IsFit)
    {
      return this->Map(boxes);
    }
    BoxPacket<D, Width> scaledBoxes;
    for (int lane = 0; lane < Width; ++lane)
    {
      const FloatBox<D> box = boxes.Get(lane);
      scaledBoxes.Set(
        lane, box.Min[0] <= box.Max[0] ? this->ToFirst(box) : box); // empty ones as they are
    }
    return scaledBoxes;
  }

  SKD_FLATTEN unsigned Overlapping(const BoxPacket<D, Width>& boxes, const FloatBox<D>& box) const
  {
    return OverlappingLanes(
      boxes, [&](int axis) { return Lanes<Width>(box.Min[axis]); },
      [&](int axis) { return Lanes<Width>(box.Max[axis]); });
  }

  /// Of boxes seen by ToFirst and a box of the first tree, or the other way round.
  SKD_FLATTEN unsigned SureOf(const BoxPacket<D, Width>& boxes, const FloatBox<D>& box) const
  {
    if (!TellsSure || !this->Map.IsFit)
    {
      return 0;
    }
    return OverlappingLanes(
      boxes, [&](int axis) { return Lanes<Width>(box.Min[axis] + this->Excess); },
      [&](int axis) { return Lanes<Width>(box.Max[axis] - this->Excess); });
  }

  bool Visit(std::uint32_t a, std::uint32_t b, bool isSure)
  {
    if constexpr (TellsSure)
    {
      return this->TheVisitor(a, b, isSure);
    }
    else
    {
      return this->TheVisitor(a, b);
    }
  }

private:
  static constexpr bool TellsSure =
    std::is_invocable_v<Visitor&, std::uint32_t, std::uint32_t, bool>;

  /// From frame to frame of one world in single precision: a power of two and a shift, and a margin
  /// for what rounding does to them. Fit for frames of much the same size that are near each other.
  struct FrameMap
  {
    bool IsFit = false;
    float Factor = 1.0f;
    float Shift[D] = {};
    float Margin = 0.0f;

    FrameMap() = default;
    FrameMap(const Frame<D>& first, const Frame<D>& second, double margin)
      : IsFit(margin >= 0.0)
    {
      constexpr double most = 16.0;
      const double factor = first.Scale / second.Scale;
      double factorUp = factor;
      for (int axis = 0; axis < D; ++axis)
      {
        const double shift = (second.Centre[axis] - first.Centre[axis]) * first.Scale;
        this->Shift[axis] = static_cast<float>(std::clamp(shift, -most, most));
        factorUp = std::max(factorUp, std::abs(shift));
      }
      // Two roundings of at most half a unit in the last place, of numbers of at most twice
      // `factorUp`.
      this->Margin = Frame<D>::RoundUp(margin * first.Scale + 4.0 * FLT_EPSILON * factorUp);
      this->Factor = static_cast<float>(std::clamp(factor, 1.0 / most, most));
      this->IsFit = this->IsFit && factorUp < most && factor > 1.0 / most && this->Margin < most;
    }

    BoxPacket<D, Width> operator()(const BoxPacket<D, Width>& boxes) const
    {
      BoxPacket<D, Width> scaledBoxes;
      ForEachAxis<D>(
        [&](int axis)
        {
          const Lanes<Width> factor(this->Factor);
          const float shift = this->Shift[axis];
          (boxes.Mins(axis) * factor + Lanes<Width>(shift) - Lanes<Width>(this->Margin))
            .Store(scaledBoxes.Min[axis]);
          (boxes.Maxs(axis) * factor + Lanes<Width>(shift) + Lanes<Width>(this->Margin))
            .Store(scaledBoxes.Max[axis]);
        });
      return scaledBoxes;
    }
  };

  /// The same through a motion: the centre of a box is moved, and its half lengths by the
  /// magnitudes of the rotation's elements.
  struct MotionMap
  {
    bool IsFit = false;
    float Rows[3][3] = {};
    float Shift[3] = {};
    float Margin = 0.0f;

    MotionMap() = default;
    MotionMap(const Frame<3>& first, const Frame<3>& second, const MovedWorld& toFirst)
    {
      constexpr double most = 16.0;
      const RigidMotion& motion = toFirst.Motion;
      const double factor = first.Scale / second.Scale;
      const Vector3 centre = motion.Forward(second.Centre) - first.Centre;
      double largest = 0.0; // of coordinates, for those in the second's frame are at most 1
      for (int axis = 0; axis < 3; ++axis)
      {
        const double shift = centre[axis] * first.Scale;
        this->Shift[axis] = static_cast<float>(std::clamp(shift, -most, most));
        largest = std::max(largest, 2.0 * factor + std::abs(shift));
        for (int other = 0; other < 3; ++other)
        {
          const double element = motion.Rows[axis][other] * factor;
          this->Rows[axis][other] = static_cast<float>(std::clamp(element, -most, most));
        }
      }
      // In single precision ten roundings of the centre, ten of the half lengths and two of what
      // they give; in double precision some of coordinates in the world.
      const double inWorld = 16.0 * std::numeric_limits<double>::epsilon() *
        (Norm(first.Centre) + Norm(second.Centre) + Norm(motion.Shift));
      this->Margin =
        Frame<3>::RoundUp((toFirst.Margin + inWorld) * first.Scale + 24.0 * FLT_EPSILON * largest);
      this->IsFit =
        toFirst.Margin >= 0.0 && largest < most && factor > 1.0 / most && this->Margin < most;
    }

    BoxPacket<3, Width> operator()(const BoxPacket<3, Width>& boxes) const
    {
      const Lanes<Width> half(0.5f);
      std::array<Lanes<Width>, 3> centres;
      std::array<Lanes<Width>, 3> lengths;
      ForEachAxis<3>(
        [&](int axis)
        {
          centres[axis] = (boxes.Maxs(axis) + boxes.Mins(axis)) * half;
          lengths[axis] = (boxes.Maxs(axis) - boxes.Mins(axis)) * half;
        });
      BoxPacket<3, Width> scaledBoxes;
      ForEachAxis<3>(
        [&](int axis)
        {
          Lanes<Width> centre(this->Shift[axis]);
          Lanes<Width> length(this->Margin);
          ForEachAxis<3>(
            [&](int other)
            {
              const float element = this->Rows[axis][other];
              centre = centre + centres[other] * Lanes<Width>(element);
              length = length + lengths[other] * Lanes<Width>(std::abs(element));
            });
          (centre - length).Store(scaledBoxes.Min[axis]);
          (centre + length).Store(scaledBoxes.Max[axis]);
        });
      return scaledBoxes;
    }
  };

  const Frame<D>& First;
  const Frame<D>& Second;
  const ToFirstWorld& TheMotion;
  Visitor& TheVisitor;
  std::conditional_t<std::is_same_v<ToFirstWorld, MovedWorld>, MotionMap, FrameMap> Map;
  float Excess = std::numeric_limits<float>::infinity();
};

}

#endif
