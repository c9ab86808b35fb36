// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_TriangleHits_h
#define skd_Queries_TriangleHits_h

#include "../Geometry/SegmentNearTriangle.h"
#include "../Sieves/TriangleSieves.h"
#include "../Tree/TreeView.h"
#include "../Tree/Walk.h"
#include "AlongSegment.h"

namespace skd
{
namespace detail
{

/// A tree to queries that find elements by their positions.
class PositionsView : public TreeView<3>
{
public:
  explicit PositionsView(const TreeView<3>& view)
    : TreeView<3>(view)
  {
  }

  std::uint32_t Element(std::uint32_t position) const { return position; }
  void FetchElements(std::uint32_t) const {}
};

}

/// Where a segment hits the triangles of a tree whose packs have points: what its exact tests need
/// lies beside the packs, and which element a triangle is, is asked of those that are hit only.
///
/// `leaf(element, hit)` returns the parameter beyond which nothing is wanted any more, as that of
/// AlongSegment. `tolerance`: by how much triangles may be missed. A segment of no length, or one
/// that is not finite, hits nothing.
template <bool InOrder, class Leaf>
SKD_IN_ONE_PIECE void VisitTriangleHits(const TreeView<3>& tree, const TrianglePacks& packs,
  const Segment<3>& segment, double tolerance, Leaf& leaf)
{
  const SegmentView view(segment);
  if (!view.IsValid())
  {
    return;
  }
  const std::uint32_t capacity = tree.BottomAt(1).First; // of all bottom nodes, if there are more
  double limit = 1.0;
  auto test = [&](std::uint32_t position)
  {
    const std::uint32_t number = position / capacity;
    const auto corner = [&](int i)
    { return packs.Corner(number, position - number * capacity, i); };
    if (const auto hit = IntersectWithin(view, corner(0), corner(1), corner(2), tolerance))
    {
      limit = leaf(tree.Element(position), *hit);
    }
    return limit;
  };
  AlongSegment<3, decltype(test), LineSieve, InOrder> query(
    tree.GetFrame(), tree.GetBounds(), segment, tolerance, test, LineSieve(packs));
  Walk(detail::PositionsView(tree), query);
}

}

#endif
