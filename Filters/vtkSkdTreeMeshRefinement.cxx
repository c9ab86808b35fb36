// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeMeshRefinement.h"

#include "Bodies/SkdSource.h"
#include "Core/Meshing/Mesh/FindBorder.h"
#include "Core/Meshing/Mesh/GivenHangingNodes.h"
#include "Exchange/SkdCountedCells.h"
#include "Exchange/SkdFilterInputs.h"
#include "Meshing/Refine/SkdMeshOutput.h"
#include "Meshing/Refine/SkdMeshRefiner.h"
#include "Meshing/Refine/SkdMeshReport.h"
#include "Meshing/Refine/SkdNodePlacement.h"
#include "Meshing/Refine/SkdRefineState.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "vtkDataObjectTree.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeMeshRefinement);

class vtkSkdTreeMeshRefinement::Internals
{
public:
  SkdSource Surface;
  SkdCountedCells Counted; // of the Input
};

namespace
{
using Filter = vtkSkdTreeMeshRefinement;

bool HasCriteria(const SkdMeshSettings& settings)
{
  return settings.MinimumLevel > 0 || !settings.PartLevels.empty() || settings.FieldLevel > 0;
}

SkdMeshSettings MakeSettings(Filter* self, const SkdRefineState& state)
{
  SkdMeshSettings settings{ state.MakeCriteria() };
  settings.MinimumLevel = self->GetMinimumLevel();
  settings.IsConforming = self->GetMethod() == Filter::BISECTION;
  settings.Balance = static_cast<skd::Contact>(self->GetBalance());
  settings.Layers = self->GetGrowingLayers();
  settings.CellLimit =
    static_cast<std::uint64_t>(std::min<vtkIdType>(self->GetCellLimit(), 0x7fffffff));
  if (!HasCriteria(settings) && self->GetNumberOfInputConnections(1) == 0)
  {
    settings.MinimumLevel = 1;
  }
  return settings;
}

void SetPlacement(
  Filter* self, const SkdSource& surface, skd::SharedCuts* shared, skd::RefinedMesh& mesh)
{
  const double* centre = self->GetSphereCenter();
  if (self->GetPointPlacement() == Filter::SPHERE)
  {
    mesh.SetPlacement(SkdPutOnSphere({ { centre[0], centre[1], centre[2] } }));
  }
  else if (self->GetPointPlacement() == Filter::SURFACE && surface.GetCounts().Cells > 0)
  {
    mesh.SetPlacement(SkdPutOnSurface(surface),
      shared ? shared->FindBorder() : skd::MakeBorder(mesh, skd::OuterFaces(mesh)));
  }
  else if (self->GetPointPlacement() == Filter::SURFACE)
  {
    vtkWarningWithObjectMacro(self,
      "There is no surface to project new points to; they stay in the middle of edges and faces.");
  }
}

void WarnOfGivenHangingNodes(Filter* self, const skd::RefinedMesh& mesh)
{
  const skd::GivenHangingNodes given(mesh);
  if (given.Count > 0)
  {
    const skd::Vector3& x = mesh.FlatPoint(given.First);
    vtkWarningWithObjectMacro(self,
      "The mesh has hanging nodes already: "
        << given.Count << " edges have a node of other cells in their middle, the first at ("
        << x[0] << ", " << x[1] << ", " << x[2]
        << "). Bisection keeps them where it does not cut these edges. Use the mesh from before it "
           "was refined, or the method Regular.");
  }
}

void WarnAbout(Filter* self, const SkdMeshSettings& settings, const SkdReadMesh& read)
{
  const skd::SharedCuts* shared = settings.Shared;
  const bool hasCells = read.Mesh.NumberOfCells() > 0;
  if (!(shared ? shared->GetProcesses().IsAny(hasCells) : hasCells))
  {
    vtkWarningWithObjectMacro(self, "Input has no cells; the output is empty.");
  }
  else if (!(shared ? shared->GetProcesses().IsAny(HasCriteria(settings)) : HasCriteria(settings)))
  {
    vtkWarningWithObjectMacro(self,
      "Nothing is refined: the parts have no cells" << (shared ? ", or none near Input," : "")
                                                    << " and no other criterion is set.");
  }
  if (read.CellsNotRefinable > 0)
  {
    vtkWarningWithObjectMacro(self,
      "" << read.CellsNotRefinable
         << " cells cannot be refined because of their type or their points, and are kept as they "
            "are.");
  }
}

/// Whether parts are the only criterion, and all processes have finished without any round.
bool DoPartsMiss(const SkdMeshSettings& settings, const SkdMeshOutcome& outcome)
{
  const bool isMore =
    settings.MinimumLevel > 0 || settings.InsideLevel > 0 || settings.FieldLevel > 0;
  const bool isRequestedByParts = std::any_of(
    settings.PartLevels.begin(), settings.PartLevels.end(), [](int level) { return level > 0; });
  return isRequestedByParts && !isMore && settings.MaximumLevel > 0 && outcome.Rounds == 0 &&
    !outcome.IsStopped && !outcome.IsAborted;
}

void WarnAbout(Filter* self, const SkdMeshSettings& settings, const SkdMeshOutcome& outcome,
  const SkdMeshTally& tally)
{
  if (tally.CellsBefore > 0 && DoPartsMiss(settings, outcome))
  {
    vtkWarningWithObjectMacro(self,
      "Nothing is refined: the parts intersect no cell that can be refined. Check their position, "
      "or "
      "add distance bands to refine cells near them.");
  }
  if (outcome.IsStopped)
  {
    vtkWarningWithObjectMacro(self,
      "Stopped at level " << outcome.StoppedAtLevel << " of " << self->GetMaximumLevel()
                          << ": the mesh has " << tally.Cells
                          << " cells, the next level would have "
                          << "more than CellLimit (" << self->GetCellLimit()
                          << "), and the maximum level about " << outcome.CellsEstimated
                          << ". Raise CellLimit or lower MaximumLevel.");
  }
  if (tally.CellsTooSmall > 0)
  {
    vtkWarningWithObjectMacro(self,
      "" << tally.CellsTooSmall
         << " cells are not refined: they are about as small as the resolution of their "
            "coordinates. "
            "Move the mesh closer to the origin or store its points in double precision.");
  }
  if (tally.CellsOddlyShaped > 0)
  {
    vtkWarningWithObjectMacro(self,
      "" << tally.CellsOddlyShaped << " cells cannot be cut because they are not star-shaped "
         << "about their centre, and are kept as they are.");
  }
}

skd::HangingNodes FindHanging(const skd::RefinedMesh& mesh, skd::SharedCuts* shared)
{
  skd::HangingNodes hanging(mesh);
  hanging.Add(
    [shared](std::vector<char>& marks)
    {
      if (shared)
      {
        shared->ShareMarks(marks);
      }
    });
  return hanging;
}

vtkSmartPointer<vtkPointSet> MakeBlock(const SkdReadMesh& read, const SkdReadMesh::Block& block,
  const skd::HangingNodes& hanging, Filter* self)
{
  vtkSmartPointer<vtkDataObject> output;
  output.TakeReference(vtkDataObjectTypes::NewDataObject(SkdRefinedTypeOf(block.Input.Mesh)));
  auto mesh = vtkPointSet::SafeDownCast(output);
  SkdWriteBlock(read, block, hanging, self->GetOutputPointsPrecision(), mesh);
  return mesh;
}

std::vector<vtkSmartPointer<vtkPointSet>> MakeBlocks(
  const SkdReadMesh& read, const skd::HangingNodes& hanging, Filter* self)
{
  std::vector<vtkSmartPointer<vtkPointSet>> meshes;
  for (const SkdReadMesh::Block& block : read.Blocks)
  {
    meshes.push_back(MakeBlock(read, block, hanging, self));
  }
  return meshes;
}

/// The number of trees that were built, if all processes can read their input.
std::optional<int> Read(Filter* self, SkdRefineState& state, vtkInformationVector** inputs,
  const std::vector<std::vector<unsigned char>>* counted, const skd::Processes* processes,
  SkdReadMesh& read)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* field = vtkDataObject::GetData(inputs[2]);
  std::optional<int> treesBuilt;
  try
  {
    treesBuilt = state.Update(
      self, SkdBlocksOf(vtkDataObject::GetData(inputs[1])), field ? field : input, false);
    SkdReadBlocks(SkdBlocksOf(input), counted, read);
  }
  catch (const std::length_error& error)
  {
    vtkErrorWithObjectMacro(self, "Input cannot be refined: " << error.what());
    treesBuilt.reset();
  }
  const bool isAnyLost = processes && processes->IsAny(!treesBuilt);
  if (processes && !isAnyLost)
  {
    state.Field.ShareRanges(*processes);
  }
  return isAnyLost ? std::nullopt : treesBuilt;
}

/// Blocks go where they were, or in a row where the output is of another make.
void PutBlocks(const std::vector<SkdReadMesh::Block>& blocks,
  const std::vector<vtkSmartPointer<vtkPointSet>>& meshes, vtkDataObject* input,
  vtkDataObject* output)
{
  auto from = vtkDataObjectTree::SafeDownCast(input);
  auto to = vtkDataObjectTree::SafeDownCast(output);
  if (!to)
  {
    output->ShallowCopy(meshes.front());
    return;
  }
  if (from)
  {
    SkdMirror(from, to);
    vtkSmartPointer<vtkCompositeDataIterator> iterator;
    iterator.TakeReference(from->NewIterator());
    std::size_t next = 0; // blocks are in the order of the iterator
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      const int flatIndex = static_cast<int>(iterator->GetCurrentFlatIndex());
      if (next < blocks.size() && blocks[next].Input.BlockIndex == flatIndex)
      {
        to->SetDataSet(iterator, meshes[next++]);
      }
    }
    return;
  }
  auto row = vtkMultiBlockDataSet::SafeDownCast(output);
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    row->SetBlock(static_cast<unsigned int>(i), meshes[i]);
  }
}
}

//------------------------------------------------------------------------------
vtkSkdTreeMeshRefinement::vtkSkdTreeMeshRefinement()
  : vtkSkdTreeRefineAlgorithm(4, 1) // the Input comes in pieces
  , Impl(new Internals)
{
  this->MaximumLevel = 3;
}

vtkSkdTreeMeshRefinement::~vtkSkdTreeMeshRefinement() = default;

void vtkSkdTreeMeshRefinement::SetPartsConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

void vtkSkdTreeMeshRefinement::SetPartsData(vtkDataObject* parts)
{
  this->SetInputDataInternal(1, parts);
}

void vtkSkdTreeMeshRefinement::SetSurfaceConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(3, algOutput);
}

void vtkSkdTreeMeshRefinement::SetSurfaceData(vtkDataObject* surface)
{
  this->SetInputDataInternal(3, surface);
}

// Cells next to those of the own piece have values of the field in it, too.
void vtkSkdTreeMeshRefinement::SetUpInputs(SkdFilterInputs& inputs)
{
  inputs.SetStandIn(2, this->State->FieldArrays.empty() ? -1 : 0);
  inputs.SetDistribution(static_cast<SkdFilterInputs::Distribution>(this->SourceDistribution),
    [this](int port, SkdSearchRange& range) { return this->FindRange(port, range); });
}

// Whether parts intersect a cell, or are within a band, and what values the field has there, is
// known where all that may is there. Sums over parts would be added up in another order, and boxes
// decide by the size of all.
bool vtkSkdTreeMeshRefinement::FindRange(int port, SkdSearchRange& range) const
{
  range.OfDiagonal = 1e-3;   // more than any rounding
  range.OfOwnDiagonal = 1.0; // curved cells may be outside the box of their points
  if (port == 2)
  {
    this->ReachField(range);
    return this->PointPlacement == FLAT;
  }
  for (const SkdDistanceBand& band : this->State->Bands)
  {
    range.Distance = std::max(range.Distance, band.Distance);
  }
  return port == 1 && this->InsideLevel == 0 && !this->RefineByNormalDeviation &&
    this->OverlapTest == EXACT && this->PointPlacement == FLAT;
}

int vtkSkdTreeMeshRefinement::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  const auto mesh = vtkDataSet::SafeDownCast(input);
  const int type = mesh                      ? SkdRefinedTypeOf(mesh)
    : vtkDataObjectTree::SafeDownCast(input) ? input->GetDataObjectType()
                                             : VTK_MULTIBLOCK_DATA_SET;
  SkdProvideOutput(outputVector->GetInformationObject(0), type);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSkdTreeMeshRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  output->Initialize();
  const auto processes = SkdProcessesOf(outputVector->GetInformationObject(0));
  const auto* counted = processes
    ? &this->Impl->Counted.Update(input, SkdControllerOf(outputVector->GetInformationObject(0)))
    : nullptr;
  SkdStopwatch watch;
  SkdReadMesh read;
  this->PassOptions();
  const std::optional<int> treesBuilt =
    Read(this, *this->State, inputVector, counted, processes.get(), read);
  if (!treesBuilt)
  {
    return 1;
  }
  this->Impl->Surface.Update(
    vtkDataObject::GetData(inputVector[3]), false, this->Epsilon, this->ChordalDeviation);
  const auto shared =
    processes ? std::make_unique<skd::SharedCuts>(read.Mesh, *processes) : nullptr;
  SetPlacement(this, this->Impl->Surface, shared.get(), read.Mesh);
  const double buildSeconds = watch.Lap();

  SkdMeshSettings settings = MakeSettings(this, *this->State);
  settings.Shared = shared.get();
  WarnAbout(this, settings, read);
  if (this->Method == BISECTION)
  {
    WarnOfGivenHangingNodes(this, read.Mesh);
  }
  SkdMeshTally tally(read.Mesh);
  const SkdMeshOutcome outcome =
    SkdMeshRefiner(this, 0.1, 0.8, read.Mesh, this->State->Parts, settings).Refine();
  const double refineSeconds = watch.Lap();

  const skd::HangingNodes hanging = FindHanging(read.Mesh, shared.get());
  PutBlocks(read.Blocks, MakeBlocks(read, hanging, this), input, output);
  tally.Finish(read.Mesh, hanging);
  WarnAbout(this, settings, outcome, tally);

  SkdReport report(output);
  SkdReportMesh(report, read, outcome, tally);
  this->State->Report(report);
  report.AddRun(*treesBuilt, buildSeconds, "RefineSeconds", refineSeconds);
  this->Impl->Surface.Release();
  return 1;
}

void vtkSkdTreeMeshRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "SourceDistribution", this->SourceDistribution, "Method",
    this->Method == BISECTION ? "Bisection" : "Regular", "MinimumLevel", this->MinimumLevel,
    "PointPlacement", this->PointPlacement, "SphereCenter", this->SphereCenter,
    "OutputPointsPrecision", this->OutputPointsPrecision);
}
VTK_ABI_NAMESPACE_END
