// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Predicates_DigitList_h
#define skd_Predicates_DigitList_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace skd
{

/// The digits of a number, without an allocation as long as they are few: enough for the
/// coordinates of a crossing of an edge and a plane, of points that are given in double precision.
class DigitList
{
public:
  DigitList() = default;

  /// So many zeros.
  explicit DigitList(std::size_t count)
    : DigitList(count, Uninitialized())
  {
    std::fill_n(this->data(), count, 0u);
  }

  DigitList(const DigitList& other)
    : DigitList(other.Count, Uninitialized())
  {
    std::copy_n(other.data(), other.Count, this->data());
  }

  DigitList(DigitList&& other) noexcept
    : Many(std::move(other.Many))
    , Count(other.Count)
  {
    std::copy_n(other.Few, this->Many ? 0 : this->Count, this->Few);
    other.Count = 0;
  }

  DigitList& operator=(const DigitList& other) { return *this = DigitList(other); }

  DigitList& operator=(DigitList&& other) noexcept
  {
    this->Many = std::move(other.Many);
    this->Count = other.Count;
    std::copy_n(other.Few, this->Many ? 0 : this->Count, this->Few);
    other.Count = 0;
    return *this;
  }

  bool empty() const { return this->Count == 0; }
  std::size_t size() const { return this->Count; }
  std::uint32_t operator[](std::size_t i) const { return this->data()[i]; }
  std::uint32_t* data() { return this->Many ? this->Many.get() : this->Few; }
  const std::uint32_t* data() const { return this->Many ? this->Many.get() : this->Few; }

  /// Takes zeros off both ends. Returns how many there were at the beginning.
  std::size_t Trim()
  {
    std::uint32_t* const digits = this->data();
    while (this->Count > 0 && digits[this->Count - 1] == 0)
    {
      --this->Count;
    }
    std::size_t zeros = 0;
    while (zeros < this->Count && digits[zeros] == 0)
    {
      ++zeros;
    }
    if (zeros > 0)
    {
      std::copy(digits + zeros, digits + this->Count, digits);
      this->Count -= static_cast<std::uint32_t>(zeros);
    }
    return zeros;
  }

private:
  struct Uninitialized
  {
  };
  static constexpr std::size_t Most = 20;

  DigitList(std::size_t count, Uninitialized)
    : Many(count > Most ? new std::uint32_t[count] : nullptr)
    , Count(static_cast<std::uint32_t>(count))
  {
  }

  std::uint32_t Few[Most];
  std::unique_ptr<std::uint32_t[]> Many; // if there are more
  std::uint32_t Count = 0;
};

}

#endif
