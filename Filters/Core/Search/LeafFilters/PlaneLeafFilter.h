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
    const PlanePacket* packet = packets.Boxes ? nullptr : packets.First + number;
    const WholePoint x((packet ? packet->Grid : packets.Boxes[number].Grid).Of(this->Local));
    EightIntegers inside;
    if (packets.Slabs)
    {
      inside = packets.Slabs[number].Inside(x);
    }
    else
    {
      const PlaneRow* row =
        packets.Rows + (packet ? packet->FirstRow : number * std::size_t(packets.CommonRows));
      const PlaneRow* const end = row + (packet ? packet->Count : packets.CommonRows);
      for (; row != end; ++row)
      {
        inside = inside | row->Inside(x);
      }
    }
    return LowBits(count) & ~NegativeLanes(inside);
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
  const PlanePackets& Packets;
  Vector3 Local;
};

}

#endif
