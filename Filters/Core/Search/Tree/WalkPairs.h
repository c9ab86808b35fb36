// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_WalkPairs_h
#define skd_Tree_WalkPairs_h

#include "Node.h"

#include <vector>

namespace skd
{

/// Nodes or elements of two trees, and their boxes, both seen in the first's frame.
template <int D>
struct TreePair
{
  struct Side
  {
    Reference What;
    FloatBox<D> Box;
  };

  Side A;
  Side B;
};

/// The traversal of a pair of trees (Algorithm 5.4).
///
/// A Query gives
///   ToFirst(boxes)                 a FloatBox or a BoxPacket of the second tree, seen in the
///   first's
///                                  frame
///   Overlapping(boxes, box)        a bit for each lane of a BoxPacket that may hold a pair with a
///                                  FloatBox, both seen in the first's frame
///   SureOf(boxes, box)             a bit for each of these lanes whose element is a pair for sure
///   Visit(first, second, isSure)   a pair of elements was reached; false ends the walk
/// Of two nodes the one with the larger box is opened, or both if they are about as large: then one
/// box of the one is looked at beside eight of the other at once.
///
/// A tree may be walked against itself: then each pair of two elements is reached once, (a, b) or
/// (b, a), and no element with itself. The query's boxes must then not be moved.
///
/// Split() and RunFrom() divide the traversal into parts that may run in parallel, each with its
/// own query and traversal.
template <class FirstTree, class SecondTree, class Query>
class PairWalk
{
public:
  PairWalk(const FirstTree& first, const SecondTree& second, Query& query)
    : First(first)
    , Second(second)
    , TheQuery(query)
  {
  }

  /// One tree against itself.
  PairWalk(const FirstTree& tree, Query& query)
    : First(tree)
    , Second(tree)
    , IsWithinOne(true)
    , TheQuery(query)
  {
  }

  static constexpr int D = Query::Dimension;
  using Pair = TreePair<D>;
  using Side = typename Pair::Side;

  void Run()
  {
    for (const Pair& pair : this->Start())
    {
      this->RunFrom(pair);
    }
  }

  /// At least `enough` pairs from which the traversal may continue, or all. Nothing is visited.
  std::vector<Pair> Split(std::size_t enough)
  {
    std::vector<Pair> pairs = this->Start();
    this->IsSplitting = true;
    bool grows = true;
    while (grows && pairs.size() < enough)
    {
      grows = false;
      std::vector<Pair> next;
      for (const Pair& pair : pairs)
      {
        const bool isOfElements = pair.A.What.IsElement() && pair.B.What.IsElement();
        grows = grows || !isOfElements;
        this->Stack.assign(isOfElements ? 1 : 0, pair);
        if (!isOfElements)
        {
          this->Advance(pair);
        }
        next.insert(next.end(), this->Stack.begin(), this->Stack.end());
      }
      pairs.swap(next);
    }
    this->IsSplitting = false;
    this->Stack.clear();
    return pairs;
  }

  /// Continues from a pair. Returns whether the query continues.
  bool RunFrom(const Pair& start)
  {
    this->Stack.assign(1, start);
    while (!this->Stack.empty())
    {
      const Pair pair = this->Stack.back();
      this->Stack.pop_back();
      if (!this->Advance(pair))
      {
        return false;
      }
    }
    return true;
  }

private:
  std::vector<Pair> Start() const
  {
    if (this->First.IsEmpty() || this->Second.IsEmpty())
    {
      return {};
    }
    const Side second = Root(this->Second);
    return { { Root(this->First), { second.What, this->TheQuery.ToFirst(second.Box) } } };
  }

  template <class Tree>
  static Side Root(const Tree& tree)
  {
    return { Reference::ToNode(0), tree.GetFrame().Outward(tree.GetBounds()) };
  }

  static float Size(const FloatBox<D>& box)
  {
    float size = 0.0f;
    for (int axis = 0; axis < D; ++axis)
    {
      size = std::max(size, box.Max[axis] - box.Min[axis]);
    }
    return size;
  }

  bool Advance(const Pair& pair)
  {
    if (this->IsWithinOne && pair.A.What == pair.B.What)
    {
      return this->OpenWithin(pair.A.What);
    }
    const bool hasA = !pair.A.What.IsElement();
    const bool hasB = !pair.B.What.IsElement();
    if (!hasA && !hasB)
    {
      return this->Visit(pair.A, pair.B, false);
    }
    const float sizeA = Size(pair.A.Box);
    const float sizeB = Size(pair.B.Box);
    if (!hasB || (hasA && sizeA > 2.0f * sizeB))
    {
      return this->OpenFirst(this->OpenA(pair.A.What), pair.B);
    }
    this->OpenB(pair.B.What);
    return hasA && sizeB <= 2.0f * sizeA ? this->OpenEach(this->OpenA(pair.A.What), pair.A.Box)
                                         : this->OpenSecond(pair.A);
  }

  const Node<D>& OpenA(const Reference& what)
  {
    return OpenIn(this->First, what.Index(), this->RoomOfA, true, 0);
  }

  /// The same node of the second tree is met beside many of the first in turn.
  void OpenB(const Reference& what)
  {
    if (!this->NodeB || !(this->WhatB == what))
    {
      this->NodeB = &OpenIn(this->Second, what.Index(), this->RoomOfB, true, 0);
      this->BoxesOfB = this->TheQuery.ToFirst(this->NodeB->Boxes);
      this->WhatB = what;
    }
  }

  bool OpenFirst(const Node<D>& node, const Side& b)
  {
    const unsigned lanes = this->TheQuery.Overlapping(node.Boxes, b.Box) & node.Occupied();
    if (lanes == 0)
    {
      return true;
    }
    const bool areElements = node.IsLeaf && b.What.IsElement();
    const unsigned sure = areElements ? this->TheQuery.SureOf(node.Boxes, b.Box) : 0;
    return ForEachLane(lanes,
      [&](int lane)
      { return this->Consider(SideOf(node, node.Boxes, lane), b, (sure >> lane & 1u) != 0); });
  }

  bool OpenSecond(const Side& a)
  {
    const Node<D>& node = *this->NodeB;
    const auto& boxes = this->BoxesOfB;
    const unsigned lanes = this->TheQuery.Overlapping(boxes, a.Box) & node.Occupied();
    const bool areElements = node.IsLeaf && a.What.IsElement();
    const unsigned sure = areElements ? this->TheQuery.SureOf(boxes, a.Box) : 0;
    return ForEachLane(lanes,
      [&](int lane)
      { return this->Consider(a, SideOf(node, boxes, lane), (sure >> lane & 1u) != 0); });
  }

  bool OpenEach(const Node<D>& first, const FloatBox<D>& firstBox)
  {
    const Node<D>& second = *this->NodeB;
    const unsigned lanes = this->TheQuery.Overlapping(this->BoxesOfB, firstBox) & second.Occupied();
    return ForEachLane(lanes,
      [&](int lane) { return this->OpenFirst(first, SideOf(second, this->BoxesOfB, lane)); });
  }

  /// Each lane with itself and those after it. An element is not a pair with itself.
  bool OpenWithin(const Reference& what)
  {
    if (what.IsElement())
    {
      return true;
    }
    const Node<D>& node = this->OpenA(what);
    const auto boxes = this->TheQuery.ToFirst(node.Boxes);
    for (int lane = 0; lane < node.Count; ++lane)
    {
      const Side side = SideOf(node, node.Boxes, lane);
      const unsigned others =
        this->TheQuery.Overlapping(boxes, side.Box) & node.Occupied() & (~0u << lane);
      if (!ForEachLane(others,
            [&](int other) { return this->Consider(side, SideOf(node, boxes, other), false); }))
      {
        return false;
      }
    }
    return true;
  }

  template <class Body>
  static bool ForEachLane(unsigned lanes, Body body)
  {
    for (; lanes != 0; lanes &= lanes - 1)
    {
      if (!body(LowestBit(lanes)))
      {
        return false;
      }
    }
    return true;
  }

  template <class Boxes>
  static Side SideOf(const Node<D>& node, const Boxes& boxes, int lane)
  {
    return { Child(node, lane), boxes.Get(lane) };
  }

  /// Elements are visited immediately, unless the traversal is being split.
  bool Consider(const Side& a, const Side& b, bool isSure)
  {
    const bool areElements = a.What.IsElement() && b.What.IsElement();
    if (this->IsSplitting || !areElements)
    {
      this->Stack.push_back({ a, b });
      return true;
    }
    return (this->IsWithinOne && a.What == b.What) || this->Visit(a, b, isSure);
  }

  bool Visit(const Side& a, const Side& b, bool isSure)
  {
    return this->TheQuery.Visit(
      this->First.Element(a.What.Index()), this->Second.Element(b.What.Index()), isSure);
  }

  const FirstTree& First;
  const SecondTree& Second;
  const bool IsWithinOne = false;
  Query& TheQuery;
  bool IsSplitting = false;
  Node<D> RoomOfA; ///< of leaves that the trees do not store
  Node<D> RoomOfB;
  const Node<D>* NodeB = nullptr; ///< that of the second tree opened last: WhatB
  Reference WhatB;
  BoxPacket<D, Node<D>::Width> BoxesOfB; ///< its boxes, seen in the first's frame
  std::vector<Pair> Stack;
};

template <class FirstTree, class SecondTree, class Query>
void WalkPairs(const FirstTree& first, const SecondTree& second, Query& query)
{
  PairWalk<FirstTree, SecondTree, Query>(first, second, query).Run();
}

}

#endif
