// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreePointInOut.h"

#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReach.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdSetText.h"
#include "Pipeline/SkdSubset.h"
#include "Search/InOut/SkdPartClassifier.h"
#include "Search/Probe/SkdCellFinder.h"
#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreePointInOut);

class vtkSkdTreePointInOut::Internals
{
public:
  std::vector<SkdBlock> Blocks; // of the source, those with cells
  SkdPartList Parts;            // of the first model
  SkdSourceTrees Trees;         // of the second
  SkdCellFinderSource Places{ Trees, Blocks };
  std::vector<std::vector<int>> PartIds; // of the second's cells, or none
  SkdInsideRules Rules;
  double Band = 0.0;
  int Built = 0;

  /// Answers query points one by one. For use by one thread.
  using Answer = std::function<SkdInOut(vtkIdType queryPoint)>;
  Answer MakeAnswer(int model, const SkdQueryPoints& queryPoints) const;

  /// Calls set(query point, answer) for all query points.
  template <class Set>
  void Ask(const SkdQueryPoints& queryPoints, int model, SkdLoop& loop, const Set& set) const;

  SkdInOuts AskFor(const SkdQueryPoints& queryPoints, int model, SkdLoop& loop) const;
  SkdInOuts AskCorners(vtkDataSet* mesh, int model, bool all, SkdLoop& loop) const;
};

namespace
{
bool HasVolumes(const std::vector<SkdBlock>& blocks)
{
  vtkNew<vtkGenericCell> cell;
  return std::any_of(blocks.begin(), blocks.end(),
    [&](const SkdBlock& block)
    {
      for (vtkIdType i = 0; i < block.Mesh->GetNumberOfCells(); ++i)
      {
        cell->SetCellType(block.Mesh->GetCellType(i));
        if (cell->GetCellDimension() == 3)
        {
          return true;
        }
      }
      return false;
    });
}

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

/// The cells or points with the requested result, as a grid.
vtkSmartPointer<vtkUnstructuredGrid> ExtractThose(
  vtkDataSet* mesh, const SkdInOuts& answers, bool wantsInside, bool ofCells)
{
  std::vector<vtkIdType> those;
  for (vtkIdType i = 0; i < answers.GetNumber(); ++i)
  {
    if (answers.IsInside(i) == wantsInside)
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
  auto finder = std::make_shared<SkdCellFinder>(this->Places, SkdCellFinderRules());
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
  SkdTouchCells(mesh);
  SkdInOuts answers(mesh->GetNumberOfCells(), this->Rules.Method == SkdInsideMethod::WindingNumber);
  loop.For(mesh->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        mesh->GetCellPoints(cell, ids);
        answers.Set(cell, ChooseCorner(corners, ids, all));
      }
    });
  return answers;
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
bool vtkSkdTreePointInOut::NeedsNearbySource(SkdReach&)
{
  return this->Model == BODY_FITTED_MESH;
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
  if (this->Model == BOUNDARIES && !this->UseOuterFaces && HasVolumes(blocks))
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
  internals.Places.Update(internals.Built);
  for (std::size_t i = 0; this->Parts == CELL_ARRAY && i < internals.Blocks.size(); ++i)
  {
    internals.PartIds.push_back(SkdPartIdsOf(internals.Blocks[i].Mesh, this->PartArray));
  }
}

void vtkSkdTreePointInOut::WarnAbout()
{
  const std::vector<SkdPart>& parts = this->Impl->Parts.Get();
  const bool hasFaces = std::any_of(
    parts.begin(), parts.end(), [](const SkdPart& part) { return part.GetNumberOfFaces() > 0; });
  if (this->Model == BOUNDARIES ? !hasFaces : this->Impl->Trees.GetCounts().Cells == 0)
  {
    vtkWarningMacro("Source has no " << (this->Model == BOUNDARIES ? "surface" : "cells")
                                     << "; everything is outside.");
    return;
  }
  vtkIdType edges = 0;
  vtkIdType coarse = 0;
  int open = 0;
  for (const SkdPart& part : parts)
  {
    edges += part.GetNumberOfOpenEdges();
    open += part.GetNumberOfOpenEdges() > 0 ? 1 : 0;
    coarse += part.GetNumberOfCoarseFaces();
  }
  SkdWarnAboutCoarseFaces(this, coarse, this->ChordalDeviation);
  if (open > 0)
  {
    vtkWarningMacro(
      << open << " of " << parts.size() << " parts are not closed: they have " << edges
      << " open edges. Points near these may be classified wrongly; see SkdConfidence.");
  }
}

int vtkSkdTreePointInOut::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& internals = *this->Impl;
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  SkdStopwatch watch;
  internals.Blocks = SkdBlocksWithCells(SkdBlocksOf(vtkDataObject::GetData(inputVector[1])));
  if (!this->CheckSource())
  {
    return 1;
  }
  this->UpdateParts();
  this->WarnAbout();
  const double buildSeconds = watch.Lap();

  const std::vector<SkdBlock> outputs = SkdMirror(vtkDataObject::GetData(inputVector[0]), output);
  SkdLoop loop(this, this->CountQueryPoints(outputs), 0.2, 1.0);
  vtkIdType points = 0;
  vtkIdType inside = 0;
  for (const SkdBlock& block : outputs)
  {
    const SkdInOuts answers = this->AskMesh(block.Mesh, loop);
    this->ExtractFrom(block.Mesh, answers, outputVector);
    points += answers.GetNumber();
    inside += answers.CountInside();
  }
  this->Report(output, points, inside, buildSeconds, watch.Lap());
  internals.Blocks.clear();
  return 1;
}

SkdInOuts vtkSkdTreePointInOut::AskMesh(vtkDataSet* mesh, SkdLoop& loop)
{
  const Internals& internals = *this->Impl;
  const bool asksCorners = this->Ask == CELLS_ALL_POINTS || this->Ask == CELLS_ANY_POINT;
  const auto at = this->Ask == POINTS ? SkdQueryPoints::At::Points : SkdQueryPoints::At::Middles;
  SkdInOuts answers = asksCorners
    ? internals.AskCorners(mesh, this->Model, this->Ask == CELLS_ALL_POINTS, loop)
    : internals.AskFor(SkdQueryPoints(mesh, at), this->Model, loop);
  answers.AddTo(
    mesh->GetAttributes(this->Ask == POINTS ? vtkDataObject::POINT : vtkDataObject::CELL));
  return answers;
}

void vtkSkdTreePointInOut::ExtractFrom(
  vtkDataSet* mesh, const SkdInOuts& answers, vtkInformationVector* outputVector)
{
  const bool wantsInside = this->Extract == INSIDE;
  vtkSmartPointer<vtkUnstructuredGrid> grid = this->Extract == NOTHING
    ? vtkSmartPointer<vtkUnstructuredGrid>::New()
    : ExtractThose(mesh, answers, wantsInside, this->Ask != POINTS);
  if (auto* blocks = vtkMultiBlockDataSet::GetData(outputVector, 1))
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), grid);
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

void vtkSkdTreePointInOut::Report(vtkDataObject* output, vtkIdType points, vtkIdType inside,
  double buildSeconds, double querySeconds)
{
  vtkIdType edges = 0;
  vtkIdType open = 0;
  for (const SkdPart& part : this->Impl->Parts.Get())
  {
    edges += part.GetNumberOfOpenEdges();
    open += part.GetNumberOfOpenEdges() > 0 ? 1 : 0;
  }
  SkdReport report(output);
  report.AddCount("Points", points);
  report.AddCount("PointsInside", inside);
  report.AddCount("Parts", static_cast<vtkIdType>(this->Impl->Parts.Get().size()));
  report.AddCount("OpenParts", open);
  report.AddCount("OpenEdges", edges);
  const bool asksFaces = this->Model == BOUNDARIES && HasVolumes(this->Impl->Blocks);
  report.AddCount("OuterFaces", asksFaces ? 1 : 0);
  report.AddCount("TreesBuilt", this->Impl->Built);
  report.AddMeasureOf("ChordalLength", this->Impl->Parts.GetChordalLength());
  report.AddMeasure("BuildSeconds", buildSeconds);
  report.AddMeasure("QuerySeconds", querySeconds);
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
