// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdProcesses.h"

#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace
{
class ControlledProcesses : public skd::Processes
{
public:
  explicit ControlledProcesses(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  bool IsAny(bool here) const override
  {
    const int own = here ? 1 : 0;
    int any = 0;
    this->Controller->AllReduce(&own, &any, 1, vtkCommunicator::MAX_OP);
    return any != 0;
  }

  std::vector<std::vector<double>> GatherFromOthers(const std::vector<double>& own) const override
  {
    const auto count = static_cast<std::size_t>(this->Controller->GetNumberOfProcesses());
    const auto length = static_cast<vtkIdType>(own.size());
    std::vector<vtkIdType> lengths(count);
    this->Controller->AllGather(&length, lengths.data(), 1);
    std::vector<vtkIdType> offsets(count + 1, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      offsets[i + 1] = offsets[i] + lengths[i];
    }
    std::vector<double> all(static_cast<std::size_t>(offsets.back()) + 1);
    this->Controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
    std::vector<std::vector<double>> others;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (static_cast<int>(i) != this->Controller->GetLocalProcessId())
      {
        others.emplace_back(all.begin() + offsets[i], all.begin() + offsets[i + 1]);
      }
    }
    return others;
  }

private:
  vtkMultiProcessController* Controller;
};
}

std::unique_ptr<skd::Processes> SkdProcessesOf(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int count = controller ? controller->GetNumberOfProcesses() : 1;
  const bool isShared = count > 1 && output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
    output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) == count &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) == controller->GetLocalProcessId();
  return isShared ? std::make_unique<ControlledProcesses>(controller) : nullptr;
}
