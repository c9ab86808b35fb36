// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Trees that make the boxes of leaves of quantized corners answer as those that store them.
#include "Core/Search/LeafFilters/CompactTree.h"
#include "Core/Search/Queries/CandidateLists.h"
#include "Core/Search/Queries/Nearest.h"
#include "Core/Search/Queries/OverlapParts.h"
#include "Core/Search/Queries/OverlappingBox.h"
#include "Core/Search/Queries/WithinBox.h"
#include "Core/Search/Tree/BuildTree.h"
#include "CoreAnswers.h"
#include "CoreScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

using namespace coretest;

namespace
{

constexpr double Epsilon = 1e-9; // of the largest coordinate

double LargestOf(const skd::Box3& bounds)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max({ largest, std::abs(bounds.Min[axis]), std::abs(bounds.Max[axis]) });
  }
  return largest;
}

/// A tree of boxes, whole and compact, whose leaves are kept as triangles that fill these or as
/// their corners.
class Pair
{
public:
  Pair(const Boxes<3>& boxes, int capacity, skd::SplitRule rule, bool areTriangles)
    : Safety(2.0 * Epsilon * LargestOf(BoundsOf(boxes)))
    , Whole(this->Build(boxes, capacity, rule))
    , Dropped(this->Build(boxes, capacity, rule))
  {
    const std::uint32_t count = this->CountLeaves();
    this->Triangles.resize(areTriangles ? count : 0);
    this->Corners.resize(areTriangles ? 0 : count);
    for (std::uint32_t i = 0; i < this->Whole.NumberOfNodes(); ++i)
    {
      const skd::Node<3>& node = this->Whole.Open(i);
      if (node.IsLeaf)
      {
        this->Fill(boxes, node);
      }
      else
      {
        this->Dropped.SetNote(i, this->Dropped.LeavesBelow(node));
      }
    }
    this->Dropped.DropLeaves();
    this->Dropped.NoteData(DataOf);
    const double widening = skd::TrianglePacket::WideningOf(this->LargestUnit);
    const skd::LeafCorners corners{ areTriangles ? this->Triangles.data() : nullptr,
      areTriangles ? nullptr : this->Corners.data(), widening };
    this->Compact = { this->Dropped.View(), corners, this->Margin() };
  }

  /// Where the data of a leaf are said to be: soon too far from the first of a node.
  static std::uint32_t DataOf(std::uint32_t leaf) { return 3 + 20000 * leaf; }

  double Excess() const { return this->Margin() + this->Compact.Widening(); }

  /// Above what rounding safety boxes in the world adds.
  double Margin() const { return 1.0625 * this->Safety; }

  const double Safety;
  skd::Tree<3> Whole;
  skd::Tree<3> Dropped;
  skd::CompactTree Compact;

private:
  skd::Tree<3> Build(const Boxes<3>& boxes, int capacity, skd::SplitRule rule) const
  {
    skd::TreeInput<3> input = skd::MakeTreeInput(boxes, 0.5 * this->Safety);
    input.Capacity = capacity;
    input.Rule = rule;
    return skd::BuildTree<3>(std::move(input));
  }

  std::uint32_t CountLeaves() const
  {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < this->Whole.NumberOfNodes(); ++i)
    {
      count += this->Whole.Open(i).IsLeaf ? 1 : 0;
    }
    return count;
  }

  void Fill(const Boxes<3>& boxes, const skd::Node<3>& leaf)
  {
    const std::uint32_t number = this->Whole.NumberOf(leaf);
    skd::FloatBox<3> all = leaf.Boxes.Get(0);
    for (int lane = 1; lane < leaf.Count; ++lane)
    {
      skd::Enclose(all, leaf.Boxes.Get(lane));
    }
    const skd::QuantizationGrid grid(all);
    this->LargestUnit = std::max(this->LargestUnit, grid.Unit);
    for (int lane = 0; lane < 8; ++lane)
    {
      const int used = lane < leaf.Count ? lane : 0;
      if (!this->Triangles.empty())
      {
        const skd::Box3& box =
          boxes[this->Whole.Element(leaf.First + static_cast<std::uint32_t>(used))];
        skd::TrianglePacket& packet = this->Triangles[number];
        packet.Grid = grid;
        packet.Set(lane % 3, lane, this->Whole.GetFrame().Local(box.Min));
        packet.Set((lane + 1) % 3, lane, this->Whole.GetFrame().Local(box.Max));
        packet.Set((lane + 2) % 3, lane, this->Whole.GetFrame().Local(box.Centroid()));
      }
      else
      {
        const skd::FloatBox<3> box = leaf.Boxes.Get(used);
        skd::QuantizedCorners<2>& packet = this->Corners[number];
        packet.Grid = grid;
        packet.Set(0, lane, { { box.Min[0], box.Min[1], box.Min[2] } });
        packet.Set(1, lane, { { box.Max[0], box.Max[1], box.Max[2] } });
      }
    }
  }

  std::vector<skd::TrianglePacket> Triangles;
  std::vector<skd::QuantizedCorners<2>> Corners;
  float LargestUnit = 0.0f;
};

/// `test(boxes, pair)` for scenes of many kinds.
template <class Test>
void ForEachPair(Test test)
{
  int turn = 0;
  for (const std::size_t count : { 1, 7, 8, 9, 64, 65, 600 })
  {
    for (const Scene<3>& scene : AllScenes<3>(count, false))
    {
      for (const bool areTriangles : { false, true })
      {
        const int capacity = 1 + turn++ % 8;
        const auto rule = turn % 3 == 0 ? skd::SplitRule::SurfaceArea : skd::SplitRule::Median;
        SCOPED_TRACE(scene.Name + ", capacity " + std::to_string(capacity));
        test(scene.Boxes, Pair(scene.Boxes, capacity, rule, areTriangles));
      }
    }
  }
}

/// Whether a box in the frame holds one of the world, and is wider by at most so much.
void ExpectAbout(
  const skd::Frame<3>& frame, const skd::FloatBox<3>& box, const skd::Box3& own, double excess)
{
  const skd::Vector3 min = frame.Local(own.Min);
  const skd::Vector3 max = frame.Local(own.Max);
  for (int axis = 0; axis < 3; ++axis)
  {
    ASSERT_LE(box.Min[axis], min[axis]);
    ASSERT_GE(box.Max[axis], max[axis]);
    ASSERT_GE(box.Min[axis], min[axis] - excess);
    ASSERT_LE(box.Max[axis], max[axis] + excess);
  }
}

TEST(CompactTree, BoxesHoldSafetyBoxesAndAreHardlyWider)
{
  std::size_t made = 0;
  ForEachPair(
    [&](const Boxes<3>& boxes, const Pair& pair)
    {
      ASSERT_EQ(pair.Dropped.NumberOfNodes(), pair.Whole.NumberOfNodes());
      ASSERT_EQ(pair.Dropped.Depth(), pair.Whole.Depth());
      const skd::Frame<3>& frame = pair.Compact.GetFrame();
      std::vector<std::uint32_t> open{ 0 };
      std::size_t elements = 0;
      skd::Node<3> room;
      while (!open.empty())
      {
        const skd::Node<3>& node = pair.Compact.Open(open.back(), room, true);
        open.pop_back();
        made += &node == &room ? 1 : 0;
        for (std::uint32_t lane = 0; lane < node.Count; ++lane)
        {
          if (!node.IsLeaf)
          {
            open.push_back(node.First + lane);
            continue;
          }
          const skd::Box3 safe =
            boxes[pair.Compact.Element(node.First + lane)].Inflated(pair.Safety);
          ExpectAbout(frame, node.Boxes.Get(static_cast<int>(lane)), safe,
            (pair.Excess() - 0.9375 * pair.Safety) * frame.Scale + 1e-6);
          ++elements;
        }
      }
      EXPECT_EQ(elements, boxes.size());
    });
  EXPECT_GT(made, 1000u);
}

TEST(CompactTree, InnerNodesTellWhereDataOfTheirLeavesAre)
{
  std::size_t told = 0, tooFar = 0;
  ForEachPair(
    [&](const Boxes<3>&, const Pair& pair)
    {
      for (std::uint32_t i = 0; i < pair.Whole.NumberOfNodes(); ++i)
      {
        if (pair.Whole.Open(i).IsLeaf)
        {
          continue;
        }
        const auto& known = pair.Dropped.Open(i).Read<skd::KnownLeaves>();
        std::vector<std::uint32_t> data;
        for (int lane = 0; lane < 8; ++lane)
        {
          if (known.IsKnown(lane))
          {
            data.push_back(Pair::DataOf(known.NumberOf(lane)));
            const bool isNear = data.back() - data.front() < 1u << 16;
            ++(isNear ? told : tooFar);
            ASSERT_EQ(known.DataOf(lane), isNear ? data.back() : data.front() + 0xffffu);
          }
        }
      }
    });
  EXPECT_GT(told, 1000u);
  EXPECT_GT(tooFar, 1000u);
}

TEST(CompactTree, BoxesAndPointsReachWhatTheyReachInTheWholeTree)
{
  Random random(3);
  ForEachPair(
    [&](const Boxes<3>& boxes, const Pair& pair)
    {
      const auto around = Around(boxes);
      for (int i = 0; i < 10; ++i)
      {
        const skd::Vector3 x = random.Point(around);
        skd::Box3 query(x, x);
        query.Add(x + 0.5 * (random.Point(around) - x));
        const auto overlapping = [&](const auto& tree)
        {
          Ids found;
          auto visitor = [&](std::uint32_t id)
          {
            found.insert(found.end(), boxes[id].Overlaps(query) ? 1 : 0, id);
            return true;
          };
          auto sure = [&](std::uint32_t id)
          {
            found.push_back(id);
            return true;
          };
          skd::OverlappingBox<3, decltype(visitor), decltype(sure)> walk(
            tree.GetFrame(), query, pair.Excess(), visitor, sure);
          skd::Walk(tree, walk);
          return found;
        };
        ASSERT_EQ(overlapping(pair.Compact), overlapping(pair.Whole));
        ASSERT_EQ(overlapping(pair.Compact).size(),
          static_cast<std::size_t>(std::count_if(boxes.begin(), boxes.end(),
            [&](const skd::Box3& one) { return one.Overlaps(query); })));
        const auto least = [&](const auto& tree)
        {
          double least2 = std::numeric_limits<double>::infinity();
          auto visitor = [&](std::uint32_t id)
          { return least2 = std::min(least2, Norm2(x - boxes[id].Centroid())); };
          skd::Nearest<3, decltype(visitor)> walk(tree.GetFrame(), x, least2, visitor);
          skd::Walk(tree, walk);
          return least2;
        };
        ASSERT_EQ(least(pair.Compact), least(pair.Whole));
      }
    });
}

TEST(CompactTree, PairsAndCandidatesAreThoseOfTheWholeTree)
{
  ForEachPair(
    [&](const Boxes<3>& boxes, const Pair& pair)
    {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
      auto visitor = [&](std::uint32_t a, std::uint32_t b, bool isSure)
      {
        EXPECT_TRUE(!isSure || boxes[a].Overlaps(boxes[b]));
        found.insert(found.end(), boxes[a].Overlaps(boxes[b]) ? 1 : 0, { a, b });
        return true;
      };
      const auto pairsOf = [&](const auto& tree)
      {
        found.clear();
        const skd::SameWorld same;
        skd::OverlappingPairs<3, skd::SameWorld, decltype(visitor)> query(
          tree.GetFrame(), tree.GetFrame(), same, visitor, 2.0 * pair.Excess());
        skd::WalkPairs(tree, tree, query);
        return found;
      };
      ASSERT_EQ(pairsOf(pair.Compact), pairsOf(pair.Whole));
      const auto candidatesOf = [&](const auto& tree)
      {
        const std::vector<skd::CandidateLanes> all = skd::AllCandidates();
        const skd::Box3& query = boxes.back();
        std::vector<skd::CandidateLanes> list;
        const auto isMet = [&](std::uint32_t id) { return boxes[id].Overlaps(query); };
        EXPECT_TRUE(
          skd::NarrowCandidates(tree, all.data(), all.data() + all.size(), query, isMet, list));
        Ids ids;
        skd::VisitCandidates(tree, list.data(), list.data() + list.size(), query,
          [&](std::uint32_t id) { ids.insert(ids.end(), isMet(id) ? 1 : 0, id); });
        std::sort(ids.begin(), ids.end());
        return ids;
      };
      ASSERT_EQ(candidatesOf(pair.Compact), candidatesOf(pair.Whole));
    });
}

}
