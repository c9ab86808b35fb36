// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapper.h"

#include "Pipeline/SkdCompensatedSum.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdLonLat.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdShownElements.h"
#include "Remap/SkdContainedFields.h"
#include "Remap/SkdLumpedPoints.h"
#include "Remap/SkdMeshPoints.h"
#include "Remap/SkdRemapTolerances.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace skdtree
{
namespace
{
/// Of all cells' middles or all points.
std::vector<skd::Vector3> PositionsOf(const std::vector<SkdBlock>& blocks, int type)
{
  std::vector<skd::Vector3> positions;
  for (const SkdBlock& block : blocks)
  {
    const std::vector<skd::Vector3> some =
      type == vtkDataObject::CELL ? SkdMiddlesOf(block.Mesh) : SkdPointsOf(block.Mesh);
    positions.insert(positions.end(), some.begin(), some.end());
  }
  return positions;
}

/// What of each cell is covered.
std::vector<double> SharesOf(const SkdOverlapCells& cells)
{
  std::vector<double> shares(cells.Measures.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    const double whole = cells.Measures[i];
    shares[i] = whole > 0.0 ? cells.OwnMeasureOf(i, cells.Covered[i]) / whole : 0.0;
  }
  return shares;
}

std::vector<double> CosinesOfLatitude(const std::vector<skd::Vector3>& points)
{
  std::vector<double> cosines;
  std::transform(points.begin(), points.end(), std::back_inserter(cosines), SkdCosineOfLatitude);
  return cosines;
}
}

//------------------------------------------------------------------------------
void SkdRemapper::Begin(
  vtkDataSet* donor, const SkdRemapSettings& settings, vtkAlgorithm* algorithm)
{
  this->Donor = donor;
  this->OwnDonors = SkdOwnCellsOf(donor);
  this->Settings = settings;
  this->Algorithm = algorithm;
  this->Findings = SkdRemapFindings();
  this->HasWeights.clear();
  this->Clipped.clear();
  SkdFieldProblems& problems = this->Findings.Fields;
  this->CellFields = SkdReadDonorFields(donor, vtkDataObject::CELL, settings.Fields, problems);
  this->PointFields = settings.WithPointFields
    ? SkdReadDonorFields(donor, vtkDataObject::POINT, settings.Fields, problems)
    : std::vector<SkdDonorField>();
  std::set<std::string> named = settings.Fields.Extensive;
  if (!settings.Fields.Mask.empty())
  {
    named.insert(settings.Fields.Mask);
  }
  for (const std::string& name : named)
  {
    const bool isThere =
      donor->GetCellData()->GetArray(name.c_str()) || donor->GetPointData()->GetArray(name.c_str());
    if (!isThere)
    {
      problems.Missing.insert(name);
    }
  }
}

//------------------------------------------------------------------------------
void SkdRemapper::ExpectIntegrals()
{
  for (const std::vector<SkdDonorField>* fields : { &this->CellFields, &this->PointFields })
  {
    for (const SkdDonorField& field : *fields)
    {
      this->Findings.Tally.Expect(field);
    }
  }
}

void SkdRemapper::AddIntegrals(const skd::Processes& processes)
{
  this->Findings.Tally.AddOthers(processes, !this->OwnDonors.empty());
}

//------------------------------------------------------------------------------
void SkdRemapper::End()
{
  this->Donor = nullptr;
  this->CellFields.clear();
  this->PointFields.clear();
}

//------------------------------------------------------------------------------
const SkdContainedMean& SkdRemapper::SamplesOf(int type)
{
  CachedSamples& cached = type == vtkDataObject::POINT ? this->OfPoints : this->OfCells;
  const bool isOnSphere = this->Settings.Overlap.Space == SkdOverlapSpace::Sphere;
  const bool isSame = cached.Samples && cached.Samples->IsOnSphere() == isOnSphere &&
    cached.WeighsByCosine == this->Settings.WeighsByCosine && cached.Mesh.IsSameAs(this->Donor);
  if (!isSame)
  {
    std::vector<skd::Vector3> points =
      type == vtkDataObject::POINT ? SkdPointsOf(this->Donor) : SkdMiddlesOf(this->Donor);
    std::vector<double> weights;
    if (isOnSphere && this->Settings.WeighsByCosine)
    {
      weights = CosinesOfLatitude(points);
    }
    SkdLeaveOut(SkdFindCounts(this->Donor, type, {}), points);
    cached.Samples =
      std::make_unique<SkdContainedMean>(std::move(points), std::move(weights), isOnSphere);
    cached.WeighsByCosine = this->Settings.WeighsByCosine;
    cached.Mesh.Keep(this->Donor);
  }
  return *cached.Samples;
}

//------------------------------------------------------------------------------
void SkdRemapper::AddFields(vtkDataSet* block, const std::vector<SkdDonorField>& fields,
  const std::vector<std::vector<double>>& values, const std::vector<double>& measures)
{
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    if (this->Settings.ToPoints)
    {
      SkdAddRemapped(block->GetPointData(), fields[f],
        SkdLumpToPoints(block, values[f], fields[f].Components, measures),
        this->Settings.Fields.RenamesTaken, this->Findings.Fields);
    }
    else
    {
      SkdAddRemapped(block->GetCellData(), fields[f], values[f], this->Settings.Fields.RenamesTaken,
        this->Findings.Fields);
    }
  }
}

//------------------------------------------------------------------------------
void SkdRemapper::AddCounts(vtkDataSet* block, const std::vector<vtkIdType>& counts)
{
  const auto n = static_cast<vtkIdType>(counts.size());
  const auto array = SkdMakeArray<vtkIdTypeArray>(SkdRemapNames::Count, 1, n);
  const auto valid = SkdMakeArray<vtkUnsignedCharArray>(SkdRemapNames::Valid, 1, n);
  const std::vector<unsigned char> shown = SkdFindShown(block, vtkDataObject::CELL);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType count = counts[static_cast<std::size_t>(i)];
    array->SetValue(i, count);
    valid->SetValue(i, count > 0 ? 1 : 0);
    this->Findings.EmptyCells += count > 0 || shown[static_cast<std::size_t>(i)] == 0 ? 0 : 1;
  }
  this->Findings.Cells += n;
  block->GetCellData()->AddArray(array);
  block->GetCellData()->AddArray(valid);
}

//------------------------------------------------------------------------------
bool SkdRemapper::MapContained(vtkDataSet* block, double first, double last)
{
  const SkdTargetCells cells(block, this->Settings.Overlap.Space == SkdOverlapSpace::Sphere, 0.0,
    this->Settings.Overlap.TargetIsLonLat);
  this->Findings.Unfit += cells.CountUnfit();
  const std::vector<double> equal(static_cast<std::size_t>(block->GetNumberOfCells()), 1.0);
  const bool both = !this->CellFields.empty() && !this->PointFields.empty();
  SkdLoop loop(this->Algorithm, (both ? 2 : 1) * block->GetNumberOfCells(), first, last);
  std::vector<vtkIdType> counts;
  for (int type : { vtkDataObject::CELL, vtkDataObject::POINT })
  {
    const std::vector<SkdDonorField>& fields =
      type == vtkDataObject::CELL ? this->CellFields : this->PointFields;
    if (fields.empty())
    {
      continue;
    }
    const SkdContainedResult result = SkdMapContained(
      this->SamplesOf(type), fields, cells, this->Settings.Statistic, this->Settings.Empty, loop);
    this->AddFields(block, fields, result.Values, equal);
    counts = counts.empty() ? result.Counts : counts;
  }
  this->AddCounts(block, counts);
  return !SkdIsAborted(this->Algorithm);
}

//------------------------------------------------------------------------------
// Amounts are nowhere but where the donor is.
void SkdRemapper::Extrapolate(const SkdDonorField& field,
  const std::vector<skd::Vector3>& positions, const std::vector<unsigned char>& isWanted,
  std::vector<double>& values)
{
  const int type = field.IsOfPoints ? vtkDataObject::POINT : vtkDataObject::CELL;
  SkdExtrapolate(this->Settings.Extrapolation, this->SamplesOf(type).GetTree(), field, positions,
    isWanted, values);
}

// Where values that are NaN spread, what has a share of them is not without a value.
std::vector<unsigned char> SkdRemapper::FindUncovered(
  const SkdDonorField& field, const SkdOverlapCells& cells, const std::vector<double>& values) const
{
  const bool spreads = this->Settings.Fields.Missing == SkdMissingValues::Spread;
  const auto components = static_cast<std::size_t>(field.Components);
  std::vector<unsigned char> isWanted(cells.Measures.size());
  for (std::size_t i = 0; i < isWanted.size(); ++i)
  {
    const bool isEmpty = std::isnan(values[i * components]);
    isWanted[i] = isEmpty && !(spreads && cells.Covered[i] > 0.0) ? 1 : 0;
  }
  return isWanted;
}

//------------------------------------------------------------------------------
// What of each cell is covered by cells that count by the mask.
std::vector<double> SkdRemapper::FractionsOf(const SkdOverlapWeights& weights) const
{
  const SkdOverlapTable& table = weights.GetTable();
  const SkdOverlapCells& cells = weights.GetTarget();
  const std::vector<unsigned char> counts =
    SkdFindCounts(this->Donor, vtkDataObject::CELL, this->Settings.Fields);
  if (std::find(counts.begin(), counts.end(), 0) == counts.end())
  {
    return SharesOf(cells);
  }
  std::vector<double> fractions(cells.Measures.size(), 0.0);
  for (std::size_t row = 0; row < fractions.size(); ++row)
  {
    for (std::size_t k = table.Rows[row]; k < table.Rows[row + 1]; ++k)
    {
      const bool isPart = counts[static_cast<std::size_t>(table.Columns[k])] != 0;
      fractions[row] += isPart ? table.Measures[k] : 0.0;
    }
    fractions[row] = cells.OwnMeasureOf(row, fractions[row]);
    fractions[row] /= cells.Measures[row] > 0.0 ? cells.Measures[row] : 1.0;
  }
  return fractions;
}

//------------------------------------------------------------------------------
void SkdRemapper::AddCoverage(vtkDataSet* block, const SkdOverlapWeights& weights)
{
  const SkdOverlapCells& cells = weights.GetTarget();
  const auto n = static_cast<vtkIdType>(cells.Measures.size());
  const auto coverage = SkdMakeArray<vtkDoubleArray>(SkdRemapNames::Coverage, 1, n);
  const auto valid = SkdMakeArray<vtkUnsignedCharArray>(SkdRemapNames::Valid, 1, n);
  const std::vector<double> shares = SharesOf(cells);
  const std::vector<double> fractions = this->FractionsOf(weights);
  const std::vector<double>& counting = this->CellFields.empty() ? shares : fractions;
  const std::vector<unsigned char> shown = SkdFindShown(block, vtkDataObject::CELL);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double share = shares[static_cast<std::size_t>(i)];
    coverage->SetValue(i, share);
    const double answered = counting[static_cast<std::size_t>(i)];
    const bool isValid = answered > 0.0 && answered >= this->Settings.Conservative.MinimumCoverage;
    valid->SetValue(i, isValid ? 1 : 0);
    this->Findings.EmptyCells += isValid || shown[static_cast<std::size_t>(i)] == 0 ? 0 : 1;
    this->Findings.PartlyCovered += isValid && share < 1.0 - remap_tolerances::Coverage ? 1 : 0;
    const bool isCell = cells.Measures[static_cast<std::size_t>(i)] > 0.0;
    this->Findings.WithoutPartner +=
      isCell && share < 1.0 - remap_tolerances::SurfaceBorder ? 1 : 0;
    this->Findings.CoveredTwice += share > 1.0 + remap_tolerances::Coverage ? 1 : 0;
  }
  this->Findings.Cells += n;
  block->GetCellData()->AddArray(coverage);
  block->GetCellData()->AddArray(valid);
  const auto fraction = SkdMakeArray<vtkDoubleArray>(SkdRemapNames::Fraction, 1, n);
  std::copy(fractions.begin(), fractions.end(), fraction->GetPointer(0));
  block->GetCellData()->AddArray(fraction);
}

//------------------------------------------------------------------------------
void SkdRemapper::Count(const SkdOverlapWeights& weights, bool isNew)
{
  const SkdOverlapCells& donor = weights.GetDonor();
  this->Findings.Overlaps += static_cast<vtkIdType>(weights.GetTable().Columns.size());
  this->Findings.WeightsFound += isNew ? 1 : 0;
  ++this->Findings.WeightsUsed;
  this->Findings.SourceLeftOut = donor.LeftOut;
  this->Findings.SourceTooLarge = {};
  this->Findings.SourceCrossing = {};
  this->Findings.SourceTooLarge.Add(donor.TooLarge);
  this->Findings.SourceCrossing.Add(donor.Crossing);
  this->Findings.InputTooLarge.Add(weights.GetTarget().TooLarge);
  this->Findings.InputCrossing.Add(weights.GetTarget().Crossing);
  this->Findings.InputLeftOut += weights.GetTarget().LeftOut;
  for (std::size_t i = 0; i < donor.Measures.size(); ++i)
  {
    const bool isTwice = donor.Covered[i] > (1.0 + remap_tolerances::Coverage) * donor.Measures[i];
    this->Findings.SourceCoveredTwice += isTwice ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
SkdConservativeRemap SkdRemapper::MakeRemap(std::size_t index) const
{
  SkdConservativeRemap remap(
    this->Overlaps[index].GetWeights(), this->Settings.Overlap.Space, this->Settings.Conservative);
  remap.SetOwnDonors(this->OwnDonors);
  return remap;
}

std::vector<skd::Vector3> SkdRemapper::MiddlesForExtrapolation(vtkDataSet* block) const
{
  return this->Settings.Extrapolation.Method != SkdExtrapolationMethod::None
    ? SkdMiddlesOf(block)
    : std::vector<skd::Vector3>();
}

void SkdRemapper::AddConservative(vtkDataSet* block, const SkdOverlapCells& cells,
  const std::vector<skd::Vector3>& middles, const SkdDonorField& field, SkdRemappedField& mapped)
{
  if (this->Settings.Extrapolation.Method != SkdExtrapolationMethod::None && !field.IsExtensive)
  {
    const std::vector<unsigned char> isWanted = this->FindUncovered(field, cells, mapped.Values);
    this->Extrapolate(field, middles, isWanted, mapped.Values);
  }
  this->AddFields(block, { field }, { mapped.Values }, cells.Measures);
  this->Findings.Tally.Add(field, mapped.Integrals);
}

bool SkdRemapper::MapFields(vtkDataSet* block, std::size_t index, double first, double last)
{
  SkdOverlapCache& overlaps = this->Overlaps[index];
  const SkdConservativeRemap remap = this->MakeRemap(index);
  const SkdDonorGradients* gradients =
    this->Settings.IsSecondOrder ? &overlaps.GetGradients(this->Donor) : nullptr;
  const SkdOverlapPointTable* points = this->PointFields.empty()
    ? nullptr
    : overlaps.GetPointTable(this->Donor, block, this->Algorithm, first, last);
  const std::vector<skd::Vector3> positions =
    points ? SkdPointsOf(this->Donor) : std::vector<skd::Vector3>();
  const std::vector<skd::Vector3> middles = this->MiddlesForExtrapolation(block);
  ClippedBlock clipped{ block, index, {} };
  const auto add = [&](const SkdDonorField& field, SkdRemappedField&& mapped)
  {
    if (this->IsSumAssured())
    {
      clipped.Fields.emplace_back(&field, std::move(mapped));
      return;
    }
    this->AddConservative(block, overlaps.GetWeights().GetTarget(), middles, field, mapped);
  };
  for (const SkdDonorField& field : this->CellFields)
  {
    add(field, remap.Map(field, gradients, this->Settings.Limiter));
  }
  for (const SkdDonorField& field : this->PointFields)
  {
    if (points)
    {
      add(field, remap.MapPoints(field, *points, positions));
    }
  }
  if (!clipped.Fields.empty())
  {
    this->Clipped.push_back(std::move(clipped));
  }
  return !SkdIsAborted(this->Algorithm);
}

//------------------------------------------------------------------------------
// Of each component of each field of cells, one after another: over the blocks, then over the
// processes. One that has read no fields has none of their sums.
std::vector<SkdClippedSum> SkdRemapper::SumUpClipped(const skd::Processes* processes) const
{
  constexpr std::size_t count = 3;
  std::vector<double> own;
  for (std::size_t f = 0; f < this->CellFields.size(); ++f)
  {
    for (std::size_t c = 0; c < static_cast<std::size_t>(this->CellFields[f].Components); ++c)
    {
      SkdCompensatedSum sums[count];
      for (const ClippedBlock& block : this->Clipped)
      {
        const std::vector<SkdClippedSum>& some = block.Fields[f].second.Clipped;
        const SkdClippedSum sum = c < some.size() ? some[c] : SkdClippedSum();
        sums[0].Add(sum.Lost);
        sums[1].Add(sum.RoomBelow);
        sums[2].Add(sum.RoomAbove);
      }
      own.insert(own.end(), { sums[0].Get(), sums[1].Get(), sums[2].Get() });
    }
  }
  std::vector<std::vector<double>> all;
  if (processes)
  {
    all = processes->GatherFromOthers(own);
  }
  all.push_back(own);
  std::vector<double> sums(own.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    std::vector<double> each;
    for (const std::vector<double>& told : all)
    {
      each.push_back(i < told.size() ? told[i] : 0.0);
    }
    sums[i] = SkdSumOfProcesses(std::move(each));
  }
  std::vector<SkdClippedSum> clipped;
  for (std::size_t i = 0; i < sums.size(); i += count)
  {
    clipped.push_back({ sums[i], sums[i + 1], sums[i + 2] });
  }
  return clipped;
}

void SkdRemapper::FinishClipped(const std::vector<SkdClippedSum>& sums)
{
  for (ClippedBlock& clipped : this->Clipped)
  {
    const SkdConservativeRemap remap = this->MakeRemap(clipped.Index);
    const SkdOverlapCells& cells = this->Overlaps[clipped.Index].GetWeights().GetTarget();
    const std::vector<skd::Vector3> middles = this->MiddlesForExtrapolation(clipped.Block);
    auto first = sums.begin();
    for (auto& [field, mapped] : clipped.Fields)
    {
      if (!field->IsOfPoints)
      {
        const auto last = first + field->Components;
        remap.AssureSums(*field, std::vector<SkdClippedSum>(first, last), mapped);
        first = last;
      }
      this->AddConservative(clipped.Block, cells, middles, *field, mapped);
    }
  }
  this->Clipped.clear();
}

void SkdRemapper::AssureSums(const skd::Processes* processes)
{
  if (this->IsSumAssured())
  {
    this->FinishClipped(this->SumUpClipped(processes));
  }
}

//------------------------------------------------------------------------------
bool SkdRemapper::MatchSurfaces(
  const std::vector<SkdBlock>& blocks, const skd::Processes* processes, double first, double last)
{
  SkdMatchedSurfaces matched(this->Donor, blocks, this->Overlaps, processes);
  const bool isDone = matched.Match(this->Settings.Overlap, this->Algorithm, first, last);
  this->Findings.Surfaces = matched.GetFindings();
  this->Findings.WeightsFound += matched.GetNumberOfNew();
  return isDone;
}

//------------------------------------------------------------------------------
bool SkdRemapper::MapConservative(vtkDataSet* block, std::size_t index, double first, double last)
{
  while (this->Overlaps.size() <= index)
  {
    this->Overlaps.emplace_back();
  }
  this->HasWeights.resize(this->Overlaps.size(), false);
  SkdOverlapCache& overlaps = this->Overlaps[index];
  const double middle = this->PointFields.empty() ? last : 0.5 * (first + last);
  if (!overlaps.Update(this->Donor, block, this->Settings.Overlap, this->Algorithm, first, middle))
  {
    this->Findings.Problem = overlaps.GetProblem();
    return !SkdIsAborted(this->Algorithm);
  }
  this->HasWeights[index] = true;
  this->Count(overlaps.GetWeights(), overlaps.IsNew());
  this->AddCoverage(block, overlaps.GetWeights());
  return this->MapFields(block, index, middle, last);
}

// Nothing else that is found by mapping onto nothing is of interest.
void SkdRemapper::SumUpDonor()
{
  SkdRemapFindings findings = this->Findings;
  const vtkNew<vtkUnstructuredGrid> nothing;
  this->MapConservative(nothing, 0, 0.0, 1.0);
  this->FinishClipped(this->SumUpClipped(nullptr));
  this->HasWeights.clear();
  findings.Tally = this->Findings.Tally;
  this->Findings = std::move(findings);
}

//------------------------------------------------------------------------------
bool SkdRemapper::ReadFile(const std::string& fileName)
{
  if (fileName.empty())
  {
    this->Findings.Problem = "There are no weights to apply: set AppliedWeightsFileName.";
    return false;
  }
  const long time = vtksys::SystemTools::ModifiedTime(fileName);
  if (fileName != this->FileWeights.Name || time != this->FileTime)
  {
    this->Findings.Problem = this->FileWeights.Read(fileName);
    this->FileTime = time;
    this->FileWeights.Name = this->Findings.Problem.empty() ? fileName : std::string();
  }
  return this->Findings.Problem.empty();
}

void SkdRemapper::AddMapped(const std::vector<SkdBlock>& blocks, int type,
  const SkdDonorField& field, const std::vector<double>& values)
{
  auto first = values.begin();
  for (const SkdBlock& block : blocks)
  {
    const auto last = first + block.Mesh->GetNumberOfElements(type) * field.Components;
    SkdAddRemapped(block.Mesh->GetAttributes(type), field, std::vector<double>(first, last),
      this->Settings.Fields.RenamesTaken, this->Findings.Fields);
    first = last;
  }
}

void SkdRemapper::AddValid(
  const std::vector<SkdBlock>& blocks, int type, const std::vector<unsigned char>& isMapped)
{
  auto first = isMapped.begin();
  for (const SkdBlock& block : blocks)
  {
    const vtkIdType n = block.Mesh->GetNumberOfElements(type);
    const auto valid = SkdMakeArray<vtkUnsignedCharArray>(SkdRemapNames::Valid, 1, n);
    std::copy(first, first + n, valid->GetPointer(0));
    block.Mesh->GetAttributes(type)->AddArray(valid);
    this->Findings.EmptyCells += SkdCountShown(
      SkdFindShown(block.Mesh, type), [&](vtkIdType i) { return valid->GetValue(i) == 0; });
    first += n;
  }
}

void SkdRemapper::MapByFile(
  const std::string& fileName, const std::vector<SkdBlock>& blocks, int wanted)
{
  if (!this->ReadFile(fileName))
  {
    return;
  }
  SkdFileRemap remap(this->FileWeights, this->Donor, blocks, this->Algorithm);
  this->Findings.Problem = remap.Match(wanted);
  if (!this->Findings.Problem.empty())
  {
    return;
  }
  const SkdFileMeshes& meshes = remap.GetMeshes();
  std::vector<unsigned char> isMapped;
  for (const SkdDonorField& field :
    meshes.SourceType == vtkDataObject::CELL ? this->CellFields : this->PointFields)
  {
    std::vector<unsigned char> isOfField;
    std::vector<double> values = remap.Map(field, isOfField);
    if (this->Settings.Extrapolation.Method != SkdExtrapolationMethod::None)
    {
      std::vector<unsigned char> isWanted(isOfField.size());
      std::transform(isOfField.begin(), isOfField.end(), isWanted.begin(),
        [](unsigned char isMapped) { return isMapped != 0 ? 0 : 1; });
      this->Extrapolate(field, PositionsOf(blocks, meshes.TargetType), isWanted, values);
    }
    this->AddMapped(blocks, meshes.TargetType, field, values);
    isMapped = isMapped.empty() ? isOfField : isMapped;
  }
  if (!isMapped.empty())
  {
    this->AddValid(blocks, meshes.TargetType, isMapped);
  }
}

//------------------------------------------------------------------------------
const SkdOverlapWeights* SkdRemapper::GetWeights(std::size_t index) const
{
  const bool isThere = index < this->HasWeights.size() && this->HasWeights[index];
  return isThere ? &this->Overlaps[index].GetWeights() : nullptr;
}
}
