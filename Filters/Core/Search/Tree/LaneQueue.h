// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_LaneQueue_h
#define skd_Tree_LaneQueue_h

#include "Lanes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__) && defined(__SSE4_1__)
#include <smmintrin.h>
#endif

namespace skd
{

/// Some of eight lanes, of which that with the least key comes first. Keys are floats of 0 or more,
/// rounded down to multiples of eight units in the last place: of lanes whose keys are equal then
/// that of the lowest number comes first.
class LaneQueue
{
public:
  static constexpr int Width = 8;
  static constexpr int None = -1;

  /// `lanes`: a bit for each.
  void Put(unsigned lanes, const float* keys);

  /// The first, which leaves the queue; None if the keys of all are above the limit.
  int Take(float limit)
  {
    const std::int32_t least = this->Least();
    if (least > (BitsOf(limit) | LaneBits))
    {
      return None;
    }
    const int lane = least & LaneBits;
    this->Keys[lane] = Taken;
    return lane;
  }

private:
  static constexpr std::int32_t LaneBits = Width - 1;
  static constexpr std::int32_t Taken = 0x7fffffff; // above all numbers, with or without a sign

  static std::int32_t BitsOf(float key)
  {
    std::int32_t bits;
    std::memcpy(&bits, &key, sizeof(bits));
    return bits;
  }

  std::int32_t Least() const;

  /// Bits of numbers, in the order of the numbers; the number of the lane in place of the last.
  alignas(Width * sizeof(std::int32_t)) std::int32_t Keys[Width];
};

#if !defined(SKD_PLAIN_LANES) && defined(__GNUC__)

namespace detail
{
typedef std::int32_t FourIntegers __attribute__((vector_size(16)));

inline FourIntegers Smaller(FourIntegers a, FourIntegers b)
{
#if defined(__SSE4_1__)
  return (FourIntegers)_mm_min_epi32((__m128i)a, (__m128i)b);
#else
  return a < b ? a : b;
#endif
}
}

inline void LaneQueue::Put(unsigned lanes, const float* keys)
{
  using Integers = detail::TruthVector;
  Integers numbers, bits;
  for (int i = 0; i < detail::VectorWidth; ++i)
  {
    numbers[i] = i;
    bits[i] = 1 << i;
  }
  for (int first = 0; first < Width; first += detail::VectorWidth)
  {
    Integers some;
    std::memcpy(&some, keys + first, sizeof(some));
    some = (some & ~LaneBits) | (numbers + first);
    const Integers isPut = (bits & static_cast<int>(lanes >> first)) != 0;
    some = isPut ? some : Integers{} + Taken;
    std::memcpy(this->Keys + first, &some, sizeof(some));
  }
}

inline std::int32_t LaneQueue::Least() const
{
  using Four = detail::FourIntegers;
  Four first, last;
  std::memcpy(&first, this->Keys, sizeof(first));
  std::memcpy(&last, this->Keys + 4, sizeof(last));
  const Four four = detail::Smaller(first, last);
  const Four two = detail::Smaller(four, Four{ four[2], four[3], four[0], four[1] });
  return detail::Smaller(two, Four{ two[1], two[0], two[3], two[2] })[0];
}

#else

inline void LaneQueue::Put(unsigned lanes, const float* keys)
{
  for (int lane = 0; lane < Width; ++lane)
  {
    this->Keys[lane] = (lanes >> lane & 1u) != 0 ? (BitsOf(keys[lane]) & ~LaneBits) | lane : Taken;
  }
}

inline std::int32_t LaneQueue::Least() const
{
  return *std::min_element(this->Keys, this->Keys + Width);
}

#endif

}

#endif
