// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdValidInput_h
#define SkdValidInput_h

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkInformation;
class vtkMultiProcessController;

namespace skdtree
{
/// The inputs of a filter for its RequestData, in which broken cells (Cells/Read/SkdCellCheck.h)
/// are replaced by empty cells with the same ids, and without arrays that are too short or too long
/// (SkdUnfitArrays). The filter warns about these once, and about points that cannot be used
/// (SkdUnusablePoints), which stay. A valid mesh is checked again only when it is modified.
class SkdValidInput
{
public:
  /// For ProcessRequest: requests other than REQUEST_DATA get the inputs as they are.
  /// `anyMagnitude`: the filter can use all finite points.
  SkdValidInput(vtkAlgorithm* filter, vtkInformation* request, vtkInformationVector** inputs,
    bool anyMagnitude = false);

  /// Valid for the lifetime of this object.
  vtkInformationVector** Get() const { return this->Inputs; }

  /// Adds SkdReportPointsNotFinite, of each port, to the first output, if there are any.
  void Report(vtkInformationVector* outputs) const;

private:
  struct Findings
  {
    std::string BrokenCells; ///< for the warning; empty if there are none
    std::string Arrays;
    std::string Points;
    vtkIdType NumberOfPoints = 0;
  };
  static Findings Repair(vtkInformationVector* to, bool anyMagnitude);

  vtkInformationVector** Inputs;
  std::vector<vtkIdType> PointCounts; // of unusable ones, of each port; empty if there are none
  std::vector<vtkSmartPointer<vtkInformationVector>> Repaired;
  std::vector<vtkInformationVector*> RepairedInputs;
};

/// Whether there is an input that is no data set and no composite of them, or composite data that
/// have blocks, but none that is a data set: of several processes, if there is a controller, on all
/// of them, which must call it together. Then there is an error, and the outputs are to stay empty.
bool SkdRefuseOthers(
  vtkAlgorithm* filter, vtkInformationVector** inputs, vtkMultiProcessController* controller);

/// The ProcessRequest of a filter that has nothing else to do there: process(inputs) is that of its
/// superclass. `controller` is that of SkdRefuseOthers.
template <class Process>
auto SkdProcessValid(vtkAlgorithm* filter, vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, vtkMultiProcessController* controller, const Process& process)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()) &&
    SkdRefuseOthers(filter, inputs, controller))
  {
    return decltype(process(inputs))(1);
  }
  const SkdValidInput valid(filter, request, inputs);
  const auto result = process(valid.Get());
  valid.Report(outputs);
  return result;
}
}

#endif
