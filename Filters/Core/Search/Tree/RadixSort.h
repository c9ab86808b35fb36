// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_RadixSort_h
#define skd_Tree_RadixSort_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace skd
{

/// Sorts numbers whose low 32 bits ascend and whose bits 32 to 61 are the key (those above are 0):
/// a radix sort by digits of ten bits, from the lowest. O(n).
inline void SortByHighWord(std::vector<std::uint64_t>& keys)
{
  constexpr int digitBits = 10;
  constexpr int lowestBit = 32;
  constexpr std::size_t digits = 3;
  constexpr std::size_t fewest = 256; // where it gains something
  if (keys.size() < fewest)
  {
    std::sort(keys.begin(), keys.end());
    return;
  }
  using Counts = std::array<std::size_t, std::size_t(1) << digitBits>;
  const auto digitOf = [](std::uint64_t key, std::size_t digit) -> std::size_t
  { return key >> (lowestBit + digitBits * digit) & ((std::size_t(1) << digitBits) - 1); };
  std::array<Counts, digits> counts{};
  for (const std::uint64_t key : keys)
  {
    for (std::size_t digit = 0; digit < digits; ++digit)
    {
      ++counts[digit][digitOf(key, digit)];
    }
  }
  std::vector<std::uint64_t> sorted(keys.size());
  for (std::size_t digit = 0; digit < digits; ++digit)
  {
    std::size_t next = 0;
    for (std::size_t& count : counts[digit])
    {
      next += std::exchange(count, next);
    }
    for (const std::uint64_t key : keys)
    {
      sorted[counts[digit][digitOf(key, digit)]++] = key;
    }
    keys.swap(sorted);
  }
}

}

#endif
