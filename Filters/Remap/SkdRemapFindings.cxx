// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapFindings.h"

#include "Pipeline/SkdReport.h"

std::vector<std::string> SkdRemapFindings::GetWarnings() const
{
  if (!this->Problem.empty())
  {
    return { this->Problem };
  }
  if (this->WeightsFound > 0 && this->Overlaps == 0)
  {
    return { "Input and Source have nothing in common: no cell gets a value. Look at the bounds of "
             "both, and at Geometry and SourceCoordinates." };
  }
  return SkdFaultsOf({
    { this->SourceLeftOut,
      " cells of Source have no part in it: they are degenerate, not finite, ghosts or of another "
      "dimension." },
    { this->InputLeftOut,
      " cells of Input get no value: they are degenerate, not finite, ghosts or of another "
      "dimension." },
    { this->Unfit,
      " cells of Input contain nothing: on a sphere only triangles, quads, pixels and polygons do. "
      "Make triangles of strips, and flat cells of curved ones (vtkTessellatorFilter)." },
    { this->CoveredTwice,
      " cells of Input are covered more than once (SkdCoverage is above 1): cells of Source "
      "overlap each other, and count as often." },
    { this->SourceCoveredTwice,
      " cells of Source are covered more than once: cells of Input overlap each other, so the "
      "integral over Input is too large." },
  });
}
