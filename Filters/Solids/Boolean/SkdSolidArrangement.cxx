// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSolidArrangement.h"

#include "Exchange/SkdAskOthers.h"
#include "Pipeline/SkdLoop.h"
#include "Solids/Boolean/SkdAlignFaces.h"
#include "Solids/Boolean/SkdBooleanNames.h"
#include "Solids/Boolean/SkdJoinPieces.h"
#include "Solids/Boolean/SkdSlivers.h"
#include "Solids/Boolean/SkdSpreadSolids.h"
#include "Solids/Boolean/SkdSpreadWindings.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace skdtree
{
namespace
{
/// Segments meet each other more often than this for each pair of triangles where solids overlap
/// deeply; `FewEvents` are few in any case.
constexpr std::size_t EventsOfPair = 1;
constexpr std::size_t FewEvents = 5000;

/// As a rule there is that number of pairs for each triangle only where solids overlap deeply, but
/// also where thin ones cross each other.
constexpr std::size_t PairsOfTriangle = 2;

constexpr skd::RigidMotion NoMotion{ { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } },
  { { 0, 0, 0 } } };

/// A bound of what a motion's arithmetic does to a coordinate.
double RoundingOf(
  const SkdTriangleSet& from, const SkdTriangleSet& to, const skd::RigidMotion& motion)
{
  const double largest =
    from.GetLargestCoordinate() + to.GetLargestCoordinate() + Norm(motion.Shift);
  return 8.0 * std::numeric_limits<double>::epsilon() * largest;
}

bool AreSame(const skd::RigidMotion& a, const skd::RigidMotion& b)
{
  return std::equal(std::begin(a.Rows), std::end(a.Rows), std::begin(b.Rows)) && a.Shift == b.Shift;
}

/// Whether an operation is on two solids, of which no two triangles are of one face.
bool MayBeNear(const SkdBooleanBlocks& blocks, SkdBooleanOperation operation)
{
  return operation != SkdBooleanOperation::AtLeast && operation != SkdBooleanOperation::Imprint &&
    operation != SkdBooleanOperation::Split &&
    std::none_of(blocks.All.begin(), blocks.All.end(),
      [](const SkdBlock& block)
      { return block.Mesh->GetCellData()->HasArray(SkdBooleanNames::Face); });
}
}

/// Whether they have changed.
bool SkdSolidArrangement::Read(
  const SkdBooleanBlocks& blocks, double chordalDeviation, SkdTriangleSet& to)
{
  const bool isToBeAligned = blocks.AlignsFaces && !this->Spread;
  if (isToBeAligned != this->IsAligned)
  {
    to = SkdTriangleSet();
    this->IsAligned = isToBeAligned;
  }
  const bool isRead = to.Update(blocks.All, chordalDeviation);
  if (isRead)
  {
    this->CoordinateBits =
      this->Spread ? this->Spread->GetCoordinateBits() : SkdCoordinateBits(blocks.All);
    this->NumberAligned = this->IsAligned ? SkdAlignFaces(this->CoordinateBits, to) : 0;
  }
  return isRead;
}

/// Whether they have changed; nothing if points are no longer finite. Arranges what is near, or
/// moves all.
std::optional<bool> SkdSolidArrangement::UpdateTriangles(
  const SkdBooleanBlocks& blocks, double chordalDeviation, bool mayBeNear, vtkAlgorithm* filter)
{
  if (!blocks.Motion && !this->AsRead)
  {
    return this->Read(blocks, chordalDeviation, this->Triangles);
  }
  bool hasChanged = !this->AsRead || blocks.FirstOfSource != this->FirstOfSource;
  if (!this->AsRead)
  {
    this->AsRead.emplace();
  }
  hasChanged = this->Read(blocks, chordalDeviation, *this->AsRead) || hasChanged;
  if (hasChanged)
  {
    this->OfInput = {};
    this->ForgetArrangement();
    this->Pair.reset();
    this->PairTries = 0;
  }
  if (hasChanged && !blocks.Motion)
  {
    this->AsRead.reset();
    this->Triangles = SkdTriangleSet();
    return this->Read(blocks, chordalDeviation, this->Triangles);
  }
  const skd::RigidMotion motion = blocks.Motion.value_or(NoMotion);
  const bool isAtRest = !hasChanged && this->Motion && AreSame(motion, *this->Motion);
  if (isAtRest && (mayBeNear || !this->Near))
  {
    return false;
  }
  this->FirstOfSource = blocks.FirstOfSource;
  if (!hasChanged && mayBeNear && this->ArrangeNear(blocks, motion, filter))
  {
    this->Motion = motion;
    return true;
  }
  this->ForgetArrangement();
  auto moved = this->AsRead->Moved(blocks.FirstOfSource, motion);
  this->Motion = motion;
  if (!moved)
  {
    this->Motion.reset();
    return std::nullopt;
  }
  this->Triangles = *std::move(moved);
  this->OfInput.Rounding = RoundingOf(*this->AsRead, this->Triangles, motion);
  this->OfInput.Known.End = SkdFirstTriangleOf(this->Triangles, blocks.FirstOfSource);
  return true;
}

void SkdSolidArrangement::ForgetArrangement()
{
  this->Near.reset();
  this->Placement.reset();
  this->Windings.clear();
  this->Sides.clear();
  this->Solids = {};
  this->Combined.reset();
}

/// Once the Source has moved, before all that is known of where it was is given up.
bool SkdSolidArrangement::PreparePair(const SkdBooleanBlocks& blocks, vtkAlgorithm* filter)
{
  constexpr int most = 3; // times: where they are may be the reason why it fails
  const bool areClosed = std::all_of(this->BadEdges.begin(), this->BadEdges.end(),
    [](const SkdBadEdges& bad) { return bad.Count == 0; });
  if (this->Pair || this->PairTries == most || !this->Motion || !this->Placement ||
    this->Combined || this->Near || !this->AreInputs || this->Solids.Count != 2 || !areClosed)
  {
    return this->Pair != nullptr;
  }
  const auto& rows = this->Motion->Rows;
  const SkdPairState state{ *this->AsRead, blocks.FirstOfSource, *this->Placement,
    this->Arrangement, this->Windings, Dot(Cross(rows[0], rows[1]), rows[2]) < 0.0 };
  this->Pair = SkdRigidPair::Make(state, this->Triangles, this->OfInput, filter);
  ++this->PairTries;
  return this->Pair != nullptr;
}

/// False if all is to be arranged.
bool SkdSolidArrangement::ArrangeNear(
  const SkdBooleanBlocks& blocks, const skd::RigidMotion& motion, vtkAlgorithm* filter)
{
  if (!this->PreparePair(blocks, filter))
  {
    return false;
  }
  this->ForgetArrangement();
  if (!this->Pair->Move(motion) ||
    !(RoundingOf(*this->AsRead, this->Pair->GetSet(), motion) <= this->Pair->GetMostRounding()))
  {
    return false;
  }
  this->Placement.emplace(SkdMakePlacement(this->Pair->GetSet(), nullptr, std::nullopt));
  if (this->Placement->Scale == 1.0 && !this->Placement->HasTinyPoints)
  {
    const std::size_t n = this->Pair->GetSet().GetTriangles().size();
    const SkdNearLimits limits{ std::max(FewEvents, PairsOfTriangle * n), FewEvents };
    this->Near = SkdNearArrangement::Make(*this->Pair, *this->Placement, limits, filter);
  }
  return this->Near != nullptr;
}

bool SkdSolidArrangement::Update(const SkdBooleanBlocks& blocks, double chordalDeviation,
  bool areInputs, const SkdBooleanRule& rule, vtkAlgorithm* filter)
{
  const bool mayBeNear = areInputs && MayBeNear(blocks, rule.Operation);
  const std::optional<bool> hasChanged =
    this->UpdateTriangles(blocks, chordalDeviation, mayBeNear, filter);
  if (!hasChanged)
  {
    vtkErrorWithObjectMacro(
      filter, "The Source is moved to where coordinates are not finite; there is no output.");
    return false;
  }
  if (this->Spread && blocks.AlignsFaces &&
    SkdHasFacesToAlign(
      this->CoordinateBits, this->Triangles, this->Spread->ListInContact(this->Triangles)))
  {
    this->ForgetArrangement();
    return false; // faces may be those of other processes, too
  }
  this->WasSplit = *hasChanged;
  const auto findFaces = [&]
  {
    this->Faces.Update(*this->Placement, blocks.All, SkdBooleanNames::Face,
      { std::begin(SkdBooleanNames::All), std::end(SkdBooleanNames::All) });
  };
  if (this->Near)
  {
    findFaces();
    return true;
  }
  this->Triangles.LeaveOutCopies(1);
  if (!this->WasSplit && this->Placement && !this->Combined)
  {
    findFaces(); // the data may have changed
    return true;
  }
  this->WasSplit = true;
  this->ForgetArrangement();
  this->Placement.emplace(SkdMakePlacement(this->Triangles, nullptr, std::nullopt));
  findFaces();
  if (!this->Arrange(this->MakeSolids(blocks, areInputs), areInputs, rule, filter))
  {
    this->Placement.reset();
  }
  return this->Placement.has_value();
}

/// False if these solids cannot be combined so; true also after an abort, and pairs are freed.
bool SkdSolidArrangement::CombineInPairs(const SkdSolids& solids, bool areInputs,
  const SkdBooleanRule& rule, SkdSelfPairs& pairs, vtkAlgorithm* filter)
{
  const auto findWithin = [&](const std::vector<std::uint32_t>& pieceOf)
  {
    SkdLoop loop(filter, 0, 0.6, 0.6, 64);
    return pairs.AreSome ? SkdFindPairsWithin(this->Triangles, *this->Placement, pieceOf, loop)
                         : pairs.Pairs;
  };
  if (const auto operands = SkdFindOperands(this->Triangles, solids, areInputs, rule, findWithin))
  {
    pairs.Pairs = std::vector<SkdTrianglePair>();
    this->Combined = SkdCombineInPairs(*this->Placement, this->Faces, *operands, rule, filter);
  }
  return this->Combined || SkdIsAborted(filter);
}

std::optional<SkdSelfPairs> SkdSolidArrangement::FindPairs(std::size_t most, vtkAlgorithm* filter)
{
  SkdLoop loop(filter, 0, 0.2, 0.6, 8);
  if (!this->Spread)
  {
    return SkdFindSelfPairs(this->Triangles, *this->Placement, loop, filter,
      this->AsRead ? &this->OfInput : nullptr, most);
  }
  const std::vector<std::uint32_t> among = this->Spread->ListInContact(this->Triangles);
  return among.empty()
    ? SkdSelfPairs()
    : SkdFindSelfPairs(this->Triangles, *this->Placement, loop, filter, nullptr, most, &among);
}

bool SkdSolidArrangement::Arrange(
  const SkdSolids& solids, bool areInputs, const SkdBooleanRule& rule, vtkAlgorithm* filter)
{
  constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  const bool mayCombine = SkdCanCombineInPairs(rule.Operation, areInputs);
  const std::size_t dense = mayCombine
    ? std::max(FewEvents, PairsOfTriangle * this->Triangles.GetTriangles().size())
    : unlimited;
  SkdLoop splitLoop(filter, 0, 0.6, 0.8, 64);
  bool isCrowd = false;
  auto pairs = this->FindPairs(dense, filter);
  if (pairs && (pairs->AreSome || pairs->Pairs.size() > dense))
  {
    isCrowd =
      this->Spread || SkdSegmentsMeetOften(*this->Placement, dense, EventsOfPair, splitLoop);
    pairs = pairs->AreSome && !isCrowd ? this->FindPairs(unlimited, filter) : std::move(pairs);
  }
  if (!pairs)
  {
    return false;
  }
  std::optional<SkdArrangement> arrangement(SkdArrangement{ {}, {}, 0, 0, true });
  if (!isCrowd) // else to look at segments would be in vain
  {
    const std::size_t few = mayCombine ? EventsOfPair * pairs->Pairs.size() + FewEvents : unlimited;
    arrangement = SkdArrange(*this->Placement, *pairs, splitLoop, few, this->Spread != nullptr);
  }
  if (arrangement && arrangement->IsCrowd)
  {
    if (this->Spread)
    {
      return false;
    }
    if (this->CombineInPairs(solids, areInputs, rule, *pairs, filter))
    {
      this->Arrangement = *std::move(arrangement);
      this->EqualPoints.clear();
      return this->Combined.has_value();
    }
    pairs = pairs->AreSome ? this->FindPairs(unlimited, filter) : std::move(pairs);
    arrangement = pairs ? SkdArrange(*this->Placement, *pairs, splitLoop) : std::nullopt;
  }
  if (!arrangement)
  {
    return false;
  }
  this->Arrangement = *std::move(arrangement);
  this->EqualPoints = SkdFindEqualPoints(*this->Placement, this->Arrangement.Facets);
  return true;
}

SkdSolids SkdSolidArrangement::MakeSolids(const SkdBooleanBlocks& blocks, bool areInputs) const
{
  SkdSolids solids = areInputs ? SkdSolidsByInput(this->Triangles, blocks.FirstOfSource)
                               : SkdSolidsByBlock(this->Triangles, blocks.All.size());
  return areInputs || solids.Count >= 2 ? solids : SkdSolidsByPiece(this->Triangles);
}

void SkdSolidArrangement::FindSolids(const SkdBooleanBlocks& blocks, bool areInputs)
{
  if (this->Near)
  {
    this->Solids.Count = 2;
    this->AreInputs = true;
    this->BadEdges.assign(2, SkdBadEdges());
    return;
  }
  SkdSolids solids = this->MakeSolids(blocks, areInputs);
  if (this->Windings.empty() || areInputs != this->AreInputs || solids.Of != this->Solids.Of)
  {
    this->Solids = std::move(solids);
    this->AreInputs = areInputs;
    this->Windings.clear();
    this->Sides.clear();
    this->BadEdges = this->Spread
      ? std::vector<SkdBadEdges>(this->Solids.Count)
      : SkdFindBadEdges(this->Arrangement.Facets, this->Solids.Of, this->Solids.Count);
  }
}

std::optional<std::uint32_t> SkdSolidArrangement::FindUnclosed(SkdBooleanOperation operation) const
{
  const bool usesSheet = operation == SkdBooleanOperation::Intersection ||
    operation == SkdBooleanOperation::Difference || operation == SkdBooleanOperation::Split;
  for (std::uint32_t solid = 0; solid < this->Solids.Count; ++solid)
  {
    if (this->BadEdges[solid].Count > 0 && !this->AreRounded &&
      !(usesSheet && this->IsSheet(solid)))
    {
      return solid;
    }
  }
  return std::nullopt;
}

std::optional<SkdSheetFaults> SkdSolidArrangement::FindWindings()
{
  if (this->Spread)
  {
    return this->FindWindingsOverAll() ? std::make_optional(SkdSheetFaults()) : std::nullopt;
  }
  if (!this->Windings.empty() || this->Combined || this->Near)
  {
    return SkdSheetFaults();
  }
  this->Windings = SkdFindWindingNumbers(*this->Placement, this->Arrangement, this->Solids.Of);
  if (this->Windings.size() < this->Arrangement.NumberOfRegions)
  {
    return std::nullopt;
  }
  this->FindSides();
  return this->IsSheet(1) ? this->PlaceSheet() : SkdSheetFaults();
}

/// Whether they were found on all processes.
bool SkdSolidArrangement::FindWindingsOverAll()
{
  SkdSpreadWindings others(*this->Transport, this->Placement->First, this->Solids.Of);
  this->Windings = SkdFindWindingNumbers(*this->Placement, this->Arrangement, this->Solids.Of,
    [&others](const auto& positions, bool isOpen) { return others.Ask(positions, isOpen); });
  const bool isFound = this->Windings.size() == this->Arrangement.NumberOfRegions;
  return SkdMostOf(*this->Transport, isFound ? 0 : 1) == 0;
}

void SkdSolidArrangement::SetRoundsNumbers(bool rounds)
{
  if (this->AreRounded != rounds)
  {
    this->AreRounded = rounds;
    this->Windings.clear();
  }
}

vtkIdType SkdSolidArrangement::CountRoundedEdges() const
{
  vtkIdType count = 0;
  for (const SkdSideNumbers& sides : this->Sides)
  {
    count += this->BadEdges[sides.Surface].Count;
  }
  return count;
}

void SkdSolidArrangement::FindSides()
{
  this->Sides.clear();
  for (std::uint32_t solid = 0; this->AreRounded && solid < this->Solids.Count; ++solid)
  {
    if (this->BadEdges[solid].Count > 0)
    {
      this->Sides.push_back(
        SkdFindSideNumbers(this->Placement->First, this->Arrangement, this->Solids.Of, solid));
    }
  }
}

SkdRegionWindings SkdSolidArrangement::WindingsAt(std::uint32_t facet, bool isBehind) const
{
  SkdRegionWindings windings =
    this->Windings[isBehind ? this->Arrangement.GetBack(facet) : this->Arrangement.GetFront(facet)];
  for (const SkdSideNumbers& sides : this->Sides)
  {
    windings.erase(std::remove_if(windings.begin(), windings.end(),
                     [&sides](const SkdWindingOf& of) { return of.Surface == sides.Surface; }),
      windings.end());
    const SkdWindingOf winding{ sides.Surface, sides.Get(facet, isBehind) };
    if (winding.Number != 0)
    {
      windings.insert(std::lower_bound(windings.begin(), windings.end(), winding), winding);
    }
  }
  return windings;
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

SkdBooleanBoundary SkdSolidArrangement::Select(
  const SkdBooleanRule& rule, bool closesCut, bool joins)
{
  if (this->Near)
  {
    SkdNearBoundary near = this->Near->Select(rule, joins, this->Faces);
    return { {}, std::move(near.Facets), std::nullopt, near.Bad, near.Measures };
  }
  SkdBooleanBoundary boundary = this->SelectPieces(rule, closesCut);
  if (rule.Operation == SkdBooleanOperation::Imprint)
  {
    return boundary;
  }
  if (boundary.Rounded)
  {
    boundary.Bad =
      SkdFindBadEdges(this->Placement->First, boundary.Rounded->Facets, boundary.Rounded->Signs);
  }
  if (joins)
  {
    boundary.Joined = SkdJoinPieces(*this->Placement, boundary.GetFacets(this->Arrangement),
      boundary.GetSigns(), {}, this->Faces, boundary.Rounded ? &*boundary.Rounded : nullptr);
  }
  return boundary;
}

SkdBooleanBoundary SkdSolidArrangement::SelectPieces(
  const SkdBooleanRule& rule, bool closesCut) const
{
  if (this->Combined)
  {
    return { {}, this->Combined->Boundary, std::nullopt, std::nullopt, std::nullopt };
  }
  const SkdFacets& facets = this->Arrangement.Facets;
  const bool isImprint = rule.Operation == SkdBooleanOperation::Imprint;
  SkdBooleanBoundary boundary;
  SkdFacetSigns& signs = boundary.Selected;
  signs = isImprint ? SkdFacetSigns(facets.GetNumberOfFacets(), 1)
                    : this->FindSigns([&rule](const SkdRegionWindings& windings)
                        { return rule.IsSolid(windings); });
  for (std::uint32_t facet = 0;
       !isImprint && !closesCut && this->IsSheet(1) && facet < signs.size(); ++facet)
  {
    const bool isOfSheet = this->Solids.Of[facets.Parents[facet]] == 1; // the lowest layer
    signs[facet] = isOfSheet ? static_cast<signed char>(0) : signs[facet];
  }
  if (!this->EqualPoints.empty())
  {
    boundary.Rounded =
      SkdUniteEqualPoints(SkdMakeRounded(facets, signs), this->EqualPoints, isImprint);
  }
  if (!isImprint)
  {
    SkdRemoveSlivers(*this->Placement, facets, signs, boundary.Rounded);
  }
  return boundary;
}

int SkdSolidArrangement::CountParts(const SkdBooleanRule& rule) const
{
  int last = 0;
  const auto look = [&](const SkdRegionWindings& windings)
  { last = std::max(last, rule.PartOf(windings)); };
  if (this->Sides.empty())
  {
    std::for_each(this->Windings.begin(), this->Windings.end(), look);
    return last + 1;
  }
  for (std::uint32_t facet = 0; facet < this->Arrangement.Facets.GetNumberOfFacets(); ++facet)
  {
    look(this->WindingsAt(facet, true));
    look(this->WindingsAt(facet, false));
  }
  return last + 1;
}

SkdFacetSigns SkdSolidArrangement::FindSection(
  const SkdBooleanBoundary& boundary, const SkdBooleanRule& rule) const
{
  // Between two parts behind a sheet, what bounds the farther one from in front is of the section.
  const bool isOfOneSide = rule.Operation == SkdBooleanOperation::Split && rule.HasSheet;
  const SkdFacets& facets = boundary.GetFacets(this->Arrangement);
  SkdFacetSigns section = boundary.GetSigns();
  for (std::uint32_t facet = 0; facet < section.size(); ++facet)
  {
    const bool isOfSource = this->Solids.Of[facets.Parents[facet]] == 1;
    section[facet] = isOfSource && (isOfOneSide ? section[facet] > 0 : section[facet] != 0);
  }
  return section;
}

SkdBoundaryMeasures SkdSolidArrangement::Measure(
  const SkdFacets& facets, const SkdFacetSigns& signs) const
{
  SkdBoundaryMeasures measures = SkdMeasureBoundary(this->Placement->First, facets, signs,
    this->Spread ? std::make_optional(this->Spread->GetCenter()) : std::nullopt);
  measures.Area /= std::pow(this->Placement->Scale, 2);
  measures.Volume /= std::pow(this->Placement->Scale, 3);
  return measures;
}

std::string SkdSolidArrangement::NameOf(std::uint32_t solid) const
{
  const char* inputs[2] = { "Input", "Source" };
  return this->AreInputs ? inputs[solid] : "Solid " + std::to_string(solid);
}

std::string SkdSolidArrangement::TextOf(const SkdSplitEdge& edge, const SkdFacets& facets) const
{
  std::ostringstream text;
  for (const std::uint32_t point : { edge.first, edge.second })
  {
    const skd::Vector3 x =
      (1.0 / this->Placement->Scale) * facets.GetPosition(this->Placement->First, point);
    text << (point == edge.first ? "" : " to ") << "(" << x[0] << ", " << x[1] << ", " << x[2]
         << ")";
  }
  return text.str();
}
}
