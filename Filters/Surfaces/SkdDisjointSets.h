// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdDisjointSets_h
#define SkdDisjointSets_h

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

/// Disjoint sets of the numbers 0 to n - 1 (union-find, with path halving). The lowest number of a
/// set is its representative, so results do not depend on the order of unions.
class SkdDisjointSets
{
public:
  explicit SkdDisjointSets(std::size_t n)
    : Lower(n)
  {
    std::iota(this->Lower.begin(), this->Lower.end(), 0u);
  }

  std::uint32_t Find(std::uint32_t i)
  {
    while (this->Lower[i] != i)
    {
      this->Lower[i] = this->Lower[this->Lower[i]];
      i = this->Lower[i];
    }
    return i;
  }

  void Unite(std::uint32_t a, std::uint32_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Lower[std::max(a, b)] = std::min(a, b);
  }

  /// The set of each number: 0, 1, ... by ascending representative.
  std::vector<std::uint32_t> Number()
  {
    std::vector<std::uint32_t> numbers(this->Lower.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < numbers.size(); ++i)
    {
      const std::uint32_t first = this->Find(i);
      numbers[i] = first == i ? count++ : numbers[first];
    }
    return numbers;
  }

private:
  std::vector<std::uint32_t> Lower; // of the same set, or itself
};

#endif
