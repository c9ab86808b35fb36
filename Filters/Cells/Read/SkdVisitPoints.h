// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdVisitPoints_h
#define SkdVisitPoints_h

#include "Cells/Read/SkdStoredValues.h"

#include "vtkDataSet.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <cstddef>

namespace skdtree
{
/// The points of a mesh that are stored as floats or doubles, else none.
inline skd::PointArray SkdStoredPointsOf(vtkDataSet* mesh)
{
  auto* set = vtkPointSet::SafeDownCast(mesh);
  return set && set->GetPoints() ? SkdStoredPoints(set->GetPoints()->GetData()) : skd::PointArray();
}

/// Calls visit(id, x) for each point of a mesh, ascending. Those that are stored as floats or
/// doubles are read where they are: a call of VTK for each costs more than most visits.
template <class Visit>
void SkdVisitPoints(vtkDataSet* mesh, const Visit& visit)
{
  const skd::PointArray stored = SkdStoredPointsOf(mesh);
  const bool isStored = stored.Floats || stored.Doubles;
  const vtkIdType number = mesh->GetNumberOfPoints();
  for (vtkIdType id = 0; id < number; ++id)
  {
    if (isStored)
    {
      visit(id, stored.At(static_cast<std::size_t>(id)));
      continue;
    }
    skd::Vector3 x;
    mesh->GetPoint(id, x.X);
    visit(id, x);
  }
}
}

#endif
