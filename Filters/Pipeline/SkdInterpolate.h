// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdInterpolate_h
#define SkdInterpolate_h

#include "Cells/Kernels/SkdCellWeights.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "vtkDataSetAttributes.h"

namespace skdtree
{
/// A location in a Source: a point of a cell of one of its blocks; none if Block < 0.
struct SkdSourceLocation
{
  int Block;
  vtkIdType CellId;
  const double* Point;
};

/// Adds n tuples of a Source's data to `output`: tuple i is its point data interpolated, and its
/// cell data, at the location locationOf(i). meshOf(block) is the mesh of a block, see
/// SkdTouchCells(). Names of arrays that are not added are inserted into `refused`.
template <class LocationOf, class MeshOf>
void SkdInterpolateInto(vtkDataSetAttributes* output, vtkIdType n,
  const std::vector<SkdBlock>& source, const MeshOf& meshOf, const LocationOf& locationOf,
  std::set<std::string>& refused, SkdLoop& loop)
{
  SkdArrayGather points = SkdGatherInto(output, n, source, vtkDataObject::POINT, refused);
  SkdArrayGather cells = SkdGatherInto(output, n, source, vtkDataObject::CELL, refused);
  loop.For(n,
    [&](vtkIdType begin, vtkIdType end)
    {
      SkdCellWeights weights;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const SkdSourceLocation location = locationOf(i);
        if (location.Block >= 0)
        {
          weights.Evaluate(meshOf(location.Block), location.CellId, location.Point);
          points.Interpolate(i, location.Block, weights.GetPointIds(), weights.GetWeights());
          cells.Take(i, location.Block, location.CellId);
        }
      }
    });
}
}

#endif
