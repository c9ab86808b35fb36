// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// skdtree_trace_benchmark [cells [lines [kind ...]]]: streamlines of a swirl through warped cells
/// by vtkStreamTracer with cell locators, ours and VTK's. Prints a table of processor seconds, the
/// building of locators and all (medians of runs that take turns), of how many times the time with
/// the skD-tree that is, and of the points of the lines. VTK 9.1 is given prototypes; since 9.2 the
/// locator is that of the data set, as vtkSkdTreeAttach sets it, and "further time steps" have
/// another flow on the same mesh, for which Attach keeps the tree.
#include "ProcessorTime.h"
#include "VolumeKinds.h"

#include "Support/FilterRun.h"

#include "vtkCellLocatorInterpolatedVelocityField.h"
#include "vtkModifiedBSPTree.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeAttach.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkStaticCellLocator.h"
#include "vtkStreamTracer.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace skdbench;
using namespace skdtest;

namespace
{
/// Around the vertical axis in the middle of a box, and slowly up.
void SetSwirl(vtkDataSet* mesh, double up)
{
  Bounds box;
  mesh->GetBounds(box.data());
  vtkNew<vtkDoubleArray> flow;
  flow->SetName("Flow");
  flow->SetNumberOfComponents(3);
  flow->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Point x;
    mesh->GetPoint(i, x.data());
    const Point r = x - Center(box);
    flow->SetTuple3(i, -r[1], r[0], up * (box[5] - box[4]));
  }
  mesh->GetPointData()->SetVectors(flow);
}

using LocatorMaker = std::function<vtkSmartPointer<vtkAbstractCellLocator>()>;

template <class Locator>
vtkSmartPointer<vtkAbstractCellLocator> NewLocator()
{
  return vtkSmartPointer<Locator>::New();
}

struct Contender
{
  const char* Name;
  LocatorMaker Make; // empty: vtkSkdTreeAttach, kept
  vtkSmartPointer<vtkSkdTreeAttach> Attach = {};
  std::vector<double> First = {};
  std::vector<double> Further = {};
  vtkIdType Points = 0;
};

vtkSmartPointer<vtkStreamTracer> MakeTracer(vtkDataSet* seeds)
{
  auto tracer = vtkSmartPointer<vtkStreamTracer>::New();
  tracer->SetSourceData(seeds);
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(0.5);
  tracer->SetMaximumNumberOfSteps(2000);
  tracer->SetMaximumPropagation(1e30);
  tracer->SetIntegrationDirectionToForward();
  tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Flow");
  return tracer;
}

/// Sets what finds cells: a prototype, or what the mesh has.
void SetLocator(vtkStreamTracer* tracer, vtkPointSet* mesh, const LocatorMaker& make)
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  (void)mesh;
  vtkNew<vtkCellLocatorInterpolatedVelocityField> field;
  field->SetCellLocatorPrototype(make());
  tracer->SetInterpolatorPrototype(field);
#else
  tracer->SetInterpolatorType(vtkStreamTracer::INTERPOLATOR_WITH_CELL_LOCATOR);
  if (make)
  {
    const auto locator = make();
    locator->SetDataSet(mesh);
    mesh->SetCellLocator(locator);
  }
#endif
}

/// One time step: a copy of the mesh's arrays with a flow of its own.
void Trace(Contender& contender, vtkDataSet* mesh, vtkDataSet* seeds, int step)
{
  auto fresh = GridPointer::New();
  fresh->ShallowCopy(mesh);
  SetSwirl(fresh, 0.02 + 0.002 * step);
  const double start = ProcessorSeconds();
  const auto tracer = MakeTracer(seeds);
  vtkPointSet* traced = fresh;
  if (!contender.Make)
  {
    contender.Attach->SetInputData(fresh);
    contender.Attach->Update();
    traced = vtkPointSet::SafeDownCast(contender.Attach->GetOutputDataObject(0));
  }
  SetLocator(tracer, traced, contender.Make);
  tracer->SetInputData(traced);
  tracer->Update();
  (step == 0 ? contender.First : contender.Further).push_back(ProcessorSeconds() - start);
  contender.Points = tracer->GetOutput()->GetNumberOfPoints();
}

std::vector<Contender> MakeContenders()
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  Contender ours{ "vtkSkdTreeCellLocator", NewLocator<vtkSkdTreeCellLocator> };
#else
  Contender ours{ "vtkSkdTreeAttach", {} };
#endif
  return { ours, { "vtkStaticCellLocator", NewLocator<vtkStaticCellLocator> },
    { "vtkModifiedBSPTree", NewLocator<vtkModifiedBSPTree> } };
}

void Measure(const Kind& kind, int cells, int lines)
{
  const int n = std::max(2, static_cast<int>(std::cbrt(double(cells) / kind.CellsACube)));
  const GridPointer mesh = MakeGrid(kind.Make(n).Map(Bent));
  Bounds box;
  mesh->GetBounds(box.data());
  Random random(23);
  std::vector<Point> points;
  for (int i = 0; i < lines; ++i)
  {
    points.push_back(random.InBox(Grown(box, -0.2 * (box[1] - box[0]))));
  }
  const auto seeds = MakeQueries(points);
  std::vector<Contender> contenders = MakeContenders();
  for (int repetition = 0; repetition < 5; ++repetition)
  {
    for (Contender& contender : contenders)
    {
      contender.Attach = vtkSmartPointer<vtkSkdTreeAttach>::New();
      Trace(contender, mesh, seeds, 0);
      Trace(contender, mesh, seeds, 1);
    }
  }
  const double first = Median(contenders.front().First);
  const double further = Median(contenders.front().Further);
  for (const Contender& contender : contenders)
  {
    std::printf("| %lld %s | %s | %.3g | %.2f | %.3g | %.2f | %lld |\n",
      static_cast<long long>(mesh->GetNumberOfCells()), kind.Name, contender.Name,
      Median(contender.First), Median(contender.First) / first, Median(contender.Further),
      Median(contender.Further) / further, static_cast<long long>(contender.Points));
    std::fflush(stdout);
  }
}
}

int main(int argc, char* argv[])
{
  vtkSMPTools::Initialize(1);
  const int cells = argc > 1 ? std::atoi(argv[1]) : 200000;
  const int lines = argc > 2 ? std::atoi(argv[2]) : 200;
  std::printf("%s\n\n", vtkVersion::GetVTKSourceVersion());
  std::printf("| mesh | locator | seconds | x | a further time step | x | points |\n");
  std::printf("| --- | --- | ---: | ---: | ---: | ---: | ---: |\n");
  for (const Kind& kind : Kinds)
  {
    if (IsWanted(kind, argc, argv))
    {
      Measure(kind, cells, lines);
    }
  }
  return 0;
}
