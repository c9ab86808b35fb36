// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_MonotonePatches_h
#define skd_Queries_MonotonePatches_h

#include "../../Geometry/Intersection/NeighbourTriangles.h"
#include "../../Geometry/UnpairedEdges.h"
#include "../Tree/PackedRTree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skd
{

/// Parts of a surface that surely intersect nothing of it, without a look at any pair of triangles.
///
/// Of a box, take all triangles that overlap it. Seen along an axis let all of them turn one way,
/// let each edge seen in the box be passed as often in one direction as in the other, and let one
/// point in the box be in exactly one triangle. How many triangles a point is in changes only at
/// edges that are not passed so: it is one in all of the box, where the surface is monotone along
/// the axis. Around each point then the triangles that follow each other over edges, or around a
/// corner, leave no room for others: where two triangles have a point of the box in common, they
/// share an edge or corner that it is on, as numbers of points. (Volino and Magnenat-Thalmann,
/// 1994, exclude self-intersections by directions, too, and look at the contour; here there is
/// none.)
///
/// The boxes are those of groups of triangles of a packed R-tree, made longer along the axis until
/// no triangle ends outside it there. Then an edge seen in the box overlaps it, and so do all
/// triangles at the edge. Signs are those that floating-point arithmetic is sure of; boxes are
/// compared on the tree's grid, on which what overlaps does so. What is not certain is not found.
class MonotonePatches
{
public:
  /// Of a tree of triangles' boxes. cornersOf(i) are the numbers of the corners, as an array, of
  /// the triangle that has box i; equal numbers are the same point. loop(n, f) calls f(i) for all i
  /// below n, maybe in parallel. O(n) for n triangles; none are found of few of a surface's.
  template <class PointList, class CornersOf, class Loop>
  MonotonePatches(const PackedRTree& tree, std::size_t numberOfTriangles, const PointList& points,
    const CornersOf& cornersOf, const Loop& loop);

  /// Whether all that the triangles of a packet have in common with any triangle surely are corners
  /// that they share.
  bool Has(std::size_t packet) const { return this->Found[packet] != 0; }

private:
  template <class PointList, class CornersOf>
  class Finder;

  std::vector<std::uint8_t> Found; // of each packet
};

template <class PointList, class CornersOf>
class MonotonePatches::Finder
{
public:
  Finder(const PackedRTree& tree, const PointList& points, const CornersOf& cornersOf)
    : Tree(tree)
    , Points(points)
    , CornersOfBox(cornersOf)
    , Facing(tree.GetNumberOfPackets())
  {
  }

  /// Whether any of some groups of triangles, spread over all, face one way: of a surface that is
  /// monotone somewhere, as a rule. Edges are not looked at.
  bool AreSomeLikely(std::size_t numberOfTriangles) const
  {
    constexpr std::size_t group = 4 * PackedRTree::Width; // the least that is looked at by itself
    constexpr std::size_t most = 64;                      // groups, or not twice as many
    const std::size_t count = numberOfTriangles / group;
    const std::size_t step = std::max(std::size_t(1), count / most);
    bool areSome = false;
    for (std::size_t i = 0; i < count && !areSome; i += step)
    {
      areSome = this->DoFaceOneWay(i * group, (i + 1) * group);
    }
    return areSome;
  }

  template <class Loop>
  void FindDirections(std::size_t numberOfTriangles, const Loop& loop)
  {
    UnpairedEdges edges(this->Points.size());
    for (std::uint32_t i = 0; i < numberOfTriangles; ++i)
    {
      edges.AddTriangle(this->CornersOfBox(i));
    }
    const MarkedNumbers ends = edges.FindEnds();
    loop(this->Facing.size(),
      [&](std::size_t packet)
      {
        const std::size_t first = packet * PackedRTree::Width;
        const auto count =
          static_cast<int>(std::min(PackedRTree::Width, numberOfTriangles - first));
        Word facing = FirstOfEach * (0xffu & ~0u << count); // lanes without a triangle face all
        for (int lane = 0; lane < count; ++lane)
        {
          facing |= Spread(this->DirectionsOf(this->Tree.GetBoxOf(packet, lane), ends)) << lane;
        }
        this->Facing[packet] = facing;
      });
  }

  /// Marks the packets of a range in which it finds monotone patches: of `size` packets, or fewer
  /// at the end of all, and where these are none in parts of a quarter. Single packets are looked
  /// at only beside patches: elsewhere few are found, as among edges of solids.
  void Find(
    std::size_t begin, std::size_t end, std::size_t size, std::vector<std::uint8_t>& found) const
  {
    bool areSome = false;
    for (std::size_t at = begin; at < end; at += size)
    {
      const std::size_t to = std::min(end, at + size);
      if (this->IsMonotone(at, to))
      {
        areSome = true;
        std::fill(found.begin() + static_cast<std::ptrdiff_t>(at),
          found.begin() + static_cast<std::ptrdiff_t>(to), std::uint8_t(1));
      }
    }
    const std::size_t part = size / 4;
    for (std::size_t at = begin; at < end && part > 0 && (part > 1 || areSome); at += size)
    {
      if (found[at] == 0)
      {
        this->Find(at, std::min(end, at + size), part, found);
      }
    }
  }

private:
  using GridBox = PackedRTree::GridBox;

  /// Along three axes, forward and back.
  static constexpr unsigned NumberOfDirections = 6;

  /// A byte for each direction, in which are the lanes of a packet that surely face it.
  using Word = std::uint64_t;

  static constexpr Word FirstOfEach = 0x0101010101010101u;

  /// The bits of some directions as the first lane of a word.
  static Word Spread(unsigned directions)
  {
    return directions * Word(0x0002040810204081u) & FirstOfEach;
  }

  static unsigned LanesOf(Word facing, unsigned direction)
  {
    return static_cast<unsigned>(facing >> 8 * direction) & 0xffu;
  }

  bool DoFaceOneWay(std::size_t begin, std::size_t end) const
  {
    unsigned directions = ~0u;
    for (std::size_t i = begin; i < end && directions != 0; ++i)
    {
      directions &= this->DirectionsOf(this->CornersOfBox(
        this->Tree.GetBoxOf(i / PackedRTree::Width, static_cast<int>(i % PackedRTree::Width))));
    }
    return directions != 0;
  }

  /// A bit for each direction that a triangle surely faces; none if an edge of it may be open.
  unsigned DirectionsOf(std::uint32_t box, const MarkedNumbers& ends) const
  {
    const auto& corners = this->CornersOfBox(box);
    const int numberOfEnds = static_cast<int>(ends.IsMarked(corners[0])) +
      static_cast<int>(ends.IsMarked(corners[1])) + static_cast<int>(ends.IsMarked(corners[2]));
    return numberOfEnds > 1 ? 0 : this->DirectionsOf(corners);
  }

  template <class Corners>
  unsigned DirectionsOf(const Corners& corners) const
  {
    unsigned directions = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int sign = detail::SureOrient2D(
        this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]], axis);
      directions |= static_cast<unsigned>(sign > 0) << 2 * axis |
        static_cast<unsigned>(sign < 0) << (2 * axis + 1);
    }
    return directions;
  }

  bool IsMonotone(std::size_t begin, std::size_t end) const
  {
    Word facing = ~Word(0);
    for (std::size_t packet = begin; packet < end; ++packet)
    {
      facing &= this->Facing[packet];
    }
    unsigned directions = 0;
    for (unsigned direction = 0; direction < NumberOfDirections; ++direction)
    {
      directions |= static_cast<unsigned>(LanesOf(facing, direction) == 0xff) << direction;
    }
    if (directions == 0)
    {
      return false;
    }
    const GridBox box = this->GetEnclosure(begin, end);
    return this->IsMonotoneAlong(this->FindThinnest(directions, box), begin, box);
  }

  GridBox GetEnclosure(std::size_t begin, std::size_t end) const
  {
    GridBox box = this->Tree.GetEnclosureOf(begin);
    for (std::size_t packet = begin + 1; packet < end; ++packet)
    {
      const GridBox other = this->Tree.GetEnclosureOf(packet);
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Min[axis] = std::min(box.Min[axis], other.Min[axis]);
        box.Max[axis] = std::max(box.Max[axis], other.Max[axis]);
      }
    }
    return box;
  }

  /// Of some directions the one along which a box is thinnest.
  static unsigned FindThinnest(unsigned directions, const GridBox& box)
  {
    unsigned thinnest = 0;
    int least = 0x20000;
    for (unsigned direction = 0; direction < NumberOfDirections; ++direction)
    {
      const int axis = static_cast<int>(direction / 2);
      const int extent = box.Max[axis] - box.Min[axis];
      if ((directions >> direction & 1u) != 0 && extent < least)
      {
        least = extent;
        thinnest = direction;
      }
    }
    return thinnest;
  }

  /// `begin` is a packet the box of which is within this one.
  bool IsMonotoneAlong(unsigned direction, std::size_t begin, GridBox box) const
  {
    constexpr int most = 4; // times that it is made longer
    const int axis = static_cast<int>(direction / 2);
    for (int i = 0; i < most; ++i)
    {
      Lengthen(axis, box);
      GridBox longer = box;
      if (!this->IsSeenOnce(direction, this->Tree.GetBoxOf(begin, 0), box) ||
        !this->DoAllFace(direction, box, longer))
      {
        return false;
      }
      if (longer.Min[axis] == box.Min[axis] && longer.Max[axis] == box.Max[axis])
      {
        return true;
      }
      box = longer;
    }
    return false;
  }

  static void Lengthen(int axis, GridBox& box)
  {
    int widest = 0;
    for (int k = 0; k < 3; ++k)
    {
      widest = std::max(widest, box.Max[k] - box.Min[k]);
    }
    const int margin = (box.Max[axis] - box.Min[axis]) / 2 + widest / 4;
    box.Min[axis] = static_cast<std::int16_t>(std::max(-32000, box.Min[axis] - margin));
    box.Max[axis] = static_cast<std::int16_t>(std::min(32000, box.Max[axis] + margin));
  }

  /// Whether all triangles that overlap a box face a direction; `longer` is made to end where they
  /// do.
  bool DoAllFace(unsigned direction, const GridBox& box, GridBox& longer) const
  {
    const int axis = static_cast<int>(direction / 2);
    bool doAll = true;
    this->Tree.ForEachPacketOverlapping(box,
      [&](std::size_t packet, unsigned lanes)
      {
        doAll = (lanes & ~LanesOf(this->Facing[packet], direction)) == 0;
        ForEachLane(doAll ? lanes & this->Tree.FindLanesBeyond(packet, axis, box) : 0,
          [&](int lane)
          {
            const GridBox beyond = this->Tree.GetOnGrid(packet, lane);
            longer.Min[axis] = std::min(longer.Min[axis], beyond.Min[axis]);
            longer.Max[axis] = std::max(longer.Max[axis], beyond.Max[axis]);
          });
        return doAll;
      });
    return doAll;
  }

  /// Whether a point of a triangle is surely in no other one of those that overlap a box, which
  /// all face a direction.
  bool IsSeenOnce(unsigned direction, std::uint32_t triangle, const GridBox& box) const
  {
    const auto& corners = this->CornersOfBox(triangle);
    const Vector3 middle = (1.0 / 3.0) *
      (this->Points[corners[0]] + this->Points[corners[1]] + this->Points[corners[2]]);
    const int axis = static_cast<int>(direction / 2);
    GridBox column = this->Tree.GetOnGrid({ middle, middle });
    column.Min[axis] = box.Min[axis];
    column.Max[axis] = box.Max[axis];
    const int inside = direction % 2 == 0 ? 1 : -1;
    if (this->CountIn(corners, middle, axis, inside) != 1)
    {
      return false;
    }
    int count = 0; // of triangles that it is in; more than one also if that is not sure
    this->Tree.ForEachPacketOverlapping(column,
      [&](std::size_t packet, unsigned lanes)
      {
        ForEachLane(lanes,
          [&](int lane)
          {
            const std::uint32_t other = this->Tree.GetBoxOf(packet, lane);
            count += this->CountIn(this->CornersOfBox(other), middle, axis, inside);
          });
        return count < 2;
      });
    return count == 1;
  }

  /// 1 if a point is surely in a triangle, 0 if it is surely outside, else 2.
  template <class Corners>
  int CountIn(const Corners& corners, const Vector3& x, int axis, int inside) const
  {
    bool isInside = true;
    for (int i = 0; i < 3; ++i)
    {
      const int side = detail::SureOrient2D(
        this->Points[corners[i]], this->Points[corners[i == 2 ? 0 : i + 1]], x, axis);
      if (side == -inside)
      {
        return 0;
      }
      isInside = isInside && side == inside;
    }
    return isInside ? 1 : 2;
  }

  const PackedRTree& Tree;
  const PointList& Points;
  const CornersOf& CornersOfBox;
  std::vector<Word> Facing; // of each packet
};

template <class PointList, class CornersOf, class Loop>
MonotonePatches::MonotonePatches(const PackedRTree& tree, std::size_t numberOfTriangles,
  const PointList& points, const CornersOf& cornersOf, const Loop& loop)
  : Found(tree.GetNumberOfPackets(), 0)
{
  constexpr std::size_t most = 64; // packets of a patch
  constexpr std::size_t few = 512; // triangles, the pairs of which are soon looked at
  const bool isSubset = points.size() > 2 * numberOfTriangles; // of a surface, cut out of it
  if (numberOfTriangles < few || isSubset || points.size() > UnpairedEdges::MostPoints)
  {
    return;
  }
  Finder<PointList, CornersOf> finder(tree, points, cornersOf);
  if (!finder.AreSomeLikely(numberOfTriangles))
  {
    return;
  }
  finder.FindDirections(numberOfTriangles, loop);
  loop((this->Found.size() + most - 1) / most,
    [&](std::size_t group)
    {
      finder.Find(
        group * most, std::min(this->Found.size(), (group + 1) * most), most, this->Found);
    });
}

}

#endif
