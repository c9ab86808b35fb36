// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapFindings.h"

#include "Pipeline/SkdReport.h"

namespace skdtree
{
namespace
{
/// Nothing if there are none.
void NameFaulty(const SkdFaultyCells& cells, const std::string& mesh, const char* fault,
  std::vector<std::string>& warnings)
{
  if (cells.Count > 0)
  {
    warnings.push_back(std::to_string(cells.Count) + " polygons of " + mesh + " (the first: cell " +
      std::to_string(cells.First) + ") " + fault);
  }
}

constexpr const char* TooLarge =
  "are larger than a hemisphere, by the order of their corners: they have no part in it. Divide "
  "them, or reverse the order if the smaller part of the sphere is meant.";
constexpr const char* Crossing =
  "cross themselves, or their corners are opposite to each other: what they enclose is counted by "
  "the sense of their outline, or not at all. Mend them.";

constexpr const char* FarSurfaces =
  " Surfaces must nearly coincide: if they are farther apart than their cells are large, set "
  "SurfaceDistance.";
}

std::vector<std::string> SkdRemapFindings::GetWarnings(const std::string& hint) const
{
  if (!this->Problem.empty())
  {
    return { this->Problem + hint };
  }
  std::vector<std::string> warnings;
  NameFaulty(this->SourceTooLarge, "Source", TooLarge, warnings);
  NameFaulty(this->InputTooLarge, "Input", TooLarge, warnings);
  NameFaulty(this->SourceCrossing, "Source", Crossing, warnings);
  NameFaulty(this->InputCrossing, "Input", Crossing, warnings);
  if (this->WeightsUsed > 0 && this->Overlaps == 0 && this->OverlapsElsewhere == 0 &&
    warnings.empty())
  {
    warnings.push_back(
      "Input and Source have nothing in common: no cell gets a value. Look at the bounds of both, "
      "and at Geometry, SourceCoordinates and InputCoordinates." +
      std::string(this->Surfaces ? FarSurfaces : "") + hint);
    return warnings;
  }
  if (this->Surfaces)
  {
    this->Surfaces->AddWarnings(warnings);
  }
  const std::vector<std::string> others = SkdFaultsOf({
    { this->SourceLeftOut,
      " cells of Source have no part in it: they are degenerate, not finite or of another "
      "dimension." },
    { this->InputLeftOut,
      " cells of Input get no value: they are degenerate, not finite or of another dimension." },
    { this->Unfit,
      " cells of Input contain nothing: on a sphere only triangles, quads, pixels and polygons do. "
      "Make triangles of strips, and flat cells of curved ones (vtkTessellatorFilter)." },
    { this->Surfaces ? this->WithoutPartner : 0,
      " cells of Input are not covered by Source, or in part: no cell of Source faces them there "
      "within SurfaceDistance (SkdCoverage is below 1)." },
    { this->CoveredTwice,
      " cells of Input are covered more than once (SkdCoverage is above 1): cells of Source "
      "overlap each other, and count as often." },
    { this->SourceCoveredTwice,
      " cells of Source are covered more than once: cells of Input overlap each other, so the "
      "integral over Input is too large." },
  });
  warnings.insert(warnings.end(), others.begin(), others.end());
  return warnings;
}
}
