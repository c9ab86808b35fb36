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

/// The inputs of a filter as its RequestData may read them: where cells are broken
/// (Cells/SkdCellCheck.h), meshes in which these are empty, under the ids that they had. The filter
/// warns of them, once. A mesh that was whole is looked at again when it is modified.
class SkdValidInput
{
public:
  /// For ProcessRequest: requests other than REQUEST_DATA get the inputs as they are.
  SkdValidInput(vtkAlgorithm* filter, vtkInformation* request, vtkInformationVector** inputs);

  /// Good as long as this lives.
  vtkInformationVector** Get() const { return this->Inputs; }

private:
  static std::string Mend(vtkInformationVector* to);

  vtkInformationVector** Inputs;
  std::vector<vtkSmartPointer<vtkInformationVector>> Mended;
  std::vector<vtkInformationVector*> MendedInputs;
};

#endif
