// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdJoinPieces.h"

#include "Cells/Read/SkdForEach.h"
#include "Solids/Boolean/SkdBorderCrossings.h"
#include "Solids/Boolean/SkdCoplanarOverlaps.h"
#include "Solids/Boolean/SkdFacingFacets.h"
#include "Solids/Boolean/SkdMadeTriangles.h"
#include "Solids/Boolean/SkdOppositeParts.h"
#include "Solids/Boolean/SkdRoundedPlane.h"
#include "Solids/Boolean/SkdSlivers.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;
using BorderEdge = SkdPieceParts::BorderEdge;
using Pair = std::pair<std::uint32_t, std::uint32_t>;
constexpr std::uint32_t None = SkdPieceParts::None;

/// What a part becomes.
struct Made
{
  bool IsMade = false;                    // else it stays as it was
  std::vector<SkdMadeTriangle> Triangles; // ascending
};

class Joiner
{
public:
  Joiner(const SkdPlacement& placement, const SkdFacets& facets, const SkdFacetSigns& signs,
    const std::vector<std::uint32_t>& origins, SkdFaceSets& faces, const std::vector<Pair>& facing)
    : Set(placement.First)
    , Facets(facets)
    , Signs(signs)
    , Facing(facing)
    , Parts(placement.First, facets, signs, origins, faces, facing)
  {
  }

  /// Gives what faces in one plane have in common to the lowest, if they overlap.
  std::optional<SkdRoundedFacets> CutOverlaps() const
  {
    return SkdCutOverlaps(this->Set, this->Facets, this->Signs, this->Parts);
  }

  /// Finds parts that lie on each other, but for those of these pairs of facets; one may lie on
  /// several, with `areSeveral`. Returns the facets split where their borders cross, if they do.
  std::optional<SkdRoundedFacets> FindOpposite(
    const SkdFaceSets& faces, const std::vector<Pair>& apart, bool areSeveral)
  {
    const auto areApart = [&](std::uint32_t a, std::uint32_t b) {
      return std::find(apart.begin(), apart.end(), this->FacetsOf({ a, b })) != apart.end();
    };
    this->Opposite = SkdFindOppositeParts(
      this->Set, this->Facets, this->Signs, this->Parts, faces, this->Facing, areSeveral, areApart);
    return SkdSplitBorders(this->Set, this->Facets, this->Signs, this->Parts, this->Opposite);
  }

  /// Makes these parts one. Returns whether there are any.
  bool MergeOpposite()
  {
    for (const Pair& pair : this->Opposite)
    {
      this->Merged.push_back(this->FacetsOf(pair));
    }
    if (!this->Opposite.empty())
    {
      this->Parts.Merge(this->Opposite);
    }
    return !this->Opposite.empty();
  }

  std::optional<SkdRoundedFacets> Join()
  {
    if (this->Parts.GetPieces().empty())
    {
      return std::nullopt;
    }
    this->FindStraight();
    this->TriangulateAll();
    this->Parts.ForgetBorders();
    const bool isAnyNew = std::any_of(
      this->MadeOf.begin(), this->MadeOf.end(), [](const Made& made) { return made.IsMade; });
    return isAnyNew ? std::make_optional(this->Gather()) : std::nullopt;
  }

  /// The pairs of facets whose parts were made one, but could not be triangulated so.
  std::vector<Pair> ListFailed() const
  {
    std::vector<Pair> failed;
    for (std::uint32_t piece = 0; piece < this->Parts.GetPieces().size(); ++piece)
    {
      const std::uint32_t facet = this->Parts.GetPieces()[piece];
      for (const Pair& pair : this->Merged)
      {
        if (pair.first == facet && !this->MadeOf[this->Parts.GetPartOf(piece)].IsMade)
        {
          failed.push_back(pair);
        }
      }
    }
    return failed;
  }

private:
  skd::Vector3 At(std::uint32_t point) const { return this->Facets.GetPosition(this->Set, point); }

  Pair FacetsOf(const Pair& parts) const
  {
    return { this->Parts.GetFirstFacetOf(parts.first), this->Parts.GetFirstFacetOf(parts.second) };
  }

  /// Whether parts meet at a point along one line, the same before and after it, and no others.
  bool IsWithinLine(std::uint32_t point) const
  {
    if (this->IsOfSeam[point])
    {
      return false;
    }
    constexpr std::size_t most = 16; // parts, which are compared with each other
    std::array<const BorderEdge*, most> edges;
    std::size_t count = 0;
    this->Parts.ForEachFrom(point,
      [&](const BorderEdge& edge)
      {
        edges[std::min(count, most - 1)] = &edge;
        ++count;
      });
    return count >= 2 && count <= most && AreOneLine(edges.data(), edges.data() + count);
  }

  /// Whether edges from a point, by where they end, lead to two other points only, and each part
  /// comes from where the one on its right goes to.
  static bool AreOneLine(const BorderEdge* const* first, const BorderEdge* const* last)
  {
    return std::all_of(first, last,
      [&](const BorderEdge* edge)
      {
        const auto isOpposite = [edge](const BorderEdge* other) {
          return edge->Other == other->Part && other->Other == edge->Part && edge->To != other->To;
        };
        const auto isOfPart = [edge](const BorderEdge* other) { return other->Part == edge->Part; };
        return (edge->To == first[0]->To || edge->To == last[-1]->To) &&
          std::count_if(first, last, isOfPart) == 1 && std::any_of(first, last, isOpposite);
      });
  }

  /// Takes points out of lines between parts.
  void FindStraight()
  {
    this->IsTakenOut.assign(this->Set.GetPoints().size() + this->Facets.NewPoints.size(), false);
    this->IsOfSeam = this->IsTakenOut;
    for (const BorderEdge& seam : this->Parts.GetSeams())
    {
      this->IsOfSeam[seam.From] = true;
      this->IsOfSeam[seam.To] = true;
    }
    for (const BorderEdge& edge : this->Parts.GetBorder())
    {
      // Each line once, from one of its ends on.
      if (edge.Other != None && edge.Part < edge.Other && !this->IsWithinLine(edge.From))
      {
        this->Straighten(edge);
      }
    }
  }

  void Straighten(const BorderEdge& first)
  {
    std::vector<std::uint32_t> line{ first.From, first.To };
    while (this->IsWithinLine(line.back()))
    {
      const BorderEdge* next = this->Parts.FindNext(line.back(), first.Part);
      if (!next || line.size() > this->Parts.GetBorder().size())
      {
        return;
      }
      line.push_back(next->To);
    }
    if (line.size() > 2 && line.front() != line.back())
    {
      this->Straighten(line.data(), line.data() + line.size() - 1,
        this->Parts.GetToleranceOf(first.Part, first.Other));
    }
  }

  /// Takes out all points between two of a line, or divides it at the one farthest from straight.
  void Straighten(const std::uint32_t* first, const std::uint32_t* last, double tolerance)
  {
    const skd::Vector3 from = this->At(*first);
    const skd::Vector3 direction = this->At(*last) - from;
    const double length = Norm(direction);
    const std::uint32_t* farthest = nullptr;
    double most = tolerance;
    double before = 0.0;
    for (const std::uint32_t* point = first + 1; point < last; ++point)
    {
      const skd::Vector3 to = this->At(*point) - from;
      const double along = length > 0.0 ? Dot(to, direction) / length : 0.0;
      const double away = length > 0.0 ? Norm(Cross(to, direction)) / length : Norm(to);
      const bool isInOrder = along >= before - tolerance && along <= length + tolerance;
      const double off = isInOrder ? away : std::max(away, Norm(to));
      farthest = !(off <= most) ? point : farthest;
      most = std::max(most, off);
      before = std::max(before, along);
    }
    if (farthest)
    {
      this->Straighten(first, farthest, tolerance);
      this->Straighten(farthest, last, tolerance);
      return;
    }
    for (const std::uint32_t* point = first + 1; point < last; ++point)
    {
      this->IsTakenOut[*point] = true;
    }
  }

  //----------------------------------------------------------------------------
  /// 1 or -1 as the boundary has the pieces of a part.
  signed char SignOf(std::uint32_t part) const
  {
    return this->Signs[this->Parts.GetFirstFacetOf(part)];
  }

  /// Adds the edges around a part as its first facet has them, without points that are taken out.
  void ListEdges(std::uint32_t part, SkdFlatFace& face) const
  {
    const bool isReversed = this->SignOf(part) < 0;
    face.Begin();
    for (const std::uint32_t i : this->Parts.GetBorderOf(part))
    {
      const BorderEdge& edge = this->Parts.GetBorder()[i];
      if (this->IsTakenOut[edge.From])
      {
        continue;
      }
      std::uint32_t to = edge.To;
      while (this->IsTakenOut[to])
      {
        to = this->Parts.FindNext(to, part)->To;
      }
      face.Add(isReversed ? to : edge.From, isReversed ? edge.From : to);
    }
  }

  /// So that triangles are of one part each. Returns whether there are any.
  bool ListSeams(std::uint32_t part, SkdFlatFace& face) const
  {
    const std::vector<BorderEdge>& seams = this->Parts.GetSeams();
    auto seam = std::lower_bound(seams.begin(), seams.end(), part,
      [](const BorderEdge& edge, std::uint32_t wanted) { return edge.Part < wanted; });
    const auto first = seam;
    for (; seam != seams.end() && seam->Part == part; ++seam)
    {
      face.AddWithin(seam->From, seam->To);
    }
    return seam != first;
  }

  /// What a thread triangulates parts in.
  struct Memory
  {
    SkdFlatFace Face;
    std::vector<std::uint32_t> OnBorder;
  };

  /// Whether a part has points that it does not need. `onBorder` is for what is listed.
  bool HasSpare(std::uint32_t part, std::vector<std::uint32_t>& onBorder) const
  {
    onBorder.clear();
    for (const std::uint32_t edge : this->Parts.GetBorderOf(part))
    {
      onBorder.push_back(this->Parts.GetBorder()[edge].From);
      if (this->IsTakenOut[onBorder.back()])
      {
        return true;
      }
    }
    std::sort(onBorder.begin(), onBorder.end());
    const auto isInside = [&](std::uint32_t point)
    { return !std::binary_search(onBorder.begin(), onBorder.end(), point); };
    const auto pieces = this->Parts.GetPiecesOf(part);
    return std::any_of(pieces.begin(), pieces.end(),
      [&](std::uint32_t piece)
      {
        const Corners& corners = this->Facets.Corners[this->Parts.GetPieces()[piece]];
        return std::any_of(corners.begin(), corners.end(), isInside);
      });
  }

  /// As the first facet of a part has it; none if the border is not in one plane.
  std::optional<skd::Vector3> FindNormal(std::uint32_t part) const
  {
    skd::Vector3 normal{};
    const auto pieces = this->Parts.GetPiecesOf(part);
    std::uint32_t widest = pieces[0];
    for (const std::uint32_t piece : pieces)
    {
      if (!this->Parts.IsOpposite(piece))
      {
        const auto x = this->Parts.PositionsOf(piece);
        normal = normal + Cross(x[1] - x[0], x[2] - x[0]);
      }
      widest = this->Parts.GetWidthOf(piece) > this->Parts.GetWidthOf(widest) ? piece : widest;
    }
    const SkdRoundedPlane plane(
      this->Parts.PositionsOf(widest), this->Parts.GetToleranceOf(part, part));
    const auto edges = this->Parts.GetBorderOf(part);
    const bool isFlat = std::all_of(edges.begin(), edges.end(),
      [&](std::uint32_t edge)
      { return plane.Contains(this->At(this->Parts.GetBorder()[edge].From)); });
    return isFlat ? std::make_optional(normal) : std::nullopt;
  }

  Made Triangulate(std::uint32_t part, SkdFlatFace& face) const
  {
    const std::optional<skd::Vector3> normal = this->FindNormal(part);
    if (!normal)
    {
      return {};
    }
    const bool isMerged = this->Parts.IsMerged(part);
    this->ListEdges(part, face);
    if (isMerged && face.IsEmpty())
    {
      return { true, {} };
    }
    const auto at = [this](std::uint32_t point) { return this->At(point); };
    const bool hasSeams = this->ListSeams(part, face);
    const SkdFlatFace::Triangles* triangles = face.Triangulate(*normal, at);
    if (!triangles && hasSeams)
    {
      this->ListEdges(part, face);
      triangles = face.Triangulate(*normal, at);
    }
    const bool isMade = triangles && (isMerged || triangles->Right.empty());
    return isMade ? Made{ true, SkdListMade(this->Parts, part, *triangles) } : Made{};
  }

  /// A part that cannot be triangulated gets its points back, and its neighbours get those that
  /// they share.
  void TriangulateAll()
  {
    const std::size_t n = this->Parts.GetNumberOfParts();
    this->MadeOf.resize(n);
    std::vector<bool> isRetained(n, false);
    std::vector<std::uint32_t> left(n);
    std::iota(left.begin(), left.end(), 0u);
    vtkSMPThreadLocal<Memory> memories;
    while (!left.empty())
    {
      std::vector<unsigned char> isFailed(left.size(), 0);
      SkdForEach(left.size(),
        [&](std::size_t i)
        {
          const std::uint32_t part = left[i];
          this->MadeOf[part] = {};
          Memory& memory = memories.Local();
          if (this->Parts.IsMerged(part) || this->HasSpare(part, memory.OnBorder))
          {
            this->MadeOf[part] = this->Triangulate(part, memory.Face);
            isFailed[i] = !this->MadeOf[part].IsMade;
          }
        });
      std::vector<std::uint32_t> next;
      for (std::size_t i = 0; i < left.size(); ++i)
      {
        if (isFailed[i])
        {
          isRetained[left[i]] = true;
          this->PutBack(left[i], next);
        }
      }
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      next.erase(std::remove_if(next.begin(), next.end(),
                   [&isRetained](std::uint32_t part) { return isRetained[part]; }),
        next.end());
      left = std::move(next);
    }
  }

  void PutBack(std::uint32_t part, std::vector<std::uint32_t>& changed)
  {
    for (const std::uint32_t i : this->Parts.GetBorderOf(part))
    {
      const BorderEdge& edge = this->Parts.GetBorder()[i];
      if (this->IsTakenOut[edge.From])
      {
        this->IsTakenOut[edge.From] = false;
        this->Parts.ForEachFrom(
          edge.From, [&](const BorderEdge& other) { changed.push_back(other.Part); });
      }
    }
  }

  //----------------------------------------------------------------------------
  SkdRoundedFacets Gather() const
  {
    SkdRoundedFacets joined;
    joined.Facets.NewPoints = this->Facets.NewPoints;
    const auto unused = std::count(this->Signs.begin(), this->Signs.end(), 0);
    const std::size_t count = this->Signs.size() - static_cast<std::size_t>(unused);
    joined.Facets.Corners.reserve(count); // as a rule joined pieces are fewer
    joined.Facets.Parents.reserve(count);
    joined.Signs.reserve(count);
    const auto add = [&](std::uint32_t facet, const Corners& corners)
    {
      joined.Facets.Corners.push_back(corners);
      joined.Facets.Parents.push_back(this->Facets.Parents[facet]);
      joined.Signs.push_back(this->Signs[facet]);
    };
    std::uint32_t next = 0;
    std::vector<bool> isDone(this->Parts.GetPieces().size(), false); // by part before merging
    const std::vector<std::uint32_t>& pieces = this->Parts.GetPieces();
    for (std::uint32_t facet = 0; facet < this->Signs.size(); ++facet)
    {
      if (this->Signs[facet] == 0)
      {
        continue;
      }
      const bool isPiece = next < pieces.size() && pieces[next] == facet;
      const std::uint32_t piece = isPiece ? next++ : None;
      const std::uint32_t part = isPiece ? this->Parts.GetPartOf(piece) : None;
      if (!isPiece || !this->MadeOf[part].IsMade)
      {
        add(facet, this->Facets.Corners[facet]);
        continue;
      }
      const std::uint32_t before = this->Parts.GetUnmergedPartOf(piece);
      if (!isDone[before])
      {
        isDone[before] = true;
        const bool isTurned = this->Signs[facet] != this->SignOf(part);
        const std::vector<SkdMadeTriangle>& made = this->MadeOf[part].Triangles;
        auto at = std::lower_bound(made.begin(), made.end(), SkdMadeTriangle{ before, {} });
        for (; at != made.end() && at->Part == before; ++at)
        {
          const auto [a, b, c] = at->Points;
          add(facet, isTurned ? Corners{ a, c, b } : at->Points);
        }
      }
    }
    return joined;
  }

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdFacetSigns& Signs;
  const std::vector<Pair>& Facing;
  SkdPieceParts Parts;
  std::vector<Pair> Opposite;   // parts
  std::vector<Pair> Merged;     // facets, see FacetsOf
  std::vector<bool> IsTakenOut; // of each point
  std::vector<bool> IsOfSeam;   // likewise
  std::vector<Made> MadeOf;     // of each part
};

/// What is joined once.
struct Joined
{
  std::optional<SkdRoundedFacets> Facets;
  bool IsMore; // whether parts that lay on each other were looked at, so that more may be there
};

/// With `cutsOverlaps` parts that overlap lower faces in one plane are cut, if there are any; else:
/// where parts lie on each other, their borders are split where they cross; else they are made one
/// where that can be triangulated.
Joined JoinOnce(const SkdPlacement& placement, const SkdFacets& facets, const SkdFacetSigns& signs,
  const std::vector<std::uint32_t>& origins, SkdFaceSets& faces, bool cutsOverlaps)
{
  const std::vector<Pair> facing =
    SkdFindFacingFacets(placement.First, facets, signs, origins, faces);
  std::vector<Pair> apart;
  bool areSeveral = true; // else those that fail would keep others from being made one
  while (true)
  {
    Joiner joiner(placement, facets, signs, origins, faces, facing);
    if (auto cut = cutsOverlaps ? joiner.CutOverlaps() : std::nullopt)
    {
      return { std::move(cut), true };
    }
    if (auto split = joiner.FindOpposite(faces, apart, areSeveral))
    {
      return { std::move(split), true };
    }
    const bool areMerged = joiner.MergeOpposite();
    std::optional<SkdRoundedFacets> joined = joiner.Join();
    const std::vector<Pair> failed = joiner.ListFailed();
    if (failed.empty())
    {
      return { std::move(joined), areMerged };
    }
    if (!areSeveral)
    {
      apart.insert(apart.end(), failed.begin(), failed.end());
    }
    areSeveral = false;
  }
}
}

std::optional<SkdRoundedFacets> SkdJoinPieces(const SkdPlacement& placement,
  const SkdFacets& facets, const SkdFacetSigns& signs, const std::vector<std::uint32_t>& origins,
  SkdFaceSets& faces, SkdRoundedFacets* given)
{
  constexpr int most = 24;          // times
  constexpr int mostOfOverlaps = 8; // times that parts are cut where they overlap
  // Borders that split each other ever more would not end: what was before is closed, too.
  const std::size_t mostFacets = 4 * facets.GetNumberOfFacets() + 1000;
  std::optional<SkdRoundedFacets> fewest;
  Joined joined = JoinOnce(placement, facets, signs, origins, faces, true);
  if (given && joined.Facets)
  {
    given->ForgetFacets();
  }
  for (int time = 1; joined.Facets && joined.IsMore && time < most; ++time)
  {
    Joined again = JoinOnce(placement, joined.Facets->Facets, joined.Facets->Signs, origins, faces,
      time < mostOfOverlaps);
    joined.IsMore = again.IsMore;
    if (again.Facets)
    {
      const std::size_t count = again.Facets->Facets.GetNumberOfFacets();
      const std::size_t last = joined.Facets->Facets.GetNumberOfFacets();
      const bool isLeast = !fewest || last < fewest->Facets.GetNumberOfFacets();
      if (count > last && isLeast)
      {
        fewest = std::move(joined.Facets);
      }
      joined.Facets = std::move(again.Facets);
      if (count > mostFacets && fewest)
      {
        joined.Facets = std::move(fewest);
        break;
      }
    }
  }
  if (joined.Facets)
  {
    SkdRemoveSlivers(placement, joined.Facets->Facets, joined.Facets->Signs, joined.Facets);
  }
  return std::move(joined.Facets);
}
}
