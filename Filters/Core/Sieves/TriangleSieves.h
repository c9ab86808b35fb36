// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sieves (NoSieve.h) that look at the packs of triangles kept for leaves: an even tag is
/// twice the number of a node's pack.
#ifndef skd_Sieves_TriangleSieves_h
#define skd_Sieves_TriangleSieves_h

#include "../Tree/Node.h"
#include "TriangleCrossings.h"
#include "TriangleDistances.h"

namespace skd
{

/// The corners that packs name, each once a pack, as the data set has them: in single precision
/// where it has no more.
struct PackPoints
{
  const float* Floats = nullptr; ///< one of the two
  const double* Doubles = nullptr;

  Vector3 At(std::uint32_t point) const
  {
    const std::size_t at = 3 * std::size_t(point);
    return this->Floats
      ? Vector3{ { this->Floats[at], this->Floats[at + 1], this->Floats[at + 2] } }
      : Vector3{ { this->Doubles[at], this->Doubles[at + 1], this->Doubles[at + 2] } };
  }

  /// As many as packs have usually.
  void Fetch(std::uint32_t first) const
  {
    const std::size_t at = 3 * std::size_t(first);
    if (this->Floats)
    {
      FetchLines<128>(this->Floats + at);
    }
    else
    {
      FetchLines<256>(this->Doubles + at);
    }
  }
};

/// The packs of a tree's leaves.
class TrianglePacks
{
public:
  TrianglePacks(const TrianglePack* first, const PackPoints& points)
    : First(first)
    , Points(points)
  {
  }

  static bool Has(const Node<3>& node) { return (node.Tag & 1u) == 0; }
  static std::uint32_t TagOf(std::uint32_t pack) { return 2 * pack; }
  static std::uint32_t NumberOf(const Node<3>& leaf) { return leaf.Tag >> 1; }
  const TrianglePack& Of(std::uint32_t number) const { return this->First[number]; }
  void Fetch(std::uint32_t number) const { FetchLines<sizeof(TrianglePack)>(this->First + number); }

  /// Whether there are points: the packs are then those of all leaves, by number.
  bool HavePoints() const { return this->Points.Floats || this->Points.Doubles; }
  void FetchPoints(std::uint32_t number) const
  {
    this->Points.Fetch(this->First[number].FirstPoint);
  }
  Vector3 Corner(std::uint32_t number, std::uint32_t lane, int corner) const
  {
    const TrianglePack& pack = this->First[number];
    return this->Points.At(pack.FirstPoint + pack.PointOf[lane][corner]);
  }

private:
  const TrianglePack* First;
  PackPoints Points;
};

/// Lower bounds of distances. With `OnlyNearest` also upper ones: these limit the search.
template <bool OnlyNearest>
class DistanceSieve
{
public:
  static constexpr bool SkipsLeaves = true;

  /// `local`: the point in the tree's frame.
  DistanceSieve(const TrianglePacks& packs, const Vector3& local)
    : Packs(packs)
    , Local(local)
  {
  }

  bool Knows(const Node<3>& node) const { return TrianglePacks::Has(node); }

  unsigned Pass(const Node<3>& leaf, float* keys, float& limit) const
  {
    return this->Pass(TrianglePacks::NumberOf(leaf), leaf.Count, keys, limit);
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
  static constexpr bool SkipsLeaves = true;

  /// `shear`: that of the line's direction.
  LineSieve(const TrianglePacks& packs, const Shear& shear)
    : Packs(packs)
    , Crossings(shear)
  {
  }

  void Aim(const Vector3& local, double margin) { this->Crossings.Aim(local, margin); }

  bool Knows(const Node<3>& node) const { return TrianglePacks::Has(node); }

  unsigned Pass(const Node<3>& leaf, float* keys) const
  {
    return this->Pass(TrianglePacks::NumberOf(leaf), leaf.Count, keys);
  }
  unsigned Pass(std::uint32_t number, std::uint32_t count, float* keys) const
  {
    if (this->Packs.HavePoints())
    {
      this->Packs.FetchPoints(number);
    }
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
