// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdMeshRemap.h"

#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdJoinedShape.h"
#include "Pipeline/SkdPartialArrays.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdShownElements.h"
#include "Remap/SkdOverlapMesh.h"
#include "Remap/SkdOverlapSurface.h"

#include "vtkAlgorithm.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace skdtree
{
namespace
{
/// What of the target one process has may be flat, or a line, where others have curved surfaces, or
/// volumes; spaces are in that order.
SkdOverlapSpace FindCommonSpace(bool hasCells, SkdOverlapSpace own, const skd::Processes& processes)
{
  const double none = -1.0;
  double common = hasCells ? static_cast<double>(own) : none;
  for (const std::vector<double>& told : processes.GatherFromOthers({ common }))
  {
    common = std::max(common, told.front());
  }
  return common == none ? own : static_cast<SkdOverlapSpace>(static_cast<int>(common));
}
}

//------------------------------------------------------------------------------
void SkdMeshRemap::Run(SkdRemapPair& pair, const SkdRemapRequest& request,
  const skd::Processes* processes, vtkAlgorithm* algorithm)
{
  this->Pair = &pair;
  this->Request = &request;
  this->Algorithm = algorithm;
  this->Refused.clear();
  this->Empty.clear();
  this->SetUp(processes);
  this->Begin(processes);
  this->MapAll(processes);
  if (processes)
  {
    this->Remapper.AddOverlaps(*processes);
    this->Remapper.AddIntegrals(*processes);
  }
}

//------------------------------------------------------------------------------
void SkdMeshRemap::SetUp(const skd::Processes* processes)
{
  const SkdRemapRequest& request = *this->Request;
  this->Settings = request.Settings;
  this->Settings.IsSecondOrder = request.Method == SkdRemapMethod::SecondOrder;
  this->Settings.WithPointFields = request.Method != SkdRemapMethod::Automatic;
  this->Settings.ToPoints = request.Results == SkdRemapResults::Points;
  this->Settings.WeighsByCosine = request.Weighing == SkdSampleWeighing::CosineOfLatitude ||
    (request.Weighing == SkdSampleWeighing::Automatic && this->Pair->IsDonorStructured());
  SkdOverlapSpace& space = this->Settings.Overlap.Space;
  space = this->Pair->FindSpace();
  const bool mayBeCurved = request.IsConservative() ||
    (request.Method == SkdRemapMethod::Automatic &&
      request.Geometry == SkdRemapGeometry::CurvedSurface);
  if (processes)
  {
    space = FindCommonSpace(this->Pair->HasCells(), space, *processes);
  }
  this->AreCurved = mayBeCurved && space == SkdOverlapSpace::CurvedSurface;
  if (space == SkdOverlapSpace::Sphere && SkdJoinedShape::Of(this->Pair->GetDonor()))
  {
    // It may change where this process has nothing.
    this->Settings.Overlap.Radius = SkdOverlapSurface::MeanRadiusOf(this->Pair->GetDonor());
  }
}

// What only the prober maps it reads itself.
void SkdMeshRemap::Begin(const skd::Processes* processes)
{
  const bool hasOthers = processes != nullptr;
  const bool hasCells = this->Pair->HasCells();
  const bool isAutomatic = this->Request->Method == SkdRemapMethod::Automatic;
  const bool isOfOne = !isAutomatic || this->Pair->IsOfOneDimension(processes);
  const bool isForced = isAutomatic && (!hasCells || !isOfOne);
  this->Method = isForced ? SkdRemapMethod::Interpolation : this->Request->Method;
  const vtkNew<vtkUnstructuredGrid> nothing;
  const bool isProbed = this->Method == SkdRemapMethod::Interpolation &&
    this->Settings.Fields.Mask.empty() && !(isAutomatic && !hasCells && hasOthers);
  this->Remapper.Begin(
    isProbed ? nothing.Get() : this->Pair->GetDonor(), this->Settings, this->Algorithm);
  if (isProbed)
  {
    this->Empty = SkdFindEmptyFields(this->Pair->GetDonor());
  }
  if (hasOthers && !isProbed && this->Method != SkdRemapMethod::Contained)
  {
    this->Remapper.ExpectIntegrals();
  }
}

//------------------------------------------------------------------------------
void SkdMeshRemap::MapAll(const skd::Processes* processes)
{
  constexpr double matched = 0.7; // of the progress
  double start = 0.0;
  if (this->AreCurved)
  {
    this->Remapper.MatchSurfaces(this->Pair->GetOutputs(), processes, 0.0, matched);
    start = matched;
  }
  if (this->Method == SkdRemapMethod::FromFile)
  {
    constexpr int wanted[] = { -1, vtkDataObject::CELL, vtkDataObject::POINT };
    this->Remapper.MapByFile(this->Request->Applied, this->Pair->GetOutputs(),
      wanted[static_cast<int>(this->Request->Results)]);
  }
  else if (this->Pair->HasCells() || !this->Request->IsConservative())
  {
    this->MapBlocks(start);
  }
  const bool isAutomatic = this->Request->Method == SkdRemapMethod::Automatic;
  if (!this->Pair->HasCells() && (this->Request->IsConservative() || isAutomatic) &&
    !SkdOwnCellsOf(this->Pair->GetDonor()).empty())
  {
    this->Remapper.SumUpDonor();
  }
  if (this->Request->IsConservative())
  {
    this->Remapper.AssureSums(processes);
  }
}

void SkdMeshRemap::MapBlocks(double start)
{
  const std::size_t blocks = this->Pair->GetOutputs().size();
  const double step = (1.0 - start) / static_cast<double>(std::max<std::size_t>(blocks, 1));
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const double first = start + static_cast<double>(block) * step;
    if (!SkdIsAborted(this->Algorithm))
    {
      this->MapBlock(block, first, first + step);
    }
  }
}

void SkdMeshRemap::MapBlock(std::size_t block, double first, double last)
{
  vtkDataSet* mesh = this->Pair->GetOutputs()[block].Mesh;
  switch (this->Method)
  {
    case SkdRemapMethod::Contained:
      this->Remapper.MapContained(mesh, first, last);
      break;
    case SkdRemapMethod::Interpolation:
      this->Interpolate(mesh, true, first, last);
      break;
    case SkdRemapMethod::Automatic:
      this->MapAutomatically(block, first, last);
      break;
    default:
      this->Remapper.MapConservative(mesh, block, first, last);
  }
}

void SkdMeshRemap::MapAutomatically(std::size_t block, double first, double last)
{
  vtkDataSet* mesh = this->Pair->GetOutputs()[block].Mesh;
  const double middle = 0.5 * (first + last);
  if (this->Remapper.MapConservative(mesh, block, first, middle))
  {
    const bool isMapped = this->Remapper.GetWeights(block) != nullptr;
    if (!isMapped || this->Pair->GetDonor()->GetPointData()->GetNumberOfArrays() > 0)
    {
      this->Interpolate(mesh, !isMapped, middle, last);
    }
  }
}

void SkdMeshRemap::Interpolate(vtkDataSet* block, bool withCellData, double first, double last)
{
  SkdProbeSettings settings;
  settings.Fields = this->Settings.Fields;
  settings.Gradients = this->Request->Gradients;
  settings.TakesNearest = this->Settings.Empty != SkdEmptyCells::Leave;
  settings.IsOnSphere = this->Settings.Overlap.Space == SkdOverlapSpace::Sphere;
  settings.Radius = settings.IsOnSphere ? this->Pair->RadiusOfTarget() : 0.0;
  settings.ToCells = this->Request->Results == SkdRemapResults::Cells;
  this->Probe.Map(block, this->Pair->GetDonor(), withCellData, settings, this->Algorithm, first,
    last, this->Refused);
}

//------------------------------------------------------------------------------
void SkdMeshRemap::FillWeights(bool withBlocks, vtkTable* table) const
{
  const std::vector<SkdBlock>& outputs = this->Pair->GetOutputs();
  for (std::size_t block = 0; block < outputs.size(); ++block)
  {
    if (const SkdOverlapWeights* weights = this->Remapper.GetWeights(block))
    {
      SkdAppendWeights(*weights, this->Pair->GetDonor(), this->Settings.Conservative.Normalization,
        outputs[block].BlockIndex, withBlocks, table);
    }
  }
}

void SkdMeshRemap::FillOverlaps(vtkDataObject* input, vtkDataObject* overlaps) const
{
  const SkdLeafNumbers leaves = SkdLeafNumbersOf(input);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(overlaps);
  if (blocks)
  {
    blocks->SetNumberOfBlocks(leaves.Count);
  }
  const std::vector<SkdBlock>& targets = this->Pair->GetTargets();
  for (std::size_t block = 0; block < targets.size(); ++block)
  {
    const SkdOverlapWeights* weights = this->Remapper.GetWeights(block);
    const vtkSmartPointer<vtkUnstructuredGrid> mesh = weights
      ? SkdMakeOverlapMesh(this->Pair->GetDonor(), targets[block].Mesh,
          this->Remapper.GetOverlapSettings(), this->Algorithm, weights->GetTarget().Counts)
      : nullptr;
    if (mesh && blocks)
    {
      blocks->SetBlock(leaves.Of[block], mesh);
    }
    else if (mesh)
    {
      overlaps->ShallowCopy(mesh);
    }
  }
}

//------------------------------------------------------------------------------
// Of the blocks that have weights, one after another.
std::vector<vtkIdType> SkdMeshRemap::RowsOf(const SkdTargetRows& rows) const
{
  std::vector<vtkIdType> all;
  for (std::size_t block = 0; block < rows.OfBlocks.size(); ++block)
  {
    if (this->Remapper.GetWeights(block))
    {
      all.insert(all.end(), rows.OfBlocks[block].begin(), rows.OfBlocks[block].end());
    }
  }
  return all;
}

// The first process that has weights writes: it has measured the donor.
std::string SkdMeshRemap::WriteShares(const SkdWeightsFileSettings& file,
  const std::vector<SkdWeightsBlock>& blocks, const SkdWeightsSharers& sharers) const
{
  const double none = std::numeric_limits<double>::max();
  const double writer = sharers.Processes.LeastOf(blocks.empty() ? none : sharers.Rank);
  if (writer == none)
  {
    const std::string problem = SkdWriteWeights(file, this->Pair->GetDonor(), {}, {}, nullptr);
    return sharers.Rank == 0 ? problem : std::string();
  }
  const SkdTargetRows rows = sharers.FindRows();
  SkdWeightsShare share;
  share.IsWriter = sharers.Rank == static_cast<int>(writer);
  if (!rows.Problem.empty())
  {
    return share.IsWriter ? "The file " + file.Name + " was not written: " + rows.Problem
                          : std::string();
  }
  share.Rows = this->RowsOf(rows);
  share.NumberOfRows = rows.Number;
  const int corners = SkdCornersPerCell(this->Pair->GetTargets());
  share.CornersPerCell = -static_cast<int>(sharers.Processes.LeastOf(-corners));
  share.Gather = [&](const auto& own, const auto& take)
  { sharers.GatherAt(static_cast<int>(writer), own, take); };
  const std::string problem = SkdWriteWeights(file, this->Pair->GetDonor(), blocks,
    { this->Pair->GetGrids().Source, rows.GridSizes }, &share);
  return share.IsWriter ? problem : std::string();
}

std::string SkdMeshRemap::WriteWeights(const SkdWeightsSharers* sharers)
{
  SkdWeightsFileSettings file = this->Request->Written;
  if (file.Name.empty())
  {
    return "";
  }
  file.Space = this->Settings.Overlap.Space;
  file.Normalization = this->Settings.Conservative.Normalization;
  file.WithGradients = this->Settings.IsSecondOrder && file.Format == SkdWeightsFormat::Scrip;
  const auto isAny = [sharers](bool here)
  { return sharers ? sharers->Processes.IsAny(here) : here; };
  if (!isAny(!(file == this->Written) || this->Remapper.GetFindings().WeightsFound > 0))
  {
    return "";
  }
  std::vector<SkdWeightsBlock> blocks;
  for (std::size_t block = 0; block < this->Pair->GetTargets().size(); ++block)
  {
    if (const SkdOverlapWeights* weights = this->Remapper.GetWeights(block))
    {
      blocks.push_back({ this->Pair->GetTargets()[block].Mesh, weights });
    }
  }
  const std::string problem = sharers
    ? this->WriteShares(file, blocks, *sharers)
    : SkdWriteWeights(file, this->Pair->GetDonor(), blocks, this->Pair->GetGrids(), nullptr);
  const bool isWritten = !isAny(!problem.empty());
  this->Written = isWritten ? file : SkdWeightsFileSettings();
  const bool isLess = this->Settings.IsSecondOrder && !file.WithGradients;
  const bool isTold = isWritten && isLess && (!sharers || sharers->Rank == 0);
  return !isTold ? problem
                 : "The weights in " + file.Name +
      " are of first order: ESMF's form has none of gradients. SCRIP's has.";
}

//------------------------------------------------------------------------------
std::vector<std::string> SkdMeshRemap::GetWarnings() const
{
  const SkdRemapFindings& found = this->Remapper.GetFindings();
  SkdFieldProblems fields = found.Fields;
  fields.Empty.insert(this->Empty.begin(), this->Empty.end());
  std::vector<std::string> warnings = fields.GetWarnings(
    this->Settings.Fields.Missing, this->Method != SkdRemapMethod::Interpolation);
  const std::vector<std::string> others = found.GetWarnings(this->Pair->GetHint());
  warnings.insert(warnings.end(), others.begin(), others.end());
  return warnings;
}

std::set<std::string> SkdMeshRemap::GetRefused() const
{
  std::set<std::string> refused = this->Refused;
  const std::set<std::string>& others = this->Remapper.GetFindings().Fields.Refused;
  refused.insert(others.begin(), others.end());
  return refused;
}

void SkdMeshRemap::AddReport(double seconds, vtkDataObject* output) const
{
  const SkdRemapFindings& found = this->Remapper.GetFindings();
  SkdReport report(output);
  SkdReportPartialArrays(this->Pair->GetPartialArrays(), output);
  report.AddCount("SourceCells", SkdCountShown(SkdFindCounted(this->Pair->GetDonor())));
  report.AddCount("InputCells", this->Pair->GetNumberOfTargetCells());
  report.AddCount("InputCellsEmpty", found.EmptyCells);
  report.AddCount("InputCellsPartlyCovered", found.PartlyCovered);
  report.AddCount("Overlaps", found.Overlaps);
  report.AddCount("WeightsFound", found.WeightsFound);
  report.AddMeasure("Seconds", seconds);
  if (found.Surfaces)
  {
    report.AddMeasure("SurfaceGap", found.Surfaces->LargestGap);
    report.AddMeasure("SourceCoverage", found.Surfaces->SourceCoverage);
  }
  found.Tally.AddTo(output);
}

void SkdMeshRemap::End()
{
  this->Remapper.End();
  this->Pair = nullptr;
  this->Request = nullptr;
}
}
