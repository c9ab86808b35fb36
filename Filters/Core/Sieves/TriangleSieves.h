// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sieves (NoSieve.h) that look at the packs of triangles kept for bottom nodes: an even tag is
/// twice the number of a node's pack.
#ifndef skd_Sieves_TriangleSieves_h
#define skd_Sieves_TriangleSieves_h

#include "../Tree/Node.h"
#include "TriangleCrossings.h"
#include "TriangleDistances.h"

namespace skd
{

/// The packs of a tree's bottom nodes.
class TrianglePacks
{
public:
  explicit TrianglePacks(const TrianglePack* first)
    : First(first)
  {
  }

  static bool Has(const Node<3>& node) { return (node.Tag & 1u) == 0; }
  static std::uint32_t TagOf(std::uint32_t pack) { return 2 * pack; }
  const TrianglePack* Data() const { return this->First; }
  static std::uint32_t NumberOf(const Node<3>& bottom) { return bottom.Tag >> 1; }
  const TrianglePack& Of(std::uint32_t number) const { return this->First[number]; }
  void Fetch(std::uint32_t number) const { FetchLines<sizeof(TrianglePack)>(this->First + number); }

private:
  const TrianglePack* First;
};

/// Lower bounds of distances. With `OnlyNearest` also upper ones: these limit the search.
template <bool OnlyNearest>
class DistanceSieve
{
public:
  static constexpr bool SkipsBottoms = true;

  /// `local`: the point in the tree's frame.
  DistanceSieve(const TrianglePacks& packs, const Vector3& local)
    : Packs(packs)
    , Local(local)
  {
  }

  bool Knows(const Node<3>& node) const { return TrianglePacks::Has(node); }

  unsigned Pass(const Node<3>& bottom, float* keys, float& limit) const
  {
    return this->Pass(TrianglePacks::NumberOf(bottom), bottom.Count, keys, limit);
  }
  unsigned Pass(std::uint32_t number, std::uint32_t count, float* keys, float& limit) const
  {
    const TrianglePack& pack = this->Packs.Of(number);
    const TriangleDistances distances(pack, pack.Raster.Of(this->Local));
    if constexpr (OnlyNearest)
    {
      limit = std::min(limit, distances.LeastMost2(static_cast<int>(count), pack.Raster.Unit));
    }
    return distances.Within(limit, pack.Raster.Unit, keys) & LowBits(count);
  }
  void Fetch(std::uint32_t number) const { this->Packs.Fetch(number); }

private:
  TrianglePacks Packs;
  Vector3 Local;
};

/// Which triangles a line may meet.
class LineSieve
{
public:
  static constexpr bool SkipsBottoms = true;

  explicit LineSieve(const TrianglePacks& packs)
    : Packs(packs)
  {
  }

  void Aim(const Segment<3>& local, double margin)
  {
    this->Crossings = TriangleCrossings(local, margin);
  }

  bool Knows(const Node<3>& node) const { return TrianglePacks::Has(node); }

  unsigned Pass(const Node<3>& bottom, float* keys) const
  {
    return this->Pass(TrianglePacks::NumberOf(bottom), bottom.Count, keys);
  }
  unsigned Pass(std::uint32_t number, std::uint32_t count, float* keys) const
  {
    std::fill(keys, keys + Node<3>::Width, 0.0f);
    return this->Crossings.MayMeet(this->Packs.Of(number)) & LowBits(count);
  }
  void Fetch(std::uint32_t number) const { this->Packs.Fetch(number); }

private:
  TrianglePacks Packs;
  TriangleCrossings Crossings;
};

}

#endif
