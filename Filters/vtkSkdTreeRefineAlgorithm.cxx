// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeRefineAlgorithm.h"

#include "Exchange/SkdFilterInputs.h"
#include "Meshing/Refine/SkdRefineState.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdSearchRange.h"
#include "vtkInformation.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkSkdTreeRefineAlgorithm::vtkSkdTreeRefineAlgorithm(int inputPorts, int firstWholePort)
  : State(new SkdRefineState)
  , Inputs(new SkdFilterInputs(this, [firstWholePort](int port) { return port >= firstWholePort; }))
{
  this->SetNumberOfInputPorts(inputPorts);
  this->SetNumberOfOutputPorts(1);
}

vtkSkdTreeRefineAlgorithm::~vtkSkdTreeRefineAlgorithm() = default;

void vtkSkdTreeRefineAlgorithm::SetFieldConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(2, algOutput);
}

void vtkSkdTreeRefineAlgorithm::SetFieldData(vtkDataObject* field)
{
  this->SetInputDataInternal(2, field);
}

void vtkSkdTreeRefineAlgorithm::AddFieldArray(const char* name)
{
  if (name && *name)
  {
    this->State->FieldArrays.insert(name);
    this->Modified();
  }
}

void vtkSkdTreeRefineAlgorithm::RemoveAllFieldArrays()
{
  this->State->FieldArrays.clear();
  this->Modified();
}

void vtkSkdTreeRefineAlgorithm::AddPartLevel(int blockIndex, int level)
{
  this->State->PartLevels[blockIndex] = level;
  this->Modified();
}

void vtkSkdTreeRefineAlgorithm::RemoveAllPartLevels()
{
  this->State->PartLevels.clear();
  this->Modified();
}

void vtkSkdTreeRefineAlgorithm::AddDistanceBand(double distance, double level)
{
  if (vtkSkdTreeIsWithin(this, "The distance of a band", &distance, 1, 0.0, VTK_DOUBLE_MAX) &&
    vtkSkdTreeIsWithin(this, "The level of a band", &level, 1, 0.0, 30.0))
  {
    this->State->Bands.push_back({ distance, static_cast<int>(level) });
    this->Modified();
  }
}

void vtkSkdTreeRefineAlgorithm::RemoveAllDistanceBands()
{
  this->State->Bands.clear();
  this->Modified();
}

vtkTypeBool vtkSkdTreeRefineAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SetUpInputs(*this->Inputs);
  return this->Inputs->Process(request, inputVector, outputVector,
    [&](vtkInformationVector** inputs)
    { return this->Superclass::ProcessRequest(request, inputs, outputVector); });
}

void vtkSkdTreeRefineAlgorithm::SetUpInputs(SkdFilterInputs&) {}

// All processes' cells have the range of values; points of no cell may have a part of it, too.
void vtkSkdTreeRefineAlgorithm::ReachField(SkdSearchRange& range) const
{
  const bool isRelative = this->RelativeFieldThreshold && !this->State->FieldArrays.empty();
  range.WithOwn = range.WithOwn || isRelative;
  range.IsOfSamples = range.IsOfSamples || isRelative;
}

void vtkSkdTreeRefineAlgorithm::PassOptions()
{
  SkdRefineOptions& options = this->State->Options;
  options.MaximumLevel = this->MaximumLevel;
  options.Test = this->OverlapTest == EXACT ? SkdOverlapTest::Exact : SkdOverlapTest::Blind;
  options.RefineByNormalDeviation = this->RefineByNormalDeviation;
  options.NormalDeviation = this->NormalDeviation;
  options.MinimumSurfaceLevel = this->MinimumSurfaceLevel;
  options.InsideLevel = this->InsideLevel;
  options.FieldTest = static_cast<SkdFieldTest>(this->FieldTest);
  options.FieldThreshold = this->FieldThreshold;
  std::copy_n(this->FieldRange, 2, options.FieldRange);
  options.RelativeFieldThreshold = this->RelativeFieldThreshold;
  options.FieldLevel = this->FieldLevel;
  options.Epsilon = this->Epsilon;
  options.ChordalDeviation = this->ChordalDeviation;
}

int vtkSkdTreeRefineAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  SkdAcceptMeshes(info);
  if (port != 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSkdTreeRefineAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkSkdTreeRefineAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Inputs->RequestUpdateExtent(request, inputVector, outputVector);
  return 1;
}

void vtkSkdTreeRefineAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "MaximumLevel", this->MaximumLevel, "OverlapTest",
    this->OverlapTest == EXACT ? "Exact" : "Blind", "Balance", this->Balance);
  for (const auto& [blockIndex, level] : this->State->PartLevels)
  {
    os << indent << "PartLevel: " << blockIndex << " " << level << "\n";
  }
  for (const SkdDistanceBand& band : this->State->Bands)
  {
    os << indent << "DistanceBand: " << band.Distance << " " << band.Level << "\n";
  }
  SkdPrint(os, indent, "InsideLevel", this->InsideLevel, "GrowingLayers", this->GrowingLayers,
    "RefineByNormalDeviation", this->RefineByNormalDeviation, "NormalDeviation",
    this->NormalDeviation, "MinimumSurfaceLevel", this->MinimumSurfaceLevel);
  for (const std::string& name : this->State->FieldArrays)
  {
    SkdPrint(os, indent, "FieldArray", name);
  }
  SkdPrint(os, indent, "FieldTest", this->FieldTest, "FieldThreshold", this->FieldThreshold,
    "FieldRange", this->FieldRange, "RelativeFieldThreshold", this->RelativeFieldThreshold,
    "FieldLevel", this->FieldLevel, "CellLimit", this->CellLimit, "ChordalDeviation",
    this->ChordalDeviation, "Epsilon", this->Epsilon);
}
VTK_ABI_NAMESPACE_END
