// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_NoLeafFilter_h
#define skd_Queries_NoLeafFilter_h

#include "../Tree/Node.h"

namespace skd
{

/// A leaf filter, quantized or not, looks at the elements of a leaf more closely than their boxes
/// do, all at once, and says which are worth a visit: it may leave out what is proven to be no
/// answer. It gives
///   bool Knows(const Node&)                 whether it can, of this node
///   unsigned Pass(const Node&, float* keys) as TestBoxes() of a query (Walk.h)
///   static constexpr bool SkipsLeaves      whether a leaf's number, and how many elements
///                                           it has, is enough (KnownLeaves); if so it gives
///   unsigned Pass(number, count, float* keys), void Fetch(number)
/// Nearest hands it the limit, too, by reference; AlongSegment first calls Aim(point, margin), in
/// the frame: where the segment begins, clipped to where the tree is. This one knows nothing.
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
  template <class Node, class... Limit>
  unsigned Pass(const Node& leaf, float*, Limit&...) const
  {
    return leaf.Occupied();
  }
};

}

#endif
