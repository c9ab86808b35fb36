// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Adaptation/SkdMeshAdapter.h"

#include "Core/Meshing/Adaptation/FitShape.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkTable.h"

namespace skdtree
{
namespace
{
// Coordinates in single precision, and positions that were rounded to some digits.
constexpr double PlaneTolerance = 1e-6;
constexpr double SphereTolerance = 1e-5;

bool FitShape(
  const std::vector<skd::Vector3>& points, SkdSurfaceChoice choice, skd::SurfaceShape& shape)
{
  const bool wantsPlane =
    choice == SkdSurfaceChoice::Automatic || choice == SkdSurfaceChoice::Plane;
  const bool wantsSphere =
    choice == SkdSurfaceChoice::Automatic || choice == SkdSurfaceChoice::Sphere;
  return (wantsPlane && skd::FitPlane(points, PlaneTolerance, shape)) ||
    (wantsSphere && skd::FitSphere(points, SphereTolerance, shape));
}
}

bool SkdMeshAdapter::Begin(
  const std::vector<SkdBlock>& inputs, SkdSurfaceChoice choice, std::string& problem)
{
  this->Moved = SkdMovedMesh(inputs);
  this->Shape = skd::SurfaceShape();
  this->Reference = nullptr;
  this->Outcome = skd::AdaptOutcome();
  this->MeasureOfField = -1.0;
  this->Previous.clear();
  const skd::SurfaceMesh& mesh = this->Moved.Mesh;
  if (mesh.Cells.size() == 0)
  {
    problem = "Input has no triangles, quads or polygons that could move.";
    return false;
  }
  if (!FitShape(mesh.Points, choice, this->Shape))
  {
    if (choice == SkdSurfaceChoice::Plane || choice == SkdSurfaceChoice::Sphere)
    {
      const bool isPlane = choice == SkdSurfaceChoice::Plane;
      problem = std::string("The points of Input are not on a ") + (isPlane ? "plane" : "sphere") +
        ": set Surface to Automatic or Input Surface.";
      return false;
    }
    this->LayReference();
  }
  this->Best = State{ mesh.Points, {}, {}, {} };
  this->FirstAreas.clear();
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    this->FirstAreas.push_back(skd::CellArea(mesh, this->Shape, cell));
  }
  this->Best.Areas = this->FirstAreas;
  return true;
}

void SkdMeshAdapter::LayReference()
{
  this->Reference = vtkSmartPointer<vtkSkdTreeCellLocator>::New();
  this->Reference->SetDataSet(this->Moved.MakePolyData({ { 0.0, 0.0, 0.0 } }));
  this->Reference->BuildLocator();
  vtkSkdTreeCellLocator* locator = this->Reference;
  vtkNew<vtkGenericCell> cell;
  this->Shape.FindClosest = [locator, cell = vtkSmartPointer<vtkGenericCell>(cell)](
                              const skd::Vector3& x)
  {
    skd::Vector3 closest = x;
    vtkIdType cellId = -1;
    int subId = 0;
    double dist2 = 0.0;
    locator->FindClosestPoint(x.X, closest.X, cell, cellId, subId, dist2);
    return cellId >= 0 ? closest : x;
  };
}

void SkdMeshAdapter::Run(const skd::AdaptRules& rules, bool keepsAll, const FindField& find,
  const Look& look, const Integrate& integrate)
{
  State now;
  const skd::Vector3 nothing{ { 0.0, 0.0, 0.0 } };
  const skd::Vector3 origin = this->IsOnSphere() ? this->Shape.Centre : nothing;
  const auto findField = [&](const skd::SurfaceMesh& mesh, std::vector<double>& field)
  {
    now.Points = mesh.Points;
    const bool isFound = find(this->Moved.MakePolyData(origin), field);
    now.Field = field;
    return isFound;
  };
  const auto lookOn = [&](const skd::AdaptState& state)
  {
    now.Monitor = state.Monitor;
    now.Areas = state.Areas;
    if (state.IsBest)
    {
      this->Best = now;
    }
    if (keepsAll)
    {
      this->Previous.push_back(now);
    }
    return look(state.Iteration);
  };
  skd::Adaptation adaptation(this->Moved.Mesh, this->Shape, rules);
  this->Outcome = adaptation.Run(findField, lookOn);
  if (integrate && !this->Outcome.Rows.empty() && this->Outcome.End != skd::AdaptEnd::Stopped)
  {
    this->MeasureOfField = adaptation.MeasureOf(integrate(this->Moved.Mesh));
  }
}

void SkdMeshAdapter::Show(const State& state)
{
  this->Moved.Mesh.Points = state.Points;
  this->Shown = state;
}

std::vector<double> SkdMeshAdapter::RatiosOf(const std::vector<double>& areas) const
{
  std::vector<double> ratios(areas);
  for (std::size_t i = 0; i < ratios.size(); ++i)
  {
    ratios[i] = this->FirstAreas[i] > 0.0 ? areas[i] / this->FirstAreas[i] : 1.0;
  }
  return ratios;
}

void SkdMeshAdapter::FillBlocks(const std::vector<SkdBlock>& outputs) const
{
  const std::vector<double> ratios = this->RatiosOf(this->Shown.Areas);
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    if (auto* output = vtkPointSet::SafeDownCast(outputs[i].Mesh))
    {
      this->Moved.SetPoints(i, output);
      this->Moved.AddCellArray(i, output, "SkdFieldMean", this->Shown.Field);
      this->Moved.AddCellArray(i, output, "SkdMonitor", this->Shown.Monitor);
      this->Moved.AddCellArray(i, output, "SkdArea", this->Shown.Areas);
      this->Moved.AddCellArray(i, output, "SkdAreaRatio", ratios);
    }
  }
}

void SkdMeshAdapter::FillTable(vtkTable* table) const
{
  const std::vector<skd::AdaptRow>& rows = this->Outcome.Rows;
  const auto n = static_cast<vtkIdType>(rows.size());
  const auto numbers = SkdMakeArray<vtkIdTypeArray>("SkdIteration", 1, n);
  const auto repaired = SkdMakeArray<vtkIdTypeArray>("SkdPointsCutBack", 1, n);
  const auto measures = SkdMakeArray<vtkDoubleArray>("SkdEquidistributionError", 1, n);
  const auto moves = SkdMakeArray<vtkDoubleArray>("SkdLargestDisplacement", 1, n);
  const auto qualities = SkdMakeArray<vtkDoubleArray>("SkdSmallestQuality", 1, n);
  const auto steps = SkdMakeArray<vtkDoubleArray>("SkdStep", 1, n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const skd::AdaptRow& row = rows[static_cast<std::size_t>(i)];
    numbers->SetValue(i, i);
    measures->SetValue(i, row.Measure);
    moves->SetValue(i, row.Motion.LargestDisplacement);
    qualities->SetValue(i, row.SmallestQuality);
    steps->SetValue(i, row.Motion.Step);
    repaired->SetValue(i, static_cast<vtkIdType>(row.Motion.PointsCutBack));
  }
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ numbers, measures, moves, qualities, steps, repaired })
  {
    table->AddColumn(array);
  }
}
}
