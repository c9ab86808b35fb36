// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Grower_h
#define skd_Tree_Grower_h

#include "AreaSplit.h"
#include "CoarseBins.h"
#include "ElementSizes.h"
#include "Node.h"
#include "RawVector.h"
#include "SplitAtRank.h"

#include <atomic>
#include <map>
#include <memory>
#include <vector>

namespace skd
{

/// The splitting of Algorithms 3.1 and 3.2 with eight children a node: the range of a node is
/// halved at the median of the centroids along the longest axis of its box, three times. Medians
/// are rounded to full leaves, so that N alone determines the shape of the tree. Ties between
/// centroids are broken by index: the tree is reproducible, and its depth does not depend on ties.
///
/// With SplitRule::SurfaceArea ranges are divided by AreaSplit, also at full leaves. Then the
/// elements determine the shape, and the tree has at most one level more.
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
    std::uint32_t Height; ///< there may be so many levels below its node
    bool IsInBins;        ///< its elements are not yet in place
  };

  /// Elements still to be divided among some lanes of a node.
  struct Task
  {
    std::uint32_t Node;
    int Lane;
    int Shares;
    Range Elements;
  };

  Grower(RawVector<Element<D>>&& elements, int capacity, SplitRule rule = SplitRule::Median)
    : Elements(std::move(elements))
    , Capacity(static_cast<std::uint32_t>(std::clamp(capacity, 1, Node<D>::Width)))
    , IsByArea(RuleFor(rule, this->Elements) == SplitRule::SurfaceArea)
    , Nodes(this->MostNodes())
  {
  }

  /// By the median, too, of elements that are coarsely sorted.
  Grower(std::unique_ptr<CoarseBins<D>> bins, int capacity)
    : Grower(RawVector<Element<D>>(bins->Size()), capacity)
  {
    this->Bins = std::move(bins);
  }

  Range All() const
  {
    const auto last = static_cast<std::uint32_t>(this->Elements.size());
    const std::uint32_t height = HeightFor(this->CountLeaves(last));
    return this->Bins ? Range{ 0, last, this->Bins->Box(), height, true }
                      : Range{ 0, last, this->Union(0, last), height, false };
  }

  /// Make `node` the node of a range: a leaf at once, an inner one by a task to be pushed.
  template <class Push>
  void Begin(std::uint32_t node, Range range, Push push)
  {
    const std::uint32_t size = range.Last - range.First;
    const std::uint64_t leaves = this->CountLeaves(size);
    if (range.IsInBins && (leaves <= 1 || this->Bins->IsDone(range.First, size)))
    {
      this->Bins->Take(range.First, this->Elements.data() + range.First);
      range.IsInBins = false;
    }
    Node<D>& made = this->Nodes[node];
    made.Boxes.Clear();
    made.Tag = Node<D>::NoTag;
    made.IsLeaf = leaves <= 1;
    if (made.IsLeaf)
    {
      this->FillLeaf(made, range);
      return;
    }
    made.SetCount(
      static_cast<std::uint32_t>(this->IsByArea ? std::min(Width, leaves) : CountChildren(leaves)));
    made.First = this->PlaceOfChildren(made.Count, leaves);
    push(Task{ node, 0, made.Count, range });
  }

  /// One median split, or the end of a task: a lane gets its box and `descend(child, range)` is
  /// given the elements below it.
  template <class Push, class Descend>
  void Step(const Task& task, Push push, Descend descend)
  {
    if (task.Shares == 1)
    {
      Node<D>& parent = this->Nodes[task.Node];
      parent.Boxes.Set(task.Lane, task.Elements.Box);
      Range below = task.Elements;
      --below.Height;
      descend(parent.First + static_cast<std::uint32_t>(task.Lane), below);
      return;
    }
    const int leftShares = (task.Shares + 1) / 2;
    const Halves halves = this->Split(task, leftShares);
    push(Task{ task.Node, task.Lane, leftShares, halves.Left });
    push(Task{ task.Node, task.Lane + leftShares, task.Shares - leftShares, halves.Right });
  }

  const Node<D>& GetNode(std::uint32_t node) const { return this->Nodes[node]; }
  std::uint32_t ElementAt(std::uint32_t position) const { return this->Elements[position].Index; }
  const Element<D>* GetElements() const { return this->Elements.data(); }
  std::size_t NumberOfNodes() const { return this->Nodes.size(); }
  std::size_t NumberOfElements() const { return this->Elements.size(); }

  std::uint32_t GetCapacity() const { return this->Capacity; }
  SplitRule Rule() const { return this->IsByArea ? SplitRule::SurfaceArea : SplitRule::Median; }

  ///@{
  /// When all tasks are done. From that index on lie the leaves that have only leaves beside them.
  std::uint32_t FirstBehind() const { return this->Next; }
  RawVector<Node<D>> TakeNodes()
  {
    this->CloseGap();
    return std::move(this->Nodes);
  }
  ///@}

private:
  static constexpr std::uint64_t Width = Node<D>::Width;

  std::uint64_t CountLeaves(std::uint64_t elements) const
  {
    return (elements + this->Capacity - 1) / this->Capacity;
  }

  /// The least number of children with the minimum height.
  static std::uint64_t CountChildren(std::uint64_t leaves)
  {
    std::uint64_t below = 1;
    while (below * Width < leaves)
    {
      below *= Width;
    }
    return (leaves + below - 1) / below;
  }

  /// Level by level: how many nodes there are for each number of leaves below a node.
  static std::size_t CountNodes(std::uint64_t leaves)
  {
    std::size_t total = 0;
    std::map<std::uint64_t, std::uint64_t> level;
    if (leaves > 0)
    {
      level[leaves] = 1;
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
    std::uint64_t leaves, std::uint64_t number, std::map<std::uint64_t, std::uint64_t>& below)
  {
    if (leaves <= 1)
    {
      return;
    }
    AddShares(leaves, static_cast<int>(CountChildren(leaves)), number, below);
  }

  static void AddShares(std::uint64_t leaves, int shares, std::uint64_t number,
    std::map<std::uint64_t, std::uint64_t>& below)
  {
    if (shares == 1)
    {
      below[leaves] += number;
      return;
    }
    const int leftShares = (shares + 1) / 2;
    const std::uint64_t left = LeavesLeft(leaves, leftShares, shares);
    AddShares(left, leftShares, number, below);
    AddShares(leaves - left, shares - leftShares, number, below);
  }

  static std::uint64_t LeavesLeft(std::uint64_t leaves, int leftShares, int shares)
  {
    return leaves * static_cast<std::uint64_t>(leftShares) / static_cast<std::uint64_t>(shares);
  }

  /// Splits by area leave some lanes with more below them than others: one level more than needed
  /// gives room for eight times as many. A walk has no room for more than eleven.
  static std::uint32_t HeightFor(std::uint64_t leaves)
  {
    std::uint32_t height = leaves > 1 ? 1 : 0;
    while (height > 0 && height < 11 && RoomOf(height) < Width * leaves)
    {
      ++height;
    }
    return height;
  }

  /// The maximum number of leaves a given number of levels below a node.
  static std::uint64_t RoomOf(std::uint32_t height) { return std::uint64_t(1) << (3 * height); }

  /// Where N alone decides, as many as there are. Memory that is never written costs nothing.
  std::size_t MostNodes() const
  {
    const std::size_t leaves = this->CountLeaves(this->Elements.size());
    return this->IsByArea ? 2 * leaves : CountNodes(leaves);
  }

  /// Where the children of a node begin. Those that are all leaves lie behind the other nodes,
  /// which are then near each other for queries that skip leaves.
  std::uint32_t PlaceOfChildren(std::uint16_t count, std::uint64_t leaves)
  {
    return leaves > Width ? this->Next.fetch_add(count) : this->Behind.fetch_sub(count) - count;
  }

  /// Splits by area leave some nodes unused before those behind.
  void CloseGap()
  {
    const std::uint32_t gap = this->Behind - this->Next;
    if (gap == 0)
    {
      return;
    }
    for (std::uint32_t i = 0; i < this->Next; ++i)
    {
      Node<D>& node = this->Nodes[i];
      node.First -= !node.IsLeaf && node.First >= this->Behind ? gap : 0;
    }
    this->Nodes.erase(this->Nodes.begin() + this->Next, this->Nodes.begin() + this->Behind);
    this->Nodes.shrink_to_fit();
  }

  FloatBox<D> Union(std::uint32_t first, std::uint32_t last) const
  {
    FloatBox<D> box = this->Elements[first].Box;
    for (std::uint32_t position = first + 1; position < last; ++position)
    {
      Enclose(box, this->Elements[position].Box);
    }
    return box;
  }

  void FillLeaf(Node<D>& leaf, const Range& range)
  {
    leaf.First = range.First;
    leaf.SetCount(static_cast<std::uint32_t>(range.Last - range.First));
    for (int lane = 0; lane < leaf.Count; ++lane)
    {
      leaf.Boxes.Set(lane, this->Elements[range.First + static_cast<std::uint32_t>(lane)].Box);
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

  struct Halves
  {
    Range Left;
    Range Right;
  };

  /// Divides the elements of a task.
  Halves Split(const Task& task, int leftShares)
  {
    const Range& range = task.Elements;
    const auto where =
      this->IsByArea ? this->BestCut(task, leftShares) : this->Middle(task, leftShares);
    const std::uint32_t middle =
      range.First + static_cast<std::uint32_t>(where.Left) * this->Capacity;
    Halves halves{ range, range };
    halves.Left.Last = halves.Right.First = middle;
    if (range.IsInBins)
    {
      const auto boxes = this->Bins->Split(range.First, middle, where.Axis);
      halves.Left.Box = boxes.Left;
      halves.Right.Box = boxes.Right;
      return halves;
    }
    Element<D>* const elements = this->Elements.data();
    SplitAtRank<D>::Run(
      elements + range.First, elements + middle, elements + range.Last, where.Axis);
    halves.Left.Box = this->Union(range.First, middle);
    halves.Right.Box = this->Union(middle, range.Last);
    return halves;
  }

  using Cut = typename AreaSplit<D>::Cut;

  Cut Middle(const Task& task, int leftShares) const
  {
    const std::uint64_t leaves = this->CountLeaves(task.Elements.Last - task.Elements.First);
    return { LongestAxis(task.Elements.Box), LeavesLeft(leaves, leftShares, task.Shares) };
  }

  /// Every lane gets at least one leaf, and no more than its capacity.
  Cut BestCut(const Task& task, int leftShares) const
  {
    const Range& range = task.Elements;
    const std::uint64_t leaves = this->CountLeaves(range.Last - range.First);
    const std::uint64_t laneRoom = RoomOf(range.Height - 1);
    const auto left = static_cast<std::uint64_t>(leftShares);
    const auto right = static_cast<std::uint64_t>(task.Shares - leftShares);
    const std::uint64_t most = std::min(left * laneRoom, leaves - right);
    const std::uint64_t least = leaves - std::min(right * laneRoom, leaves - left);
    const Element<D>* const elements = this->Elements.data();
    const AreaSplit<D> split(elements + range.First, elements + range.Last, this->Capacity);
    return split.Best({ leaves, least, most }, LongestAxis(range.Box));
  }

  std::unique_ptr<CoarseBins<D>> Bins; // of those that are not yet in place; else none
  RawVector<Element<D>> Elements;
  std::uint32_t Capacity;
  bool IsByArea;
  RawVector<Node<D>> Nodes; // each is written whole when it is begun
  std::atomic<std::uint32_t> Next{ 1 };
  std::atomic<std::uint32_t> Behind{ static_cast<std::uint32_t>(this->Nodes.size()) };
};

}

#endif
