// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_QuantileGrid_h
#define skd_Tree_QuantileGrid_h

#include "../../Geometry/TwoDoubles.h"
#include "SplitAtRank.h"

#include <vector>

namespace skd
{

/// A grid over a tree's frame whose slabs along an axis contain about equal numbers of elements, by
/// a sample, so that slabs are thin in fine regions of graded meshes. The slab of an element is
/// monotone in SplitAtRank's key along that axis.
template <int D>
class QuantileGrid
{
public:
  using Bin = std::uint16_t;

  static constexpr int Bits = std::clamp(15 / D, 1, 8);
  static constexpr int NumberOfSlabs = 1 << Bits;
  static constexpr std::size_t NumberOfBins = std::size_t(1) << (Bits * D);

  explicit QuantileGrid(const std::vector<Element<D>>& sample)
  {
    for (int axis = 0; axis < D; ++axis)
    {
      std::array<std::size_t, NumberOfSteps> counts{};
      for (const Element<D>& element : sample)
      {
        ++counts[StepOf(element, axis)];
      }
      std::size_t before = 0;
      for (std::size_t step = 0; step < NumberOfSteps; ++step)
      {
        const std::size_t middle = before + counts[step] / 2;
        this->Slabs[axis][step] = static_cast<std::uint8_t>(
          std::min(middle * NumberOfSlabs / std::max<std::size_t>(sample.size(), 1), LastSlab));
        before += counts[step];
      }
    }
  }

  Bin BinOf(const Element<D>& element) const
  {
    const std::array<std::uint16_t, D> steps = StepsOf(element);
    unsigned bin = 0;
    ForEachAxis<D>(
      [&](int axis)
      {
        const auto a = static_cast<std::size_t>(axis);
        bin = bin << Bits | this->Slabs[a][steps[a]];
      });
    return static_cast<Bin>(bin);
  }

  static int SlabOf(Bin bin, int axis)
  {
    return bin >> (Bits * (D - 1 - axis)) & (NumberOfSlabs - 1);
  }

private:
  static constexpr std::size_t NumberOfSteps = 4096;
  static constexpr float LastStep = NumberOfSteps - 1;
  static constexpr float StepsPerUnit = 0.25f * NumberOfSteps; // of twice a centroid
  static constexpr std::size_t LastSlab = NumberOfSlabs - 1;

  /// Of equal steps along an axis: twice a centroid in the frame is from -2 to 2.
  static std::size_t StepOf(const Element<D>& element, int axis)
  {
    const float twice = element.Box.Min[axis] + element.Box.Max[axis];
    const float step = (twice + 2.0f) * StepsPerUnit;
    return step > 0.0f ? static_cast<std::size_t>(std::min(step, LastStep)) : 0;
  }

  static std::array<std::uint16_t, D> StepsOf(const Element<D>& element)
  {
#if SKD_HAS_DOUBLE_LANES
    if constexpr (D == 3)
    {
      return StepsOf(_mm_load_ps(element.Box.Min), _mm_loadu_ps(element.Box.Max));
    }
#endif
    std::array<std::uint16_t, D> steps;
    ForEachAxis<D>(
      [&](int axis) {
        steps[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(StepOf(element, axis));
      });
    return steps;
  }

#if SKD_HAS_DOUBLE_LANES
  /// StepOf() of three axes; of the fourth lane nothing is used.
  static std::array<std::uint16_t, 3> StepsOf(__m128 least, __m128 greatest)
  {
    const __m128 twice = _mm_add_ps(least, greatest);
    const __m128 step = _mm_mul_ps(_mm_add_ps(twice, _mm_set1_ps(2.0f)), _mm_set1_ps(StepsPerUnit));
    const __m128 within = _mm_min_ps(_mm_max_ps(step, _mm_setzero_ps()), _mm_set1_ps(LastStep));
    const __m128i steps = _mm_cvttps_epi32(within);
    const auto at = [](int value) { return static_cast<std::uint16_t>(value); };
    return { at(_mm_extract_epi16(steps, 0)), at(_mm_extract_epi16(steps, 2)),
      at(_mm_extract_epi16(steps, 4)) };
  }
#endif

  std::array<std::array<std::uint8_t, NumberOfSteps>, D> Slabs;
};

}

#endif
