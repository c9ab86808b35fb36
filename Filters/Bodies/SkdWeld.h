// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdWeld_h
#define SkdWeld_h

#include "Core/Geometry/Vector.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

namespace skdtree
{
/// Merges points of equal coordinates, also of those that are not numbers, by a hash table with
/// open addressing, so that a point costs one or two memory accesses.
class SkdWeld
{
public:
  SkdWeld() = default;

  /// Prepared for a number of different points.
  explicit SkdWeld(std::size_t expected)
  {
    this->Points.reserve(expected);
    std::size_t slots = Fewest;
    while (slots < 2 * (expected + 1))
    {
      slots *= 2;
    }
    this->Slots.assign(slots, -1);
  }

  /// The id of the point at x, a new one if there is none.
  vtkIdType GetId(const double x[3])
  {
    if (2 * (this->Points.size() + 1) > this->Slots.size())
    {
      this->Grow();
    }
    const skd::Vector3 point{ { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 } }; // no -0: its bits differ
    vtkIdType& slot = this->FindSlot(point);
    if (slot < 0)
    {
      slot = static_cast<vtkIdType>(this->Points.size());
      this->Points.push_back(point);
    }
    return slot;
  }

  /// By their ids.
  const std::vector<skd::Vector3>& GetPoints() const { return this->Points; }

  /// Of coordinates that are not -0.
  static std::size_t HashOf(const skd::Vector3& point)
  {
    std::uint64_t hash = 0;
    for (const double coordinate : point.X)
    {
      hash = (hash ^ BitsOf(coordinate)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }

private:
  static constexpr std::size_t Fewest = 64;

  static std::uint64_t BitsOf(double coordinate)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    return bits;
  }

  /// The slot of a point, or the free one where it belongs.
  vtkIdType& FindSlot(const skd::Vector3& point)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t at = HashOf(point) & mask;
    while (this->Slots[at] >= 0 && !this->HaveSameBits(this->Slots[at], point))
    {
      at = (at + 1) & mask;
    }
    return this->Slots[at];
  }

  bool HaveSameBits(vtkIdType id, const skd::Vector3& point) const
  {
    const skd::Vector3& other = this->Points[static_cast<std::size_t>(id)];
    return std::equal(std::begin(point.X), std::end(point.X), std::begin(other.X),
      [](double a, double b) { return BitsOf(a) == BitsOf(b); });
  }

  void Grow()
  {
    this->Slots.assign(this->Slots.empty() ? Fewest : 2 * this->Slots.size(), -1);
    for (std::size_t id = 0; id < this->Points.size(); ++id)
    {
      this->FindSlot(this->Points[id]) = static_cast<vtkIdType>(id);
    }
  }

  std::vector<skd::Vector3> Points;
  std::vector<vtkIdType> Slots; // a power of two of them, half of them free; -1: free
};
}

#endif
