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

/// Push the lanes whose key is within the limit. Ordered: the least key ends on top.
template <bool Ordered, int D>
int PushChildren(Pending* stack, int top, const Node<D>& node, const float* keys, float limit)
{
  const int base = top;
  for (int lane = 0; lane < node.Count; ++lane)
  {
    if (!(keys[lane] <= limit))
    {
      continue;
    }
    int slot = top++;
    if constexpr (Ordered)
    {
      for (; slot > base && stack[slot - 1].Key < keys[lane]; --slot)
      {
        stack[slot] = stack[slot - 1];
      }
    }
    stack[slot] = { keys[lane], Child(node, lane) };
  }
  return top;
}

}

/// The one walk over a tree. It serves every query; adding one never edits it.
///
/// A Tree gives IsEmpty(), Open(node index) -> const Node<D>&, Element(position) -> element index.
/// A Query is a small value that gives
///   static constexpr bool Ordered        visit the least key first?
///   void Keys(const Bundle&, float*)     per lane a lower bound of what is sought below that box
///   float Limit()                        keys above it (and NaN) are not wanted any more
///   bool Visit(element index)            an element was reached; false ends the walk
/// Depth first, brothers by key. No allocation. O(nodes whose key is within the limit).
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
    float keys[std::decay_t<decltype(node)>::Width];
    query.Keys(node.Boxes, keys);
    top = detail::PushChildren<Query::Ordered>(stack, top, node, keys, query.Limit());
  }
}

}

#endif
