// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Mesh_TupleNumbers_h
#define skd_Mesh_TupleNumbers_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skd
{

/// Numbers sets of N numbers, the nodes of an edge or of a face, say: 0, 1, ... in the order in
/// which they are first met. A hash table with open addressing, 4 N + 8 to 4 N + 16 bytes a set;
/// O(1). Any number of threads may Find() while none adds.
template <int N>
class TupleNumbers
{
public:
  using Tuple = std::array<std::uint32_t, N>;
  static constexpr std::uint32_t None = 0xffffffffu;

  std::uint32_t Size() const { return static_cast<std::uint32_t>(this->Tuples.size()); }

  /// The set with a number, sorted.
  const Tuple& operator[](std::uint32_t number) const { return this->Tuples[number]; }

  /// The number of a set, in whatever order; None if it was never added.
  std::uint32_t Find(Tuple tuple) const
  {
    std::sort(tuple.begin(), tuple.end());
    return this->Slots.empty() ? None : this->Slots[this->SlotOf(tuple)];
  }

  /// The number of a set, a new one when it is first met.
  std::uint32_t FindOrAdd(Tuple tuple)
  {
    std::sort(tuple.begin(), tuple.end());
    if (2 * (this->Tuples.size() + 1) > this->Slots.size())
    {
      this->Grow();
    }
    std::uint32_t& slot = this->Slots[this->SlotOf(tuple)];
    if (slot == None)
    {
      slot = this->Size();
      this->Tuples.push_back(tuple);
    }
    return slot;
  }

  std::size_t MemorySize() const
  {
    return this->Tuples.capacity() * sizeof(Tuple) + this->Slots.capacity() * sizeof(std::uint32_t);
  }

private:
  static std::uint64_t HashOf(const Tuple& tuple)
  {
    std::uint64_t hash = 0;
    for (const std::uint32_t number : tuple)
    {
      hash = (hash ^ number) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return hash;
  }

  /// Where the set is, or would be.
  std::size_t SlotOf(const Tuple& tuple) const
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t at = HashOf(tuple) & mask;
    while (this->Slots[at] != None && this->Tuples[this->Slots[at]] != tuple)
    {
      at = (at + 1) & mask;
    }
    return at;
  }

  void Grow()
  {
    this->Slots.assign(std::max<std::size_t>(16, 2 * this->Slots.size()), None);
    for (std::uint32_t number = 0; number < this->Size(); ++number)
    {
      this->Slots[this->SlotOf(this->Tuples[number])] = number;
    }
  }

  std::vector<Tuple> Tuples;
  std::vector<std::uint32_t> Slots;
};

}

#endif
