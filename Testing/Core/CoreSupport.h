// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What tests of trees share: trees of both kinds with capacities and loops that take turns, and
/// the elements that a walk of one reaches.
#ifndef coretest_CoreSupport_h
#define coretest_CoreSupport_h

#include "CoreAnswers.h"
#include "CoreDimensions.h"

#include "Core/Geometry/Distance/Distance.h"
#include "Core/Search/Tree/BuildLazyTree.h"
#include "Core/Search/Tree/BuildTree.h"
#include "Core/Search/Tree/Walk.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace coretest
{

/// From the last to the first.
struct ReversedLoop
{
  template <class Body>
  void operator()(std::size_t count, Body body) const
  {
    for (std::size_t i = count; i > 0; --i)
    {
      body(i - 1);
    }
  }
};

/// Four threads that take the next one left.
struct ThreadedLoop
{
  template <class Body>
  void operator()(std::size_t count, Body body) const
  {
    std::atomic<std::size_t> next{ 0 };
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread)
    {
      threads.emplace_back(
        [&]
        {
          for (std::size_t i = next++; i < count; i = next++)
          {
            body(i);
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }
};

template <int D>
skd::TreeInput<D> InputOf(const Boxes<D>& boxes, int capacity, double epsilon = 0.0)
{
  skd::TreeInput<D> input = skd::MakeTreeInput(boxes, epsilon);
  input.Capacity = capacity;
  return input;
}

template <int D>
skd::TreeInput<D> InputOf(const Boxes<D>& boxes, int capacity, skd::SplitRule rule)
{
  skd::TreeInput<D> input = InputOf(boxes, capacity);
  input.Rule = rule;
  return input;
}

/// `test(scene, tree)` for every scene of every size, on both kinds of tree, that built whole by
/// both rules; capacities take turns.
template <int D, class Test>
void ForEachTree(bool withUnsquarable, Test test)
{
  int turn = 0;
  for (const std::size_t count : Counts())
  {
    for (const Scene<D>& scene : AllScenes<D>(count, withUnsquarable))
    {
      const int capacity = 1 + turn++ % 8;
      SCOPED_TRACE(scene.Name + ", capacity " + std::to_string(capacity));
      test(scene, skd::BuildTree<D>(InputOf(scene.Boxes, capacity)));
      test(scene, skd::BuildTree<D>(InputOf(scene.Boxes, capacity, skd::SplitRule::SurfaceArea)));
      test(scene, skd::BuildLazyTree<D>(InputOf(scene.Boxes, capacity)));
      if (::testing::Test::HasFailure())
      {
        return;
      }
    }
  }
}

/// How far single precision may err in the world for a query that reaches `extent` world units
/// beyond the set: a few of its units in the last place, and the slack that covers them.
template <int D>
double FloatError(const skd::Frame<D>& frame, double extent = 0.0)
{
  return std::ldexp(1.0 / frame.Scale + extent, -20);
}

/// Elements that a query reaches. `make(visitor)` gives the query; the visitor returns `answer`
/// for each: whether to go on, or the limit.
template <class Answer, class Tree, class Make>
Ids Visited(const Tree& tree, Answer answer, Make make)
{
  Ids visited;
  auto visitor = [&](std::uint32_t element)
  {
    visited.push_back(element);
    return answer;
  };
  auto query = make(visitor);
  skd::Walk(tree, query);
  return visited;
}

/// A tree that counts how often a walk opens a node of it.
template <class Tree>
class CountedTree
{
public:
  explicit CountedTree(const Tree& tree)
    : TheTree(tree)
  {
  }

  bool IsEmpty() const { return this->TheTree.IsEmpty(); }
  const auto& Open(std::uint32_t node) const
  {
    ++this->Opened;
    return this->TheTree.Open(node);
  }
  void Fetch(std::uint32_t) const {}
  std::uint32_t Element(std::uint32_t position) const { return this->TheTree.Element(position); }
  const auto& GetFrame() const { return this->TheTree.GetFrame(); }
  const auto& GetBounds() const { return this->TheTree.GetBounds(); }

  mutable std::size_t Opened = 0;

private:
  const Tree& TheTree;
};

}

/// What most tests of trees need, compiled once (CoreSupport.cxx) rather than in each of them,
/// where it would take half of the time. `prefix`: extern, or nothing to compile it.
#define CORETEST_INSTANTIATE_TREES(prefix, D)                                                      \
  prefix template class skd::Tree<D>;                                                              \
  prefix template class skd::LazyTree<D>;                                                          \
  prefix template skd::Tree<D> skd::BuildTree<D>(skd::TreeInput<D> &&);                            \
  prefix template skd::LazyTree<D> skd::BuildLazyTree<D>(skd::TreeInput<D> &&)

CORETEST_INSTANTIATE_TREES(extern, 3);
#ifndef SKD_TEST_FEWER_KINDS
CORETEST_INSTANTIATE_TREES(extern, 2);
CORETEST_INSTANTIATE_TREES(extern, 6);
#endif

#endif
