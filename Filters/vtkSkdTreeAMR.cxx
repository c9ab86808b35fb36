// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeAMR.h"

#include "Exchange/SkdFilterInputs.h"
#include "Meshing/Refine/SkdBaseLattice.h"
#include "Meshing/Refine/SkdGridEstimate.h"
#include "Meshing/Refine/SkdGridOutput.h"
#include "Meshing/Refine/SkdGridReport.h"
#include "Meshing/Refine/SkdOwnBoxes.h"
#include "Meshing/Refine/SkdRefineState.h"
#include "Meshing/Refine/SkdShowEstimate.h"
#include "Pipeline/SkdJoinedShape.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Remap/SkdRemapPair.h"
#include "Remap/SkdRemapper.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <stdexcept>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeAMR);

namespace
{
constexpr int OutputVtkTypes[] = { VTK_HYPER_TREE_GRID, VTK_UNSTRUCTURED_GRID,
  VTK_OVERLAPPING_AMR };

/// Within the bounds of the parts.
SkdBaseLattice MakeLattice(vtkSkdTreeAMR* self, vtkDataObject* baseMesh, const skd::Box3& ofParts)
{
  if (baseMesh)
  {
    return SkdTakeBaseLattice(baseMesh, self->GetBranchFactor());
  }
  SkdBaseSettings settings;
  settings.Margin = self->GetBoundsMargin();
  settings.CellSize = self->GetBaseCellSize();
  std::copy_n(self->GetBaseDimensions(), 3, settings.Dimensions.begin());
  if (!self->GetAutomaticBounds())
  {
    const double* b = self->GetBaseBounds();
    settings.Bounds = skd::Box3({ { b[0], b[2], b[4] } }, { { b[1], b[3], b[5] } });
    if (settings.Bounds.IsEmpty())
    {
      return { std::nullopt, "its bounds are empty" };
    }
  }
  return SkdMakeBaseLattice(settings, ofParts, self->GetBranchFactor());
}

/// Of the cells that all processes have, as the trees' will be.
skd::Box3 FindBounds(vtkDataObject* piece, vtkMultiProcessController* controller)
{
  skd::Box3 own;
  for (const SkdBlock& block : SkdBlocksOf(piece))
  {
    for (const skd::Box3& box : SkdBoxesOfCells(block.Mesh, true))
    {
      own.Add(box);
    }
  }
  double here[6];
  double all[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    here[axis] = -own.Min[axis];
    here[axis + 3] = own.Max[axis];
  }
  controller->AllReduce(here, all, 6, vtkCommunicator::MAX_OP);
  return { { { -all[0], -all[1], -all[2] } }, { { all[3], all[4], all[5] } } };
}

/// What neighbours of the own base cells a process refines, too: what hangs on a cell, these
/// decide.
int KnownLayersOf(vtkSkdTreeAMR* self)
{
  return self->GetOutputType() == vtkSkdTreeAMR::UNSTRUCTURED_GRID ? 1 : 0;
}

/// The part of the grid that this process is to make.
void OwnPiece(SkdGrid& grid, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    grid.OwnPiece(std::max(output->Get(Pipeline::UPDATE_PIECE_NUMBER()), 0),
      std::max(output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 1));
  }
}

/// On any process.
bool IsAnyCut(const SkdGrid& grid, const skd::Processes* processes)
{
  const std::vector<unsigned char>& cut = grid.Levels.front().Cut;
  const bool isCut = std::count(cut.begin(), cut.end(), 1) > 0;
  return processes ? processes->IsAny(isCut) : isCut;
}

/// Nothing, if there are parts' cells.
std::string WhyThereAreNoParts(const SkdParts& parts)
{
  const SkdTreeCounts counts = parts.GetCounts();
  return counts.Cells > 0 || counts.CellsLeftOut == 0
    ? ""
    : " (All cells of Input are ignored: they are hidden, or " +
      SkdWhyCellsAreLeftOut(SkdComparable) + ")";
}

void WarnAbout(vtkSkdTreeAMR* self, const SkdGrid& grid, const SkdParts& parts, bool isAnyCut,
  const SkdGridEstimate& estimate)
{
  if (parts.GetNumberOfParts() == 0)
  {
    vtkWarningWithObjectMacro(self, "Input has no cells; the base mesh is not refined.");
  }
  else if (!isAnyCut)
  {
    vtkWarningWithObjectMacro(self,
      "The parts do not intersect the base mesh; nothing is refined. Correct BaseBounds or "
      "BaseMesh."
        << WhyThereAreNoParts(parts));
  }
  if (self->GetConforming() &&
    (grid.Lattice.Dimension() == 3 || self->GetOutputType() != vtkSkdTreeAMR::UNSTRUCTURED_GRID))
  {
    vtkWarningWithObjectMacro(
      self, "Conforming is ignored: it needs OutputType UNSTRUCTURED_GRID and two dimensions.");
  }
  if (grid.ResolvedLevel >= 0)
  {
    vtkWarningWithObjectMacro(self,
      "Cells of level "
        << grid.ResolvedLevel
        << " are not refined: they are about as small as the resolution of "
           "their coordinates. Move the geometry closer to the origin or lower MaximumLevel.");
  }
  if (grid.IsStopped)
  {
    vtkWarningWithObjectMacro(self,
      "Stopped at level " << grid.StoppedAtLevel << " of " << self->GetMaximumLevel()
                          << ": the grid has " << grid.Forest.NumberOfCells()
                          << " cells, the next level would have " << grid.CellsWanted
                          << ", more than CellLimit (" << self->GetCellLimit()
                          << "), and the maximum level about " << estimate.Cells
                          << ". Raise CellLimit or lower MaximumLevel.");
  }
}

SkdGridRequests RequestsOf(vtkSkdTreeAMR* self)
{
  SkdGridRequests requests;
  requests.Inside = self->GetComputeInside();
  requests.Fractions = self->GetComputeVolumeFraction();
  requests.Distances = self->GetComputeDistance();
  requests.Epsilon = self->GetEpsilon();
  return requests;
}

std::optional<SkdGrid> MakeGrid(vtkSkdTreeAMR* self, vtkDataObject* baseMesh, const SkdParts& parts)
{
  const SkdBaseLattice base = MakeLattice(self, baseMesh, parts.GetBounds());
  if (!base.Lattice)
  {
    vtkErrorWithObjectMacro(
      self, "The base mesh cannot be made: " << base.Complaint << "." << WhyThereAreNoParts(parts));
    return std::nullopt;
  }
  if (!(base.Lattice->NumberOfBaseCells() <= self->GetCellLimit()))
  {
    vtkErrorWithObjectMacro(self,
      "The base mesh cannot be made: it would have "
        << base.Lattice->NumberOfBaseCells()
        << " cells, more than CellLimit. Reduce BaseDimensions or raise CellLimit.");
    return std::nullopt;
  }
  if (self->GetOutputType() == vtkSkdTreeAMR::HYPER_TREE_GRID && base.Lattice->Dimension() == 0)
  {
    vtkErrorWithObjectMacro(self,
      "The base mesh cannot be made: a hyper tree grid needs bounds that are more than a single "
      "point. Set BaseBounds or choose another OutputType.");
    return std::nullopt;
  }
  if (self->GetOutputType() == vtkSkdTreeAMR::OVERLAPPING_AMR && !SkdIsUniform(*base.Lattice))
  {
    vtkErrorWithObjectMacro(self,
      "An overlapping AMR data set needs base cells of equal size in two or three dimensions. "
      "Choose "
      "another OutputType.");
    return std::nullopt;
  }
  return SkdGrid(*base.Lattice);
}

SkdRefineSettings MakeSettings(vtkSkdTreeAMR* self, const SkdRefineState& state)
{
  SkdRefineSettings settings{ state.MakeCriteria() };
  settings.Balance = static_cast<skd::Contact>(self->GetBalance());
  settings.Layers = self->GetGrowingLayers();
  settings.CellLimit = static_cast<std::uint64_t>(self->GetCellLimit());
  return settings;
}

/// The number of trees that were built, if all can be searched, on all processes.
std::optional<int> UpdateTrees(vtkSkdTreeAMR* self, SkdRefineState& state,
  vtkInformationVector** inputs, const skd::Processes* processes)
{
  std::optional<int> built;
  try
  {
    built = state.Update(self, SkdBlocksOf(vtkDataObject::GetData(inputs[0])),
      vtkDataObject::GetData(inputs[2]), RequestsOf(self).NeedBoundary());
  }
  catch (const std::length_error& error)
  {
    vtkErrorWithObjectMacro(self, "Input cannot be searched: " << error.what());
  }
  const bool isAnyLost = processes && processes->IsAny(!built);
  if (processes && !isAnyLost)
  {
    state.Field.ShareRanges(*processes);
  }
  return isAnyLost ? std::nullopt : built;
}

/// Estimates the size, refines the grid, and reports warnings.
SkdGridEstimate Refine(vtkSkdTreeAMR* self, const SkdRefineState& state, bool isOnItsOwn,
  const skd::Processes* processes, SkdGrid& grid)
{
  SkdRefineSettings settings = MakeSettings(self, state);
  if (isOnItsOwn)
  {
    settings.KnownLayers = KnownLayersOf(self);
    settings.Processes = processes;
  }
  const SkdGridEstimate estimate = SkdEstimateGrid(grid, state.Parts, settings, RequestsOf(self),
    OutputVtkTypes[self->GetOutputType()], self, 0.1);
  SkdShowEstimate(self, estimate.Cells, estimate.Bytes, estimate.Seconds);
  SkdGridRefiner(self, 0.1, 0.6, grid, state.Parts, settings).Refine();
  self->SetProgressText(nullptr);
  WarnAbout(self, grid, state.Parts, IsAnyCut(grid, isOnItsOwn ? processes : nullptr), estimate);
  return estimate;
}

/// The arrays of the field on the cells of the grid.
std::vector<SkdGridField> FindFields(
  vtkSkdTreeAMR* self, const SkdGrid& grid, vtkDataObject* field, double first, double last)
{
  std::set<std::string> partial;
  const vtkSmartPointer<vtkDataSet> donor = SkdJoinBlocks(SkdBlocksOf(field), partial);
  const int dimension = grid.Lattice.Dimension();
  if (SkdDimensionOf(donor) != dimension)
  {
    vtkWarningWithObjectMacro(self,
      "ComputeField is ignored: the field has no cells of the dimension of the grid, " << dimension
                                                                                       << ".");
    return {};
  }
  constexpr SkdOverlapSpace spaces[] = { SkdOverlapSpace::Line, SkdOverlapSpace::Line,
    SkdOverlapSpace::Plane, SkdOverlapSpace::Volume };
  SkdRemapSettings settings;
  settings.Overlap.Space = spaces[dimension];
  settings.IsSecondOrder = true;
  vtkNew<vtkUnstructuredGrid> leafMesh;
  const std::vector<SkdGridCell> leaves = SkdMakeUnstructuredGrid(grid, leafMesh);
  const bool hasCells = leafMesh->GetNumberOfCells() > 0; // not every process has a base cell
  SkdRemapper remapper;
  remapper.Begin(donor, settings, self);
  remapper.MapConservative(leafMesh, 0, first, last);
  for (const std::string& warning :
    hasCells ? remapper.GetFindings().GetWarnings() : std::vector<std::string>())
  {
    vtkWarningWithObjectMacro(self, "The field on the grid (as Source): " << warning);
  }
  return SkdSpreadFields(grid, leaves, leafMesh->GetCellData(), SkdRemapNames::Coverage);
}
}

//------------------------------------------------------------------------------
vtkSkdTreeAMR::vtkSkdTreeAMR()
  : vtkSkdTreeRefineAlgorithm(3, 0)
{
}

vtkSkdTreeAMR::~vtkSkdTreeAMR() = default;

void vtkSkdTreeAMR::SetBaseMeshConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

void vtkSkdTreeAMR::SetBaseMeshData(vtkDataObject* mesh)
{
  this->SetInputDataInternal(1, mesh);
}

//------------------------------------------------------------------------------
bool vtkSkdTreeAMR::RefinesOwn() const
{
  return this->Balance == NONE && this->GrowingLayers == 0 && this->OutputType != OVERLAPPING_AMR;
}

// Which parts intersect a base cell's descendants, and how many of their cells, is known where all
// that may is there.
bool vtkSkdTreeAMR::FindRange(int port, SkdSearchRange& range) const
{
  range.OfDiagonal = range.OfOwnDiagonal = 1e-3; // more than any rounding
  if (port == 2)
  {
    return this->FindRangeOfField(range);
  }
  range.WithNearest = this->ComputeDistance;
  for (const SkdDistanceBand& band : this->State->Bands)
  {
    range.Distance = std::max(range.Distance, band.Distance);
  }
  return port == 0 && this->RefinesOwn() && this->OverlapTest == EXACT && this->InsideLevel == 0 &&
    !this->RefineByNormalDeviation && !this->ComputeInside && !this->ComputeVolumeFraction;
}

// Gradients of a cell are found from its neighbours, and the space of the field from what all of it
// looks like.
bool vtkSkdTreeAMR::FindRangeOfField(SkdSearchRange& range) const
{
  this->ReachField(range);
  range.WithNeighbours = this->ComputeField;
  range.WithOwn = range.WithOwn || this->ComputeField;
  range.IsOfOneMesh = this->ComputeField;
  return this->RefinesOwn();
}

bool vtkSkdTreeAMR::CanExchange()
{
  SkdSearchRange ofParts;
  SkdSearchRange ofField;
  return this->SourceDistribution != SOURCE_REPLICATED &&
    this->GetNumberOfInputConnections(1) == 0 &&
    (this->FindRange(0, ofParts) ||
      (this->GetNumberOfInputConnections(2) > 0 && this->FindRange(2, ofField)));
}

// The base cells of this process, which depend on the bounds of all parts.
void vtkSkdTreeAMR::SetUpInputs(SkdFilterInputs& inputs)
{
  inputs.SetDistribution(static_cast<SkdFilterInputs::Distribution>(this->SourceDistribution),
    [this](int port, SkdSearchRange& range)
    { return this->State->OwnBoxes && this->FindRange(port, range); });
  inputs.SetOwn(
    [this, &inputs](vtkInformationVector* outputs) -> vtkDataObject*
    {
      vtkInformation* output = outputs->GetInformationObject(0);
      vtkMultiProcessController* controller = SkdControllerOf(output);
      vtkSmartPointer<vtkPolyData>& boxes = this->State->OwnBoxes;
      if (!controller || !this->CanExchange())
      {
        boxes = nullptr;
        return nullptr;
      }
      const SkdBaseLattice base =
        MakeLattice(this, nullptr, FindBounds(inputs.GetPiece(0), controller));
      const bool isUsable =
        base.Lattice && base.Lattice->NumberOfBaseCells() <= this->GetCellLimit();
      if (isUsable)
      {
        SkdGrid grid(*base.Lattice);
        OwnPiece(grid, output);
        SkdUpdateOwnBoxes(grid, KnownLayersOf(this), boxes);
      }
      boxes = isUsable ? boxes : nullptr; // the same on all processes
      return boxes;
    });
}

int vtkSkdTreeAMR::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  if (port == 1)
  {
    SkdAccept(info, { "vtkImageData", "vtkRectilinearGrid", "vtkDataObject" });
  }
  return 1;
}

int vtkSkdTreeAMR::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  SkdProvideOutput(outputVector->GetInformationObject(0), OutputVtkTypes[this->OutputType]);
  return 1;
}

int vtkSkdTreeAMR::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSkdTreeAMR::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  output->Initialize();
  SkdRefineState& state = *this->State;
  this->PassOptions();
  SkdStopwatch watch;
  const auto processes = SkdProcessesOf(outputVector->GetInformationObject(0));
  const std::optional<int> treesBuilt = UpdateTrees(this, state, inputVector, processes.get());
  const double buildSeconds = watch.Lap();
  std::optional<SkdGrid> grid;
  if (treesBuilt)
  {
    grid = MakeGrid(this, vtkDataObject::GetData(inputVector[1]), state.Parts);
  }
  if (!grid)
  {
    return 1;
  }
  OwnPiece(*grid, outputVector->GetInformationObject(0));
  const SkdGridEstimate estimate =
    Refine(this, state, grid->Pieces > 1 && this->RefinesOwn(), processes.get(), *grid);
  SkdGridExtras extras =
    SkdFindExtras(*grid, RequestsOf(this), state.Parts, state.Enclosure, this, 0.6, 0.85);
  if (this->ComputeField)
  {
    extras.Fields = FindFields(this, *grid, vtkDataObject::GetData(inputVector[2]), 0.85, 0.95);
  }
  const double refineSeconds = watch.Lap();

  SkdFillGridOutput(*grid, extras, state.Parts.GetBlockIndices(), this->Conforming, output);
  SkdReport report(output);
  SkdReportGrid(report, *grid, estimate);
  state.Report(report);
  report.AddRun(*treesBuilt, buildSeconds, "RefineSeconds", refineSeconds);
  return 1;
}

void vtkSkdTreeAMR::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "SourceDistribution", this->SourceDistribution, "AutomaticBounds",
    this->AutomaticBounds, "BoundsMargin", this->BoundsMargin, "BaseBounds", this->BaseBounds,
    "BaseDimensions", this->BaseDimensions, "BaseCellSize", this->BaseCellSize, "BranchFactor",
    this->BranchFactor, "ComputeInside", this->ComputeInside, "ComputeVolumeFraction",
    this->ComputeVolumeFraction, "ComputeDistance", this->ComputeDistance, "ComputeField",
    this->ComputeField, "OutputType", this->OutputType, "Conforming", this->Conforming);
}
VTK_ABI_NAMESPACE_END
