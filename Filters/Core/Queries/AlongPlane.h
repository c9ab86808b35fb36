// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_AlongPlane_h
#define skd_Queries_AlongPlane_h

#include "WithinSlabs.h"

namespace skd
{

/// Elements whose boxes come within a distance of a plane. `visitor(element)` returns false to end
/// the search.
template <int D, class Visitor>
class AlongPlane : public WithinSlabs<D, 1, Visitor>
{
public:
  AlongPlane(const Frame<D>& frame, const Plane<D>& plane, double tolerance, Visitor& visitor)
    : WithinSlabs<D, 1, Visitor>({ Slab<D>(frame, plane, tolerance) }, visitor)
  {
  }
};

}

#endif
