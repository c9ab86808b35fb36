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

  static bool Has(const Node<3>& bottom) { return (bottom.Tag & 1u) == 0; }
  static std::uint32_t TagOf(std::uint32_t pack) { return 2 * pack; }
  const TrianglePack* Data() const { return this->First; }
  const TrianglePack& Of(const Node<3>& bottom) const { return this->First[bottom.Tag >> 1]; }

private:
  const TrianglePack* First;
};

/// Lower bounds of distances. With `OnlyNearest` also upper ones: these limit the search.
template <bool OnlyNearest>
class DistanceSieve
{
public:
  /// `local`: the point in the tree's frame.
  DistanceSieve(const TrianglePacks& packs, const Vector3& local)
    : Packs(packs)
    , Local(local)
  {
  }

  bool Knows(const Node<3>& bottom) const { return TrianglePacks::Has(bottom); }

  unsigned Pass(const Node<3>& bottom, float* keys, float& limit) const
  {
    const TrianglePack& pack = this->Packs.Of(bottom);
    const TriangleDistances distances(pack, pack.Raster.Of(this->Local));
    if constexpr (OnlyNearest)
    {
      limit = std::min(limit, distances.LeastMost2(bottom.Count, pack.Raster.Unit));
    }
    return distances.Within(limit, pack.Raster.Unit, keys);
  }

private:
  TrianglePacks Packs;
  Vector3 Local;
};

/// Which triangles a line may meet.
class LineSieve
{
public:
  explicit LineSieve(const TrianglePacks& packs)
    : Packs(packs)
  {
  }

  void Aim(const Segment<3>& local, double margin)
  {
    this->Crossings = TriangleCrossings(local, margin);
  }

  bool Knows(const Node<3>& bottom) const { return TrianglePacks::Has(bottom); }

  unsigned Pass(const Node<3>& bottom, float* keys) const
  {
    std::fill(keys, keys + Node<3>::Width, 0.0f);
    return this->Crossings.MayMeet(this->Packs.Of(bottom));
  }

private:
  TrianglePacks Packs;
  TriangleCrossings Crossings;
};

}

#endif
