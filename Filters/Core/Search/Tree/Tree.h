// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Tree_h
#define skd_Tree_Tree_h

#include "RawVector.h"
#include "SplitRule.h"
#include "TreeView.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace skd
{

/// The skD-tree for queries: immutable and thread-safe. BuildTree makes one at once
/// (Algorithm 3.1). About 36 bytes an element in three dimensions, 8 without leaves.
template <int D>
class Tree
{
public:
  Tree() = default;
  /// Without elements.
  Tree(const Frame<D>& frame, const Box<D>& bounds)
    : TheFrame(frame)
    , TheBounds(bounds)
  {
  }

  /// Of what BuildTree has made.
  Tree(const Frame<D>& frame, const Box<D>& bounds, SplitRule rule, const LeafNumbers& leaves,
    RawVector<Node<D>>&& nodes, RawVector<std::uint32_t>&& elements)
    : TheFrame(frame)
    , TheBounds(bounds)
    , TheRule(rule)
    , Leaves(leaves)
    , AllNodes(nodes.size())
    , Nodes(std::move(nodes))
    , Elements(std::move(elements))
  {
  }

  bool IsEmpty() const { return this->Nodes.empty(); }
  const Node<D>& Open(std::uint32_t node) const { return this->Nodes[node]; }
  ///@{
  /// See Node::Tag and Node::Note. Before anyone walks the tree.
  void SetTag(std::uint32_t node, std::uint32_t tag) { this->Nodes[node].Tag = tag; }
  template <class T>
  void SetNote(std::uint32_t node, const T& note)
  {
    this->Nodes[node].Write(note);
  }
  ///@}
  void Fetch(std::uint32_t node) const { FetchLines<sizeof(Node<D>)>(&this->Nodes[node]); }
  std::uint32_t Element(std::uint32_t position) const { return this->Elements[position]; }

  ///@{
  /// The number of a leaf, in the order of the elements; its elements.
  std::uint32_t NumberOf(const Node<D>& leaf) const { return leaf.First / this->Leaves.Capacity; }
  ElementRange LeafAt(std::uint32_t number) const { return this->Leaves.At(number); }
  /// See KnownLeaves.
  KnownLeaves LeavesBelow(const Node<D>& inner) const
  {
    KnownLeaves known;
    for (std::uint32_t lane = 0; lane < Node<D>::Width; ++lane)
    {
      const std::uint32_t child = inner.First + lane;
      known.Entries[lane] = lane < inner.Count && this->Nodes[child].IsLeaf
        ? this->NumberOf(this->Nodes[child]) | KnownLeaves::Mark
        : child;
    }
    return known;
  }
  void FetchElements(std::uint32_t position) const
  {
    FetchLines<1>(this->Elements.data() + position);
  }
  /// Frees the memory of the leaves that have only leaves beside them, for queries that find these
  /// by their numbers (CompactTree). The notes of inner nodes are KnownLeaves.
  void DropLeaves()
  {
    const std::uint32_t first = this->Leaves.FirstBehind;
    this->Nodes.erase(this->Nodes.begin() + first, this->Nodes.end());
    this->Nodes.shrink_to_fit();
    for (Node<D>& node : this->Nodes)
    {
      if (!node.IsLeaf && node.First >= first)
      {
        node.First = first + node.template Read<KnownLeaves>().NumberOf(0);
      }
    }
  }
  /// Then: where the owner has more of each leaf, dataOf(number), which rises (KnownLeaves).
  template <class DataOf>
  void NoteData(const DataOf& dataOf)
  {
    for (Node<D>& node : this->Nodes)
    {
      if (!node.IsLeaf)
      {
        auto known = node.template Read<KnownLeaves>();
        known.NoteData(dataOf);
        node.Write(known);
      }
    }
  }
  ///@}

  TreeView<D> View() const
  {
    return { this->TheFrame, this->TheBounds, this->IsEmpty() ? nullptr : this->Nodes.data(),
      this->Elements.data(), this->Leaves };
  }

  const Frame<D>& GetFrame() const { return this->TheFrame; }
  const Box<D>& GetBounds() const { return this->TheBounds; }

  std::size_t NumberOfElements() const { return this->Elements.size(); }
  /// With those that are dropped.
  std::size_t NumberOfNodes() const { return this->AllNodes; }
  /// Levels of nodes, that of the root and the lowest counted. O(nodes).
  int Depth() const { return this->IsEmpty() ? 0 : this->DepthFrom(0); }
  /// The rule that was used: never Automatic.
  SplitRule Rule() const { return this->TheRule; }
  std::size_t MemorySize() const
  {
    return this->Nodes.capacity() * sizeof(Node<D>) +
      this->Elements.capacity() * sizeof(std::uint32_t);
  }

private:
  int DepthFrom(std::uint32_t index) const
  {
    if (index >= this->Nodes.size()) // a leaf that was dropped
    {
      return 1;
    }
    const Node<D>& node = this->Nodes[index];
    int below = 0;
    for (std::uint32_t lane = 0; lane < node.Count && !node.IsLeaf; ++lane)
    {
      below = std::max(below, this->DepthFrom(node.First + lane));
    }
    return below + 1;
  }

  Frame<D> TheFrame{};
  Box<D> TheBounds;
  SplitRule TheRule = SplitRule::Median;
  LeafNumbers Leaves{ 1, 0, 0 };
  std::size_t AllNodes = 0;
  RawVector<Node<D>> Nodes;
  RawVector<std::uint32_t> Elements;
};

}

#endif
