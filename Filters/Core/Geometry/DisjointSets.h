// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_DisjointSets_h
#define skd_Geometry_DisjointSets_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace skd
{

/// Disjoint sets of the numbers 0 to n - 1 (union-find, with path halving). The lowest number of a
/// set is its representative, so results do not depend on the order of unions.
template <class Index = std::uint32_t>
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t n)
    : Lower(n)
  {
    std::iota(this->Lower.begin(), this->Lower.end(), Index(0));
  }

  std::size_t Size() const { return this->Lower.size(); }

  /// Adds a set of one more number.
  void Add() { this->Lower.push_back(static_cast<Index>(this->Lower.size())); }

  /// The representative.
  Index Find(Index i)
  {
    while (this->Lower[i] != i)
    {
      this->Lower[i] = this->Lower[this->Lower[i]];
      i = this->Lower[i];
    }
    return i;
  }

  /// The same without shortening paths. Thread-safe.
  Index Find(Index i) const
  {
    while (this->Lower[i] != i)
    {
      i = this->Lower[i];
    }
    return i;
  }

  /// Returns whether they were of different sets.
  bool Unite(Index a, Index b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Lower[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  /// Makes a number a set by itself. All of its set must be made so.
  void TakeOut(Index i) { this->Lower[i] = i; }

  /// The representative of each number.
  std::vector<Index> Representatives()
  {
    for (Index& lower : this->Lower)
    {
      lower = this->Lower[lower]; // that of a lower number is final
    }
    return this->Lower;
  }

  /// The set of each number: 0, 1, ... by ascending representative.
  std::vector<Index> Number()
  {
    std::vector<Index> numbers;
    numbers.reserve(this->Lower.size());
    Index count = 0;
    for (const Index first : this->Representatives())
    {
      const bool isNew = static_cast<std::size_t>(first) == numbers.size();
      numbers.push_back(isNew ? count++ : numbers[first]);
    }
    return numbers;
  }

private:
  std::vector<Index> Lower; // of the same set, or itself
};

}

#endif
