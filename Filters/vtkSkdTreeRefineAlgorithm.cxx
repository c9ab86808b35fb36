// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeRefineAlgorithm.h"

#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdValidInput.h"
#include "Refine/SkdRefineState.h"
#include "vtkInformation.h"

VTK_ABI_NAMESPACE_BEGIN
vtkSkdTreeRefineAlgorithm::vtkSkdTreeRefineAlgorithm()
  : State(new SkdRefineState)
{
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
  const SkdValidInput valid(this, request, inputVector);
  return this->Superclass::ProcessRequest(request, valid.Get(), outputVector);
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

void vtkSkdTreeRefineAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "OverlapTest: " << (this->OverlapTest == EXACT ? "Exact\n" : "Blind\n");
  os << indent << "Balance: " << this->Balance << "\n";
  for (const auto& [blockIndex, level] : this->State->PartLevels)
  {
    os << indent << "PartLevel: " << blockIndex << " " << level << "\n";
  }
  for (const SkdDistanceBand& band : this->State->Bands)
  {
    os << indent << "DistanceBand: " << band.Distance << " " << band.Level << "\n";
  }
  os << indent << "InsideLevel: " << this->InsideLevel << "\n";
  os << indent << "GrowingLayers: " << this->GrowingLayers << "\n";
  os << indent << "RefineByNormalDeviation: " << (this->RefineByNormalDeviation ? "On\n" : "Off\n");
  os << indent << "NormalDeviation: " << this->NormalDeviation << "\n";
  os << indent << "MinimumSurfaceLevel: " << this->MinimumSurfaceLevel << "\n";
  for (const std::string& name : this->State->FieldArrays)
  {
    os << indent << "FieldArray: " << name << "\n";
  }
  os << indent << "FieldTest: " << this->FieldTest << "\n";
  os << indent << "FieldThreshold: " << this->FieldThreshold << "\n";
  os << indent << "FieldRange: " << this->FieldRange[0] << " " << this->FieldRange[1] << "\n";
  os << indent << "FieldLevel: " << this->FieldLevel << "\n";
  os << indent << "CellLimit: " << this->CellLimit << "\n";
  os << indent << "ChordalDeviation: " << this->ChordalDeviation << "\n";
  os << indent << "Epsilon: " << this->Epsilon << "\n";
}
VTK_ABI_NAMESPACE_END
