// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterRun.h
 * @brief inputs of filters, and their outputs by value
 */
#ifndef skdtest_FilterRun_h
#define skdtest_FilterRun_h

#include "Support/MeshBuilder.h"
#include "Support/Reported.h"
#include "Support/ValuesOf.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

#include <string>

namespace skdtest
{

/// Points without cells, as filter input.
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

/// A point array, or an empty list when there is none.
inline std::vector<double> PointArray(vtkDataObject* data, const char* name)
{
  return ValuesOf(vtkDataSet::SafeDownCast(data)->GetPointData()->GetArray(name));
}

inline vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(const std::vector<vtkDataObject*>& meshes)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(meshes.size()));
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(i), meshes[i]);
  }
  return blocks;
}

/// So many blocks, of a mesh each.
inline vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(const Mesh& mesh, int count)
{
  std::vector<GridPointer> grids(static_cast<std::size_t>(count));
  std::vector<vtkDataObject*> blocks;
  for (GridPointer& grid : grids)
  {
    grid = MakeGrid(mesh);
    blocks.push_back(grid);
  }
  return MakeBlocks(blocks);
}

/// The cells of a mesh for which `isWanted` returns true.
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

/// Sources in which nothing can be found.
struct NoSources
{
  vtkNew<vtkPolyData> Empty;
  PolyDataPointer NotFinite = [] // a mesh with points that are warned about
  {
    Mesh mesh;
    const Point nowhere{ std::nan(""), 0, 0 };
    mesh.Add(VTK_TRIANGLE, { mesh.Add(nowhere), mesh.Add(nowhere), mesh.Add(nowhere) });
    return MakePolyData(mesh);
  }();
  vtkSmartPointer<vtkMultiBlockDataSet> Blocks = MakeBlocks({ nullptr, this->Empty });

  std::vector<vtkDataObject*> All() const { return { this->Empty, this->NotFinite, this->Blocks }; }
};

inline double Linear(const Point& p)
{
  return 3.0 * p[0] - 2.0 * p[1] + 0.5 * p[2] + 7.0;
}

template <typename Array = vtkDoubleArray>
vtkSmartPointer<Array> MakeArray(
  const char* name, vtkIdType n, const std::function<double(vtkIdType)>& value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    array->SetVariantValue(i, value(i));
  }
  return array;
}

/// Adds Linear() at the points as point data.
template <typename Array = vtkDoubleArray>
void AddLinear(vtkDataSet* mesh, const char* name)
{
  const auto linear = [&](vtkIdType i)
  {
    Point p;
    mesh->GetPoint(i, p.data());
    return Linear(p);
  };
  mesh->GetPointData()->AddArray(MakeArray<Array>(name, mesh->GetNumberOfPoints(), linear));
}

/// Point data "Linear" and "LinearInt", cell data "Number": ten times the cell's id.
template <typename Pointer>
Pointer WithData(Pointer mesh)
{
  AddLinear(mesh, "Linear");
  AddLinear<vtkIntArray>(mesh, "LinearInt");
  const auto number = [](vtkIdType i) { return 10.0 * i; };
  mesh->GetCellData()->AddArray(MakeArray<vtkIntArray>("Number", mesh->GetNumberOfCells(), number));
  return mesh;
}

/// Watches progress, and aborts when it reaches a part.
struct ProgressWatch
{
  explicit ProgressWatch(vtkAlgorithm* algorithm, double abortAt = 2.0)
    : AbortAt(abortAt)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(&ProgressWatch::Look);
    algorithm->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }

  static void Look(vtkObject* caller, unsigned long, void* self, void*)
  {
    auto* watch = static_cast<ProgressWatch*>(self);
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    watch->Seen.push_back(algorithm->GetProgress());
    if (algorithm->GetProgress() >= watch->AbortAt)
    {
      algorithm->SetAbortExecute(1);
    }
  }

  double AbortAt;
  std::vector<double> Seen;
  vtkNew<vtkCallbackCommand> Command;
};

/// Aborts an update when its progress reaches a part; another one then runs to its end. Returns the
/// progress that was seen.
inline std::vector<double> AbortAt(vtkAlgorithm* algorithm, double part)
{
  ProgressWatch watch(algorithm, part);
  algorithm->Update();
  algorithm->RemoveObserver(watch.Command);
  algorithm->SetAbortExecute(0);
  algorithm->Modified();
  return watch.Seen;
}

}

#endif
