// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeAMR.h"

#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdProvideOutput.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSignedSource.h"
#include "Pipeline/SkdStopwatch.h"
#include "Pipeline/SkdWholeInput.h"
#include "Refine/SkdBaseLattice.h"
#include "Refine/SkdFieldCriterion.h"
#include "Refine/SkdGridArrays.h"
#include "Refine/SkdGridOutput.h"
#include "Refine/SkdGridRefiner.h"
#include "Refine/SkdGridReport.h"
#include "vtkDataSetAttributes.h"
#include "vtkHyperTreeGrid.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOverlappingAMR.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeAMR);

class vtkSkdTreeAMR::Internals
{
public:
  SkdParts Parts;
  SkdSignedSource Boundary;
  std::map<int, int> PartLevels; // by block index
  std::vector<SkdDistanceBand> Bands;
  SkdFieldCriterion Field;
  std::set<std::string> FieldArrays;

  std::optional<SkdGrid> MakeGrid(vtkSkdTreeAMR* self, vtkDataObject* baseMesh) const;
  SkdRefineSettings MakeSettings(vtkSkdTreeAMR* self) const;
  void UpdateField(vtkSkdTreeAMR* self, vtkDataObject* field);
  int UpdateBoundary(vtkSkdTreeAMR* self, const std::vector<SkdLeaf>& leaves);
  void ReportParts(vtkSkdTreeAMR* self, SkdReport& report) const;
};

namespace
{
SkdBaseLattice MakeLattice(vtkSkdTreeAMR* self, vtkDataObject* baseMesh, const SkdParts& parts)
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
      return { std::nullopt, "the bounds of the base mesh are empty" };
    }
  }
  return SkdMakeBaseLattice(settings, parts.GetBounds(), self->GetBranchFactor());
}

/// The part of the grid that is asked of this process.
void OwnPiece(SkdGrid& grid, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    grid.OwnPiece(std::max(output->Get(Pipeline::UPDATE_PIECE_NUMBER()), 0),
      std::max(output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 1));
  }
}

bool IsAnyCut(const SkdGrid& grid)
{
  const std::vector<unsigned char>& cut = grid.Levels.front().Cut;
  return std::count(cut.begin(), cut.end(), 1) > 0;
}

void WarnAbout(vtkSkdTreeAMR* self, const SkdGrid& grid, const SkdParts& parts)
{
  if (parts.GetNumberOfParts() == 0)
  {
    vtkWarningWithObjectMacro(self, "Input has no cells: nothing is refined.");
  }
  else if (!IsAnyCut(grid))
  {
    vtkWarningWithObjectMacro(self, "The base mesh misses the parts: they meet none of its cells.");
  }
  if (self->GetConforming() &&
    (grid.Lattice.Dimension() == 3 || self->GetOutputType() != vtkSkdTreeAMR::UNSTRUCTURED_GRID))
  {
    vtkWarningWithObjectMacro(
      self, "Conforming is for unstructured grids of two dimensions: points hang here.");
  }
  if (grid.IsStopped)
  {
    vtkWarningWithObjectMacro(self,
      "Stopped at level " << grid.StoppedAtLevel << " of " << self->GetMaximumLevel()
                          << ": the grid has " << grid.Forest.NumberOfCells()
                          << " cells, refining on would make them " << grid.CellsWanted
                          << ", more than CellLimit (" << self->GetCellLimit() << ").");
  }
}

void WarnAbout(vtkSkdTreeAMR* self, const SkdSignedSource& boundary)
{
  if (boundary.GetNumberOfFaces() == 0)
  {
    vtkWarningWithObjectMacro(self, "Input has no surface: nothing is inside.");
  }
  else if (boundary.GetNumberOfOpenEdges() > 0)
  {
    vtkWarningWithObjectMacro(self,
      "Input is not closed, it has " << boundary.GetNumberOfOpenEdges()
                                     << " open edges: what is inside goes by vote.");
  }
}

SkdGridQuestions AskedBy(vtkSkdTreeAMR* self)
{
  SkdGridQuestions questions;
  questions.Inside = self->GetComputeInside();
  questions.Fractions = self->GetComputeVolumeFraction();
  questions.Distances = self->GetComputeDistance();
  questions.Epsilon = self->GetEpsilon();
  return questions;
}

bool NeedsBoundary(vtkSkdTreeAMR* self)
{
  return AskedBy(self).NeedBoundary() || self->GetInsideLevel() > 0;
}

void AddArrays(const SkdGrid& grid, const SkdGridExtras& extras, const SkdParts& parts,
  const std::vector<SkdGridCell>& cells, vtkDataObject* output)
{
  vtkDataSetAttributes* data = output->GetAttributes(vtkDataObject::CELL);
  for (const auto& array : SkdGridArrays::Make(grid, extras, parts.GetBlockIndices(), cells))
  {
    data->AddArray(array);
  }
  data->SetActiveScalars(SkdGridArrays::LevelName);
}

void FillOutput(const SkdGrid& grid, const SkdGridExtras& extras, const SkdParts& parts,
  bool isConforming, vtkDataObject* output)
{
  if (auto trees = vtkHyperTreeGrid::SafeDownCast(output))
  {
    AddArrays(grid, extras, parts, SkdMakeHyperTreeGrid(grid, trees), trees);
  }
  else if (auto leaves = vtkUnstructuredGrid::SafeDownCast(output))
  {
    const bool conforms = isConforming && grid.Lattice.Dimension() == 2;
    AddArrays(grid, extras, parts,
      conforms ? SkdMakeConformingGrid(grid, leaves) : SkdMakeUnstructuredGrid(grid, leaves),
      leaves);
  }
  else if (auto blocks = vtkOverlappingAMR::SafeDownCast(output))
  {
    for (const SkdGridBlock& block : SkdMakeOverlappingAMR(grid, blocks))
    {
      AddArrays(grid, extras, parts, block.Cells, block.Grid);
    }
  }
}
}

//------------------------------------------------------------------------------
std::optional<SkdGrid> vtkSkdTreeAMR::Internals::MakeGrid(
  vtkSkdTreeAMR* self, vtkDataObject* baseMesh) const
{
  const SkdBaseLattice base = MakeLattice(self, baseMesh, this->Parts);
  if (!base.Lattice)
  {
    vtkErrorWithObjectMacro(self, "There is no base mesh: " << base.Complaint << ".");
    return std::nullopt;
  }
  if (!(base.Lattice->NumberOfBaseCells() <= self->GetCellLimit()))
  {
    vtkErrorWithObjectMacro(self,
      "There is no base mesh: it would have " << base.Lattice->NumberOfBaseCells()
                                              << " cells, more than CellLimit.");
    return std::nullopt;
  }
  if (self->GetOutputType() == OVERLAPPING_AMR && !SkdIsUniform(*base.Lattice))
  {
    vtkErrorWithObjectMacro(self,
      "An overlapping AMR data set needs base cells of one size, along two axes or three: choose "
      "another OutputType.");
    return std::nullopt;
  }
  return SkdGrid(*base.Lattice);
}

SkdRefineSettings vtkSkdTreeAMR::Internals::MakeSettings(vtkSkdTreeAMR* self) const
{
  SkdRefineSettings settings;
  settings.MaximumLevel = self->GetMaximumLevel();
  settings.Bands = this->Bands;
  settings.Test = self->GetTest() == EXACT ? SkdOverlapTest::Exact : SkdOverlapTest::Blind;
  settings.Balance = static_cast<skd::Contact>(self->GetBalance());
  settings.Layers = self->GetGrowingLayers();
  settings.CellLimit = static_cast<std::uint64_t>(self->GetCellLimit());
  for (const int blockIndex : this->Parts.GetBlockIndices())
  {
    const auto level = this->PartLevels.find(blockIndex);
    settings.PartLevels.push_back(
      level == this->PartLevels.end() ? settings.MaximumLevel : level->second);
  }
  if (self->GetRefineByBend())
  {
    settings.BendAngle = vtkMath::RadiansFromDegrees(self->GetBendAngle());
    settings.FlatLevel = self->GetFlatLevel();
  }
  if (self->GetInsideLevel() > 0)
  {
    settings.InsideLevel = self->GetInsideLevel();
    settings.IsInside = [this](const skd::Vector3& x) { return this->Boundary.IsInside(x.X); };
  }
  if (!this->FieldArrays.empty())
  {
    settings.FieldLevel = self->GetFieldLevel();
    settings.IsWanted = [this](const skd::Box3& box) { return this->Field.IsWanted(box); };
  }
  return settings;
}

/// Throws as SkdParts::Update() does.
void vtkSkdTreeAMR::Internals::UpdateField(vtkSkdTreeAMR* self, vtkDataObject* field)
{
  SkdFieldSettings settings;
  settings.Arrays = this->FieldArrays;
  settings.Test = static_cast<SkdFieldTest>(self->GetFieldTest());
  settings.Threshold = self->GetFieldThreshold();
  std::copy_n(self->GetFieldRange(), 2, settings.Range);
  this->Field.Update(SkdLeavesOf(field), settings, self->GetEpsilon());
  for (const std::string& name : this->Field.GetMissing())
  {
    vtkWarningWithObjectMacro(
      self, "The field has no array " << name << " that FieldTest can use.");
  }
}

/// Where something is asked that needs it. Returns how many trees were built.
int vtkSkdTreeAMR::Internals::UpdateBoundary(
  vtkSkdTreeAMR* self, const std::vector<SkdLeaf>& leaves)
{
  if (!NeedsBoundary(self))
  {
    return 0;
  }
  const int treesBuilt = this->Boundary.Update(leaves, self->GetEpsilon());
  WarnAbout(self, this->Boundary);
  return treesBuilt;
}

void vtkSkdTreeAMR::Internals::ReportParts(vtkSkdTreeAMR* self, SkdReport& report) const
{
  const SkdTreeCounts counts = this->Parts.GetCounts();
  report.AddCount("Parts", this->Parts.GetNumberOfParts());
  report.AddCount("PartCells", counts.Cells);
  report.AddCount("PartCellsLeftOut", counts.CellsLeftOut);
  report.AddMeasure("Epsilon", counts.Tolerance);
  if (NeedsBoundary(self))
  {
    report.AddCount("OpenEdges", this->Boundary.GetNumberOfOpenEdges());
  }
}

//------------------------------------------------------------------------------
vtkSkdTreeAMR::vtkSkdTreeAMR()
  : Impl(new Internals)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(1);
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

void vtkSkdTreeAMR::SetFieldConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(2, algOutput);
}

void vtkSkdTreeAMR::SetFieldData(vtkDataObject* field)
{
  this->SetInputDataInternal(2, field);
}

void vtkSkdTreeAMR::AddFieldArray(const char* name)
{
  if (name && *name)
  {
    this->Impl->FieldArrays.insert(name);
    this->Modified();
  }
}

void vtkSkdTreeAMR::RemoveAllFieldArrays()
{
  this->Impl->FieldArrays.clear();
  this->Modified();
}

void vtkSkdTreeAMR::AddPartLevel(int blockIndex, int level)
{
  this->Impl->PartLevels[blockIndex] = level;
  this->Modified();
}

void vtkSkdTreeAMR::RemoveAllPartLevels()
{
  this->Impl->PartLevels.clear();
  this->Modified();
}

void vtkSkdTreeAMR::AddDistanceBand(double distance, double level)
{
  this->Impl->Bands.push_back({ distance, static_cast<int>(std::clamp(level, 0.0, 30.0)) });
  this->Modified();
}

void vtkSkdTreeAMR::RemoveAllDistanceBands()
{
  this->Impl->Bands.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSkdTreeAMR::FillInputPortInformation(int port, vtkInformation* info)
{
  SkdAcceptMeshes(info);
  if (port == 1)
  {
    info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkRectilinearGrid");
  }
  if (port != 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSkdTreeAMR::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkSkdTreeAMR::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int types[] = { VTK_HYPER_TREE_GRID, VTK_UNSTRUCTURED_GRID, VTK_OVERLAPPING_AMR };
  SkdProvideOutput(outputVector->GetInformationObject(0), types[this->OutputType]);
  return 1;
}

int vtkSkdTreeAMR::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

// Whatever piece is asked for, all of the parts may meet it.
int vtkSkdTreeAMR::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 3; ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      SkdAskForWhole(inputVector[port]->GetInformationObject(i));
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSkdTreeAMR::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<SkdLeaf> leaves = SkdLeavesOf(vtkDataObject::GetData(inputVector[0]));
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  output->Initialize();
  SkdParts& parts = this->Impl->Parts;
  SkdStopwatch watch;
  int treesBuilt = 0;
  try
  {
    treesBuilt = parts.Update(leaves, this->Epsilon);
    this->Impl->UpdateField(this, vtkDataObject::GetData(inputVector[2]));
  }
  catch (const std::length_error& error)
  {
    vtkErrorMacro("Input cannot be searched: " << error.what());
    return 1;
  }
  treesBuilt += this->Impl->UpdateBoundary(this, leaves);
  const double buildSeconds = watch.Lap();

  std::optional<SkdGrid> grid = this->Impl->MakeGrid(this, vtkDataObject::GetData(inputVector[1]));
  if (!grid)
  {
    return 1;
  }
  OwnPiece(*grid, outputVector->GetInformationObject(0));
  SkdRefineSettings settings = this->Impl->MakeSettings(this);
  settings.OwnOnly = !grid->OwnsAll() && this->Balance == NONE && this->GrowingLayers == 0 &&
    this->OutputType != OVERLAPPING_AMR;
  SkdGridRefiner(this, 0.1, 0.6, *grid, parts, settings).Refine();
  WarnAbout(this, *grid, parts);
  const SkdGridExtras extras =
    SkdFindExtras(*grid, AskedBy(this), parts, this->Impl->Boundary, this, 0.6, 0.9);
  const double refineSeconds = watch.Lap();

  FillOutput(*grid, extras, parts, this->Conforming, output);
  SkdReport report(output);
  SkdReportGrid(report, *grid, this->MaximumLevel);
  this->Impl->ReportParts(this, report);
  report.AddCount("TreesBuilt", treesBuilt);
  report.AddMeasure("BuildSeconds", buildSeconds);
  report.AddMeasure("RefineSeconds", refineSeconds);
  return 1;
}

void vtkSkdTreeAMR::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutomaticBounds: " << (this->AutomaticBounds ? "On\n" : "Off\n");
  os << indent << "BoundsMargin: " << this->BoundsMargin << "\n";
  os << indent << "BaseBounds: " << this->BaseBounds[0] << " " << this->BaseBounds[1] << " "
     << this->BaseBounds[2] << " " << this->BaseBounds[3] << " " << this->BaseBounds[4] << " "
     << this->BaseBounds[5] << "\n";
  os << indent << "BaseDimensions: " << this->BaseDimensions[0] << " " << this->BaseDimensions[1]
     << " " << this->BaseDimensions[2] << "\n";
  os << indent << "BaseCellSize: " << this->BaseCellSize << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "BranchFactor: " << this->BranchFactor << "\n";
  os << indent << "Test: " << (this->Test == EXACT ? "Exact\n" : "Blind\n");
  os << indent << "Balance: " << this->Balance << "\n";
  os << indent << "GrowingLayers: " << this->GrowingLayers << "\n";
  for (const auto& [blockIndex, level] : this->Impl->PartLevels)
  {
    os << indent << "PartLevel: " << blockIndex << " " << level << "\n";
  }
  for (const SkdDistanceBand& band : this->Impl->Bands)
  {
    os << indent << "DistanceBand: " << band.Distance << " " << band.Level << "\n";
  }
  os << indent << "RefineByBend: " << (this->RefineByBend ? "On\n" : "Off\n");
  os << indent << "BendAngle: " << this->BendAngle << "\n";
  os << indent << "FlatLevel: " << this->FlatLevel << "\n";
  os << indent << "InsideLevel: " << this->InsideLevel << "\n";
  for (const std::string& name : this->Impl->FieldArrays)
  {
    os << indent << "FieldArray: " << name << "\n";
  }
  os << indent << "FieldTest: " << this->FieldTest << "\n";
  os << indent << "FieldThreshold: " << this->FieldThreshold << "\n";
  os << indent << "FieldRange: " << this->FieldRange[0] << " " << this->FieldRange[1] << "\n";
  os << indent << "FieldLevel: " << this->FieldLevel << "\n";
  os << indent << "CellLimit: " << this->CellLimit << "\n";
  os << indent << "ComputeInside: " << (this->ComputeInside ? "On\n" : "Off\n");
  os << indent << "ComputeVolumeFraction: " << (this->ComputeVolumeFraction ? "On\n" : "Off\n");
  os << indent << "ComputeDistance: " << (this->ComputeDistance ? "On\n" : "Off\n");
  os << indent << "OutputType: " << this->OutputType << "\n";
  os << indent << "Conforming: " << (this->Conforming ? "On\n" : "Off\n");
  os << indent << "Epsilon: " << this->Epsilon << "\n";
}
VTK_ABI_NAMESPACE_END
