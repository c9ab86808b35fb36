// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Boolean.h"
#include "CgalMesh.h"
#include "ProcessorTime.h"

#include "vtkPoints.h"
#include "vtkSkdTreeBooleanOperation.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

using namespace skdbench;

namespace
{
namespace processing = CGAL::Polygon_mesh_processing;

vtkSmartPointer<vtkPolyData> AsVtk(const CgalMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids(mesh.num_vertices() + mesh.number_of_removed_vertices());
  for (const auto vertex : mesh.vertices())
  {
    const auto& x = mesh.point(vertex);
    ids[vertex] = points->InsertNextPoint(x.x(), x.y(), x.z());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto face : mesh.faces())
  {
    cells->InsertNextCell(3);
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
    {
      cells->InsertCellPoint(ids[vertex]);
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

bool Combine(CgalMesh& first, CgalMesh& second, int operation, CgalMesh& result)
{
  using Filter = vtkSkdTreeBooleanOperation;
  const auto strict = CGAL::parameters::throw_on_self_intersection(true);
  switch (operation)
  {
    case Filter::UNION:
      return processing::corefine_and_compute_union(first, second, result, strict);
    case Filter::INTERSECTION:
      return processing::corefine_and_compute_intersection(first, second, result, strict);
    case Filter::DIFFERENCE:
      return processing::corefine_and_compute_difference(first, second, result, strict);
    default:
      return processing::corefine_and_compute_difference(second, first, result, strict);
  }
}
}

BooleanResult RunCgalBoolean(vtkPolyData* first, vtkPolyData* second, int operation)
{
  BooleanResult answer;
  const double start = ProcessorSeconds();
  CgalMesh meshes[2] = { AsCgal(first), AsCgal(second) };
  const double read = ProcessorSeconds();
  CgalMesh result;
  bool isDone = CGAL::is_closed(meshes[0]) && CGAL::is_closed(meshes[1]);
  try
  {
    isDone = isDone && Combine(meshes[0], meshes[1], operation, result);
  }
  catch (const std::exception&) // it finds an input that intersects itself near the other
  {
    isDone = false;
  }
  const double combined = ProcessorSeconds();
  if (isDone)
  {
    answer.Surface = AsVtk(result);
  }
  answer.Seconds = combined - read;
  answer.Conversion = ProcessorSeconds() - combined + read - start;
  return answer;
}
