// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPorts.h
 * @brief What filters ask of their ports: what comes in, how much of it, and what goes out.
 */

#ifndef SkdPorts_h
#define SkdPorts_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <initializer_list>

namespace skdtree
{
/// An input of any of some classes.
inline void SkdAccept(vtkInformation* port, std::initializer_list<const char*> classes)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* name : classes)
  {
    port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), name);
  }
}

/// An input of any vtkDataSet, or composite of them. Others are refused when data are requested
/// (SkdRefuseOthers): VTK would complain once for each request.
inline void SkdAcceptMeshes(vtkInformation* port)
{
  SkdAccept(port, { "vtkDataSet", "vtkCompositeDataSet", "vtkDataObject" });
}

/// Requests the whole of an input, whatever piece of the output is requested.
inline void SkdRequestWhole(vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
}

/// Requests of an input the piece that is requested of an output, of whatever extent the input is.
inline void SkdRequestSamePiece(vtkInformation* output, vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  SkdRequestWhole(input);
  input->CopyEntry(output, Pipeline::UPDATE_PIECE_NUMBER());
  input->CopyEntry(output, Pipeline::UPDATE_NUMBER_OF_PIECES());
  input->CopyEntry(output, Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
}

/// Whether a filter that computes all in one process leaves this output empty: one of a piece that
/// is not the first.
inline bool SkdIsLaterPiece(vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return output->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0;
}

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
}

#endif
