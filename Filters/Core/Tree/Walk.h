// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Walk_h
#define skd_Tree_Walk_h

#include "Node.h"

#include <type_traits>

namespace skd
{

/// A walk never waits for more than Width - 1 brothers a level, and 2^31 elements make 11 levels.
constexpr int WalkStackSize = 96;

namespace detail
{

struct Pending
{
  float Key;
  Reference What;
};

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

/// Push the wanted lanes. Ordered: the least key ends on top.
template <bool Ordered, int D>
int PushChildren(Pending* stack, int top, const Node<D>& node, unsigned wanted, const float* keys)
{
  const int base = top;
  ForEachLane(wanted,
    [&](int lane)
    {
      int slot = top++;
      if constexpr (Ordered)
      {
        for (; slot > base && stack[slot - 1].Key < keys[lane]; --slot)
        {
          stack[slot] = stack[slot - 1];
        }
      }
      stack[slot] = { Ordered ? keys[lane] : 0.0f, Child(node, lane) };
    });
  return top;
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

/// Visit the wanted elements of a bottom node, in any order. False ends the walk.
template <class Tree, class Query, int D>
bool VisitBottom(const Tree& tree, Query& query, const Node<D>& node, unsigned wanted)
{
  bool goesOn = true;
  ForEachLane(wanted,
    [&](int lane)
    {
      const std::uint32_t position = node.First + static_cast<std::uint32_t>(lane);
      goesOn = goesOn && query.Visit(tree.Element(position));
    });
  return goesOn;
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
///   float Limit()                        a node whose key is above it is not wanted any more
///   bool Visit(element index)            an element was reached; false ends the walk
/// Keys are 0 or more: with a negative limit nothing is reached. Depth first, brothers by key. No
/// allocation. O(nodes whose key is within the limit).
template <class Tree, class Query>
void Walk(const Tree& tree, Query& query)
{
  if (tree.IsEmpty())
  {
    return;
  }
  detail::Pending stack[WalkStackSize];
  int top = 0;
  stack[top++] = { 0.0f, Reference::ToNode(0) };
  while (top > 0)
  {
    const detail::Pending next = stack[--top];
    if (!(next.Key <= query.Limit()))
    {
      continue;
    }
    if (next.What.IsElement())
    {
      if (!query.Visit(tree.Element(next.What.Index())))
      {
        return;
      }
      continue;
    }
    const auto& node = tree.Open(next.What.Index());
    constexpr int width = std::decay_t<decltype(node)>::Width;
    float keys[width];
    const unsigned reached =
      node.IsBottom ? detail::ReachElements(query, node, keys, 0) : query.Reach(node.Boxes, keys);
    const unsigned wanted = reached & node.Occupied();
    if (!Query::Ordered && node.IsBottom)
    {
      if (!detail::VisitBottom(tree, query, node, wanted))
      {
        return;
      }
      continue;
    }
    if (!node.IsBottom)
    {
      detail::ForEachLane(wanted,
        [&](int lane) { detail::Fetch(tree, node.First + static_cast<std::uint32_t>(lane), 0); });
    }
    top = detail::PushChildren<Query::Ordered>(
      stack, top, node, wanted, Query::Ordered ? keys : nullptr);
  }
}

}

#endif
