// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCoherentSource_h
#define SkdCoherentSource_h

#include "Pipeline/SkdSourceTrees.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
/// Nearest cells of a source to points near each other, one after the other: the last answer is a
/// point of the source, so the distance to it bounds the next search. Answers are those of
/// Source::FindNearest(x, maximumDistance), including ties. For one thread.
template <class Source>
class SkdCoherentSource
{
public:
  explicit SkdCoherentSource(const Source& source)
    : TheSource(source)
  {
  }

  std::optional<SkdNearest> FindNearest(const double x[3], double maximumDistance)
  {
    const double known = this->Last ? this->Bound(x) : maximumDistance;
    std::optional<SkdNearest> nearest;
    if (known < maximumDistance)
    {
      nearest = this->TheSource.FindNearest(x, known);
    }
    if (!nearest) // the first, or rounding left even the last answer out
    {
      nearest = this->TheSource.FindNearest(x, maximumDistance);
    }
    if (nearest)
    {
      this->Last = nearest;
    }
    return nearest;
  }

private:
  /// Allows for rounding of the point, of differences and of distances.
  double Bound(const double x[3]) const
  {
    constexpr double slack = 64.0 * std::numeric_limits<double>::epsilon();
    double sum2 = 0.0;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double difference = x[axis] - this->Last->Point[axis];
      sum2 += difference * difference;
      largest = std::max({ largest, std::abs(x[axis]), std::abs(this->Last->Point[axis]) });
    }
    return (1.0 + slack) * std::sqrt(sum2) + slack * largest;
  }

  const Source& TheSource;
  std::optional<SkdNearest> Last;
};
}

#endif
