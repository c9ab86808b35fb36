// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_PlaneLeafFilter_h
#define skd_LeafFilters_PlaneLeafFilter_h

#include "LeafPackets.h"
#include "PlaneRow.h"

namespace skd
{

/// The planes of a leaf's cells: their first index, and their quantization grid.
struct PlanePacket
{
  QuantizationGrid Grid;
  std::uint32_t FirstRow;
  std::uint32_t Count; ///< of rows
};

/// The volume cells that may contain a point: an odd tag is twice the number of a node's packet,
/// and 1 more.
class PlaneLeafFilter
{
public:
  static constexpr bool SkipsLeaves = true;
  static constexpr bool GivesKeys = false;

  /// `local`: the point in the tree's frame.
  PlaneLeafFilter(const PlanePackets& packets, const Vector3& local)
    : Packets(packets)
    , Local(local)
  {
  }

  static bool Knows(const Node<3>& node)
  {
    return (node.Tag & 1u) != 0 && node.Tag != Node<3>::NoTag;
  }
  static std::uint32_t TagOf(std::uint32_t packet) { return 2 * packet + 1; }
  static std::uint32_t NumberOf(const Node<3>& leaf) { return leaf.Tag >> 1; }

  unsigned Pass(std::uint32_t number, std::uint32_t count, float*, float&) const
  {
    const PlanePacket& packet = this->Packets.First[number];
    const PlaneRow* row = this->Packets.Rows + packet.FirstRow;
    const Vector3 x = packet.Grid.Of(this->Local);
    const float rounded[3] = { static_cast<float>(x[0]), static_cast<float>(x[1]),
      static_cast<float>(x[2]) };
    unsigned passed = LowBits(count);
    for (std::uint32_t i = 0; i < packet.Count && passed != 0; ++i)
    {
      passed &= row[i].MayHold(rounded);
    }
    return passed;
  }

  void Fetch(std::uint32_t number) const
  {
    FetchLines<sizeof(PlanePacket)>(this->Packets.First + number);
    for (std::uint32_t i = 0; i < this->Packets.CommonRows; ++i)
    {
      FetchLines<sizeof(PlaneRow)>(
        this->Packets.Rows + number * std::uint64_t(this->Packets.CommonRows) + i);
    }
  }

private:
  PlanePackets Packets;
  Vector3 Local;
};

}

#endif
