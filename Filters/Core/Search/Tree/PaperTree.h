// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_PaperTree_h
#define skd_Tree_PaperTree_h

#include "../../Geometry/Box.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace skd
{

/// The skD-tree exactly as printed in Algorithm 3.1, for reference: 2N - 1 nodes, depth ceil(log2
/// N), one element a leaf. Queries use Tree instead, which has the same splits in a faster layout.
///
/// Nodes count from 0 here, so a link is the index of the first of two adjacent children (> 0) or
/// the negated index of the leaf's element (<= 0): no node has the root as a child.
template <int D>
struct PaperTree
{
  std::vector<Box<D>> S;       ///< the safety box of each node
  std::vector<std::int64_t> L; ///< its link
  std::vector<int> Level;      ///< its distance from the root

  bool IsLeaf(std::size_t node) const { return this->L[node] <= 0; }
};

namespace detail
{

/// Algorithm 3.1 step by step; the names are the paper's.
template <int D>
class PaperTreeBuilder
{
public:
  explicit PaperTreeBuilder(const std::vector<Box<D>>& safetyBoxes)
    : B(safetyBoxes)
    , Perm(safetyBoxes.size())
  {
    std::iota(this->Perm.begin(), this->Perm.end(), std::size_t(0));
  }

  PaperTree<D> Build()
  {
    if (this->B.empty())
    {
      return {};
    }
    const std::size_t numberOfNodes = 2 * this->B.size() - 1;
    this->Made.S.resize(numberOfNodes);
    this->Made.L.resize(numberOfNodes);
    this->Made.Level.resize(numberOfNodes);
    this->Push({ 0, 0, this->B.size() - 1 }, 0);
    while (!this->Stack.empty())
    {
      const Range range = this->Stack.back();
      this->Stack.pop_back();
      this->Make(range);
    }
    return std::move(this->Made);
  }

private:
  struct Range
  {
    std::size_t Node;
    std::size_t Min; // of Perm, both ends included, as printed
    std::size_t Max;
  };

  void Push(const Range& range, int level)
  {
    this->Made.S[range.Node] = this->Union(range);
    this->Made.Level[range.Node] = level;
    this->Stack.push_back(range);
  }

  Box<D> Union(const Range& range) const
  {
    Box<D> box;
    for (std::size_t k = range.Min; k <= range.Max; ++k)
    {
      box.Add(this->B[this->Perm[k]]);
    }
    return box;
  }

  void Make(const Range& range)
  {
    if (range.Min == range.Max)
    {
      this->Made.L[range.Node] = -static_cast<std::int64_t>(this->Perm[range.Min]);
      return;
    }
    const std::size_t middle = range.Min + (range.Max - range.Min) / 2;
    this->Reorder(range, middle, this->Made.S[range.Node].LongestAxis());
    this->Made.L[range.Node] = static_cast<std::int64_t>(this->Next);
    const int level = this->Made.Level[range.Node] + 1;
    this->Push({ this->Next, range.Min, middle }, level);
    this->Push({ this->Next + 1, middle + 1, range.Max }, level);
    this->Next += 2;
  }

  /// Ties between centroids are broken by index, so that the tree is reproducible.
  void Reorder(const Range& range, std::size_t middle, int axis)
  {
    const auto at = [this](std::size_t k)
    { return this->Perm.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(range.Min), at(middle), at(range.Max + 1),
      [this, axis](std::size_t a, std::size_t b)
      {
        const double centreA = this->B[a].Centroid()[axis];
        const double centreB = this->B[b].Centroid()[axis];
        return centreA < centreB || (centreA == centreB && a < b);
      });
  }

  const std::vector<Box<D>>& B;
  std::vector<std::size_t> Perm;
  std::vector<Range> Stack;
  std::size_t Next = 1;
  PaperTree<D> Made;
};

}

/// Algorithm 3.1 on safety boxes. O(N log N): a selection of the median, O(n), at each node.
template <int D>
PaperTree<D> BuildPaperTree(const std::vector<Box<D>>& safetyBoxes)
{
  return detail::PaperTreeBuilder<D>(safetyBoxes).Build();
}

}

#endif
