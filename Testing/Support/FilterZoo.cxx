// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/FilterZoo.h"

#include "Support/FilterRun.h"
#include "Support/LocatorCalls.h"
#include "Support/MakeOf.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkCompositeDataIterator.h"
#include "vtkHyperTreeGrid.h"
#include "vtkSkdTreeAMR.h"
#include "vtkSkdTreeAttach.h"
#include "vtkSkdTreeBooleanOperation.h"
#include "vtkSkdTreeClosestPoint.h"
#include "vtkSkdTreeCompareSurfaces.h"
#include "vtkSkdTreeCurveIntersection.h"
#include "vtkSkdTreeCurveSurfaceIntersection.h"
#include "vtkSkdTreeMeshAdaptation.h"
#include "vtkSkdTreeMeshRefinement.h"
#include "vtkSkdTreePointInOut.h"
#include "vtkSkdTreeProbe.h"
#include "vtkSkdTreeRays.h"
#include "vtkSkdTreeRemap.h"
#include "vtkSkdTreeRepresentation.h"
#include "vtkSkdTreeSpatialQuery.h"
#include "vtkSkdTreeSurfaceIntersection.h"
#include "vtkSkdTreeWallThickness.h"
#include "vtkTable.h"

#include <cstring>

namespace skdtest
{

namespace
{
using AlgorithmPointer = vtkSmartPointer<vtkAlgorithm>;

constexpr double Coarse = 0.03; // ChordalDeviation: few facets of curved cells will do

const Bounds Around = { -0.3, 2.8, -0.3, 2.8, -0.3, 2.8 };

PolyDataPointer SomePoints()
{
  Random random(7);
  std::vector<Point> points;
  for (int i = 0; i < 20; ++i)
  {
    points.push_back(random.InBox(Around));
  }
  return MakeQueries(points);
}

PolyDataPointer SomeLines()
{
  Mesh mesh;
  Random random(8);
  for (int line = 0; line < 2; ++line)
  {
    Ids ids;
    for (int i = 0; i < 3; ++i)
    {
      ids.push_back(mesh.Add(random.InBox(Around)));
    }
    mesh.Add(VTK_POLY_LINE, ids);
  }
  return WithData(MakePolyData(mesh));
}

PolyDataPointer SomeSurface()
{
  return WithData(MakePolyData(Transformed(SphereTriangles(2), 0.8, { 1.21, 1.27, 1.23 })));
}

GridPointer SomeVolumes()
{
  return WithData(MakeGrid(Transformed(Hexahedra(2), 1.2, { 0.01, 0.02, 0.03 })));
}

AlgorithmPointer MakeClosest(vtkDataObject* input, vtkDataObject* source, bool isSigned)
{
  const auto filter = MakeOf<vtkSkdTreeClosestPoint>(input, source);
  filter->SetSignedDistance(isSigned);
  filter->SetChordalDeviation(Coarse);
  filter->InterpolateSourceDataOn();
  filter->GenerateLinesOn();
  return filter;
}

AlgorithmPointer MakeComparison(vtkDataObject* input, vtkDataObject* source, bool isSigned)
{
  const auto filter = MakeOf<vtkSkdTreeCompareSurfaces>(input, source);
  filter->SetSignedDistance(isSigned);
  filter->SetChordalDeviation(Coarse);
  filter->SetMaximumBisections(1000);
  return filter;
}

AlgorithmPointer MakeRays(vtkDataObject* input, vtkDataObject* source, bool isFromCells)
{
  const auto filter = MakeOf<vtkSkdTreeRays>(input, source);
  filter->SetStart(isFromCells ? vtkSkdTreeRays::CELL_CENTERS : vtkSkdTreeRays::POINTS);
  filter->SetAlongToDirection();
  filter->SetDirection(0.3, 0.2, -0.9);
  filter->BothWaysOn();
  filter->SetHitsToAllHits();
  filter->InterpolateSourceDataOn();
  return filter;
}

AlgorithmPointer MakeThickness(vtkDataObject* input, vtkDataObject* source, int method)
{
  const auto filter = MakeOf<vtkSkdTreeWallThickness>(input, source);
  filter->SetMethod(method);
  filter->SetNumberOfRays(3);
  return filter;
}

AlgorithmPointer MakeInOutOf(vtkDataObject* input, vtkDataObject* source, int ask, int model)
{
  const auto filter = MakeOf<vtkSkdTreePointInOut>(input, source);
  filter->SetChordalDeviation(Coarse);
  filter->SetAsk(ask);
  filter->SetModel(model);
  filter->SetExtract(vtkSkdTreePointInOut::INSIDE);
  return filter;
}

AlgorithmPointer MakeProbeOf(vtkDataObject* input, vtkDataObject* source)
{
  const auto filter = MakeOf<vtkSkdTreeProbe>(input, source);
  filter->ProbeLinesOn();
  filter->AddGradientArray("Linear");
  return filter;
}

AlgorithmPointer MakeRemapOf(vtkDataObject* input, vtkDataObject* source, int method)
{
  const auto filter = MakeOf<vtkSkdTreeRemap>(input, source);
  filter->SetMethod(method);
  filter->GenerateWeightsOn();
  return filter;
}

AlgorithmPointer MakeQueryOf(vtkDataObject* input, vtkDataObject* source, int shape, int relation)
{
  const auto filter = MakeOf<vtkSkdTreeSpatialQuery>(input, source);
  filter->SetShape(shape);
  filter->SetRelation(relation);
  filter->SetBoxPosition(0.4, 0.4, 0.4);
  filter->SetBoxLength(1.5, 1.5, 1.5);
  return filter;
}

AlgorithmPointer MakeIntersectionOf(vtkDataObject* input, vtkDataObject* source)
{
  const auto filter = MakeOf<vtkSkdTreeSurfaceIntersection>(input, source);
  filter->SetChordalDeviation(Coarse);
  filter->SplitSurfacesOn();
  return filter;
}

AlgorithmPointer MakeBooleanOf(vtkDataObject* input, vtkDataObject* source, int operation)
{
  const auto filter = MakeOf<vtkSkdTreeBooleanOperation>(input, source);
  filter->SetChordalDeviation(Coarse);
  filter->SetOperation(operation);
  return filter;
}

AlgorithmPointer MakeCurves(vtkDataObject* input, vtkDataObject* source)
{
  const auto filter = MakeOf<vtkSkdTreeCurveIntersection>(input, source);
  filter->InterpolateDataOn();
  return filter;
}

AlgorithmPointer MakeCurveSurface(vtkDataObject* input, vtkDataObject* source)
{
  const auto filter = MakeOf<vtkSkdTreeCurveSurfaceIntersection>(input, source);
  filter->VolumeFacesOn();
  filter->CutCurvesOn();
  return filter;
}

AlgorithmPointer MakeAMROf(vtkDataObject* parts, int type)
{
  const auto filter = MakeOf<vtkSkdTreeAMR>(parts, nullptr);
  filter->SetChordalDeviation(Coarse);
  filter->SetMaximumLevel(1);
  filter->SetInsideLevel(1);
  filter->AutomaticBoundsOff();
  filter->SetBaseBounds(-0.31, 2.83, -0.37, 2.89, -0.33, 2.81);
  filter->SetBaseDimensions(2, 2, 2);
  filter->ComputeDistanceOn();
  filter->ComputeInsideOn();
  filter->SetOutputType(type);
  return filter;
}

/// Refines the input where another mesh has certain values.
template <class Filter>
AlgorithmPointer MakeByField(vtkDataObject* input, vtkDataObject* field)
{
  const auto filter = MakeOf<Filter>(input, nullptr);
  filter->SetMaximumLevel(1);
  filter->SetFieldData(field);
  filter->AddFieldArray("Linear");
  filter->AddFieldArray("Number");
  filter->SetFieldTest(Filter::VALUE);
  filter->SetFieldRange(7.0, 20.0);
  return filter;
}

AlgorithmPointer MakeRefinementOf(vtkDataObject* mesh, vtkDataObject* parts, vtkDataObject* surface)
{
  const auto filter = MakeOf<vtkSkdTreeMeshRefinement>(mesh, parts);
  filter->SetMaximumLevel(1);
  if (surface)
  {
    filter->SetSurfaceData(surface);
    filter->SetPointPlacement(vtkSkdTreeMeshRefinement::SURFACE);
  }
  return filter;
}

AlgorithmPointer MakeAdaptationOf(vtkDataObject* mesh, vtkDataObject* data)
{
  const auto filter = MakeOf<vtkSkdTreeMeshAdaptation>(mesh, data);
  filter->SetMaximumIterations(2);
  return filter;
}

template <class Filter>
AlgorithmPointer MakeAlone(vtkDataObject* input)
{
  return MakeOf<Filter>(input, nullptr);
}

std::vector<FilterSetup> MakeDistances()
{
  using Data = vtkDataObject;
  return {
    { "ClosestPointOn", [](Data* mesh) { return MakeClosest(SomePoints(), mesh, false); } },
    { "ClosestPointSigned", [](Data* mesh) { return MakeClosest(SomePoints(), mesh, true); } },
    { "ClosestPointFrom", [](Data* mesh) { return MakeClosest(mesh, SomeSurface(), true); } },
    { "RaysOn", [](Data* mesh) { return MakeRays(SomePoints(), mesh, false); } },
    { "RaysFrom", [](Data* mesh) { return MakeRays(mesh, SomeSurface(), true); } },
    { "ThicknessOf",
      [](Data* mesh) { return MakeThickness(mesh, nullptr, vtkSkdTreeWallThickness::SPHERES); } },
    { "ThicknessTo",
      [](Data* mesh)
      { return MakeThickness(SomeSurface(), mesh, vtkSkdTreeWallThickness::RAYS); } },
    { "CompareOf", [](Data* mesh) { return MakeComparison(mesh, SomeSurface(), false); } },
    { "CompareWith", [](Data* mesh) { return MakeComparison(SomeSurface(), mesh, true); } },
  };
}

std::vector<FilterSetup> MakeIntersections()
{
  using Data = vtkDataObject;
  return {
    { "SurfaceIntersection", [](Data* mesh) { return MakeIntersectionOf(mesh, SomeSurface()); } },
    { "SurfaceWithItself", [](Data* mesh) { return MakeIntersectionOf(mesh, nullptr); } },
    { "BooleanDifference",
      [](Data* mesh)
      { return MakeBooleanOf(mesh, SomeSurface(), vtkSkdTreeBooleanOperation::DIFFERENCE); } },
    { "BooleanCut",
      [](Data* mesh)
      { return MakeBooleanOf(SomeVolumes(), mesh, vtkSkdTreeBooleanOperation::INTERSECTION); } },
    { "Imprint",
      [](Data* mesh)
      { return MakeBooleanOf(mesh, nullptr, vtkSkdTreeBooleanOperation::IMPRINT); } },
    { "CurveIntersection", [](Data* mesh) { return MakeCurves(mesh, SomeLines()); } },
    { "CurveOnSurface", [](Data* mesh) { return MakeCurveSurface(SomeLines(), mesh); } },
    { "CurveThrough", [](Data* mesh) { return MakeCurveSurface(mesh, SomeSurface()); } },
  };
}

std::vector<FilterSetup> MakeSetups()
{
  using InOut = vtkSkdTreePointInOut;
  using Query = vtkSkdTreeSpatialQuery;
  using Remap = vtkSkdTreeRemap;
  using Data = vtkDataObject;
  return {
    { "InOutOf",
      [](Data* mesh)
      { return MakeInOutOf(SomePoints(), mesh, InOut::POINTS, InOut::BOUNDARIES); } },
    { "InOutOfCells",
      [](Data* mesh)
      { return MakeInOutOf(SomePoints(), mesh, InOut::POINTS, InOut::BODY_FITTED_MESH); } },
    { "InOutForCorners",
      [](Data* mesh)
      { return MakeInOutOf(mesh, SomeSurface(), InOut::CELLS_ALL_POINTS, InOut::BOUNDARIES); } },
    { "InOutForMiddles",
      [](Data* mesh)
      { return MakeInOutOf(mesh, SomeSurface(), InOut::CELL_CENTERS, InOut::BOUNDARIES); } },
    { "ProbeOf", [](Data* mesh) { return MakeProbeOf(SomeLines(), mesh); } },
    { "ProbeFor", [](Data* mesh) { return MakeProbeOf(mesh, SomeVolumes()); } },
    { "RemapOf",
      [](Data* mesh)
      { return MakeRemapOf(SomeVolumes(), mesh, Remap::CONSERVATIVE_SECOND_ORDER); } },
    { "RemapFor",
      [](Data* mesh) { return MakeRemapOf(mesh, SomeVolumes(), Remap::AUTOMATIC_METHOD); } },
    { "RemapContained",
      [](Data* mesh) { return MakeRemapOf(mesh, SomeSurface(), Remap::CONTAINED); } },
    { "QueryByBox",
      [](Data* mesh) { return MakeQueryOf(mesh, nullptr, Query::BOX, Query::OVERLAP); } },
    { "QueryBySphere",
      [](Data* mesh) { return MakeQueryOf(mesh, nullptr, Query::SPHERE, Query::CONTAINMENT); } },
    { "QueryNearest",
      [](Data* mesh)
      { return MakeQueryOf(mesh, SomePoints(), Query::SOURCE_POINTS, Query::NEAREST); } },
    { "QueryByCells",
      [](Data* mesh)
      { return MakeQueryOf(SomeVolumes(), mesh, Query::SOURCE_CELLS, Query::OVERLAP); } },
    { "QueryAdjacent",
      [](Data* mesh) { return MakeQueryOf(mesh, mesh, Query::SOURCE_CELLS, Query::ADJACENCY); } },
  };
}

std::vector<FilterSetup> MakeMeshes()
{
  using Data = vtkDataObject;
  return {
    { "AMRGrid", [](Data* mesh) { return MakeAMROf(mesh, vtkSkdTreeAMR::UNSTRUCTURED_GRID); } },
    { "AMRTree", [](Data* mesh) { return MakeAMROf(mesh, vtkSkdTreeAMR::HYPER_TREE_GRID); } },
    { "RefinementOf", [](Data* mesh) { return MakeRefinementOf(mesh, SomeSurface(), nullptr); } },
    { "RefinementAt",
      [](Data* mesh) { return MakeRefinementOf(SomeVolumes(), mesh, SomeSurface()); } },
    { "RefinementOnto",
      [](Data* mesh) { return MakeRefinementOf(SomeVolumes(), SomeSurface(), mesh); } },
    { "AdaptationOf", [](Data* mesh) { return MakeAdaptationOf(mesh, SomeSurface()); } },
  };
}

/// Further parts that a mesh may take, and filters that pass it on.
std::vector<FilterSetup> MakeFurtherSetups()
{
  using Data = vtkDataObject;
  return {
    { "CurveIntersectionBy", [](Data* mesh) { return MakeCurves(SomeLines(), mesh); } },
    { "CurveWithItself", [](Data* mesh) { return MakeCurves(mesh, nullptr); } },
    { "ThicknessSpheresTo",
      [](Data* mesh)
      { return MakeThickness(SomeSurface(), mesh, vtkSkdTreeWallThickness::SPHERES); } },
    { "ThicknessAlone",
      [](Data* mesh) { return MakeThickness(mesh, nullptr, vtkSkdTreeWallThickness::RAYS); } },
    { "AMRField", [](Data* mesh) { return MakeByField<vtkSkdTreeAMR>(SomeSurface(), mesh); } },
    { "RefinementField",
      [](Data* mesh) { return MakeByField<vtkSkdTreeMeshRefinement>(SomeVolumes(), mesh); } },
    { "AdaptationTo", [](Data* mesh) { return MakeAdaptationOf(SomeSurface(), mesh); } },
    { "Representation", MakeAlone<vtkSkdTreeRepresentation> },
    { "Attach", MakeAlone<vtkSkdTreeAttach> },
  };
}

void AddArrays(vtkFieldData* field, std::vector<double>& answers)
{
  for (int i = 0; i < field->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = field->GetArray(i);
    const bool isTime = array && array->GetName() && std::strstr(array->GetName(), "Seconds");
    for (vtkIdType k = 0; array && !isTime && k < array->GetNumberOfValues(); ++k)
    {
      answers.push_back(array->GetComponent(
        k / array->GetNumberOfComponents(), static_cast<int>(k % array->GetNumberOfComponents())));
    }
  }
}

void AddMesh(vtkDataSet* mesh, std::vector<double>& answers)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* x = mesh->GetPoint(i);
    answers.insert(answers.end(), x, x + 3);
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    answers.push_back(mesh->GetCellType(i));
    mesh->GetCellPoints(i, ids);
    answers.insert(answers.end(), ids->begin(), ids->end());
  }
  AddArrays(mesh->GetPointData(), answers);
  AddArrays(mesh->GetCellData(), answers);
}

void AddData(vtkDataObject* data, std::vector<double>& answers)
{
  if (auto* mesh = vtkDataSet::SafeDownCast(data))
  {
    AddMesh(mesh, answers);
  }
  else if (auto* table = vtkTable::SafeDownCast(data))
  {
    AddArrays(table->GetRowData(), answers);
  }
  else if (auto* tree = vtkHyperTreeGrid::SafeDownCast(data))
  {
    AddArrays(tree->GetCellData(), answers);
  }
}
}

const std::vector<FilterSetup>& AllFilterSetups()
{
  static const std::vector<FilterSetup> setups = []
  {
    std::vector<FilterSetup> all = MakeDistances();
    for (const auto& others :
      { MakeIntersections(), MakeSetups(), MakeMeshes(), MakeFurtherSetups() })
    {
      all.insert(all.end(), others.begin(), others.end());
    }
    return all;
  }();
  return setups;
}

std::vector<double> AnswersOf(vtkAlgorithm* filter)
{
  std::vector<double> answers;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    AddData(filter->GetOutputDataObject(port), answers);
    answers.push_back(-1.0 - port);
  }
  return answers;
}

bool AreEqual(const std::vector<double>& a, const std::vector<double>& b)
{
  const auto isSame = [](double x, double y) { return x == y || (x != x && y != y); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), isSame);
}

std::vector<double> LocatorAnswers(vtkDataSet* mesh)
{
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(mesh);
  locator->CacheCellBoundsOn();
  locator->BuildLocator();
  std::vector<double> answers;
  const auto add = [&](const Ids& ids) { answers.insert(answers.end(), ids.begin(), ids.end()); };
  Random random(9);
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < 10; ++i)
  {
    Point a = random.InBox(Around);
    const Point b = random.InBox(Around);
    const Closest closest = FindClosest(locator, a);
    answers.insert(answers.end(), { double(closest.Cell), closest.Dist2, closest.X[0] });
    answers.push_back(double(FindFirstHit(locator, a, b).Cell));
    answers.push_back(double(locator->FindCell(a.data(), 0.01)));
    answers.push_back(FindClosestCells(locator, a, 3).Number);
    answers.push_back(FindCrossings(locator, a, b).Number);
    answers.push_back(locator->InsideCellBounds(a.data(), i % 8) ? 1 : 0);
    FindAllHits(locator, a, b, 0.01, cell);
    add(FindAlongLine(locator, a, b, 0.1));
    add(FindAlongPlane(locator, a, b, 0.1));
  }
  add(FindWithinBounds(locator, { 0.4, 1.9, 0.4, 1.9, 0.4, 1.9 }));
  return answers;
}

}
