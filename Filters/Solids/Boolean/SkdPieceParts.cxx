// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdPieceParts.h"

#include "Solids/Boolean/SkdFacingFacets.h"
#include "Solids/Boolean/SkdRoundedPlane.h"

#include <numeric>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;

/// Items, ascending. They are so by their points first, of which few items have each: they are
/// dealt out to these, and then sorted there. `forEach(add)` calls add(item) for each, the same
/// again.
template <class Item, class ForEach, class PointOf>
std::vector<Item> ListByPoint(
  std::size_t count, std::size_t numberOfPoints, const ForEach& forEach, const PointOf& pointOf)
{
  constexpr std::size_t mostPoints = 4; // for each item, else to look at all takes longer
  std::vector<Item> items;
  if (numberOfPoints > mostPoints * count)
  {
    items.reserve(count);
    forEach([&items](const Item& item) { items.push_back(item); });
    std::sort(items.begin(), items.end());
    return items;
  }
  std::vector<std::uint32_t> ends(numberOfPoints + 1, 0);
  forEach([&](const Item& item) { ++ends[pointOf(item) + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  items.resize(count);
  forEach([&](const Item& item) { items[ends[pointOf(item)]++] = item; });
  std::ptrdiff_t begin = 0;
  for (const std::uint32_t end : ends)
  {
    std::sort(items.begin() + begin, items.begin() + end);
    begin = end;
  }
  return items;
}
}

//------------------------------------------------------------------------------
SkdPieceParts::SkdPieceParts(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const std::vector<std::uint32_t>& origins, SkdFaceSets& faces,
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& facing)
  : Set(set)
  , Facets(facets)
  , Signs(signs)
  , Origins(origins)
  , Faces(faces)
{
  std::vector<bool> isCut(faces.GetNumberOfTriangles(), false);
  this->FindCut(facing, isCut);
  this->ListPieces(isCut);
  if (!this->Pieces.empty())
  {
    this->ListUses();
    if (this->FindLaidOnCut(isCut))
    {
      this->ListPieces(isCut);
      this->ListUses();
    }
    this->FindParts();
    this->FindBorder();
  }
}

void SkdPieceParts::Merge(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
{
  skd::DisjointSets<> parts(this->GetNumberOfParts());
  this->Unmerged = this->PartOf;
  this->AreOpposite.assign(this->Pieces.size(), false);
  for (const auto& [first, second] : pairs)
  {
    parts.Unite(first, second);
  }
  for (const auto& [first, second] : pairs)
  {
    const std::uint32_t lowest = parts.Find(first);
    if (first == lowest || second == lowest) // else both face as that does, or its opposite
    {
      for (const std::uint32_t piece : this->PiecesOf[first == lowest ? second : first])
      {
        this->AreOpposite[piece] = true;
      }
    }
  }
  const std::vector<std::uint32_t> numbers = parts.Number();
  this->AreMerged.assign(numbers.size(), false);
  for (const auto& pair : pairs)
  {
    this->AreMerged[numbers[pair.first]] = true;
  }
  for (std::uint32_t& part : this->PartOf)
  {
    part = numbers[part];
  }
  this->ListUses();
  this->FindBorder();
}

void SkdPieceParts::ForgetBorders()
{
  this->Widths = std::vector<double>();
  this->Tolerances = std::vector<double>();
  this->Border = std::vector<BorderEdge>();
  this->BorderOf = skd::IndexRows();
}

const SkdPieceParts::BorderEdge* SkdPieceParts::FindNext(
  std::uint32_t point, std::uint32_t part) const
{
  const BorderEdge* found = nullptr;
  int count = 0;
  this->ForEachFrom(point,
    [&](const BorderEdge& edge)
    {
      found = edge.Part == part ? &edge : found;
      count += edge.Part == part;
    });
  return count == 1 ? found : nullptr;
}

//------------------------------------------------------------------------------
/// Faces that are cut, or so taken.
void SkdPieceParts::FindCut(
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& facing, std::vector<bool>& isCut)
{
  const auto n = static_cast<std::uint32_t>(this->Signs.size());
  for (std::uint32_t facet = 0; facet < n; ++facet)
  {
    if (this->Facets.IsPiece(this->Set, facet))
    {
      isCut[this->Faces.Find(this->GetOriginOf(facet) / 2)] = true;
    }
  }
  for (const auto& [first, second] : facing)
  {
    isCut[this->Faces.Find(this->GetOriginOf(first) / 2)] = true;
    isCut[this->Faces.Find(this->GetOriginOf(second) / 2)] = true;
  }
}

/// The facets in the boundary of these faces.
void SkdPieceParts::ListPieces(const std::vector<bool>& isCut)
{
  const auto n = static_cast<std::uint32_t>(this->Signs.size());
  this->Pieces.clear();
  this->Widths.clear();
  this->Tolerances.clear();
  for (std::uint32_t facet = 0; facet < n; ++facet)
  {
    if (this->Signs[facet] != 0 && isCut[this->Faces.Find(this->GetOriginOf(facet) / 2)])
    {
      this->Pieces.push_back(facet);
      this->Widths.push_back(SkdWidthOf(this->Facets.GetPositions(this->Set, facet)));
      this->Tolerances.push_back(
        SkdToleranceOf(this->Set.GetCornerPoints(this->Facets.Parents[facet])));
    }
  }
}

/// Whether any other face lies on one of these but for rounding, so that its rim is around a hole
/// of that: it is then taken as cut, too.
bool SkdPieceParts::FindLaidOnCut(std::vector<bool>& isCut)
{
  std::vector<unsigned char> isOfPiece(this->CountPoints(), 0); // looked at for all facets
  for (const std::uint32_t facet : this->Pieces)
  {
    for (const std::uint32_t corner : this->Facets.Corners[facet])
    {
      isOfPiece[corner] = 1;
    }
  }
  bool isAny = false;
  for (std::uint32_t facet = 0; facet < this->Signs.size(); ++facet)
  {
    const auto [a, b, c] = this->Facets.Corners[facet];
    if (this->Signs[facet] != 0 && isOfPiece[a] + isOfPiece[b] + isOfPiece[c] > 1 &&
      !std::binary_search(this->Pieces.begin(), this->Pieces.end(), facet) &&
      this->IsLaidOnPiece(facet))
    {
      isCut[this->Faces.Find(this->GetOriginOf(facet) / 2)] = true;
      isAny = true;
    }
  }
  return isAny;
}

/// Whether the triangle that a piece beside a facet is of continues under it.
bool SkdPieceParts::IsLaidOnPiece(std::uint32_t facet) const
{
  const Corners& corners = this->Facets.Corners[facet];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Use wanted(corners[i], corners[(i + 1) % 3], 0);
    auto use = std::lower_bound(this->Uses.begin(), this->Uses.end(), wanted);
    for (; use != this->Uses.end() && use->Ends == wanted.Ends; ++use)
    {
      if (this->IsLaidOn(facet, this->Pieces[use->Piece]))
      {
        return true;
      }
    }
  }
  return false;
}

bool SkdPieceParts::IsLaidOn(std::uint32_t facet, std::uint32_t piece) const
{
  constexpr double least = 1.0 - 1e-6;
  const auto top = this->Set.GetCornerPoints(this->Facets.Parents[facet]);
  const auto bottom = this->Set.GetCornerPoints(this->Facets.Parents[piece]);
  const skd::Vector3 area = Cross(top[1] - top[0], top[2] - top[0]);
  const skd::Vector3 other = Cross(bottom[1] - bottom[0], bottom[2] - bottom[0]);
  const double size = Norm(area);
  return this->Signs[facet] * this->Signs[piece] * Dot(area, other) > least * size * Norm(other) &&
    this->Faces.AreInOnePlane(this->GetOriginOf(facet) / 2, this->GetOriginOf(piece) / 2) &&
    SkdDoOverlap(top, bottom, (1.0 / size) * area, SkdToleranceOf(bottom));
}

void SkdPieceParts::ListUses()
{
  const auto forEach = [this](const auto& add)
  {
    for (std::uint32_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      const auto [a, b, c] = this->Facets.Corners[this->Pieces[piece]];
      add(Use(a, b, piece));
      add(Use(b, c, piece));
      add(Use(c, a, piece));
    }
  };
  this->Uses = ListByPoint<Use>(3 * this->Pieces.size(), this->CountPoints(), forEach,
    [](const Use& use) { return use.GetEnd(true); });
}

template <class Visit>
void SkdPieceParts::ForEachEdge(const Visit& visit) const
{
  const Use* const end = this->Uses.data() + this->Uses.size();
  for (const Use* first = this->Uses.data(); first != end;)
  {
    const Use* last = first + 1;
    while (last != end && last->Ends == first->Ends)
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

//------------------------------------------------------------------------------
void SkdPieceParts::FindParts()
{
  skd::DisjointSets<> parts(this->Pieces.size());
  this->ForEachEdge(
    [&](const Use* first, const Use* last)
    {
      if (last - first == 2 && this->AreOfOneFace(first[0], first[1]))
      {
        parts.Unite(first[0].Piece, first[1].Piece);
      }
    });
  this->PartOf = parts.Number();
}

bool SkdPieceParts::AreOfOneFace(const Use& a, const Use& b) const
{
  const std::uint32_t first = this->Pieces[a.Piece];
  const std::uint32_t second = this->Pieces[b.Piece];
  const std::uint32_t ofFirst = this->GetOriginOf(first);
  const std::uint32_t ofSecond = this->GetOriginOf(second);
  return a.GetFrom() == b.GetTo() && this->Signs[first] == this->Signs[second] &&
    ofFirst % 2 == ofSecond % 2 && this->Faces.Unite(ofFirst / 2, ofSecond / 2) &&
    this->AreInOnePlane(a.Piece, b.Piece);
}

/// Pieces with a common edge, of which one may be a sliver: its parent's plane says nothing of it.
bool SkdPieceParts::AreInOnePlane(std::uint32_t a, std::uint32_t b) const
{
  const auto [thinner, wider] = std::minmax(
    a, b, [this](std::uint32_t i, std::uint32_t k) { return this->Widths[i] < this->Widths[k]; });
  const double tolerance = std::max(this->Tolerances[a], this->Tolerances[b]);
  return this->Widths[thinner] > tolerance ||
    SkdRoundedPlane(this->PositionsOf(wider), tolerance).Contains(this->PositionsOf(thinner));
}

/// Whether the boundary has the edge from its lower to its higher end there. Two pieces are changed
/// along an edge together only if one is and the other is not: faces that are not cut may be there,
/// too.
bool SkdPieceParts::IsForward(const Use& use) const
{
  return use.IsForward == (this->Signs[this->Pieces[use.Piece]] > 0);
}

//------------------------------------------------------------------------------
void SkdPieceParts::FindBorder()
{
  this->Border.clear();
  this->Seams.clear();
  this->ForEachEdge([this](const Use* first, const Use* last) { this->AddBorder(first, last); });
  std::stable_sort(this->Seams.begin(), this->Seams.end(),
    [](const BorderEdge& a, const BorderEdge& b) { return a.Part < b.Part; });
  this->Uses = std::vector<Use>(); // they are found again where parts are merged
  const std::size_t border = this->Border.size();
  const auto forEach = [unsorted = std::move(this->Border)](const auto& add)
  { std::for_each(unsorted.begin(), unsorted.end(), add); };
  this->Border = ListByPoint<BorderEdge>(
    border, this->CountPoints(), forEach, [](const BorderEdge& edge) { return edge.From; });
  const auto count =
    static_cast<std::size_t>(*std::max_element(this->PartOf.begin(), this->PartOf.end())) + 1;
  this->PiecesOf = skd::IndexRows(count,
    [&](const auto& add)
    {
      for (std::uint32_t piece = 0; piece < this->PartOf.size(); ++piece)
      {
        add(this->PartOf[piece], piece);
      }
    });
  this->ToleranceOf.assign(count, 0.0);
  for (std::uint32_t piece = 0; piece < this->PartOf.size(); ++piece)
  {
    double& tolerance = this->ToleranceOf[this->PartOf[piece]];
    tolerance = std::max(tolerance, this->Tolerances[piece]);
  }
  this->BorderOf = skd::IndexRows(count,
    [&](const auto& add)
    {
      for (std::uint32_t edge = 0; edge < this->Border.size(); ++edge)
      {
        add(this->Border[edge].Part, edge);
      }
    });
}

/// So that the edge is within the part.
bool SkdPieceParts::AreOppositeOfOnePart(const Use& a, const Use& b) const
{
  return this->PartOf[a.Piece] == this->PartOf[b.Piece] && this->IsForward(a) != this->IsForward(b);
}

void SkdPieceParts::AddSeam(const Use& a, const Use& b)
{
  if (this->GetUnmergedPartOf(a.Piece) != this->GetUnmergedPartOf(b.Piece) &&
    this->IsOpposite(a.Piece) == this->IsOpposite(b.Piece))
  {
    this->Seams.push_back({ a.GetFrom(), a.GetTo(), this->PartOf[a.Piece], None });
  }
}

void SkdPieceParts::AddBorder(const Use* first, const Use* last)
{
  const bool areTwo = last - first == 2;
  if (areTwo && this->AreOppositeOfOnePart(first[0], first[1]))
  {
    this->AddSeam(first[0], first[1]);
    return;
  }
  const bool arePair = areTwo && this->IsForward(first[0]) != this->IsForward(first[1]);
  const std::size_t begin = this->Border.size();
  for (const Use* use = first; use != last; ++use)
  {
    const std::uint32_t other = arePair ? this->PartOf[first[use == first ? 1 : 0].Piece] : None;
    const bool isForward = this->IsForward(*use);
    this->Border.push_back(
      { use->GetEnd(isForward), use->GetEnd(!isForward), this->PartOf[use->Piece], other });
  }
  if (!areTwo)
  {
    BorderEdge* const of = this->Border.data() + begin;
    BorderEdge* const end = LeaveOutInner(of, this->Border.data() + this->Border.size());
    PairUp(of, end);
    this->Border.erase(this->Border.begin() + (end - this->Border.data()), this->Border.end());
  }
}

/// Of the uses of one edge: without those that are within a part, which has it in both directions.
/// Returns the new end.
SkdPieceParts::BorderEdge* SkdPieceParts::LeaveOutInner(BorderEdge* first, BorderEdge* last)
{
  for (BorderEdge* edge = first; edge != last;)
  {
    BorderEdge* const other = std::find_if(edge + 1, last,
      [edge](const BorderEdge& a) { return a.Part == edge->Part && a.From != edge->From; });
    if (other == last)
    {
      ++edge;
      continue;
    }
    last = std::rotate(other, other + 1, last);
    last = std::rotate(edge, edge + 1, last);
  }
  return last;
}

/// Where several parts meet along an edge, as many on each side: of each side the one with the
/// least number is beside that of the other, and so on, so that it is the same one all along a
/// line.
void SkdPieceParts::PairUp(BorderEdge* first, BorderEdge* last)
{
  std::sort(first, last,
    [](const BorderEdge& a, const BorderEdge& b)
    { return a.From != b.From ? a.From < b.From : a.Part < b.Part; });
  const std::ptrdiff_t half = (last - first) / 2;
  BorderEdge* const middle = first + half;
  if (middle == first || middle[-1].From == middle->From || last != middle + half)
  {
    return;
  }
  for (std::ptrdiff_t i = 0; i < half; ++i)
  {
    first[i].Other = middle[i].Part;
    middle[i].Other = first[i].Part;
  }
}
}
