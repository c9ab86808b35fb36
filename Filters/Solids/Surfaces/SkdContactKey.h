// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdContactKey_h
#define SkdContactKey_h

#include "Core/Geometry/Vector.h"

#include <cstdint>
#include <cstring>

namespace skdtree
{
/// What identifies a point of contact, or a segment, on all processes: 128 bits mixed of what it
/// lies on. That two of n have the same by chance has a probability of about n^2 / 10^39.
struct SkdContactKey
{
  std::uint64_t High = 0x9e3779b97f4a7c15u;
  std::uint64_t Low = 0xc2b2ae3d27d4eb4fu;

  bool operator==(const SkdContactKey& other) const
  {
    return this->High == other.High && this->Low == other.Low;
  }
  bool operator!=(const SkdContactKey& other) const { return !(*this == other); }
  bool operator<(const SkdContactKey& other) const
  {
    return this->High != other.High ? this->High < other.High : this->Low < other.Low;
  }

  /// By two of the finalizers of D. Stafford, each one to one.
  void Add(std::uint64_t value)
  {
    std::uint64_t x = this->High ^ value;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    this->High = (x ^ (x >> 31)) + 0x9e3779b97f4a7c15u;
    std::uint64_t y = this->Low + value * 0xff51afd7ed558ccdu;
    y = (y ^ (y >> 33)) * 0x64dd81482cbd31d7u;
    y = (y ^ (y >> 31)) * 0xe36aa5c613612997u;
    this->Low = (y ^ (y >> 33)) + 0x165667b19e3779f9u;
  }

  /// Coordinates; 0 and -0 are the same.
  void Add(const skd::Vector3& x)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double coordinate = x[axis] + 0.0;
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof(bits));
      this->Add(bits);
    }
  }

  /// That of a segment from its ends, in any order.
  static SkdContactKey OfSegment(const SkdContactKey& a, const SkdContactKey& b)
  {
    const SkdContactKey& first = b < a ? b : a;
    const SkdContactKey& second = b < a ? a : b;
    SkdContactKey key;
    for (const std::uint64_t part : { first.High, first.Low, second.High, second.Low })
    {
      key.Add(part);
    }
    return key;
  }
};
}

#endif
