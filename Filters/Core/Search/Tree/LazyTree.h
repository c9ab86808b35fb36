// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_LazyTree_h
#define skd_Tree_LazyTree_h

#include "Tree.h"

#include <array>
#include <memory>
#include <mutex>

namespace skd
{

/// Build-on-query (Algorithm 3.2): the same tree as Tree, with each node split when a traversal
/// first opens it. Only the part that queries visit is sorted. Thread-safe: the first thread splits
/// the node and others wait for it; a node that is split never changes.
template <int D>
class LazyTree
{
public:
  explicit LazyTree(TreeInput<D>&& input)
    : TheFrame(input.Frame)
    , TheBounds(input.Bounds)
  {
    if (!input.Elements.empty())
    {
      this->Growing = std::make_unique<Growth>(std::move(input.Elements), input.Capacity);
    }
  }

  /// The same for elements that are read when they are needed: each of them once before the first
  /// query, without storing boxes (CoarseBins). `loop` as in Tree.
  template <class Loop>
  LazyTree(const ReadInput<D>& input, Loop loop)
    : TheFrame(input.Frame)
    , TheBounds(input.Bounds)
  {
    if (input.Count > input.Few)
    {
      this->Growing = std::make_unique<Growth>(
        std::make_unique<CoarseBins<D>>(input.Count, input.Few, input.Read, loop), input.Capacity);
    }
    else if (input.Count > 0)
    {
      this->Growing =
        std::make_unique<Growth>(ReadAll<D>(input.Read, input.Count, loop), input.Capacity);
    }
  }

  bool IsEmpty() const { return !this->Growing; }

  const Node<D>& Open(std::uint32_t node) const
  {
    if (!this->Growing->IsReady[node].load(std::memory_order_acquire))
    {
      this->Growing->Split(node);
    }
    return this->Growing->Grower.GetNode(node);
  }

  /// Only for positions in opened leaves: others may still change.
  std::uint32_t Element(std::uint32_t position) const
  {
    return this->Growing->Grower.ElementAt(position);
  }

  const Frame<D>& GetFrame() const { return this->TheFrame; }
  const Box<D>& GetBounds() const { return this->TheBounds; }

  std::size_t NumberOfElements() const
  {
    return this->Growing ? this->Growing->Grower.NumberOfElements() : 0;
  }
  std::size_t NumberOfNodes() const
  {
    return this->Growing ? this->Growing->Grower.NumberOfNodes() : 0;
  }
  std::size_t MemorySize() const
  {
    return this->NumberOfNodes() * (sizeof(Node<D>) + sizeof(Range) + 1) +
      this->NumberOfElements() * (sizeof(skd::Element<D>) + sizeof(std::uint32_t));
  }

private:
  using Task = typename skd::Grower<D>::Task;
  using Range = typename skd::Grower<D>::Range;

  struct Growth
  {
    template <class Elements>
    Growth(Elements elements, int capacity)
      : Grower(std::move(elements), capacity)
      , IsReady(new std::atomic<bool>[this->Grower.NumberOfNodes()]())
      , Ranges(this->Grower.NumberOfNodes())
    {
      this->Ranges[0] = this->Grower.All();
    }

    void Split(std::uint32_t node)
    {
      const std::lock_guard<std::mutex> lock(this->Locks[node % this->Locks.size()]);
      if (this->IsReady[node].load(std::memory_order_relaxed))
      {
        return;
      }
      std::array<Task, Node<D>::Width> stack;
      std::size_t top = 0;
      const auto push = [&](const Task& task) { stack[top++] = task; };
      this->Grower.Begin(node, this->Ranges[node], push);
      while (top > 0)
      {
        const Task task = stack[--top];
        this->Grower.Step(task, push,
          [this](std::uint32_t child, const Range& range) { this->Ranges[child] = range; });
      }
      this->IsReady[node].store(true, std::memory_order_release);
    }

    skd::Grower<D> Grower;
    std::unique_ptr<std::atomic<bool>[]> IsReady;
    RawVector<Range> Ranges; // each is written before its node is opened
    std::array<std::mutex, 64> Locks;
  };

  Frame<D> TheFrame{};
  Box<D> TheBounds;
  std::unique_ptr<Growth> Growing;
};

}

#endif
