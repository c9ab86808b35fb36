// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdWholeInput_h
#define SkdWholeInput_h

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

/// Requests the whole of an input, whatever piece of the output is requested.
inline void SkdAskForWhole(vtkInformation* input)
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

#endif
