// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPorts_h
#define SkdPorts_h

#include "vtkAlgorithm.h"
#include "vtkInformation.h"

/// An input of any vtkDataSet, or composite of them.
inline void SkdAcceptMeshes(vtkInformation* port)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

#endif
