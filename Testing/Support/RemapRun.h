// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RemapRun.h
 * @brief vtkSkdTreeRemap run on an input and a source
 */
#ifndef skdtest_RemapRun_h
#define skdtest_RemapRun_h

#include "Support/FilterRun.h"
#include "Support/MakeOf.h"

#include "vtkSkdTreeRemap.h"
#include "vtkTable.h"

namespace skdtest
{

using RemapPointer = vtkSmartPointer<vtkSkdTreeRemap>;

inline RemapPointer MakeRemap(vtkDataObject* input, vtkDataObject* source, int method)
{
  RemapPointer remap = MakeOf<vtkSkdTreeRemap>(input, source);
  remap->SetMethod(method);
  return remap;
}

/// A cell array of the first output after an update; empty if there is none.
inline std::vector<double> RemappedCells(vtkSkdTreeRemap* remap, const char* name)
{
  remap->Update();
  auto* mesh = vtkDataSet::SafeDownCast(remap->GetOutputDataObject(0));
  return ValuesOf(mesh->GetCellData()->GetArray(name));
}

inline std::vector<double> RemappedPoints(vtkSkdTreeRemap* remap, const char* name)
{
  remap->Update();
  return PointArray(remap->GetOutputDataObject(0), name);
}

template <typename Pointer>
Pointer WithCellArray(Pointer mesh, const char* name, const std::vector<double>& values)
{
  mesh->GetCellData()->AddArray(MakeArray(name, mesh->GetNumberOfCells(),
    [&](vtkIdType i) { return values[static_cast<std::size_t>(i)]; }));
  return mesh;
}

}

#endif
