// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeBooleanOperation.h"

#include "Boolean/SkdBooleanSurface.h"
#include "Boolean/SkdRoundedFacets.h"
#include "Boolean/SkdSheet.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdOuterSurface.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeBooleanOperation);

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

SkdBooleanBlocks BlocksOf(vtkDataObject* input, vtkDataObject* source)
{
  SkdBooleanBlocks blocks{ SkdBlocksOf(input), 0, SkdIsComposite(input) || SkdIsComposite(source) };
  blocks.FirstOfSource = static_cast<int>(blocks.All.size());
  const std::vector<SkdBlock> others = SkdBlocksOf(source);
  blocks.All.insert(blocks.All.end(), others.begin(), others.end());
  return blocks;
}

constexpr const char* OrientAdvice =
  " Orient the faces (Generate Surface Normals with Consistency).";

// What was tried on scans: vtkFillHolesFilter fills some holes in part, and its faces may be
// turned.
constexpr const char* CloseAdvice =
  " Close the holes, for example by vtkFillHolesFilter with a HoleSize larger than the surface, "
  "again and again until no edge is open, and then orient the faces (Generate Surface Normals with "
  "Consistency). If edges remain (Feature Edges shows them), repair the surface where they are, in "
  "another program. An open surface can be the Source of an intersection or a difference, which it "
  "then cuts.";

void TellNotFound(Filter* self)
{
  vtkErrorWithObjectMacro(self,
    "Which regions are inside could not be found; there is no output. Please report "
    "this, with the inputs.");
}

std::string TextOf(const skd::Vector3& x)
{
  std::ostringstream text;
  text << "(" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  return text.str();
}
}

/// The arrangement of the inputs, and the solids that its regions are in: kept while the inputs are
/// unchanged.
class vtkSkdTreeBooleanOperation::Internals
{
public:
  /// Splits the surfaces along all their intersections, unless that is done. False after an abort.
  bool Arrange(Filter* self, const SkdBooleanBlocks& blocks);

  /// Finds out which triangles bound which solid: the two inputs; or, without a Source or if the
  /// operation counts solids, the blocks if there are several, else the pieces.
  void FindSolids(const SkdBooleanBlocks& blocks, bool areInputs);

  void WarnOfNoFaces(Filter* self, const SkdBooleanBlocks& blocks) const;

  /// Whether all surfaces have an inside; else an error tells which one has not. The Source may be
  /// open (a sheet) in operations that have a use for it.
  bool AreClosed(Filter* self) const;

  /// Finds out which solids each region is in, unless that is done. False, with an error, if it
  /// could not.
  bool FindWindings(Filter* self);

  /// The faces of the output.
  SkdFacetSigns Select(Filter* self) const;

  /// These as they are stored; nothing if that makes no difference.
  std::optional<SkdRoundedFacets> Round(Filter* self, const SkdFacetSigns& signs) const;

  SkdBooleanRule GetRule(Filter* self) const
  {
    return { static_cast<SkdBooleanOperation>(self->GetOperation()),
      static_cast<SkdInsideRule>(self->GetInsideRule()), this->Solids.Count,
      static_cast<std::uint32_t>(self->GetMinimumNumberOfSolids()) };
  }

  void Fill(Filter* self, const SkdBooleanBlocks& blocks, const SkdFacets& facets,
    const SkdFacetSigns& signs, vtkPolyData* output) const;
  void Report(
    Filter* self, const SkdFacets& facets, const SkdFacetSigns& signs, SkdReport& report) const;

  /// The volume and area of what is within solids.
  template <class IsSolid>
  SkdBoundaryMeasures Measure(const IsSolid& isSolid) const
  {
    return this->Measure(SkdFindBoundary(this->Arrangement, this->Windings, isSolid));
  }
  SkdBoundaryMeasures Measure(const SkdFacetSigns& signs) const;

  SkdTriangleSet Set;
  bool IsNew = false;                    // in this run
  std::optional<SkdPlacement> Placement; // none: not arranged
  SkdArrangement Arrangement;
  std::vector<std::uint32_t> EqualPoints; // see SkdFindEqualPoints
  SkdSolids Solids;
  bool AreInputs = false; // the solids
  std::vector<SkdBadEdges> BadEdges;
  std::vector<SkdRegionWindings> Windings; // empty: not known

private:
  bool PlaceSheet(Filter* self);
  std::string NameOf(std::uint32_t solid) const
  {
    const char* inputs[2] = { "Input", "Source" };
    return this->AreInputs ? inputs[solid] : "Solid " + std::to_string(solid);
  }
  bool IsSheet(std::uint32_t solid) const
  {
    return this->AreInputs && solid == 1 && this->BadEdges[1].Count > 0;
  }
  std::string LeftOutText() const
  {
    const vtkIdType count = this->Set.GetNumberOfFacesLeftOut();
    return count == 0 ? ""
                      : " " + std::to_string(count) +
        " faces are left out: they have points that are not finite, or fewer than three.";
  }
  std::string EdgeText(const SkdSplitEdge& edge) const
  {
    const double unscaled = 1.0 / this->Placement->Scale;
    const auto at = [&](std::uint32_t point) {
      return TextOf(unscaled * this->Arrangement.Facets.GetPosition(this->Placement->First, point));
    };
    return at(edge.first) + " to " + at(edge.second);
  }
};

bool vtkSkdTreeBooleanOperation::Internals::Arrange(Filter* self, const SkdBooleanBlocks& blocks)
{
  this->IsNew = this->Set.Update(blocks.All, self->GetChordalDeviation());
  if (!this->IsNew && this->Placement)
  {
    return true;
  }
  this->Placement.reset();
  this->Windings.clear();
  this->Solids = {};
  this->Set.LeaveOutCopies(1);
  SkdPlacement placement = SkdMakePlacement(this->Set, nullptr, std::nullopt);
  SkdLoop loop(self, 0, 0.2, 0.6, 8);
  const SkdPairSearch search{ SkdPairSearch::All, 0.0 };
  auto pairs = SkdTrianglePairs(placement).FindSelfIntersections(search, loop);
  if (!pairs)
  {
    this->Set.Complete();
    pairs = SkdTrianglePairs(placement).FindByTrees(search, loop);
  }
  if (SkdIsAborted(self))
  {
    return false;
  }
  SkdLoop splitLoop(self, 0, 0.6, 0.8, 64);
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

void vtkSkdTreeBooleanOperation::Internals::FindSolids(
  const SkdBooleanBlocks& blocks, bool areInputs)
{
  SkdSolids solids =
    areInputs ? SkdSolidsByInput(this->Set, blocks.FirstOfSource) : SkdSolidsByBlock(this->Set);
  if (!areInputs && solids.Count < 2)
  {
    solids = SkdSolidsByPiece(this->Set);
  }
  if (this->Windings.empty() || solids.Of != this->Solids.Of)
  {
    this->Solids = std::move(solids);
    this->AreInputs = areInputs;
    this->Windings.clear();
    this->BadEdges = SkdFindBadEdges(this->Arrangement.Facets, this->Solids.Of, this->Solids.Count);
  }
}

void vtkSkdTreeBooleanOperation::Internals::WarnOfNoFaces(
  Filter* self, const SkdBooleanBlocks& blocks) const
{
  for (const bool isSource : { false, true })
  {
    const auto isOfInput = [&](int block) { return (block >= blocks.FirstOfSource) == isSource; };
    bool hasCells = false;
    for (int block = 0; block < static_cast<int>(blocks.All.size()); ++block)
    {
      hasCells = hasCells || (isOfInput(block) && blocks.All[block].Mesh->GetNumberOfCells() > 0);
    }
    const auto& cells = this->Set.GetCells();
    const bool hasFaces = std::any_of(cells.begin(), cells.end(),
      [&](const SkdTriangleSet::Cell& cell) { return isOfInput(cell.Block); });
    if (hasCells && !hasFaces)
    {
      vtkWarningWithObjectMacro(
        self, << (isSource ? "Source" : "Input") << " has no faces; it is taken as empty.");
    }
  }
}

bool vtkSkdTreeBooleanOperation::Internals::AreClosed(Filter* self) const
{
  const bool maySheet = self->GetOperation() == INTERSECTION || self->GetOperation() == DIFFERENCE;
  for (std::uint32_t solid = 0; solid < this->Solids.Count; ++solid)
  {
    const SkdBadEdges& bad = this->BadEdges[solid];
    if (bad.Count > 0 && !(maySheet && this->IsSheet(solid)))
    {
      vtkErrorWithObjectMacro(self,
        << this->NameOf(solid) << " is not a closed, consistently oriented surface: " << bad.Open
        << " edges are open and " << bad.Count - bad.Open
        << " are between faces of opposite orientation, the first from "
        << this->EdgeText(bad.First) << ". There is no output."
        << (bad.Open > 0 ? CloseAdvice : OrientAdvice) << this->LeftOutText());
      return false;
    }
  }
  return true;
}

bool vtkSkdTreeBooleanOperation::Internals::FindWindings(Filter* self)
{
  if (!this->Windings.empty())
  {
    return true;
  }
  this->Windings = SkdFindWindingNumbers(*this->Placement, this->Arrangement, this->Solids.Of);
  if (this->Windings.size() < this->Arrangement.NumberOfRegions)
  {
    TellNotFound(self);
    return false;
  }
  return !this->IsSheet(1) || this->PlaceSheet(self);
}

bool vtkSkdTreeBooleanOperation::Internals::PlaceSheet(Filter* self)
{
  const std::vector<std::uint32_t> parts =
    SkdFindPartsOfSpace(*this->Placement, this->Arrangement, this->Solids.Of);
  if (parts.empty())
  {
    this->Windings.clear();
    TellNotFound(self);
    return false;
  }
  const SkdSheetFaults faults = SkdPlaceSheet(
    this->Placement->First, this->Arrangement, parts, this->Solids.Of, 1, this->Windings);
  if (faults.Undivided > 0)
  {
    vtkWarningWithObjectMacro(
      self, << "The Source is open and does not cut through the Input: " << faults.Undivided
            << " parts of the Input have some of it within. That cuts "
               "nothing off. Extend the Source or close it.");
  }
  if (faults.Contradictory > 0)
  {
    vtkWarningWithObjectMacro(self, << "The Source is open, and " << faults.Contradictory
                                    << " parts of the Input are both in front of it and behind; "
                                       "they are taken as in front. Orient its faces "
                                       "(Generate Surface Normals with Consistency).");
  }
  return true;
}

SkdFacetSigns vtkSkdTreeBooleanOperation::Internals::Select(Filter* self) const
{
  const SkdFacets& facets = this->Arrangement.Facets;
  if (self->GetOperation() == IMPRINT)
  {
    return SkdFacetSigns(facets.GetNumberOfFacets(), 1);
  }
  const SkdBooleanRule rule = this->GetRule(self);
  SkdFacetSigns signs = SkdFindBoundary(this->Arrangement, this->Windings,
    [&rule](const SkdRegionWindings& windings) { return rule.IsSolid(windings); });
  if (this->AreInputs && this->IsSheet(1) && !self->GetCloseCut())
  {
    for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
    {
      const bool isOfSheet = this->Solids.Of[facets.Parents[facet]] == 1; // the lowest layer
      signs[facet] = isOfSheet ? static_cast<signed char>(0) : signs[facet];
    }
  }
  return signs;
}

std::optional<SkdRoundedFacets> vtkSkdTreeBooleanOperation::Internals::Round(
  Filter* self, const SkdFacetSigns& signs) const
{
  return this->EqualPoints.empty()
    ? std::nullopt
    : std::make_optional(SkdUniteEqualPoints(
        this->Arrangement.Facets, this->EqualPoints, signs, self->GetOperation() == IMPRINT));
}

SkdBoundaryMeasures vtkSkdTreeBooleanOperation::Internals::Measure(const SkdFacetSigns& signs) const
{
  SkdBoundaryMeasures measures =
    SkdMeasureBoundary(this->Placement->First, this->Arrangement.Facets, signs);
  measures.Area /= std::pow(this->Placement->Scale, 2);
  measures.Volume /= std::pow(this->Placement->Scale, 3);
  return measures;
}

void vtkSkdTreeBooleanOperation::Internals::Fill(Filter* self, const SkdBooleanBlocks& blocks,
  const SkdFacets& facets, const SkdFacetSigns& signs, vtkPolyData* output) const
{
  const SkdBooleanRule rule = this->GetRule(self);
  const bool isImprint = rule.Operation == SkdBooleanOperation::Imprint;
  std::vector<int> counts(isImprint ? this->Windings.size() : 0);
  for (std::size_t region = 0; region < counts.size(); ++region)
  {
    counts[region] = static_cast<int>(rule.CountSolids(this->Windings[region]));
  }
  std::set<std::string> refused;
  SkdFillBooleanSurface(
    { *this->Placement, this->Arrangement, facets, blocks, signs,
      this->AreInputs ? nullptr : &this->Solids, counts.empty() ? nullptr : &counts,
      self->GetKeepPolygons() != 0, self->GetMergePieces() != 0 && !isImprint },
    output, refused);
  for (const char* name : SkdBooleanNames::All)
  {
    refused.erase(name); // of an operation before: its ids are of other inputs
  }
  SkdWarnAboutRefused(self, refused);
}

void vtkSkdTreeBooleanOperation::Internals::Report(
  Filter* self, const SkdFacets& facets, const SkdFacetSigns& signs, SkdReport& report) const
{
  const SkdBooleanRule rule = this->GetRule(self);
  const auto add = [&report](const std::string& what, const SkdBoundaryMeasures& measures)
  {
    report.AddMeasure(what + "Volume", measures.Volume);
    report.AddMeasure(what + "Area", measures.Area);
  };
  const auto isInput = [&](const SkdRegionWindings& windings)
  { return this->AreInputs ? rule.IsInside(windings, 0) : rule.CountSolids(windings) > 0; };
  if (!this->Windings.empty())
  {
    add("Input", this->Measure(isInput));
  }
  if (this->AreInputs && !this->IsSheet(1))
  {
    add("Source",
      this->Measure([&](const SkdRegionWindings& windings) { return rule.IsInside(windings, 1); }));
  }
  report.AddCount("TreesBuilt", this->IsNew);
  report.AddCount("Solids", this->Solids.Count);
  if (this->IsSheet(1))
  {
    report.AddCount("OpenEdges", this->BadEdges[1].Count);
  }
  if (self->GetOperation() == IMPRINT)
  {
    return;
  }
  add("", this->Measure(signs));
  const SkdBadEdges bad = SkdFindBadEdges(facets, signs);
  report.AddCount("BadEdges", bad.Count);
  if (bad.Count > 0 && !(this->IsSheet(1) && !self->GetCloseCut()))
  {
    vtkWarningWithObjectMacro(
      self, << "The output is not closed: " << bad.Count << " edges are open, the first from "
            << this->EdgeText(bad.First) << ". Please report this, with the inputs.");
  }
}

vtkSkdTreeBooleanOperation::vtkSkdTreeBooleanOperation()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Optional, { VTK_POLY_DATA })
  , Impl(new Internals)
{
  this->WholeInput = true; // all of it bounds the solid
  this->AnyMagnitude = true;
}

vtkSkdTreeBooleanOperation::~vtkSkdTreeBooleanOperation() = default;

int vtkSkdTreeBooleanOperation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (SkdIsLaterPiece(outputVector->GetInformationObject(0)))
  {
    return 1; // the first piece has all
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  SkdStopwatch watch;
  Internals& own = *this->Impl;
  const SkdBooleanBlocks blocks = BlocksOf(vtkDataObject::GetData(inputVector[0]), source);
  if (!own.Arrange(this, blocks))
  {
    return 1;
  }
  SkdWarnAboutCoarseFaces(this, own.Set.GetNumberOfCoarseFaces(), this->ChordalDeviation);
  SkdWarnAboutTinyPoints(this, *own.Placement);
  own.WarnOfNoFaces(this, blocks);
  own.FindSolids(blocks, source && this->Operation != AT_LEAST);
  if (this->Operation != IMPRINT && !own.AreClosed(this))
  {
    return 1;
  }
  const bool areAllClosed = std::all_of(own.BadEdges.begin(), own.BadEdges.end(),
    [](const SkdBadEdges& bad) { return bad.Count == 0; });
  if ((this->Operation != IMPRINT || areAllClosed) && !own.FindWindings(this))
  {
    return 1;
  }
  const SkdFacetSigns selected = own.Select(this);
  const std::optional<SkdRoundedFacets> rounded = own.Round(this, selected);
  const SkdFacets& facets = rounded ? rounded->Facets : own.Arrangement.Facets;
  const SkdFacetSigns& signs = rounded ? rounded->Signs : selected;
  own.Fill(this, blocks, facets, signs, output);
  SkdReport report(output);
  own.Report(this, facets, signs, report);
  report.AddCount("TrianglesFolded", rounded ? rounded->NumberFolded : 0);
  report.AddCount("TrianglesSplit", own.Arrangement.NumberSplit);
  report.AddMeasure("Seconds", watch.Lap());
  return 1;
}

void vtkSkdTreeBooleanOperation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Operation", this->Operation, "MinimumNumberOfSolids",
    this->MinimumNumberOfSolids, "InsideRule", this->InsideRule, "KeepPolygons", this->KeepPolygons,
    "MergePieces", this->MergePieces, "CloseCut", this->CloseCut, "ChordalDeviation",
    this->ChordalDeviation);
}
VTK_ABI_NAMESPACE_END
