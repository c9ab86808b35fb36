// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeRemap.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdPartialArrays.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdReport.h"
#include "Remap/SkdOverlapMesh.h"
#include "Remap/SkdRemapMeshes.h"
#include "Remap/SkdRemapProbe.h"
#include "Remap/SkdRemapper.h"
#include "Remap/SkdWeightsFile.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeRemap);

//------------------------------------------------------------------------------
class vtkSkdTreeRemap::Internals
{
public:
  explicit Internals(vtkSkdTreeRemap* self)
    : Self(self)
  {
  }

  std::set<std::string> Extensive;
  std::set<std::string> Gradients;

  void Run(vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputVector);

private:
  bool FindSpace();
  double RadiusOfInput() const;
  bool IsOfOneDimension() const;
  void PrepareDonor(vtkDataObject* source);
  void PrepareTarget();
  void FinishTarget();
  std::string HintOf() const;
  SkdRemapSettings MakeSettings() const;
  bool WeighsByCosine(vtkDataObject* source) const;
  bool IsConservative() const;
  void Begin(bool hasCells, bool hasOthers);
  bool IsOfCurvedSurfaces(const skd::Processes* processes);
  void MapBlocks(double start);
  void MapBlock(std::size_t block, double first, double last);
  void Interpolate(vtkDataSet* block, bool withCellData, double first, double last);
  void FillWeights(vtkTable* table);
  void FillOverlaps(vtkDataObject* output);
  void WriteWeights(const SkdShare& share);
  void WarnAboutFields() const;
  void Warn(const std::string& what) const;
  void Report(vtkDataObject* output, double seconds) const;

  vtkSkdTreeRemap* Self;
  SkdRemapper Remapper;
  SkdRemapProbe Probe;
  SkdWeightsFileSettings Written; // the file that there is

  // Of one run:
  std::vector<SkdBlock> Inputs;  // of the input
  std::vector<SkdBlock> Outputs; // the same, to add arrays to
  std::vector<SkdBlock> Given;   // the outputs, where these were moved to a sphere
  vtkSmartPointer<vtkDataSet> Donor;
  std::set<std::string> PartialArrays; // of the donor
  SkdWeightsGrids Grids;
  SkdRemapSettings Settings;
  bool IsComposite = false;
  int Method = AUTOMATIC_METHOD;
  std::set<std::string> Refused;
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
}

//------------------------------------------------------------------------------
// The first block that has cells speaks for all.
double vtkSkdTreeRemap::Internals::RadiusOfInput() const
{
  for (const SkdBlock& block : this->Inputs)
  {
    if (block.Mesh->GetNumberOfCells() > 0)
    {
      return SkdRadiusOf(block.Mesh).value_or(0.0);
    }
  }
  return 0.0;
}

bool vtkSkdTreeRemap::Internals::FindSpace()
{
  const auto found = std::find_if(this->Inputs.begin(), this->Inputs.end(),
    [](const SkdBlock& block) { return block.Mesh->GetNumberOfCells() > 0; });
  if (found == this->Inputs.end())
  {
    return false;
  }
  SkdOverlapSpace& space = this->Settings.Overlap.Space;
  constexpr SkdOverlapSpace spaces[] = { SkdOverlapSpace::Line, SkdOverlapSpace::Line,
    SkdOverlapSpace::Plane, SkdOverlapSpace::Sphere, SkdOverlapSpace::Volume,
    SkdOverlapSpace::CurvedSurface };
  space = spaces[this->Self->Geometry];
  if (this->Self->Geometry == AUTOMATIC_GEOMETRY)
  {
    space = SkdSpaceOf(found->Mesh);
    // What is contained goes by directions, whatever the distances of the source's points.
    const bool isOnSphere = this->Self->SourceCoordinates == LONGITUDE_LATITUDE ||
      this->Self->Method == CONTAINED || SkdRadiusOf(this->Donor);
    space = space == SkdOverlapSpace::Sphere && !isOnSphere ? SkdOverlapSpace::Plane : space;
    const bool isExact = this->Self->Method == CONSERVATIVE_FIRST_ORDER ||
      this->Self->Method == CONSERVATIVE_SECOND_ORDER;
    if (space == SkdOverlapSpace::Plane && isExact && this->HintOf().empty() &&
      !SkdAreInOnePlane(this->Donor, this->Inputs))
    {
      space = SkdOverlapSpace::CurvedSurface;
    }
  }
  return true;
}

bool vtkSkdTreeRemap::Internals::IsOfOneDimension() const
{
  const int dimension = SkdDimensionOf(this->Donor);
  return std::all_of(this->Inputs.begin(), this->Inputs.end(),
    [&](const SkdBlock& block)
    { return block.Mesh->GetNumberOfCells() == 0 || SkdDimensionOf(block.Mesh) == dimension; });
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::PrepareDonor(vtkDataObject* source)
{
  this->Donor = SkdJoinBlocks(SkdBlocksOf(source), this->PartialArrays);
  this->PrepareTarget();
  if (this->Self->SourceCoordinates == LONGITUDE_LATITUDE)
  {
    const double radius = this->RadiusOfInput();
    this->Donor = SkdMovedToSphere(this->Donor, radius > 0.0 ? radius : 1.0);
  }
}

// Results are made on the moved mesh, and go to the one that was given.
void vtkSkdTreeRemap::Internals::PrepareTarget()
{
  this->Given.clear();
  if (this->Self->InputCoordinates != LONGITUDE_LATITUDE)
  {
    return;
  }
  const bool isFree = this->Self->SourceCoordinates == LONGITUDE_LATITUDE;
  const double radius = isFree ? 1.0 : SkdRadiusOf(this->Donor).value_or(1.0);
  this->Given = this->Outputs;
  for (std::size_t i = 0; i < this->Outputs.size(); ++i)
  {
    this->Inputs[i].Mesh = SkdMovedToSphere(this->Inputs[i].Mesh, radius);
    this->Outputs[i].Mesh = SkdMovedToSphere(this->Outputs[i].Mesh, radius);
  }
}

void vtkSkdTreeRemap::Internals::FinishTarget()
{
  for (std::size_t i = 0; i < this->Given.size(); ++i)
  {
    for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      this->Given[i].Mesh->GetAttributes(type)->ShallowCopy(
        this->Outputs[i].Mesh->GetAttributes(type));
    }
  }
  this->Given.clear();
}

std::string vtkSkdTreeRemap::Internals::HintOf() const
{
  const auto isLonLat = [](const SkdBlock& block) { return SkdMayBeLonLat(block.Mesh); };
  const bool isInputGiven = this->Self->InputCoordinates == AS_GIVEN;
  const bool isSourceGiven = this->Self->SourceCoordinates == AS_GIVEN;
  if (isInputGiven && SkdRadiusOf(this->Donor) && !this->Inputs.empty() &&
    std::all_of(this->Inputs.begin(), this->Inputs.end(), isLonLat))
  {
    return " Source is on a sphere and Input may be of longitudes and latitudes: if so, set "
           "InputCoordinates.";
  }
  return isSourceGiven && SkdMayBeLonLat(this->Donor) && this->RadiusOfInput() > 0.0
    ? " Input is on a sphere and Source may be of longitudes and latitudes: if so, set "
      "SourceCoordinates."
    : "";
}

bool vtkSkdTreeRemap::Internals::WeighsByCosine(vtkDataObject* source) const
{
  const std::vector<SkdBlock> blocks = SkdBlocksOf(source);
  return this->Self->SampleWeights == COSINE_OF_LATITUDE ||
    (this->Self->SampleWeights == AUTOMATIC_WEIGHTS && !blocks.empty() &&
      std::all_of(blocks.begin(), blocks.end(),
        [](const SkdBlock& block) { return SkdIsStructured(block.Mesh); }));
}

SkdRemapSettings vtkSkdTreeRemap::Internals::MakeSettings() const
{
  const vtkSkdTreeRemap* self = this->Self;
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
  settings.IsSecondOrder = self->Method == CONSERVATIVE_SECOND_ORDER;
  settings.Limiter = static_cast<SkdLimiter>(self->Limiter);
  settings.Statistic = static_cast<SkdStatistic>(self->Statistic);
  settings.Empty = static_cast<SkdEmptyCells>(self->EmptyCells);
  settings.Extrapolation = { static_cast<SkdExtrapolationMethod>(self->Extrapolation),
    self->ExtrapolationConstant, self->ExtrapolationNeighbors };
  settings.WithPointFields = self->Method != AUTOMATIC_METHOD;
  settings.ToPoints = self->ResultsOn == POINTS;
  return settings;
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::Interpolate(
  vtkDataSet* block, bool withCellData, double first, double last)
{
  SkdProbeSettings settings;
  settings.Fields = this->Settings.Fields;
  settings.Gradients = this->Gradients;
  settings.TakesNearest = this->Self->EmptyCells != LEAVE;
  settings.IsOnSphere = this->Settings.Overlap.Space == SkdOverlapSpace::Sphere;
  settings.Radius = settings.IsOnSphere ? this->RadiusOfInput() : 0.0;
  settings.ToCells = this->Self->ResultsOn == CELLS;
  this->Probe.Map(
    block, this->Donor, withCellData, settings, this->Self, first, last, this->Refused);
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::MapBlock(std::size_t block, double first, double last)
{
  vtkDataSet* mesh = this->Outputs[block].Mesh;
  const double middle = 0.5 * (first + last);
  switch (this->Method)
  {
    case CONTAINED:
      this->Remapper.MapContained(mesh, first, last);
      break;
    case INTERPOLATION:
      this->Interpolate(mesh, true, first, last);
      break;
    case AUTOMATIC_METHOD:
      if (this->Remapper.MapConservative(mesh, block, first, middle))
      {
        const bool isMapped = this->Remapper.GetWeights(block) != nullptr;
        if (!isMapped || this->Donor->GetPointData()->GetNumberOfArrays() > 0)
        {
          this->Interpolate(mesh, !isMapped, middle, last);
        }
      }
      break;
    default:
      this->Remapper.MapConservative(mesh, block, first, last);
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::FillWeights(vtkTable* table)
{
  for (std::size_t block = 0; block < this->Outputs.size(); ++block)
  {
    if (const SkdOverlapWeights* weights = this->Remapper.GetWeights(block))
    {
      SkdAppendWeights(*weights, this->Settings.Conservative.Normalization,
        this->Outputs[block].BlockIndex, this->IsComposite, table);
    }
  }
}

void vtkSkdTreeRemap::Internals::FillOverlaps(vtkDataObject* output)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  for (std::size_t block = 0; block < this->Outputs.size(); ++block)
  {
    const vtkSmartPointer<vtkUnstructuredGrid> mesh = this->Remapper.GetWeights(block)
      ? SkdMakeOverlapMesh(
          this->Donor, this->Inputs[block].Mesh, this->Remapper.GetOverlapSettings(), this->Self)
      : nullptr;
    if (mesh)
    {
      if (blocks)
      {
        blocks->SetBlock(static_cast<unsigned int>(block), mesh);
      }
      else
      {
        output->ShallowCopy(mesh);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::Warn(const std::string& what) const
{
  vtkWarningWithObjectMacro(this->Self, << what);
}

void vtkSkdTreeRemap::Internals::WarnAboutFields() const
{
  const SkdFieldProblems& problems = this->Remapper.GetFindings().Fields;
  std::set<std::string> refused = this->Refused;
  refused.insert(problems.Refused.begin(), problems.Refused.end());
  SkdWarnAboutRefused(this->Self, refused);
  for (const std::string& warning :
    problems.GetWarnings(this->Settings.Fields.Missing, this->Method != INTERPOLATION))
  {
    this->Warn(warning);
  }
}

void vtkSkdTreeRemap::Internals::WriteWeights(const SkdShare& share)
{
  SkdWeightsFileSettings file;
  file.Name = share.NameOf(this->Self->WeightsFileName);
  file.Format = static_cast<SkdWeightsFormat>(this->Self->WeightsFileFormat);
  file.Space = this->Settings.Overlap.Space;
  file.Normalization = this->Settings.Conservative.Normalization;
  file.WithGradients = this->Settings.IsSecondOrder && file.Format == SkdWeightsFormat::Scrip;
  const bool isSame = file == this->Written && this->Remapper.GetFindings().WeightsFound == 0;
  if (file.Name.empty() || isSame)
  {
    return;
  }
  std::vector<SkdWeightsBlock> blocks;
  for (std::size_t block = 0; block < this->Outputs.size(); ++block)
  {
    if (const SkdOverlapWeights* weights = this->Remapper.GetWeights(block))
    {
      blocks.push_back({ this->Inputs[block].Mesh, weights });
    }
  }
  const std::string problem = SkdWriteWeights(file, this->Donor, blocks, this->Grids);
  this->Written = problem.empty() ? file : SkdWeightsFileSettings();
  if (!problem.empty())
  {
    this->Warn(problem);
  }
  else if (this->Settings.IsSecondOrder && !file.WithGradients)
  {
    this->Warn("The weights in " + file.Name +
      " are of first order: ESMF's form has none of gradients. SCRIP's has.");
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::Report(vtkDataObject* output, double seconds) const
{
  const SkdRemapFindings& found = this->Remapper.GetFindings();
  vtkIdType cells = 0;
  for (const SkdBlock& block : this->Outputs)
  {
    cells += block.Mesh->GetNumberOfCells();
  }
  SkdReport report(output);
  SkdReportPartialArrays(this->PartialArrays, output);
  report.AddCount("SourceCells", this->Donor->GetNumberOfCells());
  report.AddCount("InputCells", cells);
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

//------------------------------------------------------------------------------
bool vtkSkdTreeRemap::Internals::IsConservative() const
{
  return this->Method == CONSERVATIVE_FIRST_ORDER || this->Method == CONSERVATIVE_SECOND_ORDER;
}

// What only the prober maps it reads itself.
void vtkSkdTreeRemap::Internals::Begin(bool hasCells, bool hasOthers)
{
  const bool isAutomatic = this->Self->Method == AUTOMATIC_METHOD;
  this->Method =
    isAutomatic && (!hasCells || !this->IsOfOneDimension()) ? INTERPOLATION : this->Self->Method;
  const vtkNew<vtkUnstructuredGrid> nothing;
  const bool isProbed = this->Method == INTERPOLATION && this->Self->MaskArray.empty() &&
    !(isAutomatic && !hasCells && hasOthers);
  this->Remapper.Begin(isProbed ? nothing.Get() : this->Donor.Get(), this->Settings, this->Self);
  if (hasOthers && !isProbed && this->Method != CONTAINED)
  {
    this->Remapper.ExpectIntegrals();
  }
}

// What of Input one process has may be flat, or nothing.
bool vtkSkdTreeRemap::Internals::IsOfCurvedSurfaces(const skd::Processes* processes)
{
  SkdOverlapSpace& space = this->Settings.Overlap.Space;
  const bool isExact = this->Self->Method == CONSERVATIVE_FIRST_ORDER ||
    this->Self->Method == CONSERVATIVE_SECOND_ORDER;
  const bool isHere = isExact && space == SkdOverlapSpace::CurvedSurface;
  const bool isAny = processes && isExact ? processes->IsAny(isHere) : isHere;
  space = isAny ? SkdOverlapSpace::CurvedSurface : space;
  return isAny;
}

void vtkSkdTreeRemap::Internals::MapBlocks(double start)
{
  const double step =
    (1.0 - start) / static_cast<double>(std::max<std::size_t>(this->Outputs.size(), 1));
  for (std::size_t block = 0; block < this->Outputs.size(); ++block)
  {
    const double first = start + static_cast<double>(block) * step;
    if (!(SkdIsAborted(this->Self)))
    {
      this->MapBlock(block, first, first + step);
    }
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeRemap::Internals::Run(
  vtkDataObject* input, vtkDataObject* source, vtkInformationVector* outputVector)
{
  SkdStopwatch watch;
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  this->Inputs = SkdBlocksOf(input);
  this->Outputs = SkdMirror(input, output);
  this->IsComposite = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  this->Refused.clear();
  if (!this->Self->PassInputData)
  {
    SkdDropData(this->Outputs);
  }
  this->Grids = { SkdGridSizesOf(SkdBlocksOf(source)), SkdGridSizesOf(this->Inputs) };
  this->PrepareDonor(source);
  this->Settings = this->MakeSettings();
  this->Settings.WeighsByCosine = this->WeighsByCosine(source);
  const bool isByFile = this->Self->Method == WEIGHTS_FROM_FILE;
  const bool hasCells = this->FindSpace();
  const auto processes = this->Self->NeedsWhole(0)
    ? nullptr // this one has all
    : SkdProcessesOf(outputVector->GetInformationObject(0));
  const bool isCurved = this->IsOfCurvedSurfaces(processes.get());
  this->Begin(hasCells, processes != nullptr);
  constexpr double matched = 0.7; // of the progress
  if (isCurved)
  {
    this->Remapper.MatchSurfaces(this->Outputs, processes.get(), 0.0, matched);
  }
  if (isByFile)
  {
    constexpr int wanted[] = { -1, vtkDataObject::CELL, vtkDataObject::POINT };
    this->Remapper.MapByFile(
      this->Self->AppliedWeightsFileName, this->Outputs, wanted[this->Self->ResultsOn]);
  }
  else if (hasCells || !this->IsConservative())
  {
    this->MapBlocks(isCurved ? matched : 0.0);
  }
  if (processes)
  {
    this->Remapper.AddIntegrals(*processes);
  }
  if (this->Self->GenerateWeights)
  {
    this->FillWeights(vtkTable::GetData(outputVector, 1));
  }
  if (this->Self->GenerateOverlapMesh)
  {
    this->FillOverlaps(vtkDataObject::GetData(outputVector, 2));
  }
  this->WriteWeights(SkdShare::Of(outputVector));
  this->WarnAboutFields();
  for (const std::string& warning : this->Remapper.GetFindings().GetWarnings(this->HintOf()))
  {
    this->Warn(warning);
  }
  this->Report(output, watch.Lap());
  this->FinishTarget();
  this->Remapper.End();
  this->Inputs.clear();
  this->Outputs.clear();
  this->Donor = nullptr;
}

//------------------------------------------------------------------------------
vtkSkdTreeRemap::vtkSkdTreeRemap()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Required, { LIKE_INPUT, VTK_TABLE, GRID_OR_BLOCKS })
  , Impl(new Internals(this))
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

int vtkSkdTreeRemap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->IsLeftToFirst(outputVector))
  {
    return 1;
  }
  this->Impl->Run(
    vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(inputVector[1]), outputVector);
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
