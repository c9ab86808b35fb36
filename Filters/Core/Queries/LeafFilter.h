// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_LeafFilter_h
#define skd_Queries_LeafFilter_h

#include "../Tree/Node.h"

namespace skd
{

/// A leaf filter, quantized or not, looks at the elements of a leaf more closely than their boxes
/// do, all at once, and says which are worth a visit: it may leave out what is proven to be no
/// answer. It gives
///   bool Knows(const Node&)                whether it can, of this node
///   unsigned Pass(const Node&, float* keys, float& limit)
///                                          as TestBoxes() of a query (Walk.h), whose limit it may
///                                          lower
///   static constexpr bool SkipsLeaves      whether a leaf's number, and how many elements
///                                          it has, is enough (KnownLeaves); if so it gives
///   unsigned Pass(number, count, float* keys, float& limit), void Fetch(number)
/// AlongSegment first calls Aim(point, margin), in the frame: where the segment begins, clipped to
/// where the tree is. This one knows nothing.
struct NoLeafFilter
{
  static constexpr bool SkipsLeaves = false;

  template <class Point>
  void Aim(const Point&, double)
  {
  }
  template <class Node>
  bool Knows(const Node&) const
  {
    return false;
  }
  template <class Node>
  unsigned Pass(const Node& leaf, float*, float&) const
  {
    return leaf.Occupied();
  }
};

/// What queries that have a leaf filter do with it (see Walk.h), and their limit. The boxes of the
/// elements decide where the filter does not know the leaf: `Query` has TestBoxes().
template <class Query, class LeafFilter>
class FilteredQuery
{
public:
  static constexpr bool SkipsLeaves = LeafFilter::SkipsLeaves;

  template <class Node>
  unsigned TestElements(const Node& leaf, float* keys)
  {
    return this->TheLeafFilter.Knows(leaf) ? this->TheLeafFilter.Pass(leaf, keys, this->TheLimit)
                                           : static_cast<Query*>(this)->TestBoxes(leaf.Boxes, keys);
  }

  template <class Node>
  bool Knows(const Node& inner) const
  {
    return this->TheLeafFilter.Knows(inner);
  }
  unsigned TestKnown(std::uint32_t leaf, std::uint32_t count, float* keys)
  {
    return this->TheLeafFilter.Pass(leaf, count, keys, this->TheLimit);
  }
  void FetchKnown(std::uint32_t leaf) const { this->TheLeafFilter.Fetch(leaf); }

  float Limit() const { return this->TheLimit; }

protected:
  FilteredQuery(const LeafFilter& leafFilter, float limit)
    : TheLeafFilter(leafFilter)
    , TheLimit(limit)
  {
  }

  LeafFilter TheLeafFilter;
  float TheLimit;
};

}

#endif
