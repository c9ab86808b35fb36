// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdProvideOutput_h
#define SkdProvideOutput_h

#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkSmartPointer.h"

/// Puts a new data object of the type (VTK_POLY_DATA, say) into an output, unless it has one.
inline void SkdProvideOutput(vtkInformation* output, int type)
{
  vtkDataObject* data = vtkDataObject::GetData(output);
  if (!data || data->GetDataObjectType() != type)
  {
    const auto fresh =
      vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
    output->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
}

#endif
