// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdWideWalks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

// This file is compiled for AVX2. The core's inline functions must then have other names than in
// the files that are not: the linker keeps one of each name, and might keep the one that not every
// processor can run. So what is included below, which is the core alone, is in namespace skd_avx2.
#define skd skd_avx2

#include "Core/Geometry/Cells/ClosestPointInCell.h"
#include "Core/Geometry/PointArray.h"
#include "Core/Search/LeafFilters/CompactTree.h"
#include "Core/Search/LeafFilters/PlaneLeafFilter.h"
#include "Core/Search/LeafFilters/TriangleLeafFilters.h"
#include "Core/Search/Queries/AlongSegment.h"
#include "Core/Search/Queries/Nearest.h"
#include "Core/Search/Queries/OverlappingBox.h"
#include "Core/Search/Queries/OverlappingPairs.h"
#include "Core/Search/Queries/PacketHits.h"
#include "Core/Search/Queries/TriangleHits.h"
#include "Core/Search/Queries/WithinBox.h"
#include "Core/Search/Tree/CellElements.h"
#include "Core/Search/Tree/TreeView.h"
#include "Core/Search/Tree/Walk.h"
#include "Core/Search/Tree/WalkPairs.h"

namespace skdtree
{
namespace
{
const skd::CompactTree& ViewOf(const SkdWideTree& tree)
{
  return *static_cast<const skd::CompactTree*>(tree.View);
}

const skd::TrianglePackets& PacketsOf(const SkdWideTree& tree)
{
  return *static_cast<const skd::TrianglePackets*>(tree.Packets);
}

skd::Vector3 PointAt(const double x[3])
{
  return { { x[0], x[1], x[2] } };
}

const skd::Segment<3>& SegmentAt(const void* segment)
{
  return *static_cast<const skd::Segment<3>*>(segment);
}

/// A visitor of searches without a limit.
struct GoesOn
{
  bool operator()(std::uint32_t cell) const { return this->Visitor(cell) >= 0.0; }

  const SkdWideVisitor& Visitor;
};

/// Hands pairs over some at a time.
class PairBuffer
{
public:
  explicit PairBuffer(const SkdWidePairs& visitor)
    : Visitor(visitor)
  {
  }

  bool operator()(std::uint32_t a, std::uint32_t b, bool isSure)
  {
    this->Pairs[this->Count++] = { a, b, isSure };
    if (this->Count == Most)
    {
      this->Flush();
    }
    return true;
  }

  SKD_NOINLINE void Flush()
  {
    this->Visitor.Call(this->Visitor.Self, this->Pairs, this->Count);
    this->Count = 0;
  }

private:
  static constexpr int Most = 128;

  const SkdWidePairs& Visitor;
  int Count = 0;
  SkdWidePair Pairs[Most];
};

template <bool OnlyNearest>
SKD_FLATTEN void WalkNearest(
  const SkdWideTree& tree, const skd::Vector3& x, double limit2, const SkdWideVisitor& visitor)
{
  using LeafFilter = skd::DistanceLeafFilter<OnlyNearest>;
  const skd::CompactTree& view = ViewOf(tree);
  skd::Nearest<3, const SkdWideVisitor, LeafFilter> query(
    view.GetFrame(), x, limit2, visitor, LeafFilter(PacketsOf(tree), view.GetFrame().Local(x)));
  skd::Walk(view, query);
}

template <bool InOrder>
SKD_FLATTEN void WalkAlong(const SkdWideTree& tree, const skd::Segment<3>& segment, double margin,
  const SkdWideVisitor& visitor)
{
  using LeafFilter = skd::LineLeafFilter<false>;
  const skd::CompactTree& view = ViewOf(tree);
  const skd::Shear shear(segment.B - segment.A);
  skd::AlongSegment<3, const SkdWideVisitor, LeafFilter, InOrder> query(
    view.GetFrame(), segment, margin, visitor, PacketsOf(tree), shear);
  skd::Walk(view, query);
}

template <class Shape>
SKD_FLATTEN void ClosestPoint(const skd::PointArray& from, const std::uint32_t* ids,
  const skd::Vector3& x, double limit2, skd::Vector3* points, skd::VolumePoint& found)
{
  const auto gather = [&](const auto* numbers)
  {
    skd::ForEachAxis<Shape::Size>(
      [&](int i)
      {
        const auto* at = numbers + std::size_t(3) * ids[i];
        points[i] = { { at[0], at[1], at[2] } };
      });
  };
  from.Floats ? gather(from.Floats) : gather(from.Doubles);
  found = skd::ClosestPointInCell<Shape>(points, x, limit2);
}

/// Calls body(std::true_type()) or body(std::false_type()).
template <class Body>
void WithConstant(bool value, const Body& body)
{
  if (value)
  {
    body(std::true_type());
  }
  else
  {
    body(std::false_type());
  }
}
}

//------------------------------------------------------------------------------
void SkdWideWalks::Nearest(const SkdWideTree& tree, const double x[3], double limit2,
  bool onlyNearest, const SkdWideVisitor& visitor)
{
  WithConstant(onlyNearest,
    [&](auto only) { WalkNearest<decltype(only)::value>(tree, PointAt(x), limit2, visitor); });
}

//------------------------------------------------------------------------------
SKD_FLATTEN void SkdWideWalks::AboutPoint(
  const SkdWideTree& tree, const void* planes, const double x[3], const SkdWideVisitor& visitor)
{
  using LeafFilter = skd::PlaneLeafFilter;
  const skd::CompactTree& view = ViewOf(tree);
  const skd::Vector3 local = view.GetFrame().Local(PointAt(x));
  const LeafFilter leafFilter(*static_cast<const skd::PlanePackets*>(planes), local);
  const GoesOn visit{ visitor };
  skd::WithinBox<3, const GoesOn, LeafFilter> query(local, visit, leafFilter);
  skd::Walk(view, query);
}

//------------------------------------------------------------------------------
void SkdWideWalks::ClosestPointInCell(int size, const void* from, const std::uint32_t* ids,
  const double x[3], double limit2, void* points, void* found)
{
  const auto closest = [&](auto shape)
  {
    ClosestPoint<decltype(shape)>(*static_cast<const skd::PointArray*>(from), ids, PointAt(x),
      limit2, static_cast<skd::Vector3*>(points), *static_cast<skd::VolumePoint*>(found));
  };
  switch (size)
  {
    case skd::Pyramid::Size:
      return closest(skd::Pyramid());
    case skd::Wedge::Size:
      return closest(skd::Wedge());
    default:
      return closest(skd::Hexahedron());
  }
}

//------------------------------------------------------------------------------
SKD_FLATTEN void SkdWideWalks::ReadElements(const void* cells, const void* frame, double margin,
  const std::uint32_t* numbers, std::size_t count, void* to)
{
  const skd::CellElements elements(
    *static_cast<const skd::CellPoints*>(cells), *static_cast<const skd::Frame<3>*>(frame), margin);
  elements.Read(numbers, count, static_cast<skd::Element<3>*>(to));
}

//------------------------------------------------------------------------------
SKD_FLATTEN void SkdWideWalks::OverlappingBox(const SkdWideTree& tree, const void* box,
  double excess, const SkdWideVisitor& visitor, const SkdWideVisitor& sure)
{
  const skd::CompactTree& view = ViewOf(tree);
  const GoesOn visit{ visitor }, take{ sure };
  skd::OverlappingBox<3, const GoesOn, const GoesOn> query(
    view.GetFrame(), *static_cast<const skd::Box3*>(box), excess, visit, take);
  skd::Walk(view, query);
}

//------------------------------------------------------------------------------
SKD_FLATTEN void SkdWideWalks::OverlappingPairs(const SkdWideTree& first, const SkdWideTree& second,
  const void* start, double excess, const SkdWidePairs& visitor)
{
  using Query = skd::OverlappingPairs<3, skd::SameWorld, PairBuffer>;
  const skd::CompactTree& view = ViewOf(first);
  const skd::CompactTree& other = ViewOf(second);
  const skd::SameWorld world;
  PairBuffer buffer(visitor);
  Query query(view.GetFrame(), other.GetFrame(), world, buffer, excess);
  skd::PairWalk<skd::CompactTree, skd::CompactTree, Query> walk(view, other, query);
  walk.RunFrom(*static_cast<const skd::TreePair<3>*>(start));
  buffer.Flush();
}

//------------------------------------------------------------------------------
void SkdWideWalks::AlongSegment(const SkdWideTree& tree, const void* segment, double margin,
  bool inOrder, const SkdWideVisitor& visitor)
{
  WithConstant(inOrder,
    [&](auto order)
    { WalkAlong<decltype(order)::value>(tree, SegmentAt(segment), margin, visitor); });
}

//------------------------------------------------------------------------------
void SkdWideWalks::VisitTriangleHits(const SkdWideTree& tree, const void* segment, double tolerance,
  bool inOrder, const SkdWideHits& visitor)
{
  auto take = [&visitor](std::uint32_t cell, const skd::TriangleHit& hit)
  { return visitor.Call(visitor.Self, cell, &hit); };
  WithConstant(inOrder,
    [&](auto order)
    {
      skd::VisitTriangleHits<decltype(order)::value>(
        ViewOf(tree), PacketsOf(tree), SegmentAt(segment), tolerance, take);
    });
}

//------------------------------------------------------------------------------
bool SkdWideWalks::VisitPacketHits(const SkdWideTree& tree, const void* segments, int count,
  double maxSpread, double tolerance, bool inOrder, const SkdWidePacketHits& visitor)
{
  auto take = [&visitor](int line, std::uint32_t cell, const skd::TriangleHit& hit)
  { return visitor.Call(visitor.Self, line, cell, &hit); };
  bool areAlike = false;
  WithConstant(inOrder,
    [&](auto order)
    {
      areAlike = skd::VisitPacketHits<decltype(order)::value>(ViewOf(tree), PacketsOf(tree),
        static_cast<const skd::Segment<3>*>(segments), count, maxSpread, tolerance, take);
    });
  return areAlike;
}
}
