// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_LazyTree_h
#define skd_Tree_LazyTree_h

#include "Element.h"
#include "Node.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace skd
{

/// Nodes that are split when they are first opened.
template <int D>
class NodesOnQuery
{
public:
  virtual ~NodesOnQuery() = default;
  NodesOnQuery(const NodesOnQuery&) = delete;
  NodesOnQuery& operator=(const NodesOnQuery&) = delete;

  /// Thread-safe: the first thread splits the node and others wait for it; a node that is split
  /// never changes.
  const Node<D>& Open(std::uint32_t node)
  {
    if (!this->IsReady[node].load(std::memory_order_acquire))
    {
      this->Split(node);
    }
    return this->Nodes[node];
  }
  std::uint32_t ElementAt(std::uint32_t position) const { return this->Elements[position].Index; }

  virtual std::size_t NumberOfNodes() const = 0;
  virtual std::size_t NumberOfElements() const = 0;
  virtual std::size_t MemorySize() const = 0;

protected:
  NodesOnQuery() = default;
  virtual void Split(std::uint32_t node) = 0;

  const Node<D>* Nodes = nullptr;
  const Element<D>* Elements = nullptr;
  std::unique_ptr<std::atomic<bool>[]> IsReady; // by nodes
};

/// Build-on-query (Algorithm 3.2): the same tree as Tree, with each node split when a traversal
/// first opens it. Only the part that queries visit is sorted. Thread-safe: the first thread splits
/// the node and others wait for it; a node that is split never changes.
template <int D>
class LazyTree
{
public:
  LazyTree() = default;
  LazyTree(const Frame<D>& frame, const Box<D>& bounds, std::unique_ptr<NodesOnQuery<D>> nodes)
    : TheFrame(frame)
    , TheBounds(bounds)
    , Nodes(std::move(nodes))
  {
  }

  bool IsEmpty() const { return !this->Nodes; }

  const Node<D>& Open(std::uint32_t node) const { return this->Nodes->Open(node); }
  void Fetch(std::uint32_t) const {} ///< it may not be there yet

  /// Only for positions in opened leaves: others may still change.
  std::uint32_t Element(std::uint32_t position) const { return this->Nodes->ElementAt(position); }

  const Frame<D>& GetFrame() const { return this->TheFrame; }
  const Box<D>& GetBounds() const { return this->TheBounds; }

  std::size_t NumberOfElements() const { return this->Nodes ? this->Nodes->NumberOfElements() : 0; }
  std::size_t NumberOfNodes() const { return this->Nodes ? this->Nodes->NumberOfNodes() : 0; }
  std::size_t MemorySize() const { return this->Nodes ? this->Nodes->MemorySize() : 0; }

private:
  Frame<D> TheFrame{};
  Box<D> TheBounds;
  std::unique_ptr<NodesOnQuery<D>> Nodes; // none of no elements
};

}

#endif
