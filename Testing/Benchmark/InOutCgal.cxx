// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InOut.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace processing = CGAL::Polygon_mesh_processing;

CgalMesh MeshOf(vtkPolyData* surface)
{
  std::vector<Kernel::Point_3> points;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* x = surface->GetPoint(i);
    points.emplace_back(x[0], x[1], x[2]);
  }
  std::vector<std::vector<std::size_t>> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    triangles.emplace_back(ids->begin(), ids->end());
  }
  processing::orient_polygon_soup(points, triangles);
  CgalMesh mesh;
  processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}
}

Sides AskCgalSides(vtkDataSet* points, vtkPolyData* surface)
{
  const CgalMesh mesh = MeshOf(surface);
  if (!CGAL::is_closed(mesh))
  {
    return {};
  }
  const CGAL::Side_of_triangle_mesh<CgalMesh, Kernel> sideOf(mesh);
  Sides sides;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    const CGAL::Bounded_side side = sideOf(Kernel::Point_3(x[0], x[1], x[2]));
    sides.push_back(side == CGAL::ON_BOUNDARY ? -1 : side == CGAL::ON_BOUNDED_SIDE);
  }
  return sides;
}
