// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CgalMesh.h
 * @brief triangles of VTK as CGAL's mesh
 */
#ifndef skdbench_CgalMesh_h
#define skdbench_CgalMesh_h

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace skdbench
{

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

/// Faces at edges that have two already are missing: see whether it is closed.
inline CgalMesh AsCgal(vtkPolyData* surface)
{
  CgalMesh mesh;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* x = surface->GetPoint(i);
    mesh.add_vertex(CgalKernel::Point_3(x[0], x[1], x[2]));
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

#endif
