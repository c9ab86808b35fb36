// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// skdtree_boolean_benchmark [--novtk] [triangles or file ...]: combinations of two solids, beside
/// vtkBooleanOperationPolyDataFilter and, where it is found, CGAL's corefinement. Two spheres that
/// cross, or a file's closed surface and its copy, moved by irrational distances. Prints a table of
/// processor seconds of one thread, trees and all (of CGAL without conversion from and to VTK's
/// data), and of how many times the skD-tree's time that is: medians of runs that take turns. Then
/// for each who answered: volume, area, bad edges (those that triangles do not pass as often in one
/// direction as in the other), and the Hausdorff distance from the skD-tree's result, relative to
/// the length of the bounds. VTK's filter is asked once, and no more after 100 seconds.
#include "Boolean.h"
#include "ProcessorTime.h"
#include "Sphere.h"

#include "Support/RealMeshes.h"

#include "vtkBooleanOperationPolyDataFilter.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeBooleanOperation.h"
#include "vtkSkdTreeCompareSurfaces.h"
#include "vtkTable.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

using namespace skdbench;
using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;
constexpr double TooLong = 100.0; // seconds

BooleanResult RunSkdTree(vtkPolyData* first, vtkPolyData* second, int operation)
{
  const double start = ProcessorSeconds();
  vtkNew<Filter> filter;
  filter->SetInputData(first);
  filter->SetSourceData(second);
  filter->SetOperation(operation);
  filter->Update();
  return { vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)), ProcessorSeconds() - start };
}

BooleanResult RunVtk(vtkPolyData* first, vtkPolyData* second, int operation)
{
  const double start = ProcessorSeconds();
  vtkNew<vtkBooleanOperationPolyDataFilter> filter;
  const bool isReversed = operation == Filter::REVERSE_DIFFERENCE;
  filter->SetInputData(0, isReversed ? second : first);
  filter->SetInputData(1, isReversed ? first : second);
  filter->SetOperation(std::min(operation, 2));
  filter->Update();
  return { filter->GetOutput(), ProcessorSeconds() - start };
}

struct Contender
{
  const char* Name;
  std::function<BooleanResult(vtkPolyData*, vtkPolyData*, int)> Run;
  int Turns;
  bool IsIn = true;
  BooleanResult Last = {};
  std::vector<double> Seconds = {};
};

struct Measures
{
  double Volume = 0.0;
  double Area = 0.0;
  std::size_t BadEdges = 0;
};

Measures Measure(vtkPolyData* surface)
{
  const Mesh mesh = Triangulated(SurfaceOf(surface));
  Measures measures;
  std::map<std::pair<vtkIdType, vtkIdType>, int> passes;
  for (const CellSpec& cell : mesh.Cells)
  {
    Point x[3];
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = cell.Points[i];
      const vtkIdType b = cell.Points[(i + 1) % 3];
      x[i] = mesh.Points[a] - mesh.Points[0];
      passes[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : a > b ? -1 : 0;
    }
    measures.Volume += Dot(x[0], Cross(x[1], x[2])) / 6.0;
    measures.Area += 0.5 * Length(Cross(x[1] - x[0], x[2] - x[0]));
  }
  measures.BadEdges = static_cast<std::size_t>(
    std::count_if(passes.begin(), passes.end(), [](const auto& edge) { return edge.second != 0; }));
  return measures;
}

double HausdorffDistance(vtkPolyData* first, vtkPolyData* second)
{
  vtkNew<vtkSkdTreeCompareSurfaces> compare;
  compare->SetInputData(first);
  compare->SetSourceData(second);
  compare->SetSampleSpacing(1.0);
  compare->SetStatisticsTolerance(1.0); // no means are wanted
  compare->Update();
  auto* table = vtkTable::SafeDownCast(compare->GetOutputDataObject(2));
  return table->GetValueByName(2, "HausdorffDistance").ToDouble();
}

using SurfacePointer = vtkSmartPointer<vtkPolyData>;

SurfacePointer Moved(vtkPolyData* surface)
{
  const double length = surface->GetLength();
  const Point offset = { 0.1 * length * std::sqrt(2.0), 0.05 * length * std::sqrt(3.0),
    0.02 * length * std::sqrt(5.0) };
  return MakePolyData(Transformed(SurfaceOf(surface), 1.0, offset));
}

void PrintResults(const std::vector<Contender>& contenders)
{
  for (const Contender& contender : contenders)
  {
    if (contender.IsIn && contender.Last.Surface)
    {
      const Measures m = Measure(contender.Last.Surface);
      const SurfacePointer ours = contenders.front().Last.Surface;
      std::printf(
        "#   %-10s volume %.15g, area %.15g, %zu bad edges, %lld triangles, distance %.1e",
        contender.Name, m.Volume, m.Area, m.BadEdges,
        static_cast<long long>(contender.Last.Surface->GetNumberOfCells()),
        HausdorffDistance(ours, contender.Last.Surface) / ours->GetLength());
      std::printf(", conversion %.3g s\n", contender.Last.Conversion);
    }
  }
}

void Compare(const std::string& name, std::vector<Contender>& contenders, vtkPolyData* first,
  vtkPolyData* second, int operation)
{
  for (int turn = 0; turn < 5; ++turn)
  {
    for (Contender& contender : contenders)
    {
      if (contender.IsIn && turn < contender.Turns)
      {
        contender.Last = contender.Run(first, second, operation);
        contender.Seconds.push_back(contender.Last.Seconds);
      }
    }
  }
  const char* names[] = { "union", "intersection", "difference", "reverse difference" };
  std::printf("| %s | %lld | %s |", name.c_str(),
    static_cast<long long>(first->GetNumberOfCells() + second->GetNumberOfCells()),
    names[operation]);
  for (const Contender& contender : contenders)
  {
    if (!contender.IsIn || !contender.Last.Surface)
    {
      std::printf(contender.IsIn ? " refused |" : " - |");
      continue;
    }
    const double seconds = Median(contender.Seconds);
    std::printf(" %.3g s, %.3g x |", seconds, seconds / Median(contenders.front().Seconds));
  }
  std::printf("\n");
  PrintResults(contenders);
  for (Contender& contender : contenders)
  {
    contender.IsIn = contender.IsIn && contender.Seconds.front() < TooLong;
    contender.Seconds.clear();
  }
  std::fflush(stdout);
}

SurfacePointer ReadSolid(const std::string& file)
{
  const DataSetPointer data = ReadMesh(file);
  const Mesh mesh = data ? SurfaceOf(data) : Mesh();
  return mesh.Cells.empty() ? nullptr : SurfacePointer(MakePolyData(Triangulated(mesh)));
}
}

int main(int argc, char* argv[])
{
  vtkSMPTools::Initialize(1);
  std::vector<Contender> contenders = { { "skD-tree", RunSkdTree, 5 }, { "VTK", RunVtk, 1 } };
#ifdef SKDBENCH_HAS_CGAL
  contenders.push_back({ "CGAL", RunCgalBoolean, 3 });
#endif
  std::vector<std::string> scenes;
  for (int i = 1; i < argc; ++i)
  {
    const bool isOption = std::string(argv[i]) == "--novtk";
    contenders[1].IsIn = contenders[1].IsIn && !isOption;
    if (!isOption)
    {
      scenes.emplace_back(argv[i]);
    }
  }
  std::printf("| solids | triangles of both | operation |");
  for (const Contender& contender : contenders)
  {
    std::printf(" %s |", contender.Name);
  }
  std::printf("\n| --- | ---: | --- |%s\n",
    contenders.size() == 2 ? " ---: | ---: |" : " ---: | ---: | ---: |");
  for (const std::string& scene :
    scenes.empty() ? std::vector<std::string>{ "1e3", "1e4", "1e5" } : scenes)
  {
    const double triangles = std::atof(scene.c_str());
    const bool isFile = std::filesystem::exists(scene);
    const SurfacePointer first = isFile ? ReadSolid(scene) : MakeSphere(triangles, 0.0);
    if (!first)
    {
      std::printf("# no triangles: %s\n", scene.c_str());
      continue;
    }
    const SurfacePointer second = isFile ? Moved(first) : MakeSphere(triangles, 0.9);
    const std::string name = isFile ? scene.substr(scene.rfind('/') + 1) : "two spheres";
    for (int operation = 0; operation < 3; ++operation)
    {
      Compare(name, contenders, first, second, operation);
    }
  }
  return 0;
}
