// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_PackedRTree_h
#define skd_Tree_PackedRTree_h

#include "../../Geometry/MortonCode.h"
#include "Frame.h"
#include "Lanes.h"
#include "RadixSort.h"
#include "ShortLanes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skd
{

/// A packed R-tree with 16-bit boxes, for one-shot searches: boxes are rounded to a grid of 2^15
/// steps over all of them; eight consecutive boxes along a Morton curve form a packet, eight
/// packets one of the next level, and so on. Built in O(n), in less than half of the time of a
/// tree; efficient if boxes are small, but larger than the steps of the grid.
class PackedRTree
{
public:
  explicit PackedRTree(const std::vector<Box3>& boxes)
    : TheFrame(Frame<3>::Of(BoundsOf(boxes)))
  {
    std::vector<GridBox> level = this->SortAlongCurve(boxes);
    while (!level.empty())
    {
      this->AddLevel(level);
      const std::vector<Packet>& packets = this->Levels.back();
      level.resize(packets.size() > 1 ? packets.size() : 0);
      for (std::size_t i = 0; i < level.size(); ++i)
      {
        level[i] = packets[i].GetEnclosure();
      }
    }
  }

  /// Calls visit(i) for each box that overlaps this one on the grid: all that overlap it, and some
  /// that are near.
  template <class Visit>
  SKD_FLATTEN void ForEachOverlapping(const Box3& box, const Visit& visit) const
  {
    if (!this->Levels.empty())
    {
      this->Descend(WantedBox(this->Rounded(box)), 0, 0,
        [&](std::size_t at)
        {
          visit(this->Order[at]);
          return true;
        });
    }
  }

  std::size_t GetNumberOfPackets() const
  {
    return this->Levels.empty() ? 0 : this->Levels[0].size();
  }

  static constexpr std::size_t Width = 8;
  static constexpr std::size_t Log2Width = 3;

  /// The number of the box in a lane of a packet.
  std::uint32_t GetBoxOf(std::size_t packet, int lane) const
  {
    return this->Order[packet * Width + static_cast<std::size_t>(lane)];
  }

  ///@{
  /// Boxes as they are rounded to the grid: outward, and monotone, so that what overlaps does so on
  /// the grid, and what is within a box is within it there. Beyond the grid they end near its end.
  struct GridBox
  {
    std::int16_t Min[3];
    std::int16_t Max[3];
  };
  GridBox GetOnGrid(const Box3& box) const { return this->Rounded(box); }
  GridBox GetOnGrid(std::size_t packet, int lane) const
  {
    return this->Levels[0][packet].Get(static_cast<std::size_t>(lane));
  }
  GridBox GetEnclosureOf(std::size_t packet) const
  {
    return this->Levels.size() > 1 ? this->Levels[1][packet / Width].Get(packet % Width)
                                   : this->Levels[0][packet].GetEnclosure();
  }
  ///@}

  /// Calls visit(packet, lanes) for each packet with boxes that overlap this one on the grid, with
  /// a bit for each of them, until it returns false.
  template <class Visit>
  SKD_FLATTEN void ForEachPacketOverlapping(const GridBox& box, const Visit& visit) const
  {
    const WantedBox wanted(box);
    const auto visitPacket = [&](std::size_t packet)
    {
      const unsigned lanes = this->Levels[0][packet].Overlapping(wanted);
      return lanes == 0 || visit(packet, lanes);
    };
    if (this->Levels.size() > 1)
    {
      this->Descend(wanted, 1, 0, visitPacket);
    }
    else if (this->Levels.size() == 1)
    {
      visitPacket(0);
    }
  }

  /// The lanes of a packet the boxes of which are not within another one along an axis.
  unsigned FindLanesBeyond(std::size_t packet, int axis, const GridBox& box) const
  {
    const Packet& boxes = this->Levels[0][packet];
    return NegativeLanes(Above(EightShorts(box.Min[axis]), EightShorts::Load(boxes.Min[axis])) |
      Above(EightShorts::Load(boxes.Max[axis]), EightShorts(box.Max[axis])));
  }

  /// Lists of boxes, for ForEachOverlapWithin: one for each lane of a packet.
  using OverlapLists = std::array<std::vector<std::uint32_t>, 8>;

  /// For each box i of a packet, calls visit(i, others) with the boxes after it along the curve
  /// that overlap it on the grid, if there are any. All packets together give each pair of
  /// overlapping boxes once, but for those of packets with isWanted(packet) = false. Stops when
  /// `visit` returns false, and returns false.
  template <class Visit, class IsWanted>
  bool ForEachOverlapWithin(
    std::size_t packet, OverlapLists& lists, const Visit& visit, const IsWanted& isWanted) const
  {
    for (std::vector<std::uint32_t>& list : lists)
    {
      list.clear();
    }
    this->ListOverlaps(packet, lists, isWanted);
    for (std::size_t lane = 0; lane < Width; ++lane)
    {
      if (!lists[lane].empty() && !visit(this->Order[packet * Width + lane], lists[lane]))
      {
        return false;
      }
    }
    return true;
  }
  template <class Visit>
  bool ForEachOverlapWithin(std::size_t packet, OverlapLists& lists, const Visit& visit) const
  {
    return this->ForEachOverlapWithin(packet, lists, visit, [](std::size_t) { return true; });
  }

private:
  static constexpr std::size_t MostLevels = 11; // 8^11 = 2^33
  static constexpr double Steps = 16000.0;      // from the middle of the frame to its end

  /// Each number for all lanes.
  struct WantedBox
  {
    EightShorts Min[3];
    EightShorts Max[3];

    WantedBox() = default;
    explicit WantedBox(const GridBox& box)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Min[axis] = EightShorts(box.Min[axis]);
        this->Max[axis] = EightShorts(box.Max[axis]);
      }
    }
  };

  struct Packet
  {
    std::int16_t Min[3][Width];
    std::int16_t Max[3][Width];

    void Set(std::size_t lane, const GridBox& box)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Min[axis][lane] = box.Min[axis];
        this->Max[axis][lane] = box.Max[axis];
      }
    }

    GridBox GetEnclosure() const
    {
      GridBox box;
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Min[axis] = *std::min_element(this->Min[axis], this->Min[axis] + Width);
        box.Max[axis] = *std::max_element(this->Max[axis], this->Max[axis] + Width);
      }
      return box;
    }

    GridBox Get(std::size_t lane) const
    {
      GridBox box;
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Min[axis] = this->Min[axis][lane];
        box.Max[axis] = this->Max[axis][lane];
      }
      return box;
    }

    unsigned Overlapping(const WantedBox& box) const
    {
      const auto apart = [&](int axis)
      {
        return Above(EightShorts::Load(this->Min[axis]), box.Max[axis]) |
          Above(box.Min[axis], EightShorts::Load(this->Max[axis]));
      };
      return 0xffu & ~NegativeLanes(apart(0) | apart(1) | apart(2));
    }
  };

  /// Calls visit(i) for the boxes of a level, from number `from` on, that overlap one, until it
  /// returns false: those that the tree is of at level 0, the packets of the level below at others.
  template <class Visit>
  void Descend(
    const WantedBox& wanted, std::size_t bottom, std::size_t from, const Visit& visit) const
  {
    struct Open
    {
      std::size_t Packet;
      unsigned Lanes; // that are left
    };
    std::array<Open, MostLevels> open; // one packet a level
    std::size_t level = this->Levels.size() - 1;
    const auto enter = [&](std::size_t packet)
    {
      const std::size_t first = from >> (Log2Width * (level - bottom)); // that `from` is in
      const std::size_t before = first > packet * Width ? first - packet * Width : 0;
      open[level] = { packet, this->Levels[level][packet].Overlapping(wanted) & (~0u << before) };
    };
    enter(0);
    while (level < this->Levels.size())
    {
      unsigned& lanes = open[level].Lanes;
      if (lanes == 0)
      {
        ++level;
        continue;
      }
      const std::size_t at =
        open[level].Packet * Width + static_cast<std::size_t>(LowestBit(lanes));
      lanes &= lanes - 1;
      if (level > bottom)
      {
        --level;
        enter(at);
      }
      else if (!visit(at))
      {
        return;
      }
    }
  }

  template <class IsWanted>
  SKD_FLATTEN void ListOverlaps(
    std::size_t packet, OverlapLists& lists, const IsWanted& isWanted) const
  {
    const Packet& boxes = this->Levels[0][packet];
    std::array<WantedBox, Width> wanted;
    for (std::size_t lane = 0; lane < Width; ++lane)
    {
      wanted[lane] = WantedBox(boxes.Get(lane));
      this->List(packet, boxes.Overlapping(wanted[lane]) & (~1u << lane), lists[lane]);
    }
    if (this->Levels.size() == 1)
    {
      return;
    }
    const auto enclosure = [this](std::size_t i)
    { return WantedBox(this->Levels[1][i / Width].Get(i % Width)); };
    this->Descend(enclosure(packet), 1, packet + 1,
      [&](std::size_t other)
      {
        if (isWanted(other))
        {
          const Packet& others = this->Levels[0][other];
          ForEachLane(boxes.Overlapping(enclosure(other)),
            [&](int lane) { this->List(other, others.Overlapping(wanted[lane]), lists[lane]); });
        }
        return true;
      });
  }

  void List(std::size_t packet, unsigned lanes, std::vector<std::uint32_t>& list) const
  {
    ForEachLane(lanes, [&](int lane) { list.push_back(this->Order[packet * Width + lane]); });
  }

  static Box3 BoundsOf(const std::vector<Box3>& boxes)
  {
    Box3 bounds;
    for (const Box3& box : boxes)
    {
      bounds.Add(box);
    }
    return bounds;
  }

  /// Outward and monotone: boxes that overlap do so on the grid.
  GridBox Rounded(const Box3& box) const
  {
    GridBox rounded;
    for (int axis = 0; axis < 3; ++axis)
    {
      rounded.Min[axis] = static_cast<std::int16_t>(this->StepOf(box.Min[axis], axis) - 1);
      rounded.Max[axis] = static_cast<std::int16_t>(this->StepOf(box.Max[axis], axis) + 1);
    }
    return rounded;
  }

  /// Others may lie far from the frame of these.
  int StepOf(double x, int axis) const
  {
    constexpr double most = 2.0 * Steps;
    const double step = (x - this->TheFrame.Centre[axis]) * (Steps * this->TheFrame.Scale);
    return static_cast<int>(std::min(std::max(-most, step), most));
  }

  /// Fills Order; returns the boxes in that order.
  std::vector<GridBox> SortAlongCurve(const std::vector<Box3>& boxes)
  {
    std::vector<std::uint64_t> keys(boxes.size());
    std::vector<GridBox> rounded(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      rounded[i] = this->Rounded(boxes[i]);
      keys[i] = MortonCodeOf(rounded[i]) << 32 | i;
    }
    SortByHighWord(keys);
    std::vector<GridBox> sorted(boxes.size());
    this->Order.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      this->Order[i] = static_cast<std::uint32_t>(keys[i]);
      sorted[i] = rounded[this->Order[i]];
    }
    return sorted;
  }

  static std::uint64_t MortonCodeOf(const GridBox& box)
  {
    std::array<std::uint32_t, 3> cube;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int middle = (box.Min[axis] + box.Max[axis]) / 2 + (1 << 14); // of 15 bits, or nearly
      cube[axis] = static_cast<std::uint32_t>(std::min(std::max(0, middle), 0x7fff)) >> 5;
    }
    return MortonCode(cube);
  }

  /// Remaining lanes are empty: above all query boxes.
  void AddLevel(const std::vector<GridBox>& boxes)
  {
    constexpr std::int16_t beyond = 0x7fff;
    constexpr GridBox none{ { beyond, beyond, beyond }, { -beyond, -beyond, -beyond } };
    std::vector<Packet> packets((boxes.size() + Width - 1) / Width);
    for (std::size_t i = 0; i < Width * packets.size(); ++i)
    {
      packets[i / Width].Set(i % Width, i < boxes.size() ? boxes[i] : none);
    }
    this->Levels.push_back(std::move(packets));
  }

  Frame<3> TheFrame;
  std::vector<std::uint32_t> Order;
  std::vector<std::vector<Packet>> Levels; // the first of the boxes themselves
};

}

#endif
