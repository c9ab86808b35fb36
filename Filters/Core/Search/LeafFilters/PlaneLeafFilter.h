// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_LeafFilters_PlaneLeafFilter_h
#define skd_LeafFilters_PlaneLeafFilter_h

#include "LeafPackets.h"
#include "PlaneRow.h"
#include "TrianglePacket.h"

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

  SKD_FLATTEN unsigned Pass(std::uint32_t number, std::uint32_t count, float*, float&) const
  {
    const PlanePackets& packets = this->Packets;
    if (packets.Slabs)
    {
      return packets.Slabs[number].MayHold(this->On(packets.Boxes[number].Grid).X) & LowBits(count);
    }
    const PlanePacket* packet = packets.Boxes ? nullptr : packets.First + number;
    const Rounded x = this->On(packet ? packet->Grid : packets.Boxes[number].Grid);
    const PlaneRow* row =
      packets.Rows + (packet ? packet->FirstRow : number * std::size_t(packets.CommonRows));
    const PlaneRow* const end = row + (packet ? packet->Count : packets.CommonRows);
    unsigned passed = LowBits(count);
    for (; row != end && passed != 0; ++row)
    {
      passed &= row->MayHold(x.X);
    }
    return passed;
  }

  void FetchData(std::uint32_t) const {}
  void Fetch(std::uint32_t number) const
  {
    const PlanePackets& packets = this->Packets;
    if (!packets.Boxes)
    {
      FetchLines<sizeof(PlanePacket)>(packets.First + number);
      return;
    }
    FetchLines<1>(&packets.Boxes[number].Grid);
    if (packets.Slabs)
    {
      FetchLines<sizeof(SlabPacket)>(packets.Slabs + number);
      FetchLines<1>(reinterpret_cast<const char*>(packets.Slabs + number + 1) - 1);
      return;
    }
    for (std::uint32_t i = 0; i < packets.CommonRows; ++i)
    {
      FetchLines<sizeof(PlaneRow)>(packets.Rows + number * std::size_t(packets.CommonRows) + i);
    }
  }

private:
  struct Rounded
  {
    float X[3];
  };
  Rounded On(const QuantizationGrid& grid) const
  {
    const Vector3 x = grid.Of(this->Local);
    return { { static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]) } };
  }

  const PlanePackets& Packets;
  Vector3 Local;
};

}

#endif
