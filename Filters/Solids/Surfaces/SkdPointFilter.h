// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPointFilter_h
#define SkdPointFilter_h

#include "Core/Geometry/Box.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace skdtree
{
/// A filter that excludes most points that are not in a set: by bounds, and a bit for each hash
/// value.
class SkdPointFilter
{
public:
  explicit SkdPointFilter(std::size_t count)
  {
    while ((std::size_t(1) << this->Log2) < 32 * count)
    {
      ++this->Log2;
    }
    this->Bits.assign(std::size_t(1) << (this->Log2 - 6), 0);
  }

  void Add(const skd::Vector3& x)
  {
    this->Bounds.Add(x);
    const std::uint64_t hash = this->HashOf(x);
    this->Bits[hash >> 6] |= std::uint64_t(1) << (hash & 63);
  }

  bool MayHave(const skd::Vector3& x) const
  {
    if (!this->Bounds.Contains(x))
    {
      return false;
    }
    const std::uint64_t hash = this->HashOf(x);
    return (this->Bits[hash >> 6] >> (hash & 63) & 1) != 0;
  }

private:
  static std::uint64_t BitsOf(double coordinate)
  {
    std::uint64_t bits;
    coordinate += 0.0; // -0 and 0 are one
    std::memcpy(&bits, &coordinate, sizeof(bits));
    return bits;
  }

  std::uint64_t HashOf(const skd::Vector3& x) const
  {
    const std::uint64_t mixed = BitsOf(x[0]) * 0x9e3779b97f4a7c15u +
      BitsOf(x[1]) * 0xc2b2ae3d27d4eb4fu + BitsOf(x[2]) * 0x165667b19e3779f9u;
    return ((mixed ^ (mixed >> 32)) * 0xd6e8feb86659fd93u) >> (64 - this->Log2);
  }

  int Log2 = 6;
  std::vector<std::uint64_t> Bits;
  skd::Box3 Bounds;
};
}

#endif
