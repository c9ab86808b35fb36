// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeMeshAdaptation.h"

#include "Meshing/Adaptation/SkdFieldAdaptation.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeMeshAdaptation);

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

bool IsPointSet(const SkdBlock& block)
{
  return vtkPointSet::SafeDownCast(block.Mesh) != nullptr;
}
}

//------------------------------------------------------------------------------
class vtkSkdTreeMeshAdaptation::Internals
{
public:
  SkdFieldAdaptation Adaptation;

  /// Whether there is an outcome to show: the last one, if nothing has changed since.
  bool Update(vtkDataObject* input, vtkDataObject* source, vtkSkdTreeMeshAdaptation* self);

private:
  static SkdAdaptationRequest MakeRequest(const vtkSkdTreeMeshAdaptation* self);

  vtkMTimeType Times[3] = { 0, 0, 0 };
  const void* Objects[2] = { nullptr, nullptr };
  bool HasOutcome = false;
};

SkdAdaptationRequest vtkSkdTreeMeshAdaptation::Internals::MakeRequest(
  const vtkSkdTreeMeshAdaptation* self)
{
  SkdAdaptationRequest request;
  request.Array = self->FieldArray;
  request.IsSourceInDegrees = self->SourceCoordinates == LONGITUDE_LATITUDE;
  request.Weighing = static_cast<SkdFieldWeighing>(self->SampleWeights);
  request.Surface = static_cast<SkdSurfaceChoice>(self->Surface);
  request.KeepsIterations = self->AnimateIterations;
  skd::AdaptRules& rules = request.Rules;
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
  return request;
}

bool vtkSkdTreeMeshAdaptation::Internals::Update(
  vtkDataObject* input, vtkDataObject* source, vtkSkdTreeMeshAdaptation* self)
{
  const vtkMTimeType times[3] = { self->GetMTime(), input->GetMTime(), source->GetMTime() };
  const void* objects[2] = { input, source };
  const bool isSame =
    std::equal(times, times + 3, this->Times) && std::equal(objects, objects + 2, this->Objects);
  if (!isSame || !this->HasOutcome || !this->Adaptation.GetAdapter().HasIterations())
  {
    this->HasOutcome = this->Adaptation.Run(SkdBlocksOf(input), source, MakeRequest(self), self);
    std::copy(times, times + 3, this->Times);
    std::copy(objects, objects + 2, this->Objects);
    for (const SkdFieldAdaptation::Message& message : this->Adaptation.GetMessages())
    {
      if (message.IsError)
      {
        vtkErrorWithObjectMacro(self, << message.Text);
      }
      else
      {
        vtkWarningWithObjectMacro(self, << message.Text);
      }
    }
  }
  return this->HasOutcome;
}

//------------------------------------------------------------------------------
vtkSkdTreeMeshAdaptation::vtkSkdTreeMeshAdaptation()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_TABLE })
  , Impl(new Internals)
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
    SkdAccept(info, { "vtkPointSet", "vtkCompositeDataSet", "vtkDataObject" });
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
  if (!this->Impl->Update(input, source, this))
  {
    return 1;
  }
  SkdMeshAdapter& adapter = this->Impl->Adaptation.GetAdapter();
  if (this->AnimateIterations)
  {
    const bool hasTime = info->Has(Pipeline::UPDATE_TIME_STEP()) != 0;
    const double time = hasTime ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
    adapter.ShowIteration(static_cast<std::size_t>(std::max(time, 0.0)));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  else
  {
    adapter.ShowBest();
  }
  adapter.FillBlocks(outputs);
  adapter.FillTable(table);
  this->Impl->Adaptation.AddReport(output);
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
