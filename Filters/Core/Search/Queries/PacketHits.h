// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_PacketHits_h
#define skd_Queries_PacketHits_h

#include "LinePacket.h"
#include "TriangleHits.h"

#include <optional>

namespace skd
{

/// Triangles along the lines of a packet: what any of them may meet is opened once, in the order in
/// which the first of them comes to it, or, if that is all the same, in any; in a leaf each line
/// has its own leaf filter and exact test.
///
/// `visitor(line, element, hit)`: as that of VisitTriangleHits; out of order all hits are visited,
/// whatever it returns.
template <bool InOrder, class Visitor>
class AlongLines
{
public:
  static constexpr bool Ordered = InOrder;
  static constexpr bool SkipsLeaves = true;
  static constexpr bool GivesKeys = false;

  AlongLines(
    const TreeView<3>& tree, const TrianglePackets& packets, double tolerance, Visitor& visitor)
    : Tree(tree)
    , Packets(packets)
    , Tolerance(tolerance)
    , TheVisitor(visitor)
  {
  }

  /// False: not with the others.
  bool Add(int i, const Segment<3>& segment)
  {
    const SegmentView view(segment);
    LocalLine<3> line(this->Tree.GetFrame(), segment);
    if (!view.IsValid() || !line.Clip(this->Tree.GetFrame(), this->Tolerance))
    {
      return true;
    }
    TriangleCrossings crossings(view.GetShear());
    crossings.Aim(line.From.Values(), line.Margin);
    this->Lines[i].emplace(One{ view, crossings, line.Begin, line.PerLength });
    return this->Packet.Add(i, line);
  }

  void Start() { this->Packet.Start(); }

  template <int W>
  SKD_FLATTEN unsigned TestBoxes(const BoxPacket<3, W>& boxes, float* keys) const
  {
    return this->Packet.TestBoxes(boxes, keys);
  }
  template <class Node>
  unsigned TestElements(const Node& leaf, float* keys)
  {
    return this->TestKnown(TrianglePackets::NumberOf(leaf), leaf.Count, keys);
  }
  template <class Node>
  static constexpr bool Knows(const Node&)
  {
    return true;
  }
  /// Visits what is wanted at once: lines differ in it.
  unsigned TestKnown(std::uint32_t number, std::uint32_t count, float*)
  {
    const TrianglePacket& packet = this->Packets.Of(number);
    ForEachLane(this->Packet.Through(packet.Grid),
      [&](int line)
      {
        ForEachLane(this->Lines[line]->Crossings.MayIntersect(packet) & LowBits(count),
          [&](int lane) { this->Test(line, number, static_cast<std::uint32_t>(lane)); });
      });
    return 0;
  }
  void FetchKnown(std::uint32_t leaf) const { this->Packets.Fetch(leaf); }
  void FetchData(std::uint32_t line) const { this->Packets.GetPoints().Fetch(line); }
  float Limit() const { return this->Packet.Limit(); }
  bool Visit(std::uint32_t) const { return true; }

private:
  struct One
  {
    SegmentView View;
    TriangleCrossings Crossings;
    double Begin;
    double PerLength;
  };

  SKD_NOINLINE void Test(int i, std::uint32_t number, std::uint32_t lane)
  {
    const One& line = *this->Lines[i];
    if (const auto hit =
          detail::IntersectWithin(line.View, this->Packets, number, lane, this->Tolerance))
    {
      const std::uint32_t element = this->Tree.Element(this->Tree.LeafAt(number).First + lane);
      [[maybe_unused]] const double last = this->TheVisitor(i, element, *hit);
      if constexpr (InOrder)
      {
        this->Packet.Lower(i, (last - line.Begin) * line.PerLength);
      }
    }
  }

  const TreeView<3>& Tree;
  const TrianglePackets& Packets;
  const double Tolerance;
  Visitor& TheVisitor;
  LinePacket Packet;
  std::optional<One> Lines[LinePacket::Width];
};

/// VisitTriangleHits() of lines, at most LinePacket::Width, that run the same way along
/// each axis and whose ends are no farther apart along it than `maxSpread`. False: they are, or do
/// not, or there is only one, and nothing was done.
template <bool InOrder, class Visitor>
SKD_FLATTEN bool VisitPacketHits(const TreeView<3>& tree, const TrianglePackets& packets,
  const Segment<3>* segments, int count, double maxSpread, double tolerance, Visitor& visitor)
{
  if (!LinePacket::AreAlike(segments, count, maxSpread))
  {
    return false;
  }
  AlongLines<InOrder, Visitor> query(tree, packets, tolerance, visitor);
  for (int i = 0; i < count; ++i)
  {
    if (!query.Add(i, segments[i]))
    {
      return false;
    }
  }
  query.Start();
  Walk(detail::LanesView(tree), query);
  return true;
}

}

#endif
