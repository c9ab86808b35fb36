// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Adaptation/SkdFieldAdaptation.h"

#include "Cells/Read/SkdMagnitudes.h"
#include "Meshing/Adaptation/SkdFieldIntegral.h"
#include "Pipeline/SkdLonLat.h"
#include "Pipeline/SkdReport.h"
#include "Remap/SkdContainedMean.h"

#include <sstream>

namespace skdtree
{
namespace
{
/// Tolerances of finding cells, relative to their mean size: in a plane for rounding errors, on
/// curved surfaces for the distance between two approximations.
constexpr double PlaneTolerance = 1e-6;
constexpr double CurvedTolerance = 0.25;

/// Of several parts, as streams write them.
template <class... Parts>
std::string TextOf(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}
}

// Onto the surface that the mesh is on, and about the centre of its sphere. Returns the weights.
std::vector<double> SkdFieldAdaptation::SetPositions(SkdFieldSamples& samples) const
{
  const skd::SurfaceShape& shape = this->Adapter.GetShape();
  const bool isSphere = this->Adapter.IsOnSphere();
  for (skd::Vector3& x : samples.Positions)
  {
    if (isSphere)
    {
      x = this->Request.IsSourceInDegrees ? SkdDirectionOfLonLat(x) : x - shape.Centre;
    }
    else if (skd::IsFinite(x))
    {
      x = shape.Put(x);
    }
  }
  std::vector<double> weights;
  if (this->WeighsByCosine(samples))
  {
    for (const skd::Vector3& x : samples.Positions)
    {
      weights.push_back(SkdCosineOfLatitude(x));
    }
  }
  return weights;
}

bool SkdFieldAdaptation::WeighsByCosine(const SkdFieldSamples& samples) const
{
  const bool isGrid = this->Request.IsSourceInDegrees || samples.IsStructured;
  const SkdFieldWeighing choice = this->Request.Weighing;
  return this->Adapter.IsOnSphere() &&
    (choice == SkdFieldWeighing::CosineOfLatitude ||
      (choice == SkdFieldWeighing::Automatic && isGrid));
}

// Positions were put on a bent surface, which flat cells are off by a part of their size.
double SkdFieldAdaptation::ToleranceOfCells() const
{
  const skd::SurfaceShape& shape = this->Adapter.GetShape();
  const skd::SurfaceMesh& mesh = this->Adapter.GetMesh().Mesh;
  double area = 0.0;
  for (std::uint32_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    area += skd::CellArea(mesh, shape, cell);
  }
  const double size = std::sqrt(area / static_cast<double>(mesh.Cells.size()));
  return shape.What == skd::SurfaceShape::Kind::Sphere ? 0.0
    : shape.What == skd::SurfaceShape::Kind::Plane     ? PlaneTolerance * size
                                                       : CurvedTolerance * size;
}

bool SkdFieldAdaptation::ReadField(vtkDataObject* source, SkdFieldSamples& samples)
{
  samples = SkdFieldSamples::Read(source, this->Request.Array);
  this->NumberOfTooLarge = static_cast<vtkIdType>(samples.TooLarge.size());
  if (this->NumberOfTooLarge > 0)
  {
    this->Tell(false,
      TextOf(this->NumberOfTooLarge, " values of Source's field are infinite or beyond ",
        SkdComparable.Largest, ", the first that of ", samples.FirstTooLarge,
        ", and are ignored: bring the field into another unit."));
  }
  if (!samples.HasAny())
  {
    const std::string name = this->Request.Array.empty() ? "" : "\"" + this->Request.Array + "\" ";
    this->Tell(true,
      "Source has no array " + name +
        "of numbers with a finite value: there is nothing to adapt to. Set FieldArray.");
  }
  return samples.HasAny();
}

bool SkdFieldAdaptation::Run(const std::vector<SkdBlock>& inputs, vtkDataObject* source,
  const SkdAdaptationRequest& request, vtkAlgorithm* algorithm)
{
  SkdStopwatch watch;
  this->Request = request;
  this->Messages.clear();
  std::string problem;
  if (!this->Adapter.Begin(inputs, request.Surface, problem))
  {
    this->Tell(false, problem + " Nothing moves.");
    return false;
  }
  this->TellOfMesh();
  if (request.IsSourceInDegrees && !this->Adapter.IsOnSphere())
  {
    this->Tell(true,
      "Input is not on a sphere: SourceCoordinates cannot be longitude and latitude. Nothing "
      "moves.");
    return false;
  }
  SkdFieldSamples samples;
  if (!this->ReadField(source, samples))
  {
    return false;
  }
  this->Move(source, samples, algorithm);
  this->TellOfOutcome();
  this->Seconds = watch.Lap();
  return !this->Adapter.GetOutcome().Rows.empty();
}

void SkdFieldAdaptation::Move(
  vtkDataObject* source, const SkdFieldSamples& samples, vtkAlgorithm* algorithm)
{
  const bool isOnSphere = this->Adapter.IsOnSphere();
  SkdFieldSamples distinct = samples.Distinct();
  this->NumberOfSamples = distinct.Values.size();
  std::vector<double> weights = this->SetPositions(distinct);
  const SkdContainedMean means(std::move(distinct.Positions), std::move(weights), isOnSphere);
  const double tolerance = this->ToleranceOfCells();
  const double part = 1.0 / (this->Request.Rules.Iterations + 1.0);
  double progress = 0.0;
  const auto find = [&](vtkPolyData* mesh, std::vector<double>& field)
  {
    const SkdTargetCells cells(mesh, isOnSphere, tolerance);
    SkdLoop loop(algorithm, mesh->GetNumberOfCells(), progress, progress + part);
    field = means.GetMeans(cells, distinct.Values, SkdEmptyCells::Nearest, loop);
    return !SkdIsAborted(algorithm);
  };
  const auto look = [&](int iteration)
  {
    progress = part * (iteration + 1);
    return !SkdIsAborted(algorithm);
  };
  SkdMeshAdapter::Integrate integrate;
  if (this->Request.Rules.Monitor.Kind == skd::MonitorKind::Value &&
    SkdFieldIntegral::CanRead(source))
  {
    integrate = [&](const skd::SurfaceMesh& mesh)
    {
      SkdFieldIntegral field(
        source, samples, this->Adapter.GetShape(), this->Request.IsSourceInDegrees);
      return field.GetMeans(mesh);
    };
  }
  this->Adapter.Run(this->Request.Rules, this->Request.KeepsIterations, find, look, integrate);
}

void SkdFieldAdaptation::TellOfMesh()
{
  const SkdMovedMesh& mesh = this->Adapter.GetMesh();
  if (mesh.CellsLeftOut > 0)
  {
    this->Tell(false,
      TextOf(mesh.CellsLeftOut,
        " cells of Input are no triangles, quads or polygons, or are degenerate or not finite: "
        "their points stay where they are."));
  }
  if (!mesh.Mesh.NonManifoldEdges.empty())
  {
    this->Tell(false,
      TextOf(mesh.Mesh.NonManifoldEdges.size(),
        " edges of Input have more than two cells: their points stay where they are."));
  }
}

void SkdFieldAdaptation::TellOfOutcome()
{
  const skd::AdaptOutcome& outcome = this->Adapter.GetOutcome();
  if (outcome.End == skd::AdaptEnd::NoMonitor)
  {
    this->Tell(true,
      "The monitor is nowhere greater than 0: the mesh moves no further. With Monitor Value the "
      "field must be positive.");
  }
  const SkdMovedMesh& mesh = this->Adapter.GetMesh();
  if (outcome.InvalidCells > 0)
  {
    this->Tell(false,
      TextOf(outcome.InvalidCells, " cells of Input cross themselves or have no area, the first ",
        mesh.NameOf(outcome.FirstInvalid), ": their points stay where they are."));
  }
  if (outcome.CellsNotPositive > 0 && this->Request.Rules.Monitor.Kind == skd::MonitorKind::Value)
  {
    this->Tell(false,
      TextOf("The monitor is not greater than 0 in ", outcome.CellsNotPositive,
        " cells, the first ", mesh.NameOf(outcome.FirstNotPositive),
        ": there it is the largest by MaximumRatio."));
  }
  this->TellOfError();
}

// Fields of noise leave some error, so that a message is due only where it is not small.
void SkdFieldAdaptation::TellOfError()
{
  constexpr double small = 0.03;
  const skd::AdaptOutcome& outcome = this->Adapter.GetOutcome();
  const bool isStalled = outcome.End == skd::AdaptEnd::Stalled;
  const bool isCut = outcome.End == skd::AdaptEnd::Iterations && outcome.Rows.size() > 1;
  if ((isStalled || isCut) &&
    outcome.Rows[outcome.Best].Measure > std::max(small, this->Request.Rules.Tolerance))
  {
    this->Tell(false,
      TextOf("The equidistribution error is ", outcome.Rows[outcome.Best].Measure, " (at first ",
        outcome.Rows.front().Measure, "), largest in ",
        this->Adapter.GetMesh().NameOf(outcome.WorstCell), ", which has ", outcome.WorstRatio,
        " times its share; ", this->WhatHoldsBack()));
  }
}

std::string SkdFieldAdaptation::WhatHoldsBack() const
{
  const skd::AdaptOutcome& outcome = this->Adapter.GetOutcome();
  const skd::MeshMotion::Outcome& last = outcome.Rows.back().Motion;
  if (last.PointsCutBack > 0)
  {
    return TextOf(last.PointsCutBack,
      " points are held back, as else cells would be turned over or worse than MinimumQuality (the "
      "first is ",
      this->Adapter.GetMesh().NameOf(last.SpoiltCell),
      "): lower Strength, MaximumRatio or MinimumQuality, or smooth the monitor more.");
  }
  return outcome.End == skd::AdaptEnd::Stalled
    ? "steps do not lessen it any more: smooth the monitor more, or lower Relaxation."
    : "MaximumIterations are made: allow more.";
}

void SkdFieldAdaptation::AddReport(vtkDataObject* output) const
{
  const skd::AdaptOutcome& outcome = this->Adapter.GetOutcome();
  SkdReport report(output);
  report.AddCount("Iterations", static_cast<vtkIdType>(outcome.Rows.size()) - 1);
  report.AddCount("BestIteration", static_cast<vtkIdType>(outcome.Best));
  report.AddMeasure("EquidistributionBefore", outcome.Rows.front().Measure);
  report.AddMeasure("EquidistributionAfter", outcome.Rows[outcome.Best].Measure);
  if (this->Adapter.GetMeasureOfField() >= 0.0)
  {
    report.AddMeasure("EquidistributionOfField", this->Adapter.GetMeasureOfField());
  }
  report.AddMeasure("SmallestQuality", outcome.Rows[outcome.Best].SmallestQuality);
  report.AddCount("MovedCells", static_cast<vtkIdType>(this->Adapter.GetMesh().Mesh.Cells.size()));
  report.AddCount("Samples", static_cast<vtkIdType>(this->NumberOfSamples));
  if (this->NumberOfTooLarge > 0)
  {
    report.AddCount("ValuesIgnored", this->NumberOfTooLarge);
  }
  report.AddMeasure("Seconds", this->Seconds);
}
}
