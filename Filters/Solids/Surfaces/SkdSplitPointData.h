// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSplitPointData_h
#define SkdSplitPointData_h

#include "Solids/Surfaces/SkdSplitTriangles.h"

class vtkIdList;

namespace skdtree
{
class SkdArrayGather;

/// The point data of a split set: those of its points, and means of these at new ones.
class SkdSplitPointData
{
public:
  SkdSplitPointData(const SkdTriangleSet& set, const std::vector<SkdSplitPoint>& newPoints)
    : Set(set)
    , NewPoints(newPoints)
    , Origins(set.FindOrigins())
  {
  }

  /// Sets tuple `to` of gathered arrays for a point, of the set or counted on a new one: what the
  /// first data set has at it, or the mean of the corners of a new point's triangle, as its data
  /// set has them. Other tuples, of points that no data set has, stay as they are. `ids` is scratch
  /// space of a thread. Thread-safe for distinct `to`.
  void Gather(std::uint32_t point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const;

private:
  using Origin = SkdTriangleSet::Origin;

  void Interpolate(
    const SkdSplitPoint& point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const;

  const SkdTriangleSet& Set;
  const std::vector<SkdSplitPoint>& NewPoints;
  skd::Rows<Origin> Origins; // of each point
};
}

#endif
