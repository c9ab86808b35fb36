// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_SplitAtRank_h
#define skd_Tree_SplitAtRank_h

#include "Element.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace skd
{

/// std::nth_element for elements by (centroid along an axis, index), two to three times as fast: no
/// branch depends on a comparison, and what is compared most is 8 bytes, not an element.
///
///   many:  [ < low | low .. high | >= high ]   by two keys of a sample, ever closer to the rank,
///   few:   keys alone are searched for the one of that rank, then the elements parted by it.
///
/// Indices are all different, so no two keys are equal. O(n) typical and, by falling back on
/// std::nth_element where samples mislead, in every case.
template <int D>
class SplitAtRank
{
public:
  /// The centroid's bits in an order that is its own, then the index.
  using Key = std::uint64_t;

  static Key KeyOf(const Element<D>& element, int axis)
  {
    const float twice = element.Box.Min[axis] + element.Box.Max[axis] + 0.0f; // no -0
    std::uint32_t bits;
    std::memcpy(&bits, &twice, sizeof(bits));
    const std::uint32_t sign = 0u - (bits >> 31);
    return (Key(bits ^ (sign | 0x80000000u)) << 32) | element.Index;
  }

  /// Moves the `middle - first` smallest of the elements [first, last) before the others.
  static void Run(Element<D>* first, Element<D>* middle, Element<D>* last, int axis)
  {
    const SplitAtRank split(axis);
    for (int round = 0; last - first > Few; ++round)
    {
      if (round == 16)
      {
        split.Fallback(first, middle, last);
        return;
      }
      const Bracket bracket = split.Sample(first, middle, last);
      Element<D>* const low = split.Partition(first, last, bracket.Low);
      Element<D>* const high = middle < low ? low : split.Partition(low, last, bracket.High);
      first = middle < low ? first : middle < high ? low : high;
      last = middle < low ? low : middle < high ? high : last;
    }
    if (first < middle && middle < last)
    {
      split.Partition(first, last, split.KeyOfRank(first, middle, last));
    }
  }

private:
  static constexpr std::ptrdiff_t Few = 4096;
  static constexpr std::ptrdiff_t SampleSize = 512;

  struct Bracket
  {
    Key Low;
    Key High;
  };

  Key KeyOf(const Element<D>& element) const { return KeyOf(element, this->Axis); }

  /// Moves elements below a key to the front; returns the first of the others. Every element is
  /// moved unconditionally, which is cheaper than mispredicted branches.
  Element<D>* Partition(Element<D>* first, Element<D>* last, Key key) const
  {
    Element<D>* next = first;
    for (Element<D>* at = first; at != last; ++at)
    {
      const Element<D> element = *at;
      *at = *next;
      *next = element;
      next += this->KeyOf(element) < key;
    }
    return next;
  }

  /// Two of the keys, below and above the rank, three standard deviations of the sample each.
  Bracket Sample(const Element<D>* first, const Element<D>* middle, const Element<D>* last) const
  {
    std::array<Key, SampleSize> keys;
    const std::ptrdiff_t size = last - first;
    for (std::ptrdiff_t i = 0; i < SampleSize; ++i)
    {
      keys[static_cast<std::size_t>(i)] = this->KeyOf(first[i * size / SampleSize]);
    }
    constexpr std::ptrdiff_t margin = 34;
    const std::ptrdiff_t rank = (middle - first) * SampleSize / size;
    const auto low = keys.begin() + std::max<std::ptrdiff_t>(rank - margin, 0);
    const auto high = keys.begin() + std::min(rank + margin, SampleSize - 1);
    std::nth_element(keys.begin(), low, keys.end());
    std::nth_element(low + 1, high, keys.end());
    return { *low, *high };
  }

  Key KeyOfRank(const Element<D>* first, const Element<D>* middle, const Element<D>* last) const
  {
    std::array<Key, Few> buffer;
    Key* keys = buffer.data();
    std::transform(
      first, last, keys, [this](const Element<D>& element) { return this->KeyOf(element); });
    Key* const wanted = keys + (middle - first);
    Key* end = keys + (last - first);
    for (int round = 0; end - keys > 16 && round < 64; ++round)
    {
      Key* const pivot = PartAtMedianOfThree(keys, end);
      if (pivot == wanted)
      {
        return *wanted;
      }
      (wanted < pivot ? end : keys) = wanted < pivot ? pivot : pivot + 1;
    }
    std::nth_element(keys, wanted, end);
    return *wanted;
  }

  /// Returns where the pivot, below which the keys before it are, has come to.
  static Key* PartAtMedianOfThree(Key* first, Key* end)
  {
    Key* const last = end - 1;
    Key* const between = first + (last - first) / 2;
    const Key pivot =
      std::max(std::min(*first, *between), std::min(std::max(*first, *between), *last));
    std::swap(*last, pivot == *first ? *first : pivot == *between ? *between : *last);
    Key* next = first;
    for (Key* at = first; at != last; ++at)
    {
      const Key key = *at;
      *at = *next;
      *next = key;
      next += key < pivot;
    }
    std::swap(*next, *last);
    return next;
  }

  void Fallback(Element<D>* first, Element<D>* middle, Element<D>* last) const
  {
    std::nth_element(first, middle, last,
      [this](const Element<D>& a, const Element<D>& b) { return this->KeyOf(a) < this->KeyOf(b); });
  }

  explicit SplitAtRank(int axis)
    : Axis(axis)
  {
  }

  int Axis;
};

}

#endif
