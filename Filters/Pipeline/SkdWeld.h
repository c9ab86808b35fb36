// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdWeld_h
#define SkdWeld_h

#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

/// Merges points of equal coordinates, by a hash table with open addressing, so that a point costs
/// one or two memory accesses.
class SkdWeld
{
public:
  SkdWeld()
    : Points(vtkSmartPointer<vtkPoints>::New())
  {
    this->Points->SetDataTypeToDouble();
  }

  /// The id of the point at x, a new one if there is none.
  vtkIdType GetId(const double x[3])
  {
    if (2 * (this->Keys.size() + 1) > this->Slots.size())
    {
      this->Grow();
    }
    const Key key{ x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 }; // + 0 makes -0 equal in its bits, too
    vtkIdType& slot = this->FindSlot(key);
    if (slot < 0)
    {
      slot = static_cast<vtkIdType>(this->Keys.size());
      this->Keys.push_back(key);
      this->Points->InsertNextPoint(x);
    }
    return slot;
  }

  vtkPoints* GetPoints() const { return this->Points; }

private:
  using Key = std::array<double, 3>;

  static std::size_t HashOf(const Key& key)
  {
    std::uint64_t hash = 0;
    for (const double coordinate : key)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &coordinate, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }

  /// The slot of the key, or the free one where it belongs.
  vtkIdType& FindSlot(const Key& key)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t at = HashOf(key) & mask;
    while (this->Slots[at] >= 0 && this->Keys[static_cast<std::size_t>(this->Slots[at])] != key)
    {
      at = (at + 1) & mask;
    }
    return this->Slots[at];
  }

  void Grow()
  {
    this->Slots.assign(this->Slots.empty() ? 64 : 2 * this->Slots.size(), -1);
    for (std::size_t id = 0; id < this->Keys.size(); ++id)
    {
      this->FindSlot(this->Keys[id]) = static_cast<vtkIdType>(id);
    }
  }

  std::vector<Key> Keys;
  std::vector<vtkIdType> Slots; // a power of two of them, half of them free; -1: free
  vtkSmartPointer<vtkPoints> Points;
};

#endif
