// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Walk_h
#define skd_Tree_Walk_h

#include "Node.h"

#include <type_traits>

namespace skd
{

/// How deep a tree may be. 2^31 elements make 12 levels, one to a bottom node, and splits by area
/// one more.
constexpr int MostLevels = 16;

namespace detail
{

/// Calls visit(lane) for each bit that is set, from the lowest.
template <class Visit>
void ForEachLane(unsigned wanted, Visit visit)
{
  while (wanted != 0)
  {
    visit(LowestBit(wanted));
    wanted &= wanted - 1;
  }
}

/// Ask memory for the nodes that will be opened next: where the tree is larger than the caches, a
/// walk is mostly waiting for them.
template <class Tree>
auto Fetch(const Tree& tree, std::uint32_t node, int) -> decltype(tree.Fetch(node))
{
  tree.Fetch(node);
}
template <class Tree>
void Fetch(const Tree&, std::uint32_t, long)
{
}

/// The wanted lanes of a node. A query may look at elements in a way of its own.
template <class Query, int D>
auto ReachElements(Query& query, const Node<D>& bottom, float* keys, int)
  -> decltype(query.ReachElements(bottom, keys))
{
  return query.ReachElements(bottom, keys);
}
template <class Query, int D>
unsigned ReachElements(Query& query, const Node<D>& bottom, float* keys, long)
{
  return query.Reach(bottom.Boxes, keys);
}

/// Whether a query knows of subtrees that all of them are answers.
template <class Query, class = void>
struct KnowsSure : std::false_type
{
};
template <class Query>
struct KnowsSure<Query, std::void_t<decltype(&Query::VisitSure)>> : std::true_type
{
};

/// An open node whose children are visited one after the other: those that wait, and which of them
/// need no test any more.
template <int W>
struct Level
{
  float Keys[W];
  std::uint32_t First;
  unsigned Wanted;
  unsigned Sure;
};

/// `isSure`: all that is below the node is an answer.
template <class Query, int D, int W>
void Open(Query& query, const Node<D>& node, bool isSure, Level<W>& level)
{
  level.First = node.First;
  if (KnowsSure<Query>::value && isSure)
  {
    level.Wanted = level.Sure = node.Occupied();
    return;
  }
  const unsigned reached =
    node.IsBottom ? ReachElements(query, node, level.Keys, 0) : query.Reach(node.Boxes, level.Keys);
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
template <class Query, int W>
int TakeNext(Level<W>& level)
{
  const int lane = Query::Ordered ? LeastLane(level.Wanted, level.Keys) : LowestBit(level.Wanted);
  level.Wanted &= ~(1u << lane);
  return lane;
}

/// Leaves alone what is not wanted any more, the limit having fallen. Whether there is any left.
template <class Query, int W>
bool HasNext(const Query& query, Level<W>& level)
{
  if constexpr (Query::Ordered)
  {
    level.Wanted &= LessEqual(Lanes<W>::Load(level.Keys), Lanes<W>(query.Limit()));
  }
  return level.Wanted != 0;
}

/// The node to open next, and whether all that is below is an answer.
struct Turn
{
  std::uint32_t Node;
  bool IsSure;
};

/// The open nodes on the way from the root that have children which wait, and room for one more.
template <int W>
class Levels
{
public:
  Level<W>& Room() { return this->Stack[this->Count]; }
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

  template <class Query>
  Turn TakeNext()
  {
    Level<W>& last = this->Stack[this->Count - 1];
    const int lane = detail::TakeNext<Query>(last);
    this->Count -= last.Wanted == 0 ? 1 : 0;
    const bool isSure = KnowsSure<Query>::value && (last.Sure >> lane & 1u) != 0;
    return { last.First + static_cast<std::uint32_t>(lane), isSure };
  }

private:
  Level<W> Stack[MostLevels];
  int Count = 0;
};

/// Visit the wanted elements of a bottom node. False ends the walk.
template <class Tree, class Query, int W>
bool VisitElements(const Tree& tree, Query& query, Level<W>& bottom)
{
  while (HasNext(query, bottom))
  {
    const int lane = TakeNext<Query>(bottom);
    const std::uint32_t element = tree.Element(bottom.First + static_cast<std::uint32_t>(lane));
    bool goesOn = true;
    if constexpr (KnowsSure<Query>::value)
    {
      goesOn = (bottom.Sure >> lane & 1u) != 0 ? query.VisitSure(element) : query.Visit(element);
    }
    else
    {
      goesOn = query.Visit(element);
    }
    if (!goesOn)
    {
      return false;
    }
  }
  return true;
}

template <class Tree, int W>
void FetchChildren(const Tree& tree, const Level<W>& level)
{
  ForEachLane(level.Wanted,
    [&](int lane) { Fetch(tree, level.First + static_cast<std::uint32_t>(lane), 0); });
}

}

/// The one walk over a tree. It serves every query; adding one never edits it.
///
/// A Tree gives IsEmpty(), Open(node index) -> const Node<D>&, Element(position) -> element index.
/// A Query is a small value that gives
///   static constexpr bool Ordered        visit the least key first?
///   unsigned Reach(const Bundle&, float* keys)
///                                        bit i: lane i is wanted; if Ordered, its key, a lower
///                                        bound of what is sought below that box, is within Limit()
///   unsigned ReachElements(const Node&, float* keys)
///                                        if there: the same for a bottom node and its elements
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
  detail::Levels<std::decay_t<decltype(tree.Open(0))>::Width> levels;
  detail::Turn turn{ 0, false };
  while (true)
  {
    const auto& node = tree.Open(turn.Node);
    auto& opened = levels.Room();
    detail::Open(query, node, turn.IsSure, opened);
    if (!node.IsBottom && opened.Wanted != 0)
    {
      detail::FetchChildren(tree, opened);
      levels.Keep();
    }
    else if ((node.IsBottom && !detail::VisitElements(tree, query, opened)) ||
      !levels.HaveNext(query))
    {
      return;
    }
    turn = levels.template TakeNext<Query>();
  }
}

}

#endif
