// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeMeshAdaptation.h"

#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Meshing/Adaptation/SkdMeshAdapter.h"
#include "Pipeline/SkdLonLat.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Remap/SkdContainedMean.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <optional>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeMeshAdaptation);

namespace
{
/// Tolerances of finding cells, relative to their mean size: in a plane for rounding errors, on
/// curved surfaces for the distance between two approximations.
constexpr double PlaneTolerance = 1e-6;
constexpr double CurvedTolerance = 0.25;

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The field as values at places.
struct Samples
{
  std::vector<skd::Vector3> Places;
  std::vector<double> Values; // NaN where there is none
  std::vector<double> Weights;
  bool IsStructured = false;
  vtkIdType TooLarge = 0; // values whose squares are no numbers: they count as none

  void Add(const skd::Vector3& place, double value)
  {
    const bool isTooLarge = std::abs(value) > SkdComparable.Largest;
    this->TooLarge += isTooLarge;
    this->Places.push_back(place);
    this->Values.push_back(isTooLarge ? vtkMath::Nan() : value);
  }
};

/// The named array, or else the first of numbers, that is no mark of ghosts.
vtkDataArray* FindArray(vtkDataSetAttributes* data, const std::string& name)
{
  if (!name.empty())
  {
    return data->GetArray(name.c_str());
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const char* itsName = array ? array->GetName() : nullptr;
    if (itsName && itsName != std::string(vtkDataSetAttributes::GhostArrayName()))
    {
      return array;
    }
  }
  return nullptr;
}

double MagnitudeOf(vtkDataArray* array, vtkIdType i)
{
  if (array->GetNumberOfComponents() == 1)
  {
    return array->GetComponent(i, 0);
  }
  double sum = 0.0;
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    sum += array->GetComponent(i, k) * array->GetComponent(i, k);
  }
  return std::sqrt(sum);
}

skd::Vector3 MiddleOf(vtkDataSet* mesh, vtkIdType cell, vtkGenericCell* scratch)
{
  SkdLoadCell(mesh, cell, scratch);
  skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
  const vtkIdType n = scratch->GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i)
  {
    skd::Vector3 x;
    scratch->GetPoints()->GetPoint(i, x.X);
    sum = sum + x;
  }
  return n > 0 ? (1.0 / static_cast<double>(n)) * sum : sum;
}

void AddSamples(vtkDataSet* mesh, int type, vtkDataArray* array, Samples& samples)
{
  const vtkUnsignedCharArray* none = nullptr;
  vtkUnsignedCharArray* ghosts =
    type == vtkDataObject::POINT ? mesh->GetPointGhostArray() : mesh->GetCellGhostArray();
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    skd::Vector3 x;
    if (type == vtkDataObject::POINT)
    {
      mesh->GetPoint(i, x.X);
    }
    else
    {
      x = MiddleOf(mesh, i, cell);
    }
    const bool counts = ghosts == none || ghosts->GetValue(i) == 0;
    samples.Add(x, counts ? MagnitudeOf(array, i) : vtkMath::Nan());
  }
  samples.IsStructured = samples.IsStructured || SkdIsStructured(mesh);
}

Samples ReadSamples(vtkDataObject* source, const std::string& name)
{
  Samples samples;
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    for (const SkdBlock& block : SkdBlocksOf(source))
    {
      vtkDataArray* array = FindArray(block.Mesh->GetAttributes(type), name);
      if (array)
      {
        AddSamples(block.Mesh, type, array, samples);
      }
    }
    if (!samples.Places.empty())
    {
      break;
    }
  }
  return samples;
}

bool HasAny(const std::vector<double>& values)
{
  return std::any_of(
    values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool IsPointSet(const SkdBlock& block)
{
  return vtkPointSet::SafeDownCast(block.Mesh) != nullptr;
}
}

//------------------------------------------------------------------------------
class vtkSkdTreeMeshAdaptation::Internals
{
public:
  explicit Internals(vtkSkdTreeMeshAdaptation* self)
    : Self(self)
  {
  }

  SkdMeshAdapter Adapter;
  std::size_t NumberOfSamples = 0;
  vtkIdType NumberOfTooLarge = 0;
  double Seconds = 0.0;

  /// Whether there is an outcome to show: the last one, if nothing has changed since.
  bool Update(const std::vector<SkdBlock>& inputs, vtkDataObject* input, vtkDataObject* source);
  void Report(vtkDataObject* output) const;

private:
  bool Run(const std::vector<SkdBlock>& inputs, vtkDataObject* source);
  void PlaceSamples(Samples& samples) const;
  bool WeighsByCosine(const Samples& samples) const;
  double ToleranceOfCells() const;
  skd::AdaptRules MakeRules() const;
  void WarnAboutMesh() const;
  void WarnAboutOutcome() const;
  void WarnAboutError() const;

  vtkSkdTreeMeshAdaptation* Self;
  vtkMTimeType Times[3] = { 0, 0, 0 };
  const void* Objects[2] = { nullptr, nullptr };
  bool HasOutcome = false;
};

skd::AdaptRules vtkSkdTreeMeshAdaptation::Internals::MakeRules() const
{
  const vtkSkdTreeMeshAdaptation* self = this->Self;
  skd::AdaptRules rules;
  rules.Monitor.Kind = static_cast<skd::MonitorKind>(self->Monitor);
  rules.Monitor.Strength = self->Strength;
  rules.Monitor.Smoothings = self->Smoothing;
  rules.Monitor.LargestRatio = self->MaximumRatio;
  rules.Freedom.DoBordersSlide = self->Borders == SLIDE;
  rules.Freedom.CornerAngle = vtkMath::RadiansFromDegrees(self->FeatureAngle);
  rules.Freedom.CreaseAngle = rules.Freedom.CornerAngle;
  rules.Iterations = self->MaximumIterations;
  rules.Tolerance = self->Tolerance;
  rules.Relaxation = self->Relaxation;
  rules.LeastQuality = self->MinimumQuality;
  rules.AreSharesEqual = self->TargetSizes == UNIFORM;
  return rules;
}

// Onto the surface that the mesh is on, and about the centre of its sphere.
void vtkSkdTreeMeshAdaptation::Internals::PlaceSamples(Samples& samples) const
{
  const skd::SurfaceShape& shape = this->Adapter.GetShape();
  const bool isSphere = this->Adapter.IsOnSphere();
  for (skd::Vector3& x : samples.Places)
  {
    if (isSphere)
    {
      x = this->Self->SourceCoordinates == LONGITUDE_LATITUDE ? SkdDirectionOfLonLat(x)
                                                              : x - shape.Centre;
    }
    else if (skd::IsFinite(x))
    {
      x = shape.Put(x);
    }
  }
  if (this->WeighsByCosine(samples))
  {
    for (const skd::Vector3& x : samples.Places)
    {
      samples.Weights.push_back(SkdCosineOfLatitude(x));
    }
  }
}

bool vtkSkdTreeMeshAdaptation::Internals::WeighsByCosine(const Samples& samples) const
{
  const bool isGrid = this->Self->SourceCoordinates == LONGITUDE_LATITUDE || samples.IsStructured;
  const int choice = this->Self->SampleWeights;
  return this->Adapter.IsOnSphere() &&
    (choice == COSINE_OF_LATITUDE || (choice == AUTOMATIC_WEIGHTS && isGrid));
}

// Places were put on a bent surface, which flat cells are off by a part of their size.
double vtkSkdTreeMeshAdaptation::Internals::ToleranceOfCells() const
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

bool vtkSkdTreeMeshAdaptation::Internals::Update(
  const std::vector<SkdBlock>& inputs, vtkDataObject* input, vtkDataObject* source)
{
  const vtkMTimeType times[3] = { this->Self->GetMTime(), input->GetMTime(), source->GetMTime() };
  const void* objects[2] = { input, source };
  const bool isSame =
    std::equal(times, times + 3, this->Times) && std::equal(objects, objects + 2, this->Objects);
  if (!isSame || !this->HasOutcome || !this->Adapter.HasIterations())
  {
    SkdStopwatch watch;
    this->HasOutcome = this->Run(inputs, source);
    std::copy(times, times + 3, this->Times);
    std::copy(objects, objects + 2, this->Objects);
    this->Seconds = watch.Lap();
  }
  return this->HasOutcome;
}

bool vtkSkdTreeMeshAdaptation::Internals::Run(
  const std::vector<SkdBlock>& inputs, vtkDataObject* source)
{
  vtkSkdTreeMeshAdaptation* self = this->Self;
  std::string problem;
  if (!this->Adapter.Begin(inputs, static_cast<SkdSurfaceChoice>(self->Surface), problem))
  {
    vtkWarningWithObjectMacro(self, << problem << " Nothing moves.");
    return false;
  }
  this->WarnAboutMesh();
  if (self->SourceCoordinates == LONGITUDE_LATITUDE && !this->Adapter.IsOnSphere())
  {
    vtkErrorWithObjectMacro(self,
      "Input is not on a sphere: SourceCoordinates cannot be longitude "
      "and latitude. Nothing moves.");
    return false;
  }
  Samples samples = ReadSamples(source, self->FieldArray);
  this->NumberOfSamples = samples.Places.size();
  this->NumberOfTooLarge = samples.TooLarge;
  if (samples.TooLarge > 0)
  {
    vtkWarningWithObjectMacro(self,
      "" << samples.TooLarge << " values of Source's field are infinite or beyond "
         << SkdComparable.Largest << " and are ignored: bring the field into another unit.");
  }
  if (!HasAny(samples.Values))
  {
    vtkErrorWithObjectMacro(self,
      "Source has no array "
        << (self->FieldArray.empty() ? "" : "\"" + self->FieldArray + "\" ")
        << "of numbers with a finite value: there is nothing to adapt to. Set FieldArray.");
    return false;
  }
  this->PlaceSamples(samples);
  const bool isOnSphere = this->Adapter.IsOnSphere();
  const SkdContainedMean means(std::move(samples.Places), std::move(samples.Weights), isOnSphere);
  const double tolerance = this->ToleranceOfCells();
  const double part = 1.0 / (self->MaximumIterations + 1.0);
  double progress = 0.0;
  const auto find = [&](vtkPolyData* mesh, std::vector<double>& field)
  {
    const SkdTargetCells cells(mesh, isOnSphere, tolerance);
    SkdLoop loop(self, mesh->GetNumberOfCells(), progress, progress + part);
    field = means.GetMeans(cells, samples.Values, SkdEmptyCells::Nearest, loop);
    return !SkdIsAborted(self);
  };
  const auto look = [&](int iteration)
  {
    progress = part * (iteration + 1);
    return !SkdIsAborted(self);
  };
  this->Adapter.Run(this->MakeRules(), self->AnimateIterations, find, look);
  this->WarnAboutOutcome();
  return !this->Adapter.GetOutcome().Rows.empty();
}

void vtkSkdTreeMeshAdaptation::Internals::WarnAboutMesh() const
{
  const SkdMovedMesh& mesh = this->Adapter.GetMesh();
  if (mesh.CellsLeftOut > 0)
  {
    vtkWarningWithObjectMacro(this->Self,
      "" << mesh.CellsLeftOut
         << " cells of Input are no triangles, quads or polygons, or are degenerate or not finite: "
            "their points stay where they are.");
  }
  if (!mesh.Mesh.NonManifoldEdges.empty())
  {
    vtkWarningWithObjectMacro(this->Self,
      "" << mesh.Mesh.NonManifoldEdges.size()
         << " edges of Input have more than two cells: their points stay where they are.");
  }
}

void vtkSkdTreeMeshAdaptation::Internals::WarnAboutOutcome() const
{
  const skd::AdaptOutcome& outcome = this->Adapter.GetOutcome();
  if (outcome.End == skd::AdaptEnd::NoMonitor)
  {
    vtkErrorWithObjectMacro(this->Self,
      "The monitor is nowhere greater than 0: the mesh moves no further. With Monitor Value the "
      "field must be positive.");
  }
  if (outcome.InvalidCells > 0)
  {
    vtkWarningWithObjectMacro(this->Self,
      "" << outcome.InvalidCells
         << " cells of Input cross themselves or have no area: their points stay where they are.");
  }
  if (outcome.CellsNotPositive > 0 && this->Self->Monitor == VALUE)
  {
    vtkWarningWithObjectMacro(this->Self,
      "The monitor is not greater than 0 in "
        << outcome.CellsNotPositive << " cells: there it is the largest by MaximumRatio.");
  }
  this->WarnAboutError();
}

// Fields of noise leave some error, so that a message is due only where it is not small.
void vtkSkdTreeMeshAdaptation::Internals::WarnAboutError() const
{
  constexpr double small = 0.03;
  const skd::AdaptOutcome& outcome = this->Adapter.GetOutcome();
  const bool isStalled = outcome.End == skd::AdaptEnd::Stalled;
  const bool isCut = outcome.End == skd::AdaptEnd::Iterations && outcome.Rows.size() > 1;
  if (!(isStalled || isCut) ||
    !(outcome.Rows[outcome.Best].Measure > std::max(small, this->Self->Tolerance)))
  {
    return;
  }
  const SkdMovedMesh& mesh = this->Adapter.GetMesh();
  const skd::MeshMotion::Outcome& last = outcome.Rows.back().Motion;
  std::ostringstream why;
  if (last.PointsCutBack > 0)
  {
    why << last.PointsCutBack << " points are held back, as else cells would be turned over or "
        << "worse than MinimumQuality (the first is " << mesh.NameOf(last.SpoiltCell)
        << "): lower Strength, MaximumRatio or MinimumQuality, or smooth the monitor more.";
  }
  else if (isStalled)
  {
    why << "steps do not lessen it any more: smooth the monitor more, or lower Relaxation.";
  }
  else
  {
    why << "MaximumIterations are made: allow more.";
  }
  vtkWarningWithObjectMacro(this->Self,
    "The equidistribution error is "
      << outcome.Rows[outcome.Best].Measure << " (at first " << outcome.Rows.front().Measure
      << "), largest in " << mesh.NameOf(outcome.WorstCell) << ", which has " << outcome.WorstRatio
      << " times its share; " << why.str());
}

void vtkSkdTreeMeshAdaptation::Internals::Report(vtkDataObject* output) const
{
  const skd::AdaptOutcome& outcome = this->Adapter.GetOutcome();
  SkdReport report(output);
  report.AddCount("Iterations", static_cast<vtkIdType>(outcome.Rows.size()) - 1);
  report.AddCount("BestIteration", static_cast<vtkIdType>(outcome.Best));
  report.AddMeasure("EquidistributionBefore", outcome.Rows.front().Measure);
  report.AddMeasure("EquidistributionAfter", outcome.Rows[outcome.Best].Measure);
  report.AddMeasure("SmallestQuality", outcome.Rows[outcome.Best].SmallestQuality);
  report.AddCount("MovedCells", static_cast<vtkIdType>(this->Adapter.GetMesh().Mesh.Cells.size()));
  report.AddCount("Samples", static_cast<vtkIdType>(this->NumberOfSamples));
  if (this->NumberOfTooLarge > 0)
  {
    report.AddCount("ValuesIgnored", this->NumberOfTooLarge);
  }
  report.AddMeasure("Seconds", this->Seconds);
}

//------------------------------------------------------------------------------
vtkSkdTreeMeshAdaptation::vtkSkdTreeMeshAdaptation()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_TABLE })
  , Impl(new Internals(this))
{
  this->WholeInput = true;
}

vtkSkdTreeMeshAdaptation::~vtkSkdTreeMeshAdaptation() = default;

void vtkSkdTreeMeshAdaptation::SetFieldArray(const char* name)
{
  const std::string given = name ? name : "";
  if (given != this->FieldArray)
  {
    this->FieldArray = given;
    this->Modified();
  }
}

int vtkSkdTreeMeshAdaptation::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  return 1;
}

int vtkSkdTreeMeshAdaptation::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (this->AnimateIterations)
  {
    std::vector<double> times;
    for (int i = 0; i <= this->MaximumIterations; ++i)
    {
      times.push_back(i);
    }
    const double range[2] = { 0.0, times.back() };
    vtkInformation* info = outputVector->GetInformationObject(0);
    info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

int vtkSkdTreeMeshAdaptation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  table->Initialize();
  if (SkdIsLaterPiece(info))
  {
    output->Initialize(); // the first process has it all
    return 1;
  }
  const std::vector<SkdBlock> outputs = SkdMirror(input, output);
  if (!std::all_of(outputs.begin(), outputs.end(), IsPointSet))
  {
    vtkWarningMacro(
      "Blocks of Input without points of their own (images and the like) stay as they "
      "are.");
  }
  Internals& internals = *this->Impl;
  if (!internals.Update(SkdBlocksOf(input), input, source))
  {
    return 1;
  }
  if (this->AnimateIterations)
  {
    const bool hasTime = info->Has(Pipeline::UPDATE_TIME_STEP()) != 0;
    const double time = hasTime ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
    internals.Adapter.ShowIteration(static_cast<std::size_t>(std::max(time, 0.0)));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  else
  {
    internals.Adapter.ShowBest();
  }
  internals.Adapter.FillBlocks(outputs);
  internals.Adapter.FillTable(table);
  internals.Report(output);
  return 1;
}

void vtkSkdTreeMeshAdaptation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "FieldArray", this->FieldArray, "SourceCoordinates", this->SourceCoordinates,
    "SampleWeights", this->SampleWeights, "Monitor", this->Monitor, "Strength", this->Strength,
    "Smoothing", this->Smoothing, "MaximumRatio", this->MaximumRatio, "Surface", this->Surface,
    "Borders", this->Borders, "FeatureAngle", this->FeatureAngle, "TargetSizes", this->TargetSizes,
    "MaximumIterations", this->MaximumIterations, "Tolerance", this->Tolerance, "Relaxation",
    this->Relaxation, "MinimumQuality", this->MinimumQuality, "AnimateIterations",
    this->AnimateIterations);
}
VTK_ABI_NAMESPACE_END
