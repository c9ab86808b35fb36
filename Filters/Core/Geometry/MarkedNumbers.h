// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_MarkedNumbers_h
#define skd_Geometry_MarkedNumbers_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace skd
{

/// Some of the numbers 0 to n - 1, a bit each: few of many are sorted and without repetition by one
/// pass over these bits.
class MarkedNumbers
{
public:
  explicit MarkedNumbers(std::size_t n)
    : Bits(n / 64 + 1, 0)
  {
  }

  void Mark(std::uint32_t number) { this->Bits[number / 64] |= std::uint64_t(1) << number % 64; }
  bool IsMarked(std::uint32_t number) const
  {
    return (this->Bits[number / 64] >> number % 64 & 1u) != 0;
  }

  /// The first one from a number on that is marked, or `end` if there is none before it.
  std::uint32_t FindNext(std::uint32_t number, std::uint32_t end) const
  {
    while (number < end && !this->IsMarked(number))
    {
      const bool isNone = number % 64 == 0 && this->Bits[number / 64] == 0;
      number += isNone ? 64 : 1;
    }
    return number < end ? number : end;
  }

  /// Calls visit(number) for those that are marked, ascending.
  template <class Visit>
  void ForEach(const Visit& visit) const
  {
    for (std::size_t i = 0; i < this->Bits.size(); ++i)
    {
      auto number = static_cast<std::uint32_t>(64 * i);
      for (std::uint64_t bits = this->Bits[i]; bits != 0; bits >>= 1, ++number)
      {
        if ((bits & 1u) != 0)
        {
          visit(number);
        }
      }
    }
  }

  std::vector<std::uint32_t> List() const
  {
    std::vector<std::uint32_t> numbers;
    this->ForEach([&numbers](std::uint32_t number) { numbers.push_back(number); });
    return numbers;
  }

  void Clear() { this->Bits.assign(this->Bits.size(), 0); }

private:
  std::vector<std::uint64_t> Bits;
};

}

#endif
