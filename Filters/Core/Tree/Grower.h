// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Grower_h
#define skd_Tree_Grower_h

#include "Node.h"
#include "RawVector.h"
#include "SplitAtRank.h"

#include <atomic>
#include <map>
#include <vector>

namespace skd
{

/// The splitting of Algorithms 3.1 and 3.2, carried to eight children a node: the range of a node
/// is halved at the median of the centroids along the longest axis of its box, each half again,
/// and again. Medians are rounded to whole bottom nodes, so that these are full; N alone decides
/// the shape of the tree. Centroids that are equal are told apart by index: the same tree always,
/// and the same depth however many are equal.
///
///   Begin(node)            Step              Step               Step -> a box in each lane
///   [ . . . . . . . . ]    [ . . . .|. . . . ]  [ . .|. .|. .|. . ]  [.|.|.|.|.|.|.|.]
///
/// Different tasks touch different elements and nodes: they may run in parallel.
template <int D>
class Grower
{
public:
  /// A contiguous piece of the elements, and their common box.
  struct Range
  {
    std::uint32_t First;
    std::uint32_t Last;
    FloatBox<D> Box;
  };

  /// Elements still to be divided among some lanes of a node.
  struct Task
  {
    std::uint32_t Node;
    int Lane;
    int Parts;
    Range Elements;
  };

  Grower(RawVector<Element<D>>&& elements, int capacity)
    : Elements(std::move(elements))
    , Capacity(static_cast<std::uint32_t>(std::clamp(capacity, 1, Node<D>::Width)))
    , Nodes(CountNodes(this->CountBottoms(this->Elements.size())))
  {
  }

  Range All() const
  {
    const auto last = static_cast<std::uint32_t>(this->Elements.size());
    return { 0, last, this->Union(0, last) };
  }

  /// Make `node` the node of a range: a bottom node at once, an inner one by a task to be pushed.
  template <class Push>
  void Begin(std::uint32_t node, const Range& range, Push push)
  {
    Node<D>& made = this->Nodes[node];
    made.Boxes.Clear();
    made.Tag = Node<D>::NoTag;
    const std::uint64_t bottoms = this->CountBottoms(range.Last - range.First);
    made.IsBottom = bottoms <= 1;
    if (made.IsBottom)
    {
      this->FillBottom(made, range);
      return;
    }
    made.Count = static_cast<std::uint16_t>(CountChildren(bottoms));
    made.First = this->Next.fetch_add(made.Count);
    push(Task{ node, 0, made.Count, range });
  }

  /// One median split, or the end of a task: a lane gets its box and `descend(child, range)` is
  /// told which elements are below it.
  template <class Push, class Descend>
  void Step(const Task& task, Push push, Descend descend)
  {
    if (task.Parts == 1)
    {
      Node<D>& parent = this->Nodes[task.Node];
      parent.Boxes.Set(task.Lane, task.Elements.Box);
      descend(parent.First + static_cast<std::uint32_t>(task.Lane), task.Elements);
      return;
    }
    const int leftParts = (task.Parts + 1) / 2;
    const std::uint32_t middle = this->SplitAtMedian(task, leftParts);
    const Range& range = task.Elements;
    push(Task{
      task.Node, task.Lane, leftParts, { range.First, middle, this->Union(range.First, middle) } });
    push(Task{ task.Node, task.Lane + leftParts, task.Parts - leftParts,
      { middle, range.Last, this->Union(middle, range.Last) } });
  }

  const Node<D>& GetNode(std::uint32_t node) const { return this->Nodes[node]; }
  std::uint32_t ElementAt(std::uint32_t position) const { return this->Elements[position].Index; }
  std::size_t NumberOfNodes() const { return this->Nodes.size(); }
  std::size_t NumberOfElements() const { return this->Elements.size(); }

  RawVector<Node<D>> TakeNodes() { return std::move(this->Nodes); }

private:
  static constexpr std::uint64_t Width = Node<D>::Width;

  std::uint64_t CountBottoms(std::uint64_t elements) const
  {
    return (elements + this->Capacity - 1) / this->Capacity;
  }

  /// As few children as keep the height least.
  static std::uint64_t CountChildren(std::uint64_t bottoms)
  {
    std::uint64_t below = 1;
    while (below * Width < bottoms)
    {
      below *= Width;
    }
    return (bottoms + below - 1) / below;
  }

  /// Level by level: how many nodes there are for each number of bottoms below a node.
  static std::size_t CountNodes(std::uint64_t bottoms)
  {
    std::size_t total = 0;
    std::map<std::uint64_t, std::uint64_t> level;
    if (bottoms > 0)
    {
      level[bottoms] = 1;
    }
    while (!level.empty())
    {
      std::map<std::uint64_t, std::uint64_t> below;
      for (const auto& [size, number] : level)
      {
        total += number;
        AddChildren(size, number, below);
      }
      level.swap(below);
    }
    return total;
  }

  static void AddChildren(
    std::uint64_t bottoms, std::uint64_t number, std::map<std::uint64_t, std::uint64_t>& below)
  {
    if (bottoms <= 1)
    {
      return;
    }
    AddParts(bottoms, static_cast<int>(CountChildren(bottoms)), number, below);
  }

  static void AddParts(std::uint64_t bottoms, int parts, std::uint64_t number,
    std::map<std::uint64_t, std::uint64_t>& below)
  {
    if (parts == 1)
    {
      below[bottoms] += number;
      return;
    }
    const int leftParts = (parts + 1) / 2;
    const std::uint64_t left = LeftBottoms(bottoms, leftParts, parts);
    AddParts(left, leftParts, number, below);
    AddParts(bottoms - left, parts - leftParts, number, below);
  }

  static std::uint64_t LeftBottoms(std::uint64_t bottoms, int leftParts, int parts)
  {
    return bottoms * static_cast<std::uint64_t>(leftParts) / static_cast<std::uint64_t>(parts);
  }

  FloatBox<D> Union(std::uint32_t first, std::uint32_t last) const
  {
    FloatBox<D> box = this->Elements[first].Box;
    for (std::uint32_t position = first + 1; position < last; ++position)
    {
      const FloatBox<D>& other = this->Elements[position].Box;
      for (int axis = 0; axis < D; ++axis)
      {
        box.Min[axis] = std::min(box.Min[axis], other.Min[axis]);
        box.Max[axis] = std::max(box.Max[axis], other.Max[axis]);
      }
    }
    return box;
  }

  void FillBottom(Node<D>& bottom, const Range& range)
  {
    bottom.First = range.First;
    bottom.Count = static_cast<std::uint16_t>(range.Last - range.First);
    for (int lane = 0; lane < bottom.Count; ++lane)
    {
      bottom.Boxes.Set(lane, this->Elements[range.First + static_cast<std::uint32_t>(lane)].Box);
    }
  }

  static int LongestAxis(const FloatBox<D>& box)
  {
    int longest = 0;
    for (int axis = 1; axis < D; ++axis)
    {
      if (box.Max[axis] - box.Min[axis] > box.Max[longest] - box.Min[longest])
      {
        longest = axis;
      }
    }
    return longest;
  }

  std::uint32_t SplitAtMedian(const Task& task, int leftParts)
  {
    const Range& range = task.Elements;
    const std::uint64_t bottoms = this->CountBottoms(range.Last - range.First);
    const std::uint32_t middle = range.First +
      static_cast<std::uint32_t>(LeftBottoms(bottoms, leftParts, task.Parts)) * this->Capacity;
    Element<D>* const elements = this->Elements.data();
    SplitAtRank<D>::Run(
      elements + range.First, elements + middle, elements + range.Last, LongestAxis(range.Box));
    return middle;
  }

  RawVector<Element<D>> Elements;
  std::uint32_t Capacity;
  RawVector<Node<D>> Nodes; // each is written whole when it is begun
  std::atomic<std::uint32_t> Next{ 1 };
};

}

#endif
