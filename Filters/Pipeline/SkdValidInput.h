// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdValidInput_h
#define SkdValidInput_h

#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkInformation;

/// The inputs of a filter for its RequestData, in which broken cells (Cells/SkdCellCheck.h) are
/// replaced by empty cells with the same ids. The filter warns about them once. A valid mesh is
/// checked again only when it is modified.
class SkdValidInput
{
public:
  /// For ProcessRequest: requests other than REQUEST_DATA get the inputs as they are.
  SkdValidInput(vtkAlgorithm* filter, vtkInformation* request, vtkInformationVector** inputs);

  /// Valid for the lifetime of this object.
  vtkInformationVector** Get() const { return this->Inputs; }

private:
  static std::string Mend(vtkInformationVector* to);

  vtkInformationVector** Inputs;
  std::vector<vtkSmartPointer<vtkInformationVector>> Mended;
  std::vector<vtkInformationVector*> MendedInputs;
};

#endif
