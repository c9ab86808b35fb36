// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Surface_mesh.h>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

CgalMesh AsCgal(vtkPolyData* surface)
{
  CgalMesh mesh;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* x = surface->GetPoint(i);
    mesh.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    const auto vertex = [&](int i)
    { return CgalMesh::Vertex_index(static_cast<unsigned int>(ids->GetId(i))); };
    mesh.add_face(vertex(0), vertex(1), vertex(2));
  }
  return mesh;
}
}

vtkIdType RunCgalCurves(vtkPolyData* first, vtkPolyData* second)
{
  CgalMesh meshes[2] = { AsCgal(first), AsCgal(second) };
  std::vector<std::vector<Kernel::Point_3>> curves;
  CGAL::Polygon_mesh_processing::surface_intersection(
    meshes[0], meshes[1], std::back_inserter(curves));
  vtkIdType segments = 0;
  for (const auto& curve : curves)
  {
    segments += static_cast<vtkIdType>(curve.size()) - 1;
  }
  return segments;
}
