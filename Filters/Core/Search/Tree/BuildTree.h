// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_BuildTree_h
#define skd_Tree_BuildTree_h

#include "ElementReader.h"
#include "Grower.h"
#include "Tree.h"

#include <memory>
#include <vector>

namespace skd
{

/// Algorithm 3.1 by a Grower and a loop: `loop(count, body)` calls body(0) .. body(count - 1) in
/// any order, optionally in parallel.
template <int D, class Loop>
class TreeBuilder
{
public:
  TreeBuilder(Grower<D>& grower, const Loop& loop)
    : Growing(grower)
    , Run(loop)
  {
  }

  Tree<D> Build(const Frame<D>& frame, const Box<D>& bounds)
  {
    this->GrowAll();
    const LeafNumbers leaves{ this->Growing.GetCapacity(),
      static_cast<std::uint32_t>(this->Growing.NumberOfElements()), this->Growing.FirstBehind() };
    RawVector<std::uint32_t> elements = this->CopyElements();
    return Tree<D>(
      frame, bounds, this->Growing.Rule(), leaves, this->Growing.TakeNodes(), std::move(elements));
  }

private:
  using Task = typename Grower<D>::Task;
  using Range = typename Grower<D>::Range;

  /// Breadth first until there is work for every thread, then each piece to its end.
  void GrowAll()
  {
    constexpr std::size_t enough = 64;
    std::vector<Task> tasks;
    this->Growing.Begin(
      0, this->Growing.All(), [&tasks](const Task& task) { tasks.push_back(task); });
    while (!tasks.empty() && tasks.size() < enough)
    {
      std::vector<std::vector<Task>> made(tasks.size());
      this->Run(tasks.size(), [&](std::size_t i) { this->Advance(tasks[i], made[i]); });
      tasks.clear();
      for (const std::vector<Task>& some : made)
      {
        tasks.insert(tasks.end(), some.begin(), some.end());
      }
    }
    this->Run(tasks.size(), [&](std::size_t i) { this->Finish(tasks[i]); });
  }

  void Advance(const Task& task, std::vector<Task>& stack)
  {
    const auto push = [&stack](const Task& made) { stack.push_back(made); };
    this->Growing.Step(task, push,
      [&](std::uint32_t child, const Range& range) { this->Growing.Begin(child, range, push); });
  }

  void Finish(const Task& first)
  {
    std::vector<Task> stack{ first };
    while (!stack.empty())
    {
      const Task task = stack.back();
      stack.pop_back();
      this->Advance(task, stack);
    }
  }

  RawVector<std::uint32_t> CopyElements() const
  {
    constexpr std::size_t piece = 1 << 16;
    RawVector<std::uint32_t> elements(this->Growing.NumberOfElements());
    this->Run((elements.size() + piece - 1) / piece,
      [&](std::size_t i)
      {
        const std::size_t end = std::min(elements.size(), (i + 1) * piece);
        for (std::size_t position = i * piece; position < end; ++position)
        {
          elements[position] = this->Growing.ElementAt(static_cast<std::uint32_t>(position));
        }
      });
    return elements;
  }

  Grower<D>& Growing;
  const Loop& Run;
};

/// The rule of Automatic is chosen from a sample of the elements.
template <int D>
SplitRule RuleFor(const ReadInput<D>& input)
{
  if (input.Rule != SplitRule::Automatic)
  {
    return input.Rule;
  }
  const auto sample = ReadSample<D>(input.Read, input.Count, ElementSizes<D>::SampleSize);
  return ElementSizes<D>(sample, input.Count).Choose();
}

/// Builds a tree (Algorithm 3.1), O(N log N). `loop` as of TreeBuilder.
template <int D, class Loop>
Tree<D> BuildTree(TreeInput<D>&& input, const Loop& loop)
{
  if (input.Elements.empty())
  {
    return Tree<D>(input.Frame, input.Bounds);
  }
  Grower<D> grower(std::move(input.Elements), input.Capacity, input.Rule);
  return TreeBuilder<D, Loop>(grower, loop).Build(input.Frame, input.Bounds);
}

/// The same of elements that are read. Where many are divided at the median, they are first sorted
/// coarsely (CoarseBins): so threads share the work from the root on.
template <int D, class Loop>
Tree<D> BuildTree(const ReadInput<D>& input, const Loop& loop)
{
  if (input.Count == 0)
  {
    return Tree<D>(input.Frame, input.Bounds);
  }
  const SplitRule rule = RuleFor(input);
  if (rule == SplitRule::Median && input.Count > input.Few)
  {
    auto bins = std::make_unique<CoarseBins<D>>(input.Count, input.Few, input.Read, loop);
    Grower<D> grower(std::move(bins), input.Capacity);
    return TreeBuilder<D, Loop>(grower, loop).Build(input.Frame, input.Bounds);
  }
  Grower<D> grower(ReadAll<D>(input.Read, input.Count, loop), input.Capacity, rule);
  return TreeBuilder<D, Loop>(grower, loop).Build(input.Frame, input.Bounds);
}

template <int D>
Tree<D> BuildTree(TreeInput<D>&& input)
{
  return BuildTree(std::move(input), SerialLoop());
}

}

#endif
