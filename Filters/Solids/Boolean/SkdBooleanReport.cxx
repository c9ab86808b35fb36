// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBooleanReport.h"

#include "Bodies/SkdOuterSurface.h"
#include "Pipeline/SkdReport.h"
#include "Solids/Boolean/SkdBooleanNames.h"
#include "Solids/Boolean/SkdFlushFaces.h"
#include "vtkAlgorithm.h"

#include <algorithm>

namespace skdtree
{
namespace
{
constexpr const char* OrientAdvice =
  " Orient the faces (Generate Surface Normals with Consistency).";

// What was tried on scans: vtkFillHolesFilter fills some holes in part, and its faces may be
// turned.
constexpr const char* CloseAdvice =
  " Close the holes, for example by vtkFillHolesFilter with a HoleSize larger than the surface, "
  "again and again until no edge is open, and then orient the faces (Generate Surface Normals with "
  "Consistency). If edges remain (Feature Edges shows them), repair the surface where they are, in "
  "another program. Or set Open Surfaces to Winding Number: inside is then where the generalized "
  "winding number is at least one half. An open surface can be the Source of an intersection or a "
  "difference, which it then cuts.";

std::string LeftOutText(const SkdTriangleSet& triangles)
{
  const vtkIdType count = triangles.GetNumberOfFacesLeftOut();
  return count == 0 ? ""
                    : " " + std::to_string(count) +
      " faces are left out: they have points that are not finite, or fewer than three.";
}

void WarnOfNoFaces(
  vtkAlgorithm* filter, const SkdTriangleSet& triangles, const SkdBooleanBlocks& blocks)
{
  for (const bool isSource : { false, true })
  {
    const auto isOfInput = [&](int block) { return (block >= blocks.FirstOfSource) == isSource; };
    bool hasCells = false;
    for (int block = 0; block < static_cast<int>(blocks.All.size()); ++block)
    {
      hasCells = hasCells || (isOfInput(block) && blocks.All[block].Mesh->GetNumberOfCells() > 0);
    }
    const auto& cells = triangles.GetCells();
    const bool hasFaces = std::any_of(cells.begin(), cells.end(),
      [&](const SkdTriangleSet::Cell& cell) { return isOfInput(cell.Block); });
    if (hasCells && !hasFaces)
    {
      vtkWarningWithObjectMacro(
        filter, << (isSource ? "Source" : "Input") << " has no faces; it is taken as empty.");
    }
  }
}

void ReportMeasures(const std::string& what, const SkdBoundaryMeasures& measures, SkdReport& report)
{
  report.AddMeasure(what + "Volume", measures.Volume);
  report.AddMeasure(what + "Area", measures.Area);
}

void ReportCombined(const SkdCombinedSolids& combined, bool areInputs, SkdReport& report)
{
  ReportMeasures("Input", areInputs ? combined.Operands[0] : combined.Union, report);
  if (areInputs)
  {
    ReportMeasures("Source", combined.Operands[1], report);
  }
}

void ReportInputs(const SkdSolidArrangement& solids, const SkdBooleanRule& rule, SkdReport& report)
{
  const bool areInputs = solids.AreSolidsInputs();
  if (const auto& combined = solids.GetCombined())
  {
    ReportCombined(*combined, areInputs, report);
  }
  if (solids.HasWindings())
  {
    const auto isInput = [&](const SkdRegionWindings& windings)
    { return areInputs ? rule.IsInside(windings, 0) : rule.CountSolids(windings) > 0; };
    ReportMeasures("Input", solids.Measure(isInput), report);
  }
  if (solids.HasWindings() && areInputs && !solids.GetCombined() && !solids.IsSheet(1))
  {
    const auto isSource = [&](const SkdRegionWindings& windings)
    { return rule.IsInside(windings, 1); };
    ReportMeasures("Source", solids.Measure(isSource), report);
  }
  report.AddCount("TreesBuilt", solids.IsNew());
  report.AddCount("Solids", solids.GetSolids().Count);
  if (solids.IsSheet(1) || solids.CountRoundedEdges() > 0)
  {
    report.AddCount(
      "OpenEdges", solids.IsSheet(1) ? solids.GetBadEdges()[1].Count : solids.CountRoundedEdges());
  }
}
}

//------------------------------------------------------------------------------
void SkdWarnAboutInputs(vtkAlgorithm* filter, const SkdSolidArrangement& solids,
  const SkdBooleanBlocks& blocks, double chordalDeviation)
{
  const SkdTriangleSet& triangles = solids.GetTriangles();
  SkdWarnAboutCoarseFaces(filter, triangles.GetNumberOfCoarseFaces(), chordalDeviation);
  SkdWarnAboutTinyPoints(filter, solids.GetPlacement());
  WarnOfNoFaces(filter, triangles, blocks);
}

//------------------------------------------------------------------------------
void SkdTellUnclosed(vtkAlgorithm* filter, const SkdSolidArrangement& solids, std::uint32_t solid)
{
  const SkdBadEdges& bad = solids.GetBadEdges()[solid];
  vtkErrorWithObjectMacro(
    filter, << solids.NameOf(solid) << " is not a closed, consistently oriented surface: "
            << bad.Open << " edges are open and " << bad.Count - bad.Open
            << " are between faces of opposite orientation, the first from "
            << solids.TextOf(bad.First, solids.GetArrangement().Facets) << ". There is no output."
            << (bad.Open > 0 ? CloseAdvice : OrientAdvice) << LeftOutText(solids.GetTriangles()));
}

//------------------------------------------------------------------------------
void SkdTellRounded(vtkAlgorithm* filter, const SkdSolidArrangement& solids)
{
  std::string names;
  vtkIdType open = 0;
  const std::vector<SkdBadEdges>& bad = solids.GetBadEdges();
  for (std::uint32_t solid = 0; solid < bad.size(); ++solid)
  {
    names += bad[solid].Count == 0 ? "" : (names.empty() ? "" : ", ") + solids.NameOf(solid);
    open += bad[solid].Open;
  }
  if (solids.CountRoundedEdges() > 0)
  {
    vtkWarningWithObjectMacro(filter, << names << ": " << open << " edges are open and "
                                      << solids.CountRoundedEdges() - open
                                      << " are between faces of opposite orientation; inside is "
                                         "where the generalized winding number is at least one "
                                         "half. The output may be open by the gaps.");
  }
}

//------------------------------------------------------------------------------
void SkdTellSheetFaults(vtkAlgorithm* filter, const std::optional<SkdSheetFaults>& faults)
{
  if (!faults)
  {
    vtkErrorWithObjectMacro(filter,
      "Which regions are inside could not be found; there is no output. Please report "
      "this, with the inputs.");
    return;
  }
  if (faults->Undivided > 0)
  {
    vtkWarningWithObjectMacro(
      filter, << "The Source is open and does not cut through the Input: " << faults->Undivided
              << " parts of the Input have some of it within. That cuts "
                 "nothing off. Extend the Source or close it.");
  }
  if (faults->Contradictory > 0)
  {
    vtkWarningWithObjectMacro(filter, << "The Source is open, and " << faults->Contradictory
                                      << " parts of the Input are both in front of it and behind; "
                                         "they are taken as in front. Orient its faces "
                                         "(Generate Surface Normals with Consistency).");
  }
}

//------------------------------------------------------------------------------
void SkdBooleanTotals::Add(
  const SkdSolidArrangement& solids, const SkdBooleanRule& rule, const SkdBooleanBoundary& boundary)
{
  this->NumberFolded += boundary.Rounded ? boundary.Rounded->NumberFolded : 0;
  if (rule.Operation == SkdBooleanOperation::Imprint)
  {
    return;
  }
  const SkdBoundaryMeasures measures = solids.Measure(boundary);
  this->Measures.Volume += measures.Volume;
  this->Measures.Area += measures.Area;
  if (rule.Operation == SkdBooleanOperation::Split)
  {
    this->PartVolumes.push_back(measures.Volume);
  }
  const SkdBadEdges bad = boundary.Bad
    ? *boundary.Bad
    : SkdFindBadEdges(
        boundary.GetUnjoinedFacets(solids.GetArrangement()), boundary.GetUnjoinedSigns());
  if (bad.Count > 0 && this->Bad.Count == 0)
  {
    this->FirstBad = solids.TextOf(bad.First, boundary.GetFacets(solids.GetArrangement()));
  }
  this->Bad.Count += bad.Count;
}

//------------------------------------------------------------------------------
void SkdReportBoolean(vtkAlgorithm* filter, const SkdSolidArrangement& solids,
  const SkdBooleanRule& rule, const SkdBooleanTotals& totals, bool closesCut, SkdReport& report)
{
  ReportInputs(solids, rule, report);
  const std::vector<int>& bits = solids.GetCoordinateBits();
  report.AddCount(SkdBooleanNames::CoordinateBits,
    bits.empty() ? SkdFlushFaces::BitsOfDouble : *std::min_element(bits.begin(), bits.end()));
  report.AddCount("PointsAligned", solids.GetNumberAligned());
  report.AddCount("TrianglesFolded", totals.NumberFolded);
  report.AddCount("TrianglesSplit",
    solids.GetCombined() ? solids.GetCombined()->NumberSplit : solids.GetNumberSplit());
  if (!solids.GetCombined())
  {
    report.AddCount("TrianglesArranged", solids.GetNumberArranged());
  }
  if (rule.Operation == SkdBooleanOperation::Imprint)
  {
    return;
  }
  if (rule.Operation == SkdBooleanOperation::Split)
  {
    report.AddMeasures("PartVolumes", totals.PartVolumes);
  }
  ReportMeasures("", totals.Measures, report);
  report.AddCount("BadEdges", totals.Bad.Count);
  if (totals.Bad.Count > 0 && solids.CountRoundedEdges() == 0 && (closesCut || !solids.IsSheet(1)))
  {
    vtkWarningWithObjectMacro(filter, << "The output is not closed: " << totals.Bad.Count
                                      << " edges are open, the first from " << totals.FirstBad
                                      << ". Please report this, with the inputs.");
  }
}
}
