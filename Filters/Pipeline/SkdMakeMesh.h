// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMakeMesh.h
 * @brief Points and cells of VTK from the lists of an algorithm.
 */

#ifndef SkdMakeMesh_h
#define SkdMakeMesh_h

#include "Cells/Read/SkdForEach.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace skdtree
{
/// n points in double precision; pointAt(i) is a skd::Vector3, computed in parallel.
template <class PointAt>
vtkSmartPointer<vtkPoints> SkdMakePoints(vtkIdType n, const PointAt& pointAt)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(n);
  double* const values = coordinates->GetPointer(0);
  SkdForEach(n,
    [&](vtkIdType i)
    {
      const auto& x = pointAt(i);
      std::copy_n(x.X, 3, values + 3 * i);
    });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

/// Cells of the same size from a list; cornersOf(element) has their point ids, of any integer type.
template <class List, class CornersOf>
vtkSmartPointer<vtkCellArray> SkdMakeCells(int size, const List& list, const CornersOf& cornersOf)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(size * static_cast<vtkIdType>(list.size()));
  vtkIdType next = 0;
  for (const auto& element : list)
  {
    const auto& corners = cornersOf(element);
    for (int corner = 0; corner < size; ++corner)
    {
      ids->SetValue(next++, static_cast<vtkIdType>(corners[corner]));
    }
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (next > 0)
  {
    cells->SetData(size, ids);
  }
  return cells;
}

/// Makes a mesh the surface of a list of triangles.
template <class PointAt, class List, class CornersOf>
void SkdSetTriangles(vtkPolyData* mesh, vtkIdType numberOfPoints, const PointAt& pointAt,
  const List& list, const CornersOf& cornersOf)
{
  mesh->SetPoints(SkdMakePoints(numberOfPoints, pointAt));
  mesh->SetPolys(SkdMakeCells(3, list, cornersOf));
}
}

#endif
