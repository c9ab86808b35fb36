// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreePointInOut.h"

#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSearchRange.h"
#include "Pipeline/SkdSetText.h"
#include "Pipeline/SkdShownElements.h"
#include "Pipeline/SkdSubset.h"
#include "Pipeline/SkdVolumeCells.h"
#include "Search/InOut/SkdPartClassifier.h"
#include "Search/InOut/SkdSpreadParts.h"
#include "Search/Probe/SkdCellFinder.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreePointInOut);

class vtkSkdTreePointInOut::Internals
{
public:
  std::vector<SkdBlock> Blocks; // of the source, those with cells
  SkdPartList Parts;            // of the first model
  SkdSpreadParts Pieces;        // the same of a source that stays in its pieces
  SkdSourceTrees Trees;         // of the second
  SkdCellFinderSource CellFinders{ Trees, Blocks };
  std::vector<std::vector<int>> PartIds; // of the second's cells, or none
  SkdInsideRules Rules;
  double Band = 0.0;
  int Built = 0;
  double BuildSeconds = 0.0;

  /// Answers query points one by one. For use by one thread.
  using Answer = std::function<SkdInOut(vtkIdType queryPoint)>;
  Answer MakeAnswer(int model, const SkdQueryPoints& queryPoints) const;

  /// Calls set(query point, answer) for all query points.
  template <class Set>
  void Ask(const SkdQueryPoints& queryPoints, int model, SkdLoop& loop, const Set& set) const;

  SkdInOuts AskFor(const SkdQueryPoints& queryPoints, int model, SkdLoop& loop) const;
  SkdInOuts AskCorners(vtkDataSet* mesh, int model, bool all, SkdLoop& loop) const;
};

/// What is told of the parts.
struct vtkSkdTreePointInOut::PartFacts
{
  std::size_t Number = 0;
  bool HaveFaces = false;
  bool HaveVolumes = false; // boundaries of volume cells
  vtkIdType Open = 0;
  vtkIdType OpenEdges = 0;
  vtkIdType CoarseFaces = 0;
  double ChordalLength = 0.0;
};

namespace
{
/// The answer of a cell, from those of its points: that of the least depth, or of the greatest.
SkdInOut ChooseCorner(const std::vector<SkdInOut>& corners, vtkIdList* ids, bool least)
{
  SkdInOut chosen;
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
  {
    const SkdInOut& corner = corners[ids->GetId(k)];
    const bool isBetter = least ? corner.Depth < chosen.Depth : corner.Depth > chosen.Depth;
    chosen = k == 0 || isBetter ? corner : chosen;
  }
  return chosen;
}

/// The answers of a mesh's cells, from those of its points.
SkdInOuts ChooseCorners(vtkDataSet* mesh, const std::vector<SkdInOut>& corners, bool least,
  bool hasWinding, SkdLoop& loop)
{
  SkdTouchCells(mesh);
  SkdInOuts answers(mesh->GetNumberOfCells(), hasWinding);
  loop.For(mesh->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        mesh->GetCellPoints(cell, ids);
        answers.Set(cell, ChooseCorner(corners, ids, least));
      }
    });
  return answers;
}

SkdInOuts ListAnswers(const std::vector<SkdInOut>& found)
{
  SkdInOuts answers(static_cast<vtkIdType>(found.size()), false);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    answers.Set(static_cast<vtkIdType>(i), found[i]);
  }
  return answers;
}

/// The cells or points that are shown and have the requested result, as a grid.
vtkSmartPointer<vtkUnstructuredGrid> ExtractThose(
  vtkDataSet* mesh, const SkdInOuts& answers, bool wantsInside, bool ofCells)
{
  const std::vector<unsigned char> shown =
    SkdFindShown(mesh, ofCells ? vtkDataObject::CELL : vtkDataObject::POINT);
  std::vector<vtkIdType> those;
  for (vtkIdType i = 0; i < answers.GetNumber(); ++i)
  {
    if (answers.IsInside(i) == wantsInside && shown[static_cast<std::size_t>(i)] != 0)
    {
      those.push_back(i);
    }
  }
  SkdSubset subset(mesh);
  if (ofCells)
  {
    subset.SetCells(those);
  }
  else
  {
    subset.SetPoints(those);
  }
  subset.CopyData();
  return subset.Get();
}
}

vtkSkdTreePointInOut::Internals::Answer vtkSkdTreePointInOut::Internals::MakeAnswer(
  int model, const SkdQueryPoints& queryPoints) const
{
  if (model == BOUNDARIES)
  {
    auto asker =
      std::make_shared<SkdPartClassifier>(this->Parts.Get(), this->Rules, this->Band, queryPoints);
    return [asker](vtkIdType queryPoint) { return asker->Ask(queryPoint); };
  }
  auto finder = std::make_shared<SkdCellFinder>(this->CellFinders, SkdCellFinderRules());
  return [this, finder, &queryPoints](vtkIdType queryPoint)
  {
    SkdInOut answer;
    double x[3];
    queryPoints.GetPoint(queryPoint, x);
    answer.Confidence = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]) ? 1 : 0;
    if (finder->Find(x))
    {
      const SkdCellLocation& location = finder->GetLocation();
      answer.IsInside = true;
      answer.Depth = 1;
      answer.PartId = this->PartIds.empty() ? this->Blocks[location.Block].BlockIndex
                                            : this->PartIds[location.Block][location.CellId];
    }
    return answer;
  };
}

template <class Set>
void vtkSkdTreePointInOut::Internals::Ask(
  const SkdQueryPoints& queryPoints, int model, SkdLoop& loop, const Set& set) const
{
  loop.For(queryPoints.GetNumber(),
    [&](vtkIdType begin, vtkIdType end)
    {
      const Answer answer = this->MakeAnswer(model, queryPoints);
      for (vtkIdType index = begin; index < end; ++index)
      {
        const vtkIdType queryPoint = queryPoints.GetQueryPoint(index);
        set(queryPoint, answer(queryPoint));
      }
    });
}

SkdInOuts vtkSkdTreePointInOut::Internals::AskFor(
  const SkdQueryPoints& queryPoints, int model, SkdLoop& loop) const
{
  SkdInOuts answers(queryPoints.GetNumber(), this->Rules.Method == SkdInsideMethod::WindingNumber);
  this->Ask(queryPoints, model, loop,
    [&](vtkIdType queryPoint, const SkdInOut& answer) { answers.Set(queryPoint, answer); });
  return answers;
}

// Each point is classified once for all cells that have it.
SkdInOuts vtkSkdTreePointInOut::Internals::AskCorners(
  vtkDataSet* mesh, int model, bool all, SkdLoop& loop) const
{
  std::vector<SkdInOut> corners(mesh->GetNumberOfPoints());
  this->Ask(SkdQueryPoints(mesh, SkdQueryPoints::At::Points), model, loop,
    [&](vtkIdType point, const SkdInOut& answer) { corners[point] = answer; });
  return ChooseCorners(
    mesh, corners, all, this->Rules.Method == SkdInsideMethod::WindingNumber, loop);
}

vtkSkdTreePointInOut::vtkSkdTreePointInOut()
  : vtkSkdTreeFacetAlgorithm(SourceUse::Required, { LIKE_INPUT, GRID_OR_BLOCKS })
  , Impl(new Internals)
{
}

vtkSkdTreePointInOut::~vtkSkdTreePointInOut() = default;

void vtkSkdTreePointInOut::SetPartArray(const char* name)
{
  SkdSetText(this, name, this->PartArray);
}

// A cell that contains a point is near it; a boundary is decided over all of its faces.
bool vtkSkdTreePointInOut::NeedsNearbySource(SkdSearchRange&)
{
  return this->Model == BODY_FITTED_MESH;
}

// Passes through closed boundaries are counted by the processes that have the faces.
bool vtkSkdTreePointInOut::CanAskPieces(int port)
{
  return port == 1 && this->Model == BOUNDARIES && this->Parts == BLOCKS &&
    this->Method == AUTOMATIC && this->UseOuterFaces && this->BoundaryBand == 0.0;
}

bool vtkSkdTreePointInOut::CheckSource()
{
  const std::vector<SkdBlock>& blocks = this->Impl->Blocks;
  if (this->Parts == CELL_ARRAY && !SkdHavePartArray(blocks, this->PartArray))
  {
    vtkErrorMacro("Source has no cell array of numbers named \""
      << this->PartArray << "\" in all its blocks. Choose another PartArray.");
    return false;
  }
  if (this->Model == BOUNDARIES && !this->UseOuterFaces && SkdHasVolumeCells(blocks))
  {
    vtkErrorMacro(
      "Source has volume cells where surfaces are needed. Turn UseOuterFaces on, or set "
      "Model to BODY_FITTED_MESH.");
    return false;
  }
  return true;
}

void vtkSkdTreePointInOut::UpdateParts()
{
  Internals& internals = *this->Impl;
  internals.Rules = { static_cast<SkdInsideMethod>(this->Method), this->NumberOfRays,
    static_cast<std::uint64_t>(this->Seed), this->WindingTolerance };
  internals.Band = this->BoundaryBand;
  internals.PartIds.clear();
  internals.Pieces = SkdSpreadParts();
  if (this->Model == BOUNDARIES)
  {
    internals.Trees.Clear();
    internals.Built = internals.Parts.Update(internals.Blocks, static_cast<SkdPartsBy>(this->Parts),
      this->PartArray,
      { this->Epsilon, internals.Rules.Method, this->RepairOrientation,
        SkdChordalLength(internals.Blocks, this->ChordalDeviation) });
    return;
  }
  internals.Rules.Method = SkdInsideMethod::AxisRays;
  internals.Parts = SkdPartList();
  internals.Built = internals.Trees.Update(internals.Blocks, this->Epsilon);
  internals.CellFinders.Update(internals.Built);
  for (std::size_t i = 0; this->Parts == CELL_ARRAY && i < internals.Blocks.size(); ++i)
  {
    internals.PartIds.push_back(SkdPartIdsOf(internals.Blocks[i].Mesh, this->PartArray));
  }
}

vtkSkdTreePointInOut::PartFacts vtkSkdTreePointInOut::GetFacts() const
{
  const Internals& internals = *this->Impl;
  PartFacts facts;
  facts.Number = internals.Parts.Get().size();
  facts.HaveFaces = this->Model == BODY_FITTED_MESH && internals.Trees.GetCounts().Cells > 0;
  facts.HaveVolumes = this->Model == BOUNDARIES && SkdHasVolumeCells(internals.Blocks);
  facts.ChordalLength = internals.Parts.GetChordalLength();
  for (const SkdPart& part : internals.Parts.Get())
  {
    facts.HaveFaces = facts.HaveFaces || part.GetNumberOfFaces() > 0;
    facts.Open += part.GetNumberOfOpenEdges() > 0 ? 1 : 0;
    facts.OpenEdges += part.GetNumberOfOpenEdges();
    facts.CoarseFaces += part.GetNumberOfCoarseFaces();
  }
  return facts;
}

void vtkSkdTreePointInOut::WarnAbout(const PartFacts& facts)
{
  if (!facts.HaveFaces)
  {
    vtkWarningMacro("Source has no " << (this->Model == BOUNDARIES ? "surface" : "cells")
                                     << "; everything is outside.");
    return;
  }
  SkdWarnAboutCoarseFaces(this, facts.CoarseFaces, this->ChordalDeviation);
  if (facts.Open > 0)
  {
    vtkWarningMacro(<< facts.Open << " of " << facts.Number << " parts are not closed: they have "
                    << facts.OpenEdges
                    << " open edges. Points near these may be classified wrongly; see "
                       "SkdConfidence.");
  }
}

int vtkSkdTreePointInOut::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& internals = *this->Impl;
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  SkdStopwatch watch;
  std::optional<PartFacts> facts;
  std::vector<SkdInOuts> answers;
  if (this->Inputs->GetSpread(1))
  {
    facts = this->AskPieces(SkdMirror(input, output), answers);
    source = facts ? source : this->Inputs->GatherSpread(1);
  }
  internals.Blocks = SkdBlocksWithCells(SkdBlocksOf(source));
  if (!facts)
  {
    if (!this->CheckSource())
    {
      return 1;
    }
    this->UpdateParts();
    facts = this->GetFacts();
    internals.BuildSeconds = watch.Lap();
    answers = this->AskMeshes(SkdMirror(input, output));
  }
  this->WarnAbout(*facts);
  this->FillOutputs(*facts, SkdBlocksOf(output), answers, outputVector);
  SkdReport(output).AddMeasure("QuerySeconds", watch.Lap());
  internals.Blocks.clear();
  return 1;
}

std::vector<SkdInOuts> vtkSkdTreePointInOut::AskMeshes(const std::vector<SkdBlock>& meshes)
{
  const Internals& internals = *this->Impl;
  SkdLoop loop(this, this->CountQueryPoints(meshes), 0.2, 1.0);
  const auto at = this->Ask == POINTS ? SkdQueryPoints::At::Points : SkdQueryPoints::At::Middles;
  std::vector<SkdInOuts> answers;
  for (const SkdBlock& block : meshes)
  {
    answers.push_back(this->AsksCorners()
        ? internals.AskCorners(block.Mesh, this->Model, this->Ask == CELLS_ALL_POINTS, loop)
        : internals.AskFor(SkdQueryPoints(block.Mesh, at), this->Model, loop));
  }
  return answers;
}

// All processes ask together, also those that have fewer meshes. Nothing is returned if the source
// must be gathered.
std::optional<vtkSkdTreePointInOut::PartFacts> vtkSkdTreePointInOut::AskPieces(
  const std::vector<SkdBlock>& meshes, std::vector<SkdInOuts>& answers)
{
  const SkdSpreadSource& spread = *this->Inputs->GetSpread(1);
  SkdStopwatch watch;
  this->Impl->Parts = SkdPartList();
  this->Impl->Trees.Clear();
  SkdSpreadParts& parts = this->Impl->Pieces;
  this->Impl->Built = parts.Update(spread, this->Epsilon);
  this->Impl->BuildSeconds = watch.Lap();
  if (!parts.AreFit())
  {
    return std::nullopt;
  }
  SkdTransport& transport = spread.GetTransport();
  SkdLoop loop(this, this->CountQueryPoints(meshes), 0.2, 1.0);
  const auto at =
    this->Ask == CELL_CENTERS ? SkdQueryPoints::At::Middles : SkdQueryPoints::At::Points;
  const int rounds = SkdMostOf(transport, static_cast<int>(meshes.size()));
  const vtkSmartPointer<vtkDataSet> empty = vtkSmartPointer<vtkUnstructuredGrid>::New();
  for (int round = 0; round < rounds; ++round)
  {
    const bool isOwn = round < static_cast<int>(meshes.size());
    const vtkSmartPointer<vtkDataSet> mesh =
      isOwn ? meshes[static_cast<std::size_t>(round)].Mesh : empty;
    std::vector<SkdInOut> found;
    if (parts.Ask(SkdQueryPoints(mesh, at), loop, found) == SkdSpreadResult::Undecided)
    {
      return std::nullopt;
    }
    if (isOwn)
    {
      answers.push_back(this->AsksCorners()
          ? ChooseCorners(mesh, found, this->Ask == CELLS_ALL_POINTS, false, loop)
          : ListAnswers(found));
    }
  }
  PartFacts facts;
  facts.Number = parts.GetNumber();
  facts.HaveFaces = parts.HaveFaces();
  facts.HaveVolumes = SkdMostOf(transport, SkdHasVolumeCells(spread.GetBlocks()) ? 1 : 0) == 1;
  return facts;
}

void vtkSkdTreePointInOut::FillOutputs(const PartFacts& facts, const std::vector<SkdBlock>& meshes,
  const std::vector<SkdInOuts>& answers, vtkInformationVector* outputVector)
{
  const auto to = this->Ask == POINTS ? vtkDataObject::POINT : vtkDataObject::CELL;
  vtkIdType points = 0;
  vtkIdType inside = 0;
  const SkdLeafNumbers leaves = SkdLeafNumbersOf(vtkDataObject::GetData(outputVector, 0));
  if (auto* blocks = vtkMultiBlockDataSet::GetData(outputVector, 1))
  {
    blocks->SetNumberOfBlocks(leaves.Count);
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    answers[i].AddTo(meshes[i].Mesh->GetAttributes(to));
    this->ExtractFrom(meshes[i].Mesh, leaves.Of[i], answers[i], outputVector);
    const std::vector<unsigned char> shown = SkdFindShown(meshes[i].Mesh, to);
    points += SkdCountShown(shown);
    inside += SkdCountShown(shown, [&](vtkIdType element) { return answers[i].IsInside(element); });
  }
  SkdReport report(vtkDataObject::GetData(outputVector, 0));
  report.AddCount("Points", points);
  report.AddCount("PointsInside", inside);
  report.AddCount("Parts", static_cast<vtkIdType>(facts.Number));
  report.AddCount("OpenParts", facts.Open);
  report.AddCount("OpenEdges", facts.OpenEdges);
  report.AddCount("OuterFaces", facts.HaveVolumes ? 1 : 0);
  report.AddCount("TreesBuilt", this->Impl->Built);
  report.AddMeasureOf("ChordalLength", facts.ChordalLength);
  report.AddMeasure("BuildSeconds", this->Impl->BuildSeconds);
  if (this->Inputs->GetSpread(1))
  {
    report.AddCount("PointsSent", static_cast<vtkIdType>(this->Impl->Pieces.CountRequests()));
  }
}

void vtkSkdTreePointInOut::ExtractFrom(
  vtkDataSet* mesh, unsigned int leaf, const SkdInOuts& answers, vtkInformationVector* outputVector)
{
  const bool wantsInside = this->Extract == INSIDE;
  vtkSmartPointer<vtkUnstructuredGrid> grid = this->Extract == NOTHING
    ? vtkSmartPointer<vtkUnstructuredGrid>::New()
    : ExtractThose(mesh, answers, wantsInside, this->Ask != POINTS);
  if (auto* blocks = vtkMultiBlockDataSet::GetData(outputVector, 1))
  {
    blocks->SetBlock(leaf, grid);
    return;
  }
  vtkUnstructuredGrid::GetData(outputVector, 1)->ShallowCopy(grid);
}

vtkIdType vtkSkdTreePointInOut::CountQueryPoints(const std::vector<SkdBlock>& blocks) const
{
  vtkIdType queryPoints = 0;
  for (const SkdBlock& block : blocks)
  {
    const bool asksPoints = this->Ask != CELL_CENTERS;
    queryPoints += asksPoints ? block.Mesh->GetNumberOfPoints() : 0;
    queryPoints += this->Ask != POINTS ? block.Mesh->GetNumberOfCells() : 0;
  }
  return queryPoints;
}

void vtkSkdTreePointInOut::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Model", this->Model, "Parts", this->Parts, "PartArray", this->PartArray,
    "Method", this->Method, "NumberOfRays", this->NumberOfRays, "Seed", this->Seed,
    "WindingTolerance", this->WindingTolerance, "Ask", this->Ask, "BoundaryBand",
    this->BoundaryBand, "UseOuterFaces", this->UseOuterFaces, "RepairOrientation",
    this->RepairOrientation, "Extract", this->Extract);
}
VTK_ABI_NAMESPACE_END
