// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TimeSource.h
 * @brief a mesh that moves with time, for tests of pipelines in time
 */
#ifndef skdtest_TimeSource_h
#define skdtest_TimeSource_h

#include "Support/MeshBuilder.h"

#include "vtkDataObjectAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <vector>

namespace skdtest
{

/// A copy of a mesh as it is at a time: moved along each axis.
inline vtkSmartPointer<vtkPointSet> MovedTo(vtkPointSet* mesh, double time)
{
  auto moved = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  moved->DeepCopy(mesh);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double x[3];
    moved->GetPoint(i, x);
    moved->GetPoints()->SetPoint(i, x[0] + 0.61 * time, x[1] + 0.37 * time, x[2] - 0.25 * time);
  }
  return moved;
}

/// Has time steps; of another time it gives the last step that is not later, as readers do.
class TimeSource : public vtkDataObjectAlgorithm
{
public:
  static TimeSource* New();
  vtkTypeMacro(TimeSource, vtkDataObjectAlgorithm);

  void Set(vtkPointSet* mesh, const std::vector<double>& steps)
  {
    this->Mesh = mesh;
    this->Steps = steps;
    this->Modified();
  }

  /// The step that is shown at a time.
  double StepAt(double time) const
  {
    const auto next = std::upper_bound(this->Steps.begin(), this->Steps.end(), time);
    return next == this->Steps.begin() ? this->Steps.front() : *(next - 1);
  }

protected:
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  TimeSource() { this->SetNumberOfInputPorts(0); }

  int RequestDataObject(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    if (!vtkDataObject::GetData(outputs))
    {
      const auto data = vtkSmartPointer<vtkDataObject>::Take(this->Mesh->NewInstance());
      outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), data);
    }
    return 1;
  }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* output = outputs->GetInformationObject(0);
    const double range[2] = { this->Steps.front(), this->Steps.back() };
    output->Set(Pipeline::TIME_STEPS(), this->Steps.data(), static_cast<int>(this->Steps.size()));
    output->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* output = outputs->GetInformationObject(0);
    const bool hasTime = output->Has(Pipeline::UPDATE_TIME_STEP()) != 0;
    const double step = this->StepAt(hasTime ? output->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0);
    vtkDataObject* data = vtkDataObject::GetData(outputs);
    data->ShallowCopy(MovedTo(this->Mesh, step));
    data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step);
    return 1;
  }

  int FillOutputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPointSet");
    return 1;
  }

private:
  vtkSmartPointer<vtkPointSet> Mesh;
  std::vector<double> Steps;
};

inline TimeSource* TimeSource::New()
{
  auto* source = new TimeSource;
  source->InitializeObjectBase();
  return source;
}

}

#endif
