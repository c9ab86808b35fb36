// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeSourceAlgorithm.h"

#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkSkdTreeSourceAlgorithm::vtkSkdTreeSourceAlgorithm(
  SourceUse use, std::initializer_list<int> outputTypes)
  : Inputs(new SkdFilterInputs(this, [this](int port) { return this->NeedsWhole(port); }))
  , Use(use)
  , OutputTypes(outputTypes)
{
  this->Inputs->SetAsks(
    [this](int port) { return port == 1 && !this->NeedsWhole(0) && this->CanAskPieces(port); });
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(static_cast<int>(this->OutputTypes.size()));
}

vtkSkdTreeSourceAlgorithm::~vtkSkdTreeSourceAlgorithm() = default;

void vtkSkdTreeSourceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "SourceDistribution", this->SourceDistribution);
}

void vtkSkdTreeSourceAlgorithm::SetSourceConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

void vtkSkdTreeSourceAlgorithm::SetSourceData(vtkDataObject* source)
{
  this->SetInputDataInternal(1, source);
}

vtkTypeBool vtkSkdTreeSourceAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()) && this->Use == SourceUse::Required &&
    this->GetNumberOfInputConnections(1) == 0)
  {
    vtkMultiProcessController* all = SkdControllerOf(outputVector->GetInformationObject(0));
    if (!all || all->GetLocalProcessId() == 0) // said once
    {
      vtkErrorMacro("Source is not set: connect the mesh to search to input port 1.");
    }
    return 1; // the outputs are empty
  }
  this->Inputs->SetAnyMagnitude(this->AnyMagnitude);
  this->Inputs->SetListsByCells(this->ListsByInputCells());
  this->Inputs->SetDistribution(
    static_cast<SkdFilterInputs::Distribution>(this->SourceDistribution),
    [this](int port, SkdSearchRange& range)
    { return port == 1 && !this->NeedsWhole(0) && this->NeedsNearbySource(range); });
  return this->Inputs->Process(request, inputVector, outputVector,
    [&](vtkInformationVector** inputs)
    { return this->Superclass::ProcessRequest(request, inputs, outputVector); });
}

bool vtkSkdTreeSourceAlgorithm::NeedsWhole(int port)
{
  return port > 0 || this->WholeInput || this->GetNumberOfInputConnections(1) == 0;
}

bool vtkSkdTreeSourceAlgorithm::NeedsNearbySource(SkdSearchRange&)
{
  return false;
}

bool vtkSkdTreeSourceAlgorithm::CanAskPieces(int)
{
  return false;
}

bool vtkSkdTreeSourceAlgorithm::ListsByInputCells()
{
  return false;
}

std::vector<std::vector<unsigned char>> vtkSkdTreeSourceAlgorithm::FindListedCells(
  vtkInformationVector* outputs)
{
  return this->Inputs->FindCounted(outputs->GetInformationObject(0));
}

std::vector<std::vector<unsigned char>> vtkSkdTreeSourceAlgorithm::FindListedPoints(
  vtkInformationVector* outputs)
{
  return this->Inputs->FindCountedPoints(outputs->GetInformationObject(0));
}

bool vtkSkdTreeSourceAlgorithm::IsLeftToFirst(vtkInformationVector* outputs)
{
  return this->NeedsWhole(0) && SkdIsLaterPiece(outputs->GetInformationObject(0));
}

int vtkSkdTreeSourceAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  SkdAcceptMeshes(info);
  if (port == 1) // also where it is required: VTK would complain once for each request
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSkdTreeSourceAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  const int type = this->OutputTypes[port];
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    type < 0 ? "vtkDataObject" : vtkDataObjectTypes::GetClassNameFromTypeId(type));
  return 1;
}

int vtkSkdTreeSourceAlgorithm::TypeFor(int outputType, vtkDataObject* input)
{
  if (outputType == GRID_OR_BLOCKS)
  {
    return SkdIsComposite(input) ? VTK_MULTIBLOCK_DATA_SET : VTK_UNSTRUCTURED_GRID;
  }
  if (outputType == LIKE_INPUT && !SkdIsComposite(input) && !vtkDataSet::SafeDownCast(input))
  {
    return VTK_UNSTRUCTURED_GRID; // it stays empty
  }
  return outputType == LIKE_INPUT ? input->GetDataObjectType() : outputType;
}

int vtkSkdTreeSourceAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    SkdProvideOutput(
      outputVector->GetInformationObject(port), TypeFor(this->OutputTypes[port], input));
  }
  return 1;
}

int vtkSkdTreeSourceAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Inputs->RequestUpdateExtent(request, inputVector, outputVector);
  return 1;
}
VTK_ABI_NAMESPACE_END
