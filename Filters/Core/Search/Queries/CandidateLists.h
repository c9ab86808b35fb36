// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Searches a family of nested boxes in one traversal of a tree (section 6.5): each box gets its
/// candidate list from the enclosing box instead of searching from the root.
#ifndef skd_Queries_CandidateLists_h
#define skd_Queries_CandidateLists_h

#include "../Tree/Node.h"
#include "CandidateLanes.h"
#include "QueryBox.h"

#include <vector>

namespace skd
{

namespace detail
{

/// Working lists for one box, reused to avoid allocation.
struct NarrowingLists
{
  std::vector<CandidateLanes> Elements;
  std::vector<CandidateLanes> Nodes;
};

/// One box's part of the walk. First what costs least and may settle it: a node within the box
/// holds an element, which meets it. Nodes are opened last, and only as long as nothing is settled:
/// smaller boxes, which reach fewer of them, do the rest.
template <class Tree, int D, class Test>
class Narrowing
{
public:
  Narrowing(const Tree& tree, const Box<D>& box, Test& test, std::vector<CandidateLanes>& list)
    : TheTree(tree)
    , TheTest(test)
    , List(list)
    , Elements(ThreadsLists().Elements)
    , Nodes(ThreadsLists().Nodes)
  {
    SetAround(tree.GetFrame(), box, this->Outer, this->Inner);
    this->Elements.clear();
    this->Nodes.clear();
  }

  void Take(const CandidateLanes& lanes)
  {
    const auto& node = this->Open(lanes.Node, true);
    const unsigned wanted = this->Outer.Overlapping(node.Boxes) & lanes.Lanes & node.Occupied();
    if (wanted == 0)
    {
      return;
    }
    if (!this->IsMet)
    {
      this->IsMet = (this->Inner.Holding(node.Boxes) & wanted) != 0;
    }
    (node.IsLeaf ? this->Elements : this->Nodes).push_back({ lanes.Node, wanted });
  }

  bool Settle()
  {
    this->TestElements();
    while (!this->IsMet && !this->Nodes.empty())
    {
      const CandidateLanes lanes = this->Nodes.back();
      this->Nodes.pop_back();
      const auto& node = this->Open(lanes.Node, false);
      ForEachLane(lanes.Lanes, [&](int lane) { this->Take({ Child(node, lane).Index(), ~0u }); });
      this->TestElements();
    }
    if (this->IsMet)
    {
      this->List.insert(this->List.end(), this->Nodes.begin(), this->Nodes.end());
    }
    return this->IsMet;
  }

private:
  const Node<D>& Open(std::uint32_t node, bool wantsBoxes)
  {
    return OpenIn(this->TheTree, node, this->Room, wantsBoxes, 0);
  }

  static NarrowingLists& ThreadsLists()
  {
    thread_local NarrowingLists lists;
    return lists;
  }

  /// Elements found disjoint are dropped; untested ones are kept.
  void TestElements()
  {
    for (const CandidateLanes& lanes : this->Elements)
    {
      unsigned remaining = lanes.Lanes;
      if (!this->IsMet)
      {
        const auto& node = this->Open(lanes.Node, false);
        ForEachLane(lanes.Lanes,
          [&](int lane)
          {
            const auto position = node.First + static_cast<std::uint32_t>(lane);
            this->IsMet = this->IsMet || this->TheTest(this->TheTree.Element(position));
            remaining = this->IsMet ? remaining : remaining & ~(1u << lane);
          });
      }
      if (remaining != 0)
      {
        this->List.push_back({ lanes.Node, remaining });
      }
    }
    this->Elements.clear();
  }

  const Tree& TheTree;
  QueryBox<D> Outer;
  QueryBox<D> Inner;
  Test& TheTest;
  std::vector<CandidateLanes>& List;
  std::vector<CandidateLanes>& Elements;
  std::vector<CandidateLanes>& Nodes;
  Node<D> Room; ///< of a leaf that the tree does not store
  bool IsMet = false;
};

}

/// Whether an element meets `box`, given the list [first, last) of a box that it is a part of.
/// What is left for the parts of `box` in turn is appended to `list`: nothing if no element meets
/// it. `test(element)` decides: exactly, or always true, which takes the safety box for the element
/// ("blind" refinement); it is called only for elements whose boxes overlap `box`, and only as long
/// as it says no. The answer does not depend on the order of the list. Thread-safe; `test` must not
/// narrow candidates itself.
template <class Tree, int D, class Test>
bool NarrowCandidates(const Tree& tree, const CandidateLanes* first, const CandidateLanes* last,
  const Box<D>& box, Test test, std::vector<CandidateLanes>& list)
{
  if (tree.IsEmpty())
  {
    return false;
  }
  detail::Narrowing<Tree, D, Test> narrowing(tree, box, test, list);
  for (; first != last; ++first)
  {
    narrowing.Take(*first);
  }
  return narrowing.Settle();
}

/// Calls `visit(element)` for every element on a list whose box overlaps `box`.
template <class Tree, int D, class Visit>
void VisitCandidates(const Tree& tree, const CandidateLanes* first, const CandidateLanes* last,
  const Box<D>& box, Visit visit)
{
  const QueryBox<D> queryBox = OuterBox(tree.GetFrame(), box);
  thread_local std::vector<CandidateLanes> stack;
  stack.assign(first, last);
  Node<D> room;
  while (!tree.IsEmpty() && !stack.empty())
  {
    const CandidateLanes lanes = stack.back();
    stack.pop_back();
    const Node<D>& node = OpenIn(tree, lanes.Node, room, true, 0);
    ForEachLane(queryBox.Overlapping(node.Boxes) & lanes.Lanes & node.Occupied(),
      [&](int lane)
      {
        const Reference child = Child(node, lane);
        if (child.IsElement())
        {
          visit(tree.Element(child.Index()));
        }
        else
        {
          stack.push_back({ child.Index(), ~0u });
        }
      });
  }
}

}

#endif
