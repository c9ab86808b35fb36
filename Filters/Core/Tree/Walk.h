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
      stack[slot] = { keys[lane], Child(node, lane) };
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

/// Whether a query knows of subtrees that all of them are answers.
template <class Query, class = void>
struct KnowsSure : std::false_type
{
};
template <class Query>
struct KnowsSure<Query, std::void_t<decltype(&Query::VisitSure)>> : std::true_type
{
};

/// The key of a node below which all is an answer.
constexpr float SureKey = -1.0f;

/// The lanes of a node to visit, and which of these need no test any more.
struct Choice
{
  unsigned Wanted;
  unsigned Sure;
};

template <class Query, int D>
Choice Choose(Query& query, const Node<D>& node, float key, float* keys)
{
  if (KnowsSure<Query>::value && key == SureKey)
  {
    return { node.Occupied(), node.Occupied() };
  }
  const unsigned reached =
    node.IsBottom ? ReachElements(query, node, keys, 0) : query.Reach(node.Boxes, keys);
  Choice choice{ reached & node.Occupied(), 0u };
  if constexpr (KnowsSure<Query>::value)
  {
    choice.Sure = choice.Wanted != 0 ? choice.Wanted & query.SureOf(node) : 0u;
  }
  return choice;
}

/// Visit the wanted elements of a bottom node, in any order. False ends the walk.
template <class Tree, class Query, int D>
bool VisitBottom(const Tree& tree, Query& query, const Node<D>& node, const Choice& choice)
{
  bool goesOn = true;
  ForEachLane(choice.Wanted,
    [&](int lane)
    {
      const std::uint32_t element = tree.Element(node.First + static_cast<std::uint32_t>(lane));
      if constexpr (KnowsSure<Query>::value)
      {
        if ((choice.Sure >> lane & 1u) != 0)
        {
          goesOn = goesOn && query.VisitSure(element);
          return;
        }
      }
      goesOn = goesOn && query.Visit(element);
    });
  return goesOn;
}

/// Push the wanted children of an inner node, or of any where elements are visited by their keys.
template <class Tree, class Query, int D>
int Descend(const Tree& tree, const Query&, Pending* stack, int top, const Node<D>& node,
  const Choice& choice, float* keys)
{
  if (!Query::Ordered)
  {
    ForEachLane(choice.Wanted,
      [&](int lane) { keys[lane] = (choice.Sure >> lane & 1u) != 0 ? SureKey : 0.0f; });
  }
  if (!node.IsBottom)
  {
    ForEachLane(choice.Wanted,
      [&](int lane) { Fetch(tree, node.First + static_cast<std::uint32_t>(lane), 0); });
  }
  return PushChildren<Query::Ordered>(stack, top, node, choice.Wanted, keys);
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
    const detail::Choice choice = detail::Choose(query, node, next.Key, keys);
    if (!Query::Ordered && node.IsBottom)
    {
      if (!detail::VisitBottom(tree, query, node, choice))
      {
        return;
      }
      continue;
    }
    top = detail::Descend(tree, query, stack, top, node, choice, keys);
  }
}

}

#endif
