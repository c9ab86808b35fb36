// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Rows_h
#define skd_Geometry_Rows_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace skd
{

/// Rows of different lengths in one list. `Offset` is the type of what says where each begins.
template <class Item, class Offset = std::size_t>
class Rows
{
public:
  struct Row
  {
    const Item* First;
    const Item* Last;

    const Item* begin() const { return this->First; }
    const Item* end() const { return this->Last; }
    std::size_t size() const { return static_cast<std::size_t>(this->Last - this->First); }
    const Item& operator[](std::size_t i) const { return this->First[i]; }
  };

  Rows() = default;

  /// Items in any order: forEach(add) calls add(row, item) for all of them, and does so twice, to
  /// count and to store. Those of a row stay in this order. O(n).
  template <class ForEach>
  Rows(std::size_t numberOfRows, const ForEach& forEach)
    : Offsets(numberOfRows + 1, 0)
  {
    forEach([this](std::size_t row, const Item&) { ++this->Offsets[row + 1]; });
    std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
    this->Items.resize(this->Offsets.back());
    std::vector<Offset> next(this->Offsets.begin(), this->Offsets.end() - 1);
    forEach([&](std::size_t row, const Item& item) { this->Items[next[row]++] = item; });
  }

  std::size_t size() const { return this->Offsets.size() - 1; }
  Row operator[](std::size_t i) const
  {
    const Item* items = this->Items.data();
    return { items + this->Offsets[i], items + this->Offsets[i + 1] };
  }

  /// Adds a row.
  template <class Iterator>
  void Add(Iterator first, Iterator last)
  {
    this->Items.insert(this->Items.end(), first, last);
    this->Offsets.push_back(static_cast<Offset>(this->Items.size()));
  }

  void AddEmpty(std::size_t numberOfRows)
  {
    this->Offsets.resize(this->Offsets.size() + numberOfRows, this->Offsets.back());
  }

  /// Sorts the items of each row; loop(n, f) calls f(i) for all i below n, maybe in parallel.
  template <class Loop>
  void SortEach(const Loop& loop)
  {
    loop(this->size(),
      [this](std::size_t i)
      {
        Item* items = this->Items.data();
        std::sort(items + this->Offsets[i], items + this->Offsets[i + 1]);
      });
  }

  /// For each of n items, which are numbers, the rows that have it, ascending.
  Rows Inverse(std::size_t n) const
  {
    return Rows(n,
      [this](const auto& add)
      {
        for (std::size_t row = 0; row < this->size(); ++row)
        {
          for (const Item item : (*this)[row])
          {
            add(item, static_cast<Item>(row));
          }
        }
      });
  }

  /// @{ All rows: the items of one after the other; where each begins, and the end.
  const std::vector<Item>& GetItems() const { return this->Items; }
  const std::vector<Offset>& GetOffsets() const { return this->Offsets; }
  /// @}

private:
  std::vector<Offset> Offsets{ 0 };
  std::vector<Item> Items;
};

/// Rows of indices.
using IndexRows = Rows<std::uint32_t>;

}

#endif
