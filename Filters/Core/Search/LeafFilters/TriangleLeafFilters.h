// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Leaf filters (Tree/Walk.h) for the packets of triangles of leaves: an even tag is twice
/// the number of a node's packet.
#ifndef skd_LeafFilters_TriangleLeafFilters_h
#define skd_LeafFilters_TriangleLeafFilters_h

#include "../Tree/AxisLanes.h"
#include "LeafPackets.h"
#include "TriangleCrossings.h"
#include "TriangleDistances.h"

namespace skd
{

inline const TrianglePacket& TrianglePackets::Of(std::uint32_t number) const
{
  return this->First[number];
}

inline void TrianglePackets::Fetch(std::uint32_t number) const
{
  FetchLines<sizeof(TrianglePacket)>(this->First + number);
}

inline Vector3 TrianglePackets::Corner(std::uint32_t number, std::uint32_t lane, int corner) const
{
  const TrianglePacket& packet = this->First[number];
  return this->Points.At(packet.FirstPoint + packet.PointOf[lane][corner]);
}

template <class Body>
auto TrianglePackets::WithCorners(std::uint32_t number, std::uint32_t lane, const Body& body) const
{
  const TrianglePacket& packet = this->First[number];
  const auto pass = [&](const auto* points)
  {
    points += 3 * std::size_t(packet.FirstPoint);
    const auto corner = [&](int i) { return points + 3 * std::size_t(packet.PointOf[lane][i]); };
    const decltype(points) corners[] = { corner(0), corner(1), corner(2) };
    return body([&](std::ptrdiff_t axis)
      { return AxisLanes<3>::Of([&](int i) { return corners[i][axis]; }); });
  };
  return this->Points.Floats ? pass(this->Points.Floats) : pass(this->Points.Doubles);
}

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

/// The triangles that a line may intersect. `OfAll`: of a tree whose packets have points, so that
/// every node is known. Lanes that are not in use then have triangles of no area.
template <bool OfAll>
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

  static bool Knows(const Node<3>& node) { return OfAll || TrianglePackets::Knows(node); }
  void FetchData(std::uint32_t line) const
  {
    if (OfAll)
    {
      this->GetPoints().Fetch(line);
    }
  }
  unsigned Pass(std::uint32_t number, std::uint32_t count, float*, float&) const
  {
    const unsigned passed = this->Crossings.MayIntersect(this->Of(number));
    return OfAll ? passed : passed & LowBits(count);
  }

private:
  TriangleCrossings Crossings;
};

}

#endif
