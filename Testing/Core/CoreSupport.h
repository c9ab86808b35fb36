// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of the core share: the dimensions, trees of both kinds with capacities and loops
/// that take turns, and what is expected of the elements that a walk reached.
#ifndef coretest_CoreSupport_h
#define coretest_CoreSupport_h

#include "CoreScenes.h"

#include "Core/Geometry/Distance/Distance.h"
#include "Core/Search/Tree/BuildLazyTree.h"
#include "Core/Search/Tree/BuildTree.h"
#include "Core/Search/Tree/Walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <thread>

namespace coretest
{

template <int D>
struct Dimension
{
  static constexpr int Value = D;
};

#ifdef SKD_TEST_FEWER_KINDS
using Dimensions = ::testing::Types<Dimension<3>>;
#else
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>, Dimension<6>>;
#endif

struct DimensionNames
{
  template <class Type>
  static std::string GetName(int)
  {
    return "D" + std::to_string(Type::Value);
  }
};

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

/// The numbers of elements at which the shape of a tree of eights changes, and a larger one.
inline const std::vector<std::size_t>& Counts()
{
  static const std::vector<std::size_t> counts{ 0, 1, 2, 7, 8, 9, 63, 64, 65, 513, 5000 };
  return counts;
}

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

using Ids = std::vector<std::uint32_t>;

/// The elements of a scene for which `isWanted(box)`.
template <int D, class Predicate>
Ids Select(const Boxes<D>& boxes, Predicate isWanted)
{
  Ids ids;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (isWanted(boxes[i]))
    {
      ids.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return ids;
}

inline Ids Sorted(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// Each once at most, every one of `must`, and none that is not in `may`.
inline void ExpectVisited(const Ids& visited, const Ids& must, const Ids& may)
{
  const Ids got = Sorted(visited);
  EXPECT_TRUE(std::adjacent_find(got.begin(), got.end()) == got.end()) << "reached twice";
  Ids missed;
  std::set_difference(must.begin(), must.end(), got.begin(), got.end(), std::back_inserter(missed));
  EXPECT_TRUE(missed.empty()) << missed.size() << " of " << must.size()
                              << " missed, one of them: " << missed.front();
  Ids needless;
  std::set_difference(got.begin(), got.end(), may.begin(), may.end(), std::back_inserter(needless));
  EXPECT_TRUE(needless.empty()) << needless.size() << " of " << got.size()
                                << " reached needlessly, one of them: " << needless.front();
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
  prefix template skd::LazyTree<D> skd::BuildLazyTree<D>(skd::TreeInput<D> &&);                    \
  prefix template std::vector<coretest::Scene<D>> coretest::AllScenes<D>(std::size_t, bool)

CORETEST_INSTANTIATE_TREES(extern, 3);
#ifndef SKD_TEST_FEWER_KINDS
CORETEST_INSTANTIATE_TREES(extern, 2);
CORETEST_INSTANTIATE_TREES(extern, 6);
#endif

#endif
