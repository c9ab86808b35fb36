// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Leaf filters (Tree/Walk.h) for the packets of triangles of leaves: an even tag is twice
/// the number of a node's packet.
#ifndef skd_LeafFilters_TriangleLeafFilters_h
#define skd_LeafFilters_TriangleLeafFilters_h

#include "../Tree/Node.h"
#include "TriangleCrossings.h"
#include "TriangleDistances.h"

namespace skd
{

/// The corners that packets name, each once a packet, as the data set has them: in single precision
/// where it has no more.
struct PacketPoints
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

  /// As many as packets have usually.
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

/// The packets of a tree's leaves, for leaf filters to look at.
class TrianglePackets
{
public:
  TrianglePackets() = default; ///< none
  TrianglePackets(const TrianglePacket* first, const PacketPoints& points)
    : First(first)
    , Points(points)
  {
  }

  static constexpr bool SkipsLeaves = true;
  static bool Knows(const Node<3>& node) { return (node.Tag & 1u) == 0; }
  static std::uint32_t TagOf(std::uint32_t packet) { return 2 * packet; }
  static std::uint32_t NumberOf(const Node<3>& leaf) { return leaf.Tag >> 1; }
  const TrianglePacket& Of(std::uint32_t number) const { return this->First[number]; }
  void Fetch(std::uint32_t number) const
  {
    FetchLines<sizeof(TrianglePacket)>(this->First + number);
  }

  /// Whether there are points: the packets are then those of all leaves, by number.
  bool HavePoints() const { return this->Points.Floats || this->Points.Doubles; }
  void FetchPoints(std::uint32_t number) const
  {
    this->Points.Fetch(this->First[number].FirstPoint);
  }
  Vector3 Corner(std::uint32_t number, std::uint32_t lane, int corner) const
  {
    const TrianglePacket& packet = this->First[number];
    return this->Points.At(packet.FirstPoint + packet.PointOf[lane][corner]);
  }

private:
  const TrianglePacket* First = nullptr;
  PacketPoints Points;
};

/// Lower bounds of distances. With `OnlyNearest` also upper ones: these limit the search.
template <bool OnlyNearest>
class DistanceLeafFilter : public TrianglePackets
{
public:
  static constexpr bool GivesKeys = true;

  /// `local`: the point in the tree's frame.
  DistanceLeafFilter(const TrianglePackets& packets, const Vector3& local)
    : TrianglePackets(packets)
    , Local(local)
  {
  }

  unsigned Pass(std::uint32_t number, std::uint32_t count, float* keys, float& limit) const
  {
    const TrianglePacket& packet = this->Of(number);
    const TriangleDistances distances(packet, packet.Grid.Of(this->Local));
    if constexpr (OnlyNearest)
    {
      limit = std::min(limit, distances.LeastMost2(static_cast<int>(count), packet.Grid.Unit));
    }
    return distances.Within(limit, packet.Grid.Unit, keys) & LowBits(count);
  }

private:
  Vector3 Local;
};

/// The triangles that a line may intersect.
class LineLeafFilter : public TrianglePackets
{
public:
  /// `shear`: that of the line's direction.
  LineLeafFilter(const TrianglePackets& packets, const Shear& shear)
    : TrianglePackets(packets)
    , Crossings(shear)
  {
  }

  void Aim(const Vector3& local, double margin) { this->Crossings.Aim(local, margin); }

  static constexpr bool GivesKeys = false;

  unsigned Pass(std::uint32_t number, std::uint32_t count, float*, float&) const
  {
    if (this->HavePoints())
    {
      this->FetchPoints(number);
    }
    return this->Crossings.MayIntersect(this->Of(number)) & LowBits(count);
  }

private:
  TriangleCrossings Crossings;
};

}

#endif
