// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdFilterInputs.h"

#include "Pipeline/SkdPartialArrays.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdTimes.h"
#include "Pipeline/SkdValidInput.h"
#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

#include <algorithm>

int SkdFilterInputs::Process(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, const std::function<int(vtkInformationVector** inputs)>& process)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    SkdUniteTimes(inputs, this->Filter->GetNumberOfInputPorts(), outputs);
  }
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return process(inputs);
  }
  const int result = this->ProcessData(request, inputs, outputs, process);
  SkdMarkRequestedTime(outputs);
  SkdReportPartialArrays(outputs);
  return result;
}

int SkdFilterInputs::ProcessData(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, const std::function<int(vtkInformationVector** inputs)>& process)
{
  const SkdValidInput valid(this->Filter, request, inputs, this->AnyMagnitude);
  std::vector<vtkSmartPointer<vtkInformationVector>> kept;
  std::vector<vtkInformationVector*> whole;
  for (int port = 0; port < this->Filter->GetNumberOfInputPorts(); ++port)
  {
    kept.push_back(vtkSmartPointer<vtkInformationVector>::New());
    kept.back()->Copy(valid.Get()[port]);
    this->GatherInto(kept.back(), port);
    whole.push_back(kept.back());
  }
  const int result = process(whole.data());
  valid.Report(outputs);
  return result;
}

// What was requested of the input says whether it is this process's piece.
void SkdFilterInputs::GatherInto(vtkInformationVector* inputs, int port)
{
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* input = inputs->GetInformationObject(i);
    vtkDataObject* piece = vtkDataObject::GetData(input);
    vtkMultiProcessController* controller =
      piece && this->NeedsWhole(port) ? SkdControllerOf(input) : nullptr;
    const bool isSpread = controller && this->StaysSpread && this->StaysSpread(port) &&
      this->Spread[{ port, i }].Update(piece, controller);
    vtkDataObject* used = isSpread ? this->Spread[{ port, i }].GetOwn() : nullptr;
    if (!isSpread)
    {
      this->Spread.erase({ port, i });
    }
    if (!controller || isSpread)
    {
      this->Whole.erase({ port, i });
    }
    else
    {
      used = this->Whole[{ port, i }].Update(piece, controller);
    }
    if (used)
    {
      vtkNew<vtkInformation> gathered;
      gathered->Copy(input);
      gathered->Set(vtkDataObject::DATA_OBJECT(), used);
      inputs->SetInformationObject(i, gathered);
    }
  }
}

void SkdFilterInputs::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) const
{
  const int from = request->Has(vtkExecutive::FROM_OUTPUT_PORT())
    ? request->Get(vtkExecutive::FROM_OUTPUT_PORT())
    : 0;
  vtkInformation* output = outputs->GetInformationObject(std::max(from, 0));
  const bool isOwnPiece = SkdControllerOf(output) != nullptr;
  for (int port = 0; port < this->Filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      if (this->NeedsWhole(port) && !isOwnPiece)
      {
        SkdRequestWhole(input);
      }
      else if (port > 0)
      {
        SkdRequestSamePiece(output, input);
      }
    }
  }
}

const SkdWholeInput* SkdFilterInputs::GetWhole(int port) const
{
  const auto found = this->Whole.find({ port, 0 });
  return found == this->Whole.end() ? nullptr : &found->second;
}

const SkdSpreadSource* SkdFilterInputs::GetSpread(int port) const
{
  const auto found = this->Spread.find({ port, 0 });
  return found == this->Spread.end() ? nullptr : &found->second;
}
