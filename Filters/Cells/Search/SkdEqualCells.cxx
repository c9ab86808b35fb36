// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdEqualCells.h"

#include "Cells/Read/SkdForEach.h"
#include "Cells/Search/SkdCellStore.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace skdtree
{
namespace
{
using HashedCell = std::pair<std::uint64_t, std::uint32_t>;

bool MayBeEqual(SkdShape shape)
{
  return shape != SkdShape::Polyhedron && shape != SkdShape::Generic;
}

using Bits = std::array<std::uint64_t, 3>;

Bits BitsOf(const skd::Vector3& x)
{
  Bits bits;
  std::memcpy(bits.data(), x.X, sizeof(bits));
  return bits;
}

std::uint64_t Mixed(std::uint64_t hash, std::uint64_t bits)
{
  hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
  return hash ^ hash >> 32;
}

std::uint64_t HashOf(const SkdCellStore& store, std::uint32_t cell)
{
  const std::uint32_t* ids = store.PointIdsOf(cell);
  const std::uint32_t size = store.SizeOf(cell);
  auto hash = Mixed(size, static_cast<std::uint64_t>(store.ShapeOf(cell)));
  for (std::uint32_t i = 0; i < size; ++i)
  {
    const Bits bits = BitsOf(store.Point(ids[i]));
    hash = Mixed(Mixed(Mixed(hash, bits[0]), bits[1]), bits[2]);
  }
  return hash;
}

bool AreEqual(const SkdCellStore& store, std::uint32_t a, std::uint32_t b)
{
  const SkdShape shape = store.ShapeOf(a);
  if (!MayBeEqual(shape) || shape != store.ShapeOf(b) || store.SizeOf(a) != store.SizeOf(b))
  {
    return false;
  }
  const std::uint32_t* p = store.PointIdsOf(a);
  return std::equal(p, p + store.SizeOf(a), store.PointIdsOf(b),
    [&store](std::uint32_t i, std::uint32_t k)
    { return i == k || BitsOf(store.Point(i)) == BitsOf(store.Point(k)); });
}

bool AreBoxesEqual(const skd::Node<3>& node)
{
  constexpr int few = 4; // equal cells that are no matter
  const int last = node.Count - 1;
  bool areEqual = node.Count >= few;
  for (int axis = 0; areEqual && axis < 3; ++axis)
  {
    const auto isSame = [last](const float* values)
    {
      return std::all_of(
        values, values + last + 1, [values](float value) { return value == *values; });
    };
    areEqual = isSame(node.Boxes.Min[axis]) && isSame(node.Boxes.Max[axis]);
  }
  return areEqual;
}
}

//------------------------------------------------------------------------------
bool SkdEqualCells::AreLikely(const skd::Tree<3>& tree)
{
  constexpr std::size_t sample = 1 << 16;
  const std::size_t step = tree.NumberOfNodes() / sample + 1;
  for (std::size_t i = 0; i < tree.NumberOfNodes(); i += step)
  {
    if (AreBoxesEqual(tree.Open(static_cast<std::uint32_t>(i))))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
SkdEqualCells::SkdEqualCells(const SkdCellStore& store)
{
  const std::uint32_t n = store.NumberOfCells();
  std::vector<HashedCell> hashed(n);
  SkdForEach(n, [&](std::uint32_t cell) { hashed[cell] = { HashOf(store, cell), cell }; });
  std::sort(hashed.begin(), hashed.end()); // those of one hash by ascending cell
  std::vector<std::uint32_t> firstOf(n);
  for (std::size_t begin = 0, i = 0; i < n; ++i)
  {
    begin = hashed[i].first == hashed[begin].first ? begin : i;
    const auto [first, cell] = std::make_pair(hashed[begin].second, hashed[i].second);
    firstOf[cell] = AreEqual(store, first, cell) ? first : cell;
  }
  this->Group(firstOf);
}

//------------------------------------------------------------------------------
// The first of each cell's group is itself or comes before it.
void SkdEqualCells::Group(const std::vector<std::uint32_t>& firstOf)
{
  const auto n = static_cast<std::uint32_t>(firstOf.size());
  std::vector<std::uint32_t> groupOf(n);
  for (std::uint32_t cell = 0; cell < n; ++cell)
  {
    if (firstOf[cell] == cell)
    {
      groupOf[cell] = static_cast<std::uint32_t>(this->Firsts.size());
      this->Firsts.push_back(cell);
    }
  }
  this->Others = { this->Firsts.size(),
    [&](const auto& add)
    {
      for (std::uint32_t cell = 0; cell < n; ++cell)
      {
        if (firstOf[cell] != cell)
        {
          add(groupOf[firstOf[cell]], cell);
        }
      }
    } };
}
}
