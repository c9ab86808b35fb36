// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_BuildLazyTree_h
#define skd_Tree_BuildLazyTree_h

#include "ElementReader.h"
#include "Grower.h"
#include "LazyTree.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>

namespace skd
{

/// A Grower that splits one node at a time.
template <int D>
class GrowOnQuery : public NodesOnQuery<D>
{
public:
  /// `elements` as of Grower.
  template <class Source>
  GrowOnQuery(Source elements, int capacity)
    : Growing(std::move(elements), capacity)
    , Ranges(this->Growing.NumberOfNodes())
  {
    this->Ranges[0] = this->Growing.All();
    this->Nodes = &this->Growing.GetNode(0);
    this->Elements = this->Growing.GetElements();
    this->IsReady.reset(new std::atomic<bool>[this->Growing.NumberOfNodes()]());
  }

  std::size_t NumberOfNodes() const override { return this->Growing.NumberOfNodes(); }
  std::size_t NumberOfElements() const override { return this->Growing.NumberOfElements(); }
  std::size_t MemorySize() const override
  {
    return this->NumberOfNodes() * (sizeof(Node<D>) + sizeof(Range) + 1) +
      this->NumberOfElements() * (sizeof(Element<D>) + sizeof(std::uint32_t));
  }

private:
  using Task = typename Grower<D>::Task;
  using Range = typename Grower<D>::Range;

  void Split(std::uint32_t node) override
  {
    const std::lock_guard<std::mutex> lock(this->Locks[node % this->Locks.size()]);
    if (this->IsReady[node].load(std::memory_order_relaxed))
    {
      return;
    }
    std::array<Task, Node<D>::Width> stack;
    std::size_t top = 0;
    const auto push = [&](const Task& task) { stack[top++] = task; };
    this->Growing.Begin(node, this->Ranges[node], push);
    while (top > 0)
    {
      const Task task = stack[--top];
      this->Growing.Step(task, push,
        [this](std::uint32_t child, const Range& range) { this->Ranges[child] = range; });
    }
    this->IsReady[node].store(true, std::memory_order_release);
  }

  Grower<D> Growing;
  RawVector<Range> Ranges; // each is written before its node is opened
  std::array<std::mutex, 64> Locks;
};

/// A tree that is built by queries (Algorithm 3.2). O(N) here.
template <int D>
LazyTree<D> BuildLazyTree(TreeInput<D>&& input)
{
  return { input.Frame, input.Bounds,
    input.Elements.empty()
      ? nullptr
      : std::make_unique<GrowOnQuery<D>>(std::move(input.Elements), input.Capacity) };
}

/// The same for elements that are read when they are needed: each of them once before the first
/// query, without storing boxes (CoarseBins). `loop` as of TreeBuilder.
template <int D, class Loop>
LazyTree<D> BuildLazyTree(const ReadInput<D>& input, const Loop& loop)
{
  std::unique_ptr<NodesOnQuery<D>> nodes;
  if (input.Count > input.Few)
  {
    // Of each range a query needs a part alone, so that it pays to sort smaller ones coarsely.
    const std::size_t enough = std::min<std::size_t>(input.Few, 4096);
    nodes = std::make_unique<GrowOnQuery<D>>(
      std::make_unique<CoarseBins<D>>(input.Count, enough, input.Read, loop), input.Capacity);
  }
  else if (input.Count > 0)
  {
    nodes =
      std::make_unique<GrowOnQuery<D>>(ReadAll<D>(input.Read, input.Count, loop), input.Capacity);
  }
  return { input.Frame, input.Bounds, std::move(nodes) };
}

}

#endif
