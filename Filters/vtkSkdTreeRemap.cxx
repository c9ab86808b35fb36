// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeRemap.h"

#include "Exchange/SkdCountedCells.h"
#include "Exchange/SkdJoinedRows.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "Remap/SkdMeshRemap.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <cmath>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeRemap);

//------------------------------------------------------------------------------
class vtkSkdTreeRemap::Internals
{
public:
  std::set<std::string> Extensive;
  std::set<std::string> Gradients;
  SkdMeshRemap Remap;
  SkdCountedCells Counted; // of the Input

  /// Marks the cells of the outputs that this process counts, or no longer.
  void Mark(vtkDataObject* input, const std::vector<SkdBlock>& outputs,
    vtkMultiProcessController* controller);
  static void Unmark(const std::vector<SkdBlock>& outputs);

  SkdRemapRequest MakeRequest(const vtkSkdTreeRemap* self) const;
  SkdRemapSettings MakeSettings(const vtkSkdTreeRemap* self) const;
};

namespace
{
void AddName(vtkObject* self, std::set<std::string>& names, const char* name)
{
  if (name && names.insert(name).second)
  {
    self->Modified();
  }
}

/// Writes the file of weights, if one is wanted: `controller` has the processes that share it, or
/// is nullptr.
std::string WriteWeights(SkdMeshRemap& remap, vtkDataObject* input,
  vtkMultiProcessController* controller, const skd::Processes* processes)
{
  if (!processes)
  {
    return remap.WriteWeights(nullptr);
  }
  const auto findRows = [&]() -> SkdTargetRows
  {
    const SkdJoinedRows rows = SkdJoinRows(input, controller);
    return { rows.OfBlocks, rows.Number, SkdGridSizesOf(SkdBlocksOf(rows.Whole)), rows.Problem };
  };
  const auto gatherAt = [&](int process, const auto& own, const auto& take)
  { SkdGatherAt(process, own, take, controller); };
  const SkdWeightsSharers sharers{ *processes, controller->GetLocalProcessId(), findRows,
    gatherAt };
  return remap.WriteWeights(&sharers);
}

void Warn(const SkdMeshRemap& remap, const std::string& problem, vtkSkdTreeRemap* self)
{
  if (!problem.empty())
  {
    vtkWarningWithObjectMacro(self, << problem);
  }
  SkdWarnAboutRefused(self, remap.GetRefused());
  for (const std::string& warning : remap.GetWarnings())
  {
    vtkWarningWithObjectMacro(self, << warning);
  }
}
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::Mark(
  vtkDataObject* input, const std::vector<SkdBlock>& outputs, vtkMultiProcessController* controller)
{
  const std::vector<std::vector<unsigned char>>& counted = this->Counted.Update(input, controller);
  for (std::size_t block = 0; block < outputs.size(); ++block)
  {
    SkdSetOwnCells(outputs[block].Mesh, counted[block]);
  }
}

void vtkSkdTreeRemap::Internals::Unmark(const std::vector<SkdBlock>& outputs)
{
  for (const SkdBlock& block : outputs)
  {
    SkdSetOwnCells(block.Mesh, {});
  }
}

SkdRemapSettings vtkSkdTreeRemap::Internals::MakeSettings(const vtkSkdTreeRemap* self) const
{
  SkdRemapSettings settings;
  settings.Fields.Missing = static_cast<SkdMissingValues>(self->MissingValues);
  settings.Fields.MissingValue = self->UseMissingValue ? self->MissingValue : vtkMath::Nan();
  settings.Fields.Mask = self->MaskArray;
  settings.Fields.Extensive = this->Extensive;
  settings.Fields.RenamesTaken = self->RenameTakenArrays;
  settings.Overlap.DonorIsLonLat = self->SourceEdgesAlongParallels;
  settings.Overlap.TargetIsLonLat = self->InputEdgesAlongParallels;
  settings.Overlap.Facets.Distance = self->SurfaceDistance;
  settings.Overlap.Facets.LeastCosine =
    self->SurfaceAngle < 90.0 ? std::cos(vtkMath::RadiansFromDegrees(self->SurfaceAngle)) : 0.0;
  settings.Conservative.Normalization = static_cast<SkdNormalization>(self->Normalization);
  settings.Conservative.MinimumCoverage = self->MinimumCoverage;
  settings.Conservative.RotatesVectors = self->RotateVectors;
  settings.Limiter = static_cast<SkdLimiter>(self->Limiter);
  settings.Statistic = static_cast<SkdStatistic>(self->Statistic);
  settings.Empty = static_cast<SkdEmptyCells>(self->EmptyCells);
  settings.Extrapolation = { static_cast<SkdExtrapolationMethod>(self->Extrapolation),
    self->ExtrapolationConstant, self->ExtrapolationNeighbors };
  return settings;
}

SkdRemapRequest vtkSkdTreeRemap::Internals::MakeRequest(const vtkSkdTreeRemap* self) const
{
  SkdRemapRequest request;
  request.Method = static_cast<SkdRemapMethod>(self->Method);
  request.Results = static_cast<SkdRemapResults>(self->ResultsOn);
  request.Geometry = static_cast<SkdRemapGeometry>(self->Geometry);
  request.IsDonorInDegrees = self->SourceCoordinates == LONGITUDE_LATITUDE;
  request.IsTargetInDegrees = self->InputCoordinates == LONGITUDE_LATITUDE;
  request.Weighing = static_cast<SkdSampleWeighing>(self->SampleWeights);
  request.Settings = this->MakeSettings(self);
  request.Gradients = this->Gradients;
  request.Written.Name = self->WeightsFileName;
  request.Written.Format = static_cast<SkdWeightsFormat>(self->WeightsFileFormat);
  request.Applied = self->AppliedWeightsFileName;
  return request;
}

//------------------------------------------------------------------------------
vtkSkdTreeRemap::vtkSkdTreeRemap()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_TABLE, GRID_OR_BLOCKS })
  , Impl(new Internals)
{
}

vtkSkdTreeRemap::~vtkSkdTreeRemap() = default;

void vtkSkdTreeRemap::SetText(std::string& property, const char* text)
{
  const std::string given = text ? text : "";
  if (given != property)
  {
    property = given;
    this->Modified();
  }
}

void vtkSkdTreeRemap::AddExtensiveArray(const char* name)
{
  AddName(this, this->Impl->Extensive, name);
}

void vtkSkdTreeRemap::ClearExtensiveArrays()
{
  this->Impl->Extensive.clear();
  this->Modified();
}

void vtkSkdTreeRemap::AddGradientArray(const char* name)
{
  AddName(this, this->Impl->Gradients, name);
}

void vtkSkdTreeRemap::ClearGradientArrays()
{
  this->Impl->Gradients.clear();
  this->Modified();
}

bool vtkSkdTreeRemap::NeedsWhole(int port)
{
  return (this->ResultsOn == POINTS && this->Method != INTERPOLATION) ||
    this->Method == WEIGHTS_FROM_FILE || this->Superclass::NeedsWhole(port);
}

//------------------------------------------------------------------------------
// How many of the nearest there are within a distance, and how far a box has to grow, is not known
// without all samples.
bool vtkSkdTreeRemap::NeedsNearbySource(SkdSearchRange& range)
{
  const bool isContained = this->Method == CONTAINED;
  const bool isInterpolated = this->Method == INTERPOLATION || this->Method == AUTOMATIC_METHOD;
  const bool isExtrapolated = !isContained && this->Method != INTERPOLATION &&
    this->Extrapolation != NO_EXTRAPOLATION && this->Extrapolation != CONSTANT_VALUE;
  const bool hasGaps = this->UseMissingValue || !this->MaskArray.empty();
  const bool isInDegrees =
    this->SourceCoordinates == LONGITUDE_LATITUDE || this->InputCoordinates == LONGITUDE_LATITUDE;
  range.OfDiagonal = 1e-3; // as far as Probe goes, and more than any rounding
  range.IsOfOneMesh = true;
  range.WithOwn = true;
  range.WithNeighbours = this->Method == CONSERVATIVE_SECOND_ORDER; // for gradients and limiters
  range.WithNearest =
    isExtrapolated || ((isContained || isInterpolated) && this->EmptyCells == NEAREST);
  range.IsOfSamples = isContained || isExtrapolated;
  range.Directions = this->Geometry == SPHERE || isInDegrees ? SkdByDirections::Always
    : this->Geometry == AUTOMATIC_GEOMETRY                   ? SkdByDirections::OnSpheres
                                                             : SkdByDirections::Never;
  range.IsOwnInDegrees = this->InputCoordinates == LONGITUDE_LATITUDE;
  range.IsSearchedInDegrees = this->SourceCoordinates == LONGITUDE_LATITUDE;
  range.IsNotForSpheres = isInterpolated; // there points move to the radius of the cells
  range.IsOfNearSurfaces = !isContained && this->Method != INTERPOLATION &&
    (this->Geometry == CURVED_SURFACE ||
      (this->Geometry == AUTOMATIC_GEOMETRY && this->Method != AUTOMATIC_METHOD));
  range.IsUnlessFlat = this->Geometry == AUTOMATIC_GEOMETRY && !isInDegrees;
  range.Distance = range.IsOfNearSurfaces ? this->SurfaceDistance : 0.0;
  return !(isInterpolated && range.Directions == SkdByDirections::Always) &&
    !(range.IsOfSamples && range.WithNearest && hasGaps) &&
    !(isContained && this->EmptyCells == ENCLOSING_BOX) &&
    !(isExtrapolated && this->Extrapolation != NEAREST_VALUE) && this->WeightsFileName.empty();
}

int vtkSkdTreeRemap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->IsLeftToFirst(outputVector))
  {
    return 1;
  }
  SkdStopwatch watch;
  auto* input = vtkDataObject::GetData(inputVector[0]);
  auto* output = vtkDataObject::GetData(outputVector, 0);
  const std::vector<SkdBlock> outputs = SkdMirror(input, output);
  if (!this->PassInputData)
  {
    SkdDropData(outputs);
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  const bool hasAll = this->NeedsWhole(0);
  const auto processes = hasAll ? nullptr : SkdProcessesOf(information);
  SkdRemapRequest request = this->Impl->MakeRequest(this);
  if (!hasAll && !processes)
  {
    request.Written.Name = SkdShare::Of(outputVector).NameOf(this->WeightsFileName);
  }
  if (processes && (request.IsConservative() || this->Method == AUTOMATIC_METHOD))
  {
    this->Impl->Mark(input, outputs, SkdControllerOf(information));
  }
  SkdRemapPair pair(SkdBlocksOf(vtkDataObject::GetData(inputVector[1])), SkdBlocksOf(input),
    outputs, request, processes.get());
  SkdMeshRemap& remap = this->Impl->Remap;
  remap.Run(pair, request, processes.get(), this);
  if (this->GenerateWeights)
  {
    remap.FillWeights(
      vtkCompositeDataSet::SafeDownCast(input) != nullptr, vtkTable::GetData(outputVector, 1));
  }
  if (this->GenerateOverlapMesh)
  {
    remap.FillOverlaps(input, vtkDataObject::GetData(outputVector, 2));
  }
  Warn(remap, WriteWeights(remap, input, SkdControllerOf(information), processes.get()), this);
  remap.AddReport(watch.Lap(), output);
  pair.Finish();
  Internals::Unmark(outputs);
  remap.End();
  return 1;
}

void vtkSkdTreeRemap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Method", this->Method, "ResultsOn", this->ResultsOn, "Geometry",
    this->Geometry, "SurfaceDistance", this->SurfaceDistance, "SurfaceAngle", this->SurfaceAngle,
    "SourceCoordinates", this->SourceCoordinates, "InputCoordinates", this->InputCoordinates,
    "SourceEdgesAlongParallels", this->SourceEdgesAlongParallels, "InputEdgesAlongParallels",
    this->InputEdgesAlongParallels, "Statistic", this->Statistic, "SampleWeights",
    this->SampleWeights, "EmptyCells", this->EmptyCells, "Extrapolation", this->Extrapolation,
    "ExtrapolationConstant", this->ExtrapolationConstant, "ExtrapolationNeighbors",
    this->ExtrapolationNeighbors, "Limiter", this->Limiter, "Normalization", this->Normalization,
    "MinimumCoverage", this->MinimumCoverage, "MissingValues", this->MissingValues,
    "UseMissingValue", this->UseMissingValue, "MissingValue", this->MissingValue, "MaskArray",
    this->MaskArray, "RotateVectors", this->RotateVectors, "PassInputData", this->PassInputData,
    "RenameTakenArrays", this->RenameTakenArrays, "GenerateWeights", this->GenerateWeights,
    "GenerateOverlapMesh", this->GenerateOverlapMesh, "WeightsFileName", this->WeightsFileName,
    "WeightsFileFormat", this->WeightsFileFormat, "AppliedWeightsFileName",
    this->AppliedWeightsFileName);
  for (const std::string& name : this->Impl->Extensive)
  {
    SkdPrint(os, indent, "ExtensiveArray", name);
  }
  for (const std::string& name : this->Impl->Gradients)
  {
    SkdPrint(os, indent, "GradientArray", name);
  }
}
VTK_ABI_NAMESPACE_END
