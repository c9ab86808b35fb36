// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_TreeView_h
#define skd_Tree_TreeView_h

#include "Frame.h"
#include "Node.h"

namespace skd
{

/// What a walk sees of a tree that is built whole (Tree), which it must not outlive.
template <int D>
class TreeView
{
public:
  TreeView(const Frame<D>& frame, const Box<D>& bounds, const Node<D>* nodes,
    const std::uint32_t* elements)
    : TheFrame(frame)
    , TheBounds(bounds)
    , Nodes(nodes)
    , Elements(elements)
  {
  }

  bool IsEmpty() const { return this->Nodes == nullptr; }
  const Node<D>& Open(std::uint32_t node) const { return this->Nodes[node]; }
  void Fetch(std::uint32_t node) const { FetchLines<sizeof(Node<D>)>(this->Nodes + node); }
  std::uint32_t Element(std::uint32_t position) const { return this->Elements[position]; }
  const Frame<D>& GetFrame() const { return this->TheFrame; }
  const Box<D>& GetBounds() const { return this->TheBounds; }

private:
  Frame<D> TheFrame;
  Box<D> TheBounds;
  const Node<D>* Nodes;
  const std::uint32_t* Elements;
};

}

#endif
