// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_TriangleHits_h
#define skd_Queries_TriangleHits_h

#include "../../Geometry/Intersection/SegmentNearTriangle.h"
#include "../LeafFilters/TriangleLeafFilters.h"
#include "../Tree/TreeView.h"
#include "../Tree/Walk.h"
#include "AlongSegment.h"

namespace skd
{
namespace detail
{

SKD_NOINLINE inline std::optional<TriangleHit> IntersectOneByOne(const SegmentView& view,
  const TrianglePackets& packets, std::uint32_t number, std::uint32_t lane, double tolerance)
{
  const auto corner = [&](int i) { return packets.Corner(number, lane, i); };
  return IntersectWithin(view, corner(0), corner(1), corner(2), tolerance);
}

/// IntersectWithin() of a triangle of a packet, to the last bit, with its corners side by side: of
/// products that differ when they are rounded the order is known (Sign.h), and few are equal.
inline std::optional<TriangleHit> IntersectWithin(const SegmentView& view,
  const TrianglePackets& packets, std::uint32_t number, std::uint32_t lane, double tolerance)
{
  using Three = AxisLanes<3>;
  const ShearedLanes<Three> seen =
    packets.WithCorners(number, lane, [&](const auto& along) { return view.See<Three>(along); });
  const Three nextX = Next(seen.X);
  const Three nextY = Next(seen.Y);
  const Three left = seen.X * nextY;
  const Three right = seen.Y * nextX;
  const unsigned above = Above(left, right);
  const unsigned below = Above(right, left);
  if (std::max(above, below) == LowBits(3))
  {
    const Three weights = (left - right) +
      (ProductMinus(seen.X, nextY, left) - ProductMinus(seen.Y, nextX, right)); // of C, A, B
    const double area = weights[1] + weights[2] + weights[0];
    const Three parts = Next(weights) * seen.Z;
    if (const auto t = view.Accept((parts[0] + parts[1] + parts[2]) / area))
    {
      return TriangleHit{ *t, weights[2] / area, weights[0] / area, false, true };
    }
  }
  const bool isCertain = std::max(above, below) == LowBits(3) || (above != 0 && below != 0);
  return isCertain && !(tolerance > 0.0)
    ? std::nullopt
    : IntersectOneByOne(view, packets, number, lane, tolerance);
}

/// A tree to queries that find elements by the number of their leaf and their lane in it:
/// the Element() of a position is Width times that number and the lane.
class LanesView
{
public:
  static constexpr std::uint32_t Width = TrianglePacket::Width;

  explicit LanesView(const TreeView<3>& view)
    : View(view)
  {
  }

  bool IsEmpty() const { return this->View.IsEmpty(); }
  const Node<3>& Open(std::uint32_t node) const { return this->View.Open(node); }
  void Fetch(std::uint32_t node) const { this->View.Fetch(node); }
  ElementRange LeafAt(std::uint32_t number) const
  {
    return { number * Width, this->View.LeafAt(number).Count };
  }
  std::uint32_t Element(std::uint32_t laneOfAll) const { return laneOfAll; }
  void FetchElements(std::uint32_t laneOfAll) const
  {
    this->View.FetchElements(this->View.LeafAt(laneOfAll / Width).First);
  }
  /// The element itself.
  std::uint32_t ElementAt(std::uint32_t number, std::uint32_t lane) const
  {
    return this->View.Element(this->View.LeafAt(number).First + lane);
  }

private:
  const TreeView<3>& View;
};

}

/// Where a segment hits the triangles of a tree whose packets have points: what its exact tests
/// need lies beside the packets, and the element of a triangle is read only for those that are hit
/// only.
///
/// `visitor(element, hit)` returns the parameter beyond which nothing is wanted any more, as that
/// of AlongSegment. `tolerance`: by how much triangles may be missed. A segment of no length, or
/// one that is not finite, hits nothing.
template <bool InOrder, class Visitor>
SKD_FLATTEN void VisitTriangleHits(const TreeView<3>& tree, const TrianglePackets& packets,
  const Segment<3>& segment, double tolerance, Visitor& visitor)
{
  const SegmentView view(segment);
  if (!view.IsValid())
  {
    return;
  }
  const detail::LanesView lanes(tree);
  double limit = 1.0;
  auto test = [&](std::uint32_t laneOfAll) SKD_NOINLINE SKD_FLATTEN
  {
    const std::uint32_t number = laneOfAll / lanes.Width;
    const std::uint32_t lane = laneOfAll % lanes.Width;
    if (const auto hit = detail::IntersectWithin(view, packets, number, lane, tolerance))
    {
      limit = visitor(lanes.ElementAt(number, lane), *hit);
    }
    return limit;
  };
  AlongSegment<3, decltype(test), LineLeafFilter<true>, InOrder> query(
    tree.GetFrame(), segment, tolerance, test, packets, view.GetShear());
  Walk(lanes, query);
}

}

#endif
