// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshRefinementRun.h
 * @brief vtkSkdTreeMeshRefinement run on meshes and parts, and its output by value
 */
#ifndef skdtest_MeshRefinementRun_h
#define skdtest_MeshRefinementRun_h

#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/MeshMeasures.h"

#include "vtkSkdTreeMeshRefinement.h"

namespace skdtest
{

using RefinementPointer = vtkSmartPointer<vtkSkdTreeMeshRefinement>;

inline RefinementPointer MakeRefinement(
  vtkDataObject* mesh, vtkDataObject* parts, int levels, int method = 0)
{
  auto filter = RefinementPointer::New();
  filter->SetInputDataObject(0, mesh);
  filter->SetPartsData(parts);
  filter->SetMaximumLevel(levels);
  filter->SetMethod(method);
  return filter;
}

inline vtkDataSet* RunRefinement(vtkSkdTreeMeshRefinement* filter)
{
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

inline std::vector<double> CellValues(vtkDataSet* mesh, const char* name)
{
  return ValuesOf(mesh->GetCellData()->GetArray(name));
}

/// A polyline around a corner of the unit cube.
inline PolyDataPointer MakeCurve()
{
  Mesh mesh;
  for (int i = 0; i < 20; ++i)
  {
    mesh.Add(Point{ 0.9 - 0.04 * i, 0.1 + 0.002 * i * i, 0.2 + 0.01 * i });
  }
  for (vtkIdType i = 0; i + 1 < 20; ++i)
  {
    mesh.Add(VTK_LINE, { i, i + 1 });
  }
  return MakePolyData(mesh);
}

}

#endif
