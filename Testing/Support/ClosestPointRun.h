// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosestPointRun.h
 * @brief vtkSkdTreeClosestPoint run on points and a source, and its output by value
 */
#ifndef skdtest_ClosestPointRun_h
#define skdtest_ClosestPointRun_h

#include "Support/MeshBuilder.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkSkdTreeClosestPoint.h"

#include <string>

namespace skdtest
{

using FilterPointer = vtkSmartPointer<vtkSkdTreeClosestPoint>;

/// Points without cells, which is all that the filter wants of its input.
inline PolyDataPointer MakeQueries(const std::vector<Point>& points)
{
  auto queries = PolyDataPointer::New();
  queries->SetPoints(MakePoints(points));
  return queries;
}

/// Random points in the bounds of a source and around.
inline std::vector<Point> RandomQueries(vtkDataSet* source, int count, int seed = 5)
{
  Bounds box;
  source->GetBounds(box.data());
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(random.InBox(Grown(box, (i % 3) * 0.25 * Diagonal(box))));
  }
  return points;
}

inline FilterPointer MakeFilter(vtkDataObject* input, vtkDataObject* source)
{
  auto filter = FilterPointer::New();
  filter->SetInputDataObject(0, input);
  filter->SetSourceData(source);
  return filter;
}

inline FilterPointer MakeSignedFilter(vtkDataObject* input, vtkDataObject* source)
{
  FilterPointer filter = MakeFilter(input, source);
  filter->SignedDistanceOn();
  return filter;
}

/// A point array, or an empty list when there is none.
inline std::vector<double> PointArray(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = vtkDataSet::SafeDownCast(data)->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    values.push_back(array->GetVariantValue(i).ToDouble());
  }
  return values;
}

/// The values of a point array of a filter's first output, after an update.
inline std::vector<double> RunArray(vtkSkdTreeClosestPoint* filter, const char* name)
{
  filter->Update();
  return PointArray(filter->GetOutput(), name);
}

inline std::vector<double> RunDistances(vtkSkdTreeClosestPoint* filter)
{
  return RunArray(filter, "SkdDistance");
}

/// A number of the report, NaN when there is none.
inline double Reported(vtkSkdTreeClosestPoint* filter, const std::string& what)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray(("SkdReport" + what).c_str());
  return array ? array->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
}

inline int RunTreesBuilt(vtkSkdTreeClosestPoint* filter)
{
  filter->Update();
  return static_cast<int>(Reported(filter, "TreesBuilt"));
}

inline vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(const std::vector<vtkDataObject*>& leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(leaves.size()));
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(i), leaves[i]);
  }
  return blocks;
}

/// The cells of a mesh for which `isWanted` tells true.
inline Mesh Part(const Mesh& mesh, const std::function<bool(std::size_t)>& isWanted)
{
  Mesh part;
  part.Points = mesh.Points;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (isWanted(cell))
    {
      part.Cells.push_back(mesh.Cells[cell]);
    }
  }
  return part;
}

}

#endif
