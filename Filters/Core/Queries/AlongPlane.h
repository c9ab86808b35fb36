// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_AlongPlane_h
#define skd_Queries_AlongPlane_h

#include "WithinSlabs.h"

namespace skd
{

/// Elements whose boxes come within a distance of a plane. `leaf(element)` returns false to end
/// the search.
template <int D, class Leaf>
class AlongPlane : public WithinSlabs<D, 1, Leaf>
{
public:
  AlongPlane(const Frame<D>& frame, const Plane<D>& plane, double tolerance, Leaf& leaf)
    : WithinSlabs<D, 1, Leaf>({ Slab<D>(frame, plane, tolerance) }, leaf)
  {
  }
};

}

#endif
