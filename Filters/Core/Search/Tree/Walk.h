// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Walk_h
#define skd_Tree_Walk_h

#include "Node.h"

#include <type_traits>

namespace skd
{

/// The maximum depth of a tree. 2^31 elements need 12 levels with one element a leaf, and splits by
/// area one more.
constexpr int MostLevels = 16;

namespace detail
{

/// Prefetches the nodes that will be opened next: in trees larger than the caches, traversals
/// mostly wait for memory.
template <class Tree>
auto Fetch(const Tree& tree, std::uint32_t node, int) -> decltype(tree.Fetch(node))
{
  tree.Fetch(node);
}
template <class Tree>
void Fetch(const Tree&, std::uint32_t, long)
{
}

/// Whether a traversal may skip leaf nodes: the tree gives their elements by number, and the query
/// has its own test for these.
template <class Tree, class Query, class = void>
struct SkipsLeaves : std::false_type
{
};
template <class Tree, class Query>
struct SkipsLeaves<Tree, Query,
  std::void_t<decltype(&Tree::LeafAt), std::enable_if_t<Query::SkipsLeaves>>> : std::true_type
{
};

/// The wanted lanes of a node. A query may look at elements in a way of its own.
template <class Query, int D>
auto TestElements(Query& query, const Node<D>& leaf, float* keys, int)
  -> decltype(query.TestElements(leaf, keys))
{
  return query.TestElements(leaf, keys);
}
template <class Query, int D>
unsigned TestElements(Query& query, const Node<D>& leaf, float* keys, long)
{
  return query.TestBoxes(leaf.Boxes, keys);
}

/// Whether a query can decide that all elements of a subtree are answers.
template <class Query, class = void>
struct KnowsSure : std::false_type
{
};
template <class Query>
struct KnowsSure<Query, std::void_t<decltype(&Query::VisitSure)>> : std::true_type
{
};

/// An open node: its remaining children, and those of them that need no further test.
template <class Node>
struct Level
{
  float Keys[Node::Width];
  std::uint32_t First;
  unsigned Wanted;
  unsigned Sure;
  // Of a walk that skips leaves:
  unsigned Known;     ///< the children that are leaves which need not be opened
  const Node* Opened; ///< whose note then says which these are

  bool IsKnown(int lane) const { return (this->Known >> lane & 1u) != 0; }
  std::uint32_t NumberOf(int lane) const
  {
    return this->Opened->template Read<KnownLeaves>().NumberOf(lane);
  }
};

/// `isSure`: all elements below the node are answers.
template <class Query, class Node>
void Open(Query& query, const Node& node, bool isSure, Level<Node>& level)
{
  level.First = node.First;
  if (KnowsSure<Query>::value && isSure)
  {
    level.Wanted = level.Sure = node.Occupied();
    return;
  }
  const unsigned reached = node.IsLeaf ? TestElements(query, node, level.Keys, 0)
                                       : query.TestBoxes(node.Boxes, level.Keys);
  level.Wanted = reached & node.Occupied();
  if constexpr (KnowsSure<Query>::value)
  {
    level.Sure = level.Wanted != 0 ? level.Wanted & query.SureOf(node) : 0u;
  }
}

/// Of some lanes, at least one, that with the least key. Written so that compilers make it without
/// a branch in the loop: which child comes first is anyone's guess.
inline int LeastLane(unsigned lanes, const float* keys)
{
  int least = LowestBit(lanes);
  ForEachLane(
    lanes & (lanes - 1), [&](int lane) { least = keys[lane] < keys[least] ? lane : least; });
  return least;
}

/// Of the lanes of a level that wait, at least one: takes out that which comes next.
template <class Query, class Node>
int TakeNext(Level<Node>& level)
{
  const int lane = Query::Ordered ? LeastLane(level.Wanted, level.Keys) : LowestBit(level.Wanted);
  level.Wanted &= ~(1u << lane);
  return lane;
}

/// Drops children beyond the reduced limit. Returns whether any are left.
template <class Query, class Node>
bool HasNext(const Query& query, Level<Node>& level)
{
  if constexpr (Query::Ordered)
  {
    level.Wanted &=
      LessEqual(Lanes<Node::Width>::Load(level.Keys), Lanes<Node::Width>(query.Limit()));
  }
  return level.Wanted != 0;
}

/// The elements of a leaf that is not opened.
template <class Tree, class Query, class Node>
void OpenKnown(const Tree& tree, Query& query, std::uint32_t number, Level<Node>& level)
{
  const auto elements = tree.LeafAt(number);
  tree.FetchElements(elements.First);
  level.First = elements.First;
  level.Wanted = query.TestKnown(number, elements.Count, level.Keys);
}

/// The node to open next, and whether all elements below are answers; or a known leaf.
struct Turn
{
  std::uint32_t Index; ///< of the node, or the number of a leaf
  bool IsSure;
  bool IsKnown;
};

/// Opens the next node. Returns whether it is a leaf.
template <class Tree, class Query, class Node>
bool Take(const Tree& tree, Query& query, const Turn& turn, Level<Node>& level)
{
  if constexpr (SkipsLeaves<Tree, Query>::value)
  {
    if (turn.IsKnown)
    {
      OpenKnown(tree, query, turn.Index, level);
      return true;
    }
  }
  const auto& node = tree.Open(turn.Index);
  Open(query, node, turn.IsSure, level);
  if constexpr (SkipsLeaves<Tree, Query>::value)
  {
    level.Opened = &node;
    level.Known = query.Knows(node) ? node.template Read<KnownLeaves>().Lanes : 0u;
  }
  return node.IsLeaf;
}

/// The stack of open nodes with remaining children, and space for one more.
template <class Node>
class Levels
{
public:
  Level<Node>& Room() { return this->Stack[this->Count]; }
  /// The level in that room has children that wait.
  void Keep() { ++this->Count; }

  /// Whether there is any left with a next one, the limit having fallen.
  template <class Query>
  bool HaveNext(const Query& query)
  {
    while (this->Count > 0 && !HasNext(query, this->Stack[this->Count - 1]))
    {
      --this->Count;
    }
    return this->Count > 0;
  }

  template <class Tree, class Query>
  Turn TakeNext()
  {
    Level<Node>& last = this->Stack[this->Count - 1];
    const int lane = detail::TakeNext<Query>(last);
    this->Count -= last.Wanted == 0 ? 1 : 0;
    if constexpr (SkipsLeaves<Tree, Query>::value)
    {
      if (last.IsKnown(lane))
      {
        return { last.NumberOf(lane), false, true };
      }
    }
    const bool isSure = KnowsSure<Query>::value && (last.Sure >> lane & 1u) != 0;
    return { last.First + static_cast<std::uint32_t>(lane), isSure, false };
  }

private:
  Level<Node> Stack[MostLevels];
  int Count = 0;
};

/// False ends the walk.
template <class Tree, class Query, class Node>
bool VisitElement(const Tree& tree, Query& query, const Level<Node>& leaf, int lane)
{
  const std::uint32_t element = tree.Element(leaf.First + static_cast<std::uint32_t>(lane));
  if constexpr (KnowsSure<Query>::value)
  {
    return (leaf.Sure >> lane & 1u) != 0 ? query.VisitSure(element) : query.Visit(element);
  }
  else
  {
    return query.Visit(element);
  }
}

/// Visits the selected elements of a leaf. False ends the traversal.
template <class Tree, class Query, class Node>
bool VisitElements(const Tree& tree, Query& query, Level<Node>& leaf)
{
  if constexpr (!Query::Ordered)
  {
    for (unsigned wanted = leaf.Wanted; wanted != 0; wanted &= wanted - 1)
    {
      if (!VisitElement(tree, query, leaf, LowestBit(wanted)))
      {
        return false;
      }
    }
    return true;
  }
  while (HasNext(query, leaf))
  {
    const int lane = TakeNext<Query>(leaf);
    if (!VisitElement(tree, query, leaf, lane))
    {
      return false;
    }
  }
  return true;
}

template <class Tree, class Query, class Node>
void FetchChildren(const Tree& tree, const Query& query, const Level<Node>& level)
{
  ForEachLane(level.Wanted,
    [&](int lane)
    {
      if constexpr (SkipsLeaves<Tree, Query>::value)
      {
        if (level.IsKnown(lane))
        {
          query.FetchKnown(level.NumberOf(lane));
          return;
        }
      }
      Fetch(tree, level.First + static_cast<std::uint32_t>(lane), 0);
    });
}

}

/// The traversal of a tree. It serves every query and need not be changed for new ones.
///
/// A Tree gives IsEmpty(), Open(node index) -> const Node<D>&, Element(position) -> element index.
/// A Query is a small value that gives
///   static constexpr bool Ordered        visit the least key first?
///   unsigned TestBoxes(const BoxPacket&, float* keys)
///                                        bit i: lane i is wanted; if Ordered, its key, a lower
///                                        bound of what is sought below that box, is within Limit()
///   unsigned TestElements(const Node&, float* keys)
///                                        if there: the same for a leaf and its elements
///   static constexpr bool SkipsLeaves   if there and true, it gives
///   bool Knows(const Node&)              whether the node's note, if it is an inner one, is
///                                        KnownLeaves: these need not be opened
///   unsigned TestKnown(number, count, float* keys), void FetchKnown(number)
///                                        what TestElements() does, by a leaf's number, and
///                                        that this test will follow
///   unsigned SureOf(const Node&), bool VisitSure(element index)
///                                        if there, and not Ordered: the lanes below which all is
///                                        an answer, and what is visited without a test of any box
///   float Limit()                        a node whose key is above it is not wanted any more
///   bool Visit(element index)            an element was reached; false ends the walk
/// Keys are 0 or more: with a negative limit nothing is reached. Depth first, brothers by key. No
/// allocation. O(nodes whose key is within the limit).
template <class Tree, class Query>
void Walk(const Tree& tree, Query& query)
{
  if (tree.IsEmpty() || !(0.0f <= query.Limit()))
  {
    return;
  }
  detail::Levels<std::decay_t<decltype(tree.Open(0))>> levels;
  detail::Turn turn{ 0, false, false };
  while (true)
  {
    auto& opened = levels.Room();
    const bool isLeaf = detail::Take(tree, query, turn, opened);
    if (!isLeaf && opened.Wanted != 0)
    {
      detail::FetchChildren(tree, query, opened);
      levels.Keep();
    }
    else if ((isLeaf && !detail::VisitElements(tree, query, opened)) || !levels.HaveNext(query))
    {
      return;
    }
    turn = levels.template TakeNext<Tree, Query>();
  }
}

/// A leaf filter, quantized or not, looks at the elements of a leaf more closely than their boxes
/// do, all at once, and says which are worth a visit: it may leave out what is proven to be no
/// answer. It gives
///   bool Knows(const Node&)             whether it can, of this node
///   std::uint32_t NumberOf(const Node&) by what it knows the leaf
///   unsigned Pass(number, count, float* keys, float& limit)
///                                       as TestBoxes() of a query, whose limit it may lower, of a
///                                       leaf's number and how many elements it has
///   static constexpr bool SkipsLeaves   whether numbers are those of KnownLeaves; if so it gives
///   void Fetch(number)
/// AlongSegment first calls Aim(point, margin), in the frame: where the segment begins, clipped to
/// where the tree is. This one knows nothing.
struct NoLeafFilter
{
  static constexpr bool SkipsLeaves = false;

  template <class Point>
  void Aim(const Point&, double)
  {
  }
  template <class Node>
  static bool Knows(const Node&)
  {
    return false;
  }
  template <class Node>
  static std::uint32_t NumberOf(const Node&)
  {
    return 0;
  }
  unsigned Pass(std::uint32_t, std::uint32_t count, float*, float&) const { return LowBits(count); }
};

/// What queries that have a leaf filter do with it, and their limit. The boxes of the
/// elements decide where the filter does not know the leaf: `Query` has TestBoxes().
template <class Query, class LeafFilter>
class FilteredQuery
{
public:
  static constexpr bool SkipsLeaves = LeafFilter::SkipsLeaves;

  template <class Node>
  unsigned TestElements(const Node& leaf, float* keys)
  {
    return this->Knows(leaf) ? this->TestKnown(LeafFilter::NumberOf(leaf), leaf.Count, keys)
                             : static_cast<Query*>(this)->TestBoxes(leaf.Boxes, keys);
  }

  template <class Node>
  bool Knows(const Node& inner) const
  {
    return LeafFilter::Knows(inner);
  }
  unsigned TestKnown(std::uint32_t leaf, std::uint32_t count, float* keys)
  {
    return this->TheLeafFilter.Pass(leaf, count, keys, this->TheLimit);
  }
  void FetchKnown(std::uint32_t leaf) const { this->TheLeafFilter.Fetch(leaf); }

  float Limit() const { return this->TheLimit; }

protected:
  FilteredQuery(const LeafFilter& leafFilter, float limit)
    : TheLeafFilter(leafFilter)
    , TheLimit(limit)
  {
  }

  LeafFilter TheLeafFilter;
  float TheLimit;
};

}

#endif
