// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_CoverByBoxes_h
#define skd_Tree_CoverByBoxes_h

#include "../../Geometry/Box.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skd
{

/// A few boxes in place of many: each of the given is in one of them. They are the top of a tree
/// whose nodes are halved along the longest axis, at the median of the centroids, of very many
/// about there: at most 2^levels. Empty boxes, and ones with NaN, are left out. O(n levels).
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
    if (boxes.size() >> levels > MostJoined * MostJoined)
    {
      JoinNeighbours(boxes);
    }
    if (!boxes.empty())
    {
      Divide(boxes, 0, boxes.size(), levels, cover);
    }
    return cover;
  }

private:
  static constexpr std::size_t SampleSize = 512;
  static constexpr std::size_t MostJoined = 8;

  static double LengthsOf(const Box<D>& box)
  {
    double sum = 0.0;
    for (int axis = 0; axis < D; ++axis)
    {
      sum += box.Length(axis);
    }
    return sum;
  }

  /// Boxes that follow each other become one where they touch, a few at most: of very many these
  /// are as good, and fewer.
  static void JoinNeighbours(std::vector<Box<D>>& boxes)
  {
    std::size_t last = 0;
    std::size_t joined = 1;
    double lengths = LengthsOf(boxes[0]);
    for (std::size_t i = 1; i < boxes.size(); ++i)
    {
      Box<D> both = boxes[last];
      both.Add(boxes[i]);
      const double own = LengthsOf(boxes[i]);
      const double together = LengthsOf(both);
      const bool isNear = joined < MostJoined && together <= lengths + own;
      last += isNear ? 0 : 1;
      boxes[last] = isNear ? both : boxes[i];
      lengths = isNear ? together : own;
      joined = isNear ? joined + 1 : 1;
    }
    boxes.resize(last + 1);
  }

  static void Divide(std::vector<Box<D>>& boxes, std::size_t begin, std::size_t end, int levels,
    std::vector<Box<D>>& cover)
  {
    if (levels == 0 || end - begin == 1)
    {
      Box<D> all;
      for (std::size_t i = begin; i < end; ++i)
      {
        all.Add(boxes[i]);
      }
      cover.push_back(all);
      return;
    }
    const std::size_t middle = Halve(boxes, begin, end);
    Divide(boxes, begin, middle, levels - 1, cover);
    Divide(boxes, middle, end, levels - 1, cover);
  }

  static auto At(std::vector<Box<D>>& boxes, std::size_t i)
  {
    return boxes.begin() + static_cast<std::ptrdiff_t>(i);
  }

  static std::size_t Halve(std::vector<Box<D>>& boxes, std::size_t begin, std::size_t end)
  {
    Box<D> centroids;
    for (std::size_t i = begin; i < end; ++i)
    {
      centroids.Add(boxes[i].Centroid());
    }
    const int axis = centroids.LongestAxis();
    const std::size_t fewest = (end - begin) / 4;
    std::size_t middle = end;
    if (end - begin > 16 * SampleSize)
    {
      const double median = MedianOfSample(boxes, begin, end, axis);
      const auto second = std::partition(At(boxes, begin), At(boxes, end),
        [axis, median](const Box<D>& box) { return box.Centroid()[axis] < median; });
      middle = static_cast<std::size_t>(second - boxes.begin());
    }
    if (middle - begin < fewest || end - middle < fewest || middle == end)
    {
      middle = begin + (end - begin) / 2;
      std::nth_element(At(boxes, begin), At(boxes, middle), At(boxes, end),
        [axis](const Box<D>& a, const Box<D>& b)
        { return a.Centroid()[axis] < b.Centroid()[axis]; });
    }
    return middle;
  }

  /// Of boxes taken in no order that a mesh has, because in rows of cells some steps would return
  /// to the same place of each row.
  static double MedianOfSample(
    const std::vector<Box<D>>& boxes, std::size_t begin, std::size_t end, int axis)
  {
    std::vector<double> sample;
    for (std::uint64_t i = 1; i <= SampleSize; ++i)
    {
      const std::uint64_t scattered = (i * 0x9e3779b97f4a7c15u) >> 16;
      sample.push_back(
        boxes[begin + static_cast<std::size_t>(scattered % (end - begin))].Centroid()[axis]);
    }
    const auto median = sample.begin() + SampleSize / 2;
    std::nth_element(sample.begin(), median, sample.end());
    return *median;
  }
};

}

#endif
