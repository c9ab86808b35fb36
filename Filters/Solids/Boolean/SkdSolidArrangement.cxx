// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSolidArrangement.h"

#include "Pipeline/SkdLoop.h"
#include "vtkAlgorithm.h"

#include <cmath>
#include <sstream>

bool SkdSolidArrangement::Update(
  const SkdBooleanBlocks& blocks, double chordalDeviation, vtkAlgorithm* filter)
{
  this->WasSplit = this->Triangles.Update(blocks.All, chordalDeviation);
  if (!this->WasSplit && this->Placement)
  {
    return true;
  }
  this->Placement.reset();
  this->Windings.clear();
  this->Solids = {};
  this->Triangles.LeaveOutCopies(1);
  SkdPlacement placement = SkdMakePlacement(this->Triangles, nullptr, std::nullopt);
  SkdLoop loop(filter, 0, 0.2, 0.6, 8);
  const SkdPairSearch search{ SkdPairSearch::All, 0.0 };
  auto pairs = SkdTrianglePairs(placement).FindSelfIntersections(search, loop);
  if (!pairs)
  {
    this->Triangles.Complete();
    pairs = SkdTrianglePairs(placement).FindByTrees(search, loop);
  }
  if (SkdIsAborted(filter))
  {
    return false;
  }
  SkdLoop splitLoop(filter, 0, 0.6, 0.8, 64);
  auto arrangement = SkdArrange(placement, *std::move(pairs), splitLoop);
  if (!arrangement)
  {
    return false;
  }
  this->Arrangement = *std::move(arrangement);
  this->Placement.emplace(std::move(placement));
  this->EqualPoints = SkdFindEqualPoints(*this->Placement, this->Arrangement.Facets);
  return true;
}

void SkdSolidArrangement::FindSolids(const SkdBooleanBlocks& blocks, bool areInputs)
{
  SkdSolids solids = areInputs ? SkdSolidsByInput(this->Triangles, blocks.FirstOfSource)
                               : SkdSolidsByBlock(this->Triangles);
  if (!areInputs && solids.Count < 2)
  {
    solids = SkdSolidsByPiece(this->Triangles);
  }
  if (this->Windings.empty() || solids.Of != this->Solids.Of)
  {
    this->Solids = std::move(solids);
    this->AreInputs = areInputs;
    this->Windings.clear();
    this->BadEdges = SkdFindBadEdges(this->Arrangement.Facets, this->Solids.Of, this->Solids.Count);
  }
}

std::optional<std::uint32_t> SkdSolidArrangement::FindUnclosed(SkdBooleanOperation operation) const
{
  const bool usesSheet =
    operation == SkdBooleanOperation::Intersection || operation == SkdBooleanOperation::Difference;
  for (std::uint32_t solid = 0; solid < this->Solids.Count; ++solid)
  {
    if (this->BadEdges[solid].Count > 0 && !(usesSheet && this->IsSheet(solid)))
    {
      return solid;
    }
  }
  return std::nullopt;
}

std::optional<SkdSheetFaults> SkdSolidArrangement::FindWindings()
{
  if (!this->Windings.empty())
  {
    return SkdSheetFaults();
  }
  this->Windings = SkdFindWindingNumbers(*this->Placement, this->Arrangement, this->Solids.Of);
  if (this->Windings.size() < this->Arrangement.NumberOfRegions)
  {
    return std::nullopt;
  }
  return this->IsSheet(1) ? this->PlaceSheet() : SkdSheetFaults();
}

std::optional<SkdSheetFaults> SkdSolidArrangement::PlaceSheet()
{
  const std::vector<std::uint32_t> parts =
    SkdFindPartsOfSpace(*this->Placement, this->Arrangement, this->Solids.Of);
  if (parts.empty())
  {
    this->Windings.clear();
    return std::nullopt;
  }
  return SkdPlaceSheet(
    this->Placement->First, this->Arrangement, parts, this->Solids.Of, 1, this->Windings);
}

SkdBooleanBoundary SkdSolidArrangement::Select(const SkdBooleanRule& rule, bool closesCut) const
{
  const SkdFacets& facets = this->Arrangement.Facets;
  const bool isImprint = rule.Operation == SkdBooleanOperation::Imprint;
  SkdBooleanBoundary boundary;
  SkdFacetSigns& signs = boundary.Selected;
  signs = isImprint
    ? SkdFacetSigns(facets.GetNumberOfFacets(), 1)
    : SkdFindBoundary(this->Arrangement, this->Windings,
        [&rule](const SkdRegionWindings& windings) { return rule.IsSolid(windings); });
  for (std::uint32_t facet = 0;
       !isImprint && !closesCut && this->IsSheet(1) && facet < signs.size(); ++facet)
  {
    const bool isOfSheet = this->Solids.Of[facets.Parents[facet]] == 1; // the lowest layer
    signs[facet] = isOfSheet ? static_cast<signed char>(0) : signs[facet];
  }
  if (!this->EqualPoints.empty())
  {
    boundary.Rounded = SkdUniteEqualPoints(facets, this->EqualPoints, signs, isImprint);
  }
  return boundary;
}

SkdBoundaryMeasures SkdSolidArrangement::Measure(const SkdFacetSigns& signs) const
{
  SkdBoundaryMeasures measures =
    SkdMeasureBoundary(this->Placement->First, this->Arrangement.Facets, signs);
  measures.Area /= std::pow(this->Placement->Scale, 2);
  measures.Volume /= std::pow(this->Placement->Scale, 3);
  return measures;
}

std::string SkdSolidArrangement::NameOf(std::uint32_t solid) const
{
  const char* inputs[2] = { "Input", "Source" };
  return this->AreInputs ? inputs[solid] : "Solid " + std::to_string(solid);
}

std::string SkdSolidArrangement::TextOf(const SkdSplitEdge& edge) const
{
  std::ostringstream text;
  for (const std::uint32_t point : { edge.first, edge.second })
  {
    const skd::Vector3 x = (1.0 / this->Placement->Scale) *
      this->Arrangement.Facets.GetPosition(this->Placement->First, point);
    text << (point == edge.first ? "" : " to ") << "(" << x[0] << ", " << x[1] << ", " << x[2]
         << ")";
  }
  return text.str();
}
