// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdInterpolate_h
#define SkdInterpolate_h

#include "Cells/Kernels/SkdCellWeights.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "vtkDataSetAttributes.h"

/// A place in a Source: a point of a cell of one of its blocks; none if Block < 0.
struct SkdSourcePlace
{
  int Block;
  vtkIdType CellId;
  const double* Point;
};

/// Adds n tuples of a Source's data to `output`: tuple i is its point data interpolated, and its
/// cell data, at the place placeOf(i). meshOf(block) is the mesh of a block, see SkdTouchCells().
/// Names of arrays that are not added are inserted into `refused`.
template <class PlaceOf, class MeshOf>
void SkdInterpolateInto(vtkDataSetAttributes* output, vtkIdType n,
  const std::vector<SkdBlock>& source, const MeshOf& meshOf, const PlaceOf& placeOf,
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
        const SkdSourcePlace place = placeOf(i);
        if (place.Block >= 0)
        {
          weights.Evaluate(meshOf(place.Block), place.CellId, place.Point);
          points.Interpolate(i, place.Block, weights.GetPointIds(), weights.GetWeights());
          cells.Take(i, place.Block, place.CellId);
        }
      }
    });
}

#endif
