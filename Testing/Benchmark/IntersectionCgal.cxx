// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CgalMesh.h"
#include "Intersection.h"

#include <CGAL/Polygon_mesh_processing/intersection.h>

using namespace skdbench;

vtkIdType RunCgalCurves(vtkPolyData* first, vtkPolyData* second)
{
  CgalMesh meshes[2] = { AsCgal(first), AsCgal(second) };
  std::vector<std::vector<CgalKernel::Point_3>> curves;
  CGAL::Polygon_mesh_processing::surface_intersection(
    meshes[0], meshes[1], std::back_inserter(curves));
  vtkIdType segments = 0;
  for (const auto& curve : curves)
  {
    segments += static_cast<vtkIdType>(curve.size()) - 1;
  }
  return segments;
}
