// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Tree_h
#define skd_Tree_Tree_h

#include "Grower.h"
#include "TreeView.h"

namespace skd
{

/// What a tree is built from. Boxes are safety boxes in the frame; at most
/// MaximumNumberOfElements of them, all finite.
template <int D>
struct TreeInput
{
  skd::Frame<D> Frame;
  Box<D> Bounds; ///< the safety box of all, in the world
  RawVector<Element<D>> Elements;
  int Capacity = Node<D>::Width;      ///< elements a leaf, clamped to 1 .. Node<D>::Width
  SplitRule Rule = SplitRule::Median; ///< LazyTree knows the median only
};

/// The same of elements that are read when they are needed, and as often: `Read` must stay good as
/// long as the tree.
template <int D>
struct ReadInput
{
  skd::Frame<D> Frame;
  Box<D> Bounds;
  std::uint32_t Count = 0;
  ElementReader<D> Read;
  int Capacity = Node<D>::Width;
  SplitRule Rule = SplitRule::Median;   ///< LazyTree knows the median only
  std::size_t Few = CoarseBins<D>::Few; ///< so few elements are all read at once
};

/// The frame, the bounds and the elements of a set of boxes, inflated by 2 epsilon (section 3.1).
template <int D>
TreeInput<D> MakeTreeInput(const std::vector<Box<D>>& boxes, double epsilon)
{
  TreeInput<D> input;
  for (const Box<D>& box : boxes)
  {
    input.Bounds.Add(box.Inflated(2.0 * epsilon));
  }
  input.Frame = Frame<D>::Of(input.Bounds);
  input.Elements.reserve(boxes.size());
  for (const Box<D>& box : boxes)
  {
    const auto index = static_cast<std::uint32_t>(input.Elements.size());
    input.Elements.push_back({ input.Frame.Outward(box.Inflated(2.0 * epsilon)), index });
  }
  return input;
}

/// Runs the bodies of a loop sequentially; pass another loop to run them in parallel.
struct SerialLoop
{
  template <class Body>
  void operator()(std::size_t count, Body body) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      body(i);
    }
  }
};

/// The skD-tree for queries: built at once (Algorithm 3.1), then immutable and thread-safe. O(N log
/// N) to build, about 32 bytes an element in three dimensions.
template <int D>
class Tree
{
public:
  Tree() = default;

  /// `loop(count, body)` calls body(0) .. body(count - 1) in any order, optionally in parallel.
  template <class Loop>
  Tree(TreeInput<D>&& input, Loop loop)
    : TheFrame(input.Frame)
    , TheBounds(input.Bounds)
  {
    if (input.Elements.empty())
    {
      return;
    }
    this->Grow(skd::Grower<D>(std::move(input.Elements), input.Capacity, input.Rule), loop);
  }

  /// The same of elements that are read. Where many are divided at the median, they are first
  /// sorted coarsely (CoarseBins): so threads share the work from the root on.
  template <class Loop>
  Tree(const ReadInput<D>& input, Loop loop)
    : TheFrame(input.Frame)
    , TheBounds(input.Bounds)
  {
    if (input.Count == 0)
    {
      return;
    }
    const SplitRule rule = RuleFor(input);
    if (rule == SplitRule::Median && input.Count > input.Few)
    {
      auto bins = std::make_unique<CoarseBins<D>>(input.Count, input.Few, input.Read, loop);
      this->Grow(skd::Grower<D>(std::move(bins), input.Capacity), loop);
      return;
    }
    this->Grow(
      skd::Grower<D>(ReadAll<D>(input.Read, input.Count, loop), input.Capacity, rule), loop);
  }

  explicit Tree(TreeInput<D>&& input)
    : Tree(std::move(input), SerialLoop())
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
  /// See KnownLeaves. Of a node high above, only the first children are returned.
  KnownLeaves LeavesBelow(const Node<D>& inner) const
  {
    KnownLeaves known{ this->FirstLeaf(inner.First), {}, 0 };
    for (std::uint32_t lane = 0; lane < inner.Count; ++lane)
    {
      const std::uint32_t beyond = this->FirstLeaf(inner.First + lane) - known.Number;
      if (beyond <= std::numeric_limits<std::uint16_t>::max() &&
        this->Nodes[inner.First + lane].IsLeaf)
      {
        known.Lanes |= static_cast<std::uint8_t>(1u << lane);
        known.Beyond[lane > 0 ? lane - 1 : 0] = static_cast<std::uint16_t>(beyond);
      }
    }
    return known;
  }
  void FetchElements(std::uint32_t position) const
  {
    FetchLines<1>(this->Elements.data() + position);
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
  std::size_t NumberOfNodes() const { return this->Nodes.size(); }
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
  using Task = typename skd::Grower<D>::Task;
  using Range = typename skd::Grower<D>::Range;

  static SplitRule RuleFor(const ReadInput<D>& input)
  {
    if (input.Rule != SplitRule::Automatic)
    {
      return input.Rule;
    }
    const auto sample = ReadSample<D>(input.Read, input.Count, ElementSizes<D>::SampleSize);
    return ElementSizes<D>(sample, input.Count).Choose();
  }

  template <class Loop>
  void Grow(skd::Grower<D>&& grower, Loop& loop)
  {
    this->TheRule = grower.Rule();
    this->Leaves = { static_cast<std::uint32_t>(grower.GetCapacity()),
      static_cast<std::uint32_t>(grower.NumberOfElements()) };
    GrowAll(grower, loop);
    this->CopyElements(grower, loop);
    this->Nodes = grower.TakeNodes();
  }

  /// Breadth first until there is work for every thread, then each piece to its end.
  template <class Loop>
  static void GrowAll(skd::Grower<D>& grower, Loop& loop)
  {
    constexpr std::size_t enough = 64;
    std::vector<Task> tasks;
    grower.Begin(0, grower.All(), [&tasks](const Task& task) { tasks.push_back(task); });
    while (!tasks.empty() && tasks.size() < enough)
    {
      std::vector<std::vector<Task>> made(tasks.size());
      loop(tasks.size(), [&](std::size_t i) { Advance(grower, tasks[i], made[i]); });
      tasks.clear();
      for (const std::vector<Task>& some : made)
      {
        tasks.insert(tasks.end(), some.begin(), some.end());
      }
    }
    loop(tasks.size(), [&](std::size_t i) { Finish(grower, tasks[i]); });
  }

  static void Advance(skd::Grower<D>& grower, const Task& task, std::vector<Task>& stack)
  {
    const auto push = [&stack](const Task& made) { stack.push_back(made); };
    grower.Step(task, push,
      [&](std::uint32_t child, const Range& range) { grower.Begin(child, range, push); });
  }

  static void Finish(skd::Grower<D>& grower, const Task& first)
  {
    std::vector<Task> stack{ first };
    while (!stack.empty())
    {
      const Task task = stack.back();
      stack.pop_back();
      Advance(grower, task, stack);
    }
  }

  template <class Loop>
  void CopyElements(const skd::Grower<D>& grower, Loop& loop)
  {
    constexpr std::size_t piece = 1 << 16;
    this->Elements.resize(grower.NumberOfElements());
    loop((this->Elements.size() + piece - 1) / piece,
      [&](std::size_t i)
      {
        const std::size_t end = std::min(this->Elements.size(), (i + 1) * piece);
        for (std::size_t position = i * piece; position < end; ++position)
        {
          this->Elements[position] = grower.ElementAt(static_cast<std::uint32_t>(position));
        }
      });
  }

  std::uint32_t FirstLeaf(std::uint32_t index) const
  {
    while (!this->Nodes[index].IsLeaf)
    {
      index = this->Nodes[index].First;
    }
    return this->NumberOf(this->Nodes[index]);
  }

  int DepthFrom(std::uint32_t index) const
  {
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
  LeafNumbers Leaves{ 1, 0 };
  RawVector<Node<D>> Nodes;
  RawVector<std::uint32_t> Elements;
};

}

#endif
