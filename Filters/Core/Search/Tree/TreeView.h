// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_TreeView_h
#define skd_Tree_TreeView_h

#include "Frame.h"
#include "Node.h"

namespace skd
{

struct ElementRange
{
  std::uint32_t First;
  std::uint32_t Count;
};

/// All leaves except the last are full: their numbers give their elements.
struct LeafNumbers
{
  std::uint32_t Capacity;
  std::uint32_t NumberOfElements;
  /// From this index on all nodes are leaves that have only leaves beside them. Once they are
  /// dropped (Tree::DropLeaves), it is that of the leaf of number 0.
  std::uint32_t FirstBehind;

  ElementRange At(std::uint32_t number) const
  {
    const std::uint32_t first = number * this->Capacity;
    return { first, std::min(this->Capacity, this->NumberOfElements - first) };
  }
};

/// A read-only view of a Tree, which must outlive it.
template <int D>
class TreeView
{
public:
  TreeView() = default; ///< of an empty tree
  TreeView(const Frame<D>& frame, const Box<D>& bounds, const Node<D>* nodes,
    const std::uint32_t* elements, const LeafNumbers& leaves)
    : TheFrame(frame)
    , TheBounds(bounds)
    , Nodes(nodes)
    , Elements(elements)
    , Leaves(leaves)
  {
  }

  bool IsEmpty() const { return this->Nodes == nullptr; }
  const Node<D>& Open(std::uint32_t node) const { return this->Nodes[node]; }
  void Fetch(std::uint32_t node) const { FetchLines<sizeof(Node<D>)>(this->Nodes + node); }
  std::uint32_t Element(std::uint32_t position) const { return this->Elements[position]; }
  ElementRange LeafAt(std::uint32_t number) const { return this->Leaves.At(number); }
  void FetchElements(std::uint32_t position) const { FetchLines<1>(this->Elements + position); }
  const Frame<D>& GetFrame() const { return this->TheFrame; }
  const Box<D>& GetBounds() const { return this->TheBounds; }

protected:
  const LeafNumbers& GetLeaves() const { return this->Leaves; }

private:
  Frame<D> TheFrame{};
  Box<D> TheBounds;
  const Node<D>* Nodes = nullptr;
  const std::uint32_t* Elements = nullptr;
  LeafNumbers Leaves{ 1, 0, 0 };
};

}

#endif
