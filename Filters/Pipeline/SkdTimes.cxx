// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdTimes.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

namespace skdtree
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The times of several inputs together.
class Times
{
public:
  void Add(vtkInformation* input)
  {
    if (input->Has(Pipeline::TIME_STEPS()))
    {
      const double* steps = input->Get(Pipeline::TIME_STEPS());
      const int number = input->Length(Pipeline::TIME_STEPS());
      this->Steps.insert(this->Steps.end(), steps, steps + number);
      this->Limits.insert(this->Limits.end(), steps, steps + number);
    }
    if (input->Has(Pipeline::TIME_RANGE()))
    {
      const double* range = input->Get(Pipeline::TIME_RANGE());
      this->Limits.insert(this->Limits.end(), range, range + 2);
    }
  }

  void Unite()
  {
    std::sort(this->Steps.begin(), this->Steps.end());
    this->Steps.erase(std::unique(this->Steps.begin(), this->Steps.end()), this->Steps.end());
  }

  void Tell(vtkInformation* output) const
  {
    if (this->Limits.empty())
    {
      return;
    }
    const auto [least, most] = std::minmax_element(this->Limits.begin(), this->Limits.end());
    const double range[2] = { *least, *most };
    output->Set(Pipeline::TIME_RANGE(), range, 2);
    if (!this->Steps.empty())
    {
      output->Set(Pipeline::TIME_STEPS(), this->Steps.data(), static_cast<int>(this->Steps.size()));
    }
  }

private:
  std::vector<double> Steps;
  std::vector<double> Limits;
};
}

void SkdUniteTimes(vtkInformationVector** inputs, int ports, vtkInformationVector* outputs)
{
  Times times;
  for (int port = 0; port < ports; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      times.Add(inputs[port]->GetInformationObject(i));
    }
  }
  times.Unite();
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    times.Tell(outputs->GetInformationObject(port));
  }
}

void SkdMarkRequestedTime(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* output = outputs->GetInformationObject(port);
    vtkDataObject* data = vtkDataObject::GetData(output);
    if (data && output->Has(Pipeline::TIME_RANGE()) && output->Has(Pipeline::UPDATE_TIME_STEP()))
    {
      data->GetInformation()->Set(
        vtkDataObject::DATA_TIME_STEP(), output->Get(Pipeline::UPDATE_TIME_STEP()));
    }
  }
}
}
