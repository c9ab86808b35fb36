// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_TreeInput_h
#define skd_Tree_TreeInput_h

#include "Element.h"
#include "Node.h"
#include "RawVector.h"
#include "SplitRule.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace skd
{

/// Reads the elements of some indices, reproducibly: read(indices, count, to). Thread-safe.
template <int D>
using ElementReader = std::function<void(const std::uint32_t*, std::size_t, Element<D>*)>;

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

/// Up to this number of elements, splits of stored boxes are faster than CoarseBins.
constexpr std::size_t FewElements = std::size_t(1) << 16;

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
  SplitRule Rule = SplitRule::Median; ///< LazyTree knows the median only
  std::size_t Few = FewElements;      ///< so few elements are all read at once
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

}

#endif
