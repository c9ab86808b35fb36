// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_PaperTree_h
#define skd_Tree_PaperTree_h

#include "../Geometry/Box.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace skd
{

/// The skD-tree exactly as Algorithm 3.1 prints it, to be read, drawn and checked: 2N - 1 nodes,
/// depth ceil(log2 N), one element a leaf. Queries run on Tree instead, which is the same split
/// laid out for speed.
///
/// Nodes count from 0 here, so a link is the index of the first of two adjacent children (> 0) or
/// the negated index of the leaf's element (<= 0): no node has the root as a child.
template <int D>
struct PaperTree
{
  std::vector<Box<D>> S;        ///< the safety box of each node
  std::vector<std::int64_t> L;  ///< its link
  std::vector<int> Level;       ///< its distance from the root

  bool IsLeaf(std::size_t node) const { return this->L[node] <= 0; }
};

/// Algorithm 3.1 on safety boxes. O(N log N): a selection of the median, O(n), at each node.
template <int D>
PaperTree<D> BuildPaperTree(const std::vector<Box<D>>& safetyBoxes)
{
  struct Range
  {
    std::size_t Node;
    std::size_t First; // of perm, last included, as printed
    std::size_t Last;
  };
  PaperTree<D> tree;
  if (safetyBoxes.empty())
  {
    return tree;
  }
  std::vector<std::size_t> perm(safetyBoxes.size());
  std::iota(perm.begin(), perm.end(), std::size_t(0));
  const auto boxOf = [&](std::size_t first, std::size_t last)
  {
    Box<D> box;
    for (std::size_t k = first; k <= last; ++k)
    {
      box.Add(safetyBoxes[perm[k]]);
    }
    return box;
  };
  const std::size_t numberOfNodes = 2 * safetyBoxes.size() - 1;
  tree.S.resize(numberOfNodes);
  tree.L.resize(numberOfNodes);
  tree.Level.resize(numberOfNodes, 0);
  tree.S[0] = boxOf(0, perm.size() - 1);
  std::size_t next = 1;
  std::vector<Range> stack{ { 0, 0, perm.size() - 1 } };
  while (!stack.empty())
  {
    const Range range = stack.back();
    stack.pop_back();
    const std::size_t middle = range.First + (range.Last - range.First) / 2;
    if (range.First == range.Last)
    {
      tree.L[range.Node] = -static_cast<std::int64_t>(perm[middle]);
      continue;
    }
    const int axis = tree.S[range.Node].LongestAxis();
    std::nth_element(perm.begin() + range.First, perm.begin() + middle,
      perm.begin() + range.Last + 1,
      [&](std::size_t a, std::size_t b)
      {
        const double centreA = safetyBoxes[a].Centroid()[axis];
        const double centreB = safetyBoxes[b].Centroid()[axis];
        return centreA < centreB || (centreA == centreB && a < b);
      });
    tree.L[range.Node] = static_cast<std::int64_t>(next);
    tree.S[next] = boxOf(range.First, middle);
    tree.S[next + 1] = boxOf(middle + 1, range.Last);
    tree.Level[next] = tree.Level[next + 1] = tree.Level[range.Node] + 1;
    stack.push_back({ next, range.First, middle });
    stack.push_back({ next + 1, middle + 1, range.Last });
    next += 2;
  }
  return tree;
}

}

#endif
