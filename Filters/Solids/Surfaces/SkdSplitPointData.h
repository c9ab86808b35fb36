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
    , Origins(set.GetOrigins())
  {
  }

  /// Sets tuple `to` of gathered arrays for a point, of the set or counted on a new one: what the
  /// first data set has at it, or the mean of the corners of a new point's triangle, as its data
  /// set has them. Other tuples, of points that no data set has, are cleared. `ids` is scratch
  /// space of a thread. Thread-safe for distinct `to`.
  void Gather(std::uint32_t point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const;

  /// Where the data of a point come from; nullptr of a new point, and of one that no data set has.
  const SkdTriangleSet::Origin* FindOrigin(std::uint32_t point) const;

  /// How many points from one on follow each other in their data set, too; 1 if it has none.
  /// Without others between them, for they are ascending.
  std::uint32_t CountAlike(std::uint32_t point) const
  {
    return point < this->Origins.size() ? this->Set.CountInRun(point) : 1;
  }

private:
  using Origin = SkdTriangleSet::Origin;

  void Interpolate(
    const SkdSplitPoint& point, vtkIdType to, SkdArrayGather& arrays, vtkIdList* ids) const;

  const SkdTriangleSet& Set;
  const std::vector<SkdSplitPoint>& NewPoints;
  const skd::Rows<Origin>& Origins; // of each point
};
}

#endif
