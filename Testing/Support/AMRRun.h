// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AMRRun.h
 * @brief vtkSkdTreeAMR run on parts, and its output by value
 */
#ifndef skdtest_AMRRun_h
#define skdtest_AMRRun_h

#include "Support/EventCounter.h"
#include "Support/MeshBuilder.h"
#include "Support/Reported.h"
#include "Support/SurfaceMeshes.h"
#include "Support/ValuesOf.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkSkdTreeAMR.h"

#include <string>

namespace skdtest
{

using AMRPointer = vtkSmartPointer<vtkSkdTreeAMR>;

inline AMRPointer MakeAMR(vtkDataObject* parts, int levels)
{
  auto filter = AMRPointer::New();
  filter->SetInputDataObject(0, parts);
  filter->SetMaximumLevel(levels);
  filter->SetOutputType(vtkSkdTreeAMR::UNSTRUCTURED_GRID);
  return filter;
}

inline PolyDataPointer MakeTorus()
{
  return MakePolyData(TorusTriangles(24, 12));
}

/// One base cell of given bounds.
inline AMRPointer MakeAMRIn(vtkDataObject* parts, int levels, const Bounds& box)
{
  AMRPointer filter = MakeAMR(parts, levels);
  filter->AutomaticBoundsOff();
  filter->SetBaseBounds(box[0], box[1], box[2], box[3], box[4], box[5]);
  filter->SetBaseDimensions(1, 1, 1);
  return filter;
}

/// Bounds around a data set in no special place.
inline Bounds OddBounds(vtkDataSet* data)
{
  Bounds box;
  data->GetBounds(box.data());
  const double by = Diagonal(box);
  return { box[0] - 0.0371 * by, box[1] + 0.0873 * by, box[2] - 0.1171 * by, box[3] + 0.0311 * by,
    box[4] - 0.0593 * by, box[5] + 0.0719 * by };
}

/// The numbers of a report after an update; empty if there are none.
inline std::vector<double> CellArray(vtkSkdTreeAMR* filter, const char* name)
{
  return ValuesOf(
    filter->GetOutputDataObject(0)->GetAttributes(vtkDataObject::CELL)->GetArray(name));
}

/// A leaf of an unstructured output.
struct Leaf
{
  Bounds Box;
  int Level;
  bool IsCut;
};

inline std::vector<Leaf> LeavesOf(vtkSkdTreeAMR* filter)
{
  auto grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  const std::vector<double> levels = CellArray(filter, "SkdLevel");
  const std::vector<double> cut = CellArray(filter, "SkdCut");
  std::vector<Leaf> leaves(levels.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    grid->GetCellBounds(static_cast<vtkIdType>(i), leaves[i].Box.data());
    leaves[i].Level = static_cast<int>(levels[i]);
    leaves[i].IsCut = cut[i] != 0;
  }
  return leaves;
}

inline std::vector<Leaf> RunLeaves(vtkSkdTreeAMR* filter)
{
  filter->Update();
  return LeavesOf(filter);
}

/// The leaf that holds a point.
inline const Leaf* FindLeaf(const std::vector<Leaf>& leaves, const Point& x)
{
  for (const Leaf& leaf : leaves)
  {
    if (Contains(leaf.Box, x))
    {
      return &leaf;
    }
  }
  return nullptr;
}

inline double VolumeOf(const std::vector<Leaf>& leaves)
{
  double volume = 0.0;
  for (const Leaf& leaf : leaves)
  {
    volume +=
      (leaf.Box[1] - leaf.Box[0]) * (leaf.Box[3] - leaf.Box[2]) * (leaf.Box[5] - leaf.Box[4]);
  }
  return volume;
}

}

#endif
