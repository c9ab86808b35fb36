// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCoherentNearest_h
#define SkdCoherentNearest_h

#include "Cells/Search/SkdCellTree.h"

#include <cmath>

namespace skdtree
{
/// Nearest cells to a sequence of points near each other: the answer to the last one is a point of
/// the set, so the distance to it bounds the next search. Answers are those of
/// SkdCellTree::FindNearest, including ties. For one thread.
class SkdCoherentNearest
{
public:
  SkdCoherentNearest(const SkdCellTree& tree, const SkdCellSource& source, double limit2)
    : Tree(tree)
    , Source(source)
    , Limit2(limit2)
  {
  }

  SkdFoundCell Find(const skd::Vector3& x)
  {
    const double known2 = this->Last.Id < 0 ? this->Limit2 : this->Bound2(x);
    SkdFoundCell found;
    if (known2 < this->Limit2)
    {
      found = this->Tree.FindNearest(x, known2, this->Source);
    }
    if (found.Id < 0) // the first, or rounding left even the last answer out
    {
      found = this->Tree.FindNearest(x, this->Limit2, this->Source);
    }
    if (found.Id >= 0)
    {
      this->Last = found;
    }
    return found;
  }

private:
  /// Allows for rounding of the point and of distances.
  double Bound2(const skd::Vector3& x) const
  {
    constexpr double slack = 1.0 + 64.0 * std::numeric_limits<double>::epsilon();
    const double maxDistance = skd::Norm(x - this->Last.Point) + this->Tree.Rounding();
    return maxDistance * maxDistance * slack;
  }

  const SkdCellTree& Tree;
  SkdCellSource Source;
  double Limit2;
  SkdFoundCell Last;
};
}

#endif
