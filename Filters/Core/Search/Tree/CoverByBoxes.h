// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_CoverByBoxes_h
#define skd_Tree_CoverByBoxes_h

#include "../../Geometry/Box.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace skd
{

/// A few boxes in place of many: each of the given is in one of them. They are the top of a tree
/// whose nodes are halved at the median of the centroids along the longest axis: at most
/// 2^levels. Empty boxes, and ones with NaN, are left out. O(n levels).
template <int D>
class CoverByBoxes
{
public:
  static std::vector<Box<D>> Of(std::vector<Box<D>> boxes, int levels)
  {
    boxes.erase(
      std::remove_if(boxes.begin(), boxes.end(), [](const Box<D>& box) { return box.IsEmpty(); }),
      boxes.end());
    std::vector<Box<D>> cover;
    if (!boxes.empty())
    {
      Divide(boxes, 0, boxes.size(), levels, cover);
    }
    return cover;
  }

private:
  static void Divide(std::vector<Box<D>>& boxes, std::size_t begin, std::size_t end, int levels,
    std::vector<Box<D>>& cover)
  {
    Box<D> all;
    Box<D> centroids;
    for (std::size_t i = begin; i < end; ++i)
    {
      all.Add(boxes[i]);
      centroids.Add(boxes[i].Centroid());
    }
    if (levels == 0 || end - begin == 1)
    {
      cover.push_back(all);
      return;
    }
    const int axis = centroids.LongestAxis();
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&boxes](std::size_t i)
    { return boxes.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
      [axis](const Box<D>& a, const Box<D>& b) { return a.Centroid()[axis] < b.Centroid()[axis]; });
    Divide(boxes, begin, middle, levels - 1, cover);
    Divide(boxes, middle, end, levels - 1, cover);
  }
};

}

#endif
