// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdJoinPieces.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/Rows.h"
#include "Solids/Boolean/SkdFlatFace.h"
#include "Solids/Surfaces/SkdSplitPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;
constexpr std::uint32_t None = 0xffffffffu;

/// A piece at one of its edges, from a corner to the next.
struct Use
{
  std::uint64_t Ends;  ///< of the edge, the lower one first, as one number: uses are sorted by it
  std::uint32_t Piece; ///< among those that are looked at
  bool IsForward;      ///< from the lower end to the higher

  Use(std::uint32_t from, std::uint32_t to, std::uint32_t piece)
    : Ends(static_cast<std::uint64_t>(std::min(from, to)) << 32 | std::max(from, to))
    , Piece(piece)
    , IsForward(from < to)
  {
  }

  std::uint32_t GetFrom() const { return this->GetEnd(this->IsForward); }
  std::uint32_t GetTo() const { return this->GetEnd(!this->IsForward); }
  std::uint32_t GetEnd(bool isLower) const
  {
    return static_cast<std::uint32_t>(isLower ? this->Ends >> 32 : this->Ends);
  }
  bool operator<(const Use& other) const
  {
    return this->Ends != other.Ends ? this->Ends < other.Ends : this->Piece < other.Piece;
  }
};

/// An edge around a part of a face, which is on its left, as the boundary has it: of a part that is
/// reversed there, against the order of its facets' corners.
struct BorderEdge
{
  std::uint32_t From;
  std::uint32_t To;
  std::uint32_t Part;
  std::uint32_t Other; ///< the part on its right, of several one each; None if there is none

  bool operator<(const BorderEdge& other) const
  {
    return this->From != other.From ? this->From < other.From : this->To < other.To;
  }
};

class Joiner
{
public:
  Joiner(const SkdPlacement& placement, const SkdFacets& facets, const SkdFacetSigns& signs,
    const std::vector<std::uint32_t>& origins, SkdFaceSets& faces)
    : Set(placement.First)
    , Facets(facets)
    , Signs(signs)
    , Origins(origins)
    , Faces(faces)
    , Tolerance(4.0 * // of a point and both ends
        SkdSplitPoints::ErrorOf(placement.Scale * placement.First.GetSet().GetLargestCoordinate()))
  {
  }

  std::optional<SkdRoundedFacets> Join()
  {
    this->ListPieces();
    if (this->Pieces.empty())
    {
      return std::nullopt;
    }
    this->FindParts();
    this->FindStraight();
    this->TriangulateAll();
    const bool isAnyNew = std::any_of(this->Made.begin(), this->Made.end(),
      [](const std::vector<Corners>& made) { return !made.empty(); });
    return isAnyNew ? std::make_optional(this->Gather()) : std::nullopt;
  }

private:
  /// As in the origins.
  std::uint32_t OriginOf(std::uint32_t facet) const
  {
    const std::uint32_t parent = this->Facets.Parents[facet];
    return this->Origins.empty() ? 2 * parent : this->Origins[parent];
  }

  skd::Vector3 At(std::uint32_t point) const { return this->Facets.GetPosition(this->Set, point); }

  /// Without a call, which a comparison of arrays is.
  static bool AreDifferent(const Corners& a, const Corners& b)
  {
    return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) != 0;
  }

  /// The facets in the boundary of faces that are cut.
  void ListPieces()
  {
    const auto n = static_cast<std::uint32_t>(this->Signs.size());
    std::vector<bool> isCut(this->Faces.GetNumberOfTriangles(), false);
    for (std::uint32_t facet = 0; facet < n; ++facet)
    {
      if (AreDifferent(
            this->Facets.Corners[facet], this->Set.GetCorners(this->Facets.Parents[facet])))
      {
        isCut[this->Faces.Find(this->OriginOf(facet) / 2)] = true;
      }
    }
    for (std::uint32_t facet = 0; facet < n; ++facet)
    {
      if (this->Signs[facet] != 0 && isCut[this->Faces.Find(this->OriginOf(facet) / 2)])
      {
        this->Pieces.push_back(facet);
      }
    }
  }

  bool AreOfOneFace(const Use& a, const Use& b) const
  {
    const std::uint32_t first = this->Pieces[a.Piece];
    const std::uint32_t second = this->Pieces[b.Piece];
    const std::uint32_t ofFirst = this->OriginOf(first);
    const std::uint32_t ofSecond = this->OriginOf(second);
    return a.GetFrom() == b.GetTo() && this->Signs[first] == this->Signs[second] &&
      ofFirst % 2 == ofSecond % 2 && this->Faces.Unite(ofFirst / 2, ofSecond / 2);
  }

  /// Whether the boundary has the edge from its lower to its higher end there. Two pieces are
  /// changed along an edge together only if one is and the other is not: faces that are not cut may
  /// be there, too.
  bool IsForward(const Use& use) const
  {
    return use.IsForward == (this->Signs[this->Pieces[use.Piece]] > 0);
  }

  /// The connected parts of faces, and the edges around them.
  void FindParts()
  {
    const auto n = static_cast<std::uint32_t>(this->Pieces.size());
    std::vector<Use> uses;
    uses.reserve(3 * this->Pieces.size());
    for (std::uint32_t piece = 0; piece < n; ++piece)
    {
      const Corners& corners = this->Facets.Corners[this->Pieces[piece]];
      for (std::size_t i = 0; i < 3; ++i)
      {
        uses.emplace_back(corners[i], corners[(i + 1) % 3], piece);
      }
    }
    std::sort(uses.begin(), uses.end());
    skd::DisjointSets<> parts(n);
    ForEachEdge(uses,
      [&](const Use* first, const Use* last)
      {
        if (last - first == 2 && this->AreOfOneFace(first[0], first[1]))
        {
          parts.Unite(first[0].Piece, first[1].Piece);
        }
      });
    this->PartOf = parts.Number();
    ForEachEdge(uses, [this](const Use* first, const Use* last) { this->AddBorder(first, last); });
    std::sort(this->Border.begin(), this->Border.end());
    const auto count =
      static_cast<std::size_t>(*std::max_element(this->PartOf.begin(), this->PartOf.end())) + 1;
    this->PiecesOf = skd::IndexRows(count,
      [&](const auto& add)
      {
        for (std::uint32_t piece = 0; piece < n; ++piece)
        {
          add(this->PartOf[piece], piece);
        }
      });
    this->BorderOf = skd::IndexRows(count,
      [&](const auto& add)
      {
        for (std::uint32_t edge = 0; edge < this->Border.size(); ++edge)
        {
          add(this->Border[edge].Part, edge);
        }
      });
  }

  template <class Visit>
  static void ForEachEdge(const std::vector<Use>& uses, const Visit& visit)
  {
    const Use* const end = uses.data() + uses.size();
    for (const Use* first = uses.data(); first != end;)
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

  void AddBorder(const Use* first, const Use* last)
  {
    const bool areTwo = last - first == 2;
    if (areTwo && this->AreOfOneFace(first[0], first[1]))
    {
      return;
    }
    const bool arePair = areTwo && this->IsForward(first[0]) != this->IsForward(first[1]);
    const std::size_t begin = this->Border.size();
    for (const Use* use = first; use != last; ++use)
    {
      const std::uint32_t other = arePair ? this->PartOf[first[use == first ? 1 : 0].Piece] : None;
      const std::uint32_t part = this->PartOf[use->Piece];
      const bool isForward = this->IsForward(*use);
      this->Border.push_back(
        { use->GetEnd(isForward), use->GetEnd(!isForward), part, other == part ? None : other });
    }
    if (!areTwo)
    {
      PairUp(this->Border.data() + begin, this->Border.data() + this->Border.size());
    }
  }

  /// Where several parts meet along an edge, as many on each side: of each side the one with the
  /// least number is beside that of the other, and so on, so that it is the same one all along a
  /// line.
  static void PairUp(BorderEdge* first, BorderEdge* last)
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
      const bool areSame = first[i].Part == middle[i].Part;
      first[i].Other = areSame ? None : middle[i].Part;
      middle[i].Other = areSame ? None : first[i].Part;
    }
  }

  //----------------------------------------------------------------------------
  /// The edge of a part that begins at a point, if there is one only.
  const BorderEdge* FindNext(std::uint32_t point, std::uint32_t part) const
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

  template <class Visit>
  void ForEachFrom(std::uint32_t point, const Visit& visit) const
  {
    const BorderEdge wanted{ point, 0, 0, 0 };
    auto at = std::lower_bound(this->Border.begin(), this->Border.end(), wanted);
    for (; at != this->Border.end() && at->From == point; ++at)
    {
      visit(*at);
    }
  }

  /// Whether parts meet at a point along one line, the same before and after it, and no others.
  bool IsWithinLine(std::uint32_t point) const
  {
    constexpr std::size_t most = 16; // parts, which are compared with each other
    std::array<const BorderEdge*, most> edges;
    std::size_t count = 0;
    this->ForEachFrom(point,
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
    for (const BorderEdge& edge : this->Border)
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
      const BorderEdge* next = this->FindNext(line.back(), first.Part);
      if (!next || line.size() > this->Border.size())
      {
        return;
      }
      line.push_back(next->To);
    }
    if (line.size() > 2 && line.front() != line.back())
    {
      this->Straighten(line.data(), line.data() + line.size() - 1);
    }
  }

  /// Takes out all points between two of a line, or divides it at the one farthest from straight.
  void Straighten(const std::uint32_t* first, const std::uint32_t* last)
  {
    const skd::Vector3 from = this->At(*first);
    const skd::Vector3 direction = this->At(*last) - from;
    const double length = Norm(direction);
    const std::uint32_t* farthest = nullptr;
    double most = this->Tolerance;
    double before = 0.0;
    for (const std::uint32_t* point = first + 1; point < last; ++point)
    {
      const skd::Vector3 to = this->At(*point) - from;
      const double along = length > 0.0 ? Dot(to, direction) / length : 0.0;
      const double away = length > 0.0 ? Norm(Cross(to, direction)) / length : Norm(to);
      const bool isInOrder = along >= before - this->Tolerance && along <= length + this->Tolerance;
      const double off = isInOrder ? away : std::max(away, Norm(to));
      farthest = !(off <= most) ? point : farthest;
      most = std::max(most, off);
      before = std::max(before, along);
    }
    if (farthest)
    {
      this->Straighten(first, farthest);
      this->Straighten(farthest, last);
      return;
    }
    for (const std::uint32_t* point = first + 1; point < last; ++point)
    {
      this->IsTakenOut[*point] = true;
    }
  }

  //----------------------------------------------------------------------------
  /// The edges around a part as its facets have them, without points that are taken out.
  std::vector<SkdFlatFace::Edge> ListEdges(std::uint32_t part) const
  {
    const bool isReversed = this->Signs[this->Pieces[this->PiecesOf[part][0]]] < 0;
    std::vector<SkdFlatFace::Edge> edges;
    for (const std::uint32_t i : this->BorderOf[part])
    {
      const BorderEdge& edge = this->Border[i];
      if (this->IsTakenOut[edge.From])
      {
        continue;
      }
      std::uint32_t to = edge.To;
      while (this->IsTakenOut[to])
      {
        to = this->FindNext(to, part)->To;
      }
      edges.emplace_back(isReversed ? to : edge.From, isReversed ? edge.From : to);
    }
    return edges;
  }

  /// Whether a part has points that it does not need.
  bool HasSpare(std::uint32_t part) const
  {
    std::vector<std::uint32_t> onBorder;
    for (const std::uint32_t edge : this->BorderOf[part])
    {
      onBorder.push_back(this->Border[edge].From);
      if (this->IsTakenOut[onBorder.back()])
      {
        return true;
      }
    }
    std::sort(onBorder.begin(), onBorder.end());
    const auto isInside = [&](std::uint32_t point)
    { return !std::binary_search(onBorder.begin(), onBorder.end(), point); };
    const auto pieces = this->PiecesOf[part];
    return std::any_of(pieces.begin(), pieces.end(),
      [&](std::uint32_t piece)
      {
        const Corners& corners = this->Facets.Corners[this->Pieces[piece]];
        return std::any_of(corners.begin(), corners.end(), isInside);
      });
  }

  std::vector<Corners> Triangulate(std::uint32_t part) const
  {
    skd::Vector3 normal{};
    for (const std::uint32_t piece : this->PiecesOf[part])
    {
      const auto x = this->Facets.GetPositions(this->Set, this->Pieces[piece]);
      normal = normal + Cross(x[1] - x[0], x[2] - x[0]);
    }
    return SkdFlatFace(this->ListEdges(part), normal)
      .Triangulate([this](std::uint32_t point) { return this->At(point); });
  }

  /// A part that cannot be triangulated gets its points back, and its neighbours get those that
  /// they share.
  void TriangulateAll()
  {
    const std::size_t n = this->PiecesOf.size();
    this->Made.resize(n);
    std::vector<bool> isRetained(n, false);
    std::vector<std::uint32_t> left(n);
    std::iota(left.begin(), left.end(), 0u);
    while (!left.empty())
    {
      std::vector<unsigned char> isFailed(left.size(), 0);
      SkdForEach(left.size(),
        [&](std::size_t i)
        {
          const std::uint32_t part = left[i];
          this->Made[part].clear();
          if (this->HasSpare(part))
          {
            this->Made[part] = this->Triangulate(part);
            isFailed[i] = this->Made[part].empty();
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
    for (const std::uint32_t i : this->BorderOf[part])
    {
      const BorderEdge& edge = this->Border[i];
      if (this->IsTakenOut[edge.From])
      {
        this->IsTakenOut[edge.From] = false;
        this->ForEachFrom(
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
    std::uint32_t piece = 0;
    std::vector<bool> isDone(this->Made.size(), false);
    for (std::uint32_t facet = 0; facet < this->Signs.size(); ++facet)
    {
      const bool isPiece = piece < this->Pieces.size() && this->Pieces[piece] == facet;
      const std::uint32_t part = isPiece ? this->PartOf[piece++] : None;
      if (this->Signs[facet] == 0)
      {
        continue;
      }
      if (!isPiece || this->Made[part].empty())
      {
        add(facet, this->Facets.Corners[facet]);
      }
      else if (!isDone[part])
      {
        isDone[part] = true;
        std::for_each(this->Made[part].begin(), this->Made[part].end(),
          [&](const Corners& corners) { add(facet, corners); });
      }
    }
    return joined;
  }

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdFacetSigns& Signs;
  const std::vector<std::uint32_t>& Origins;
  SkdFaceSets& Faces;
  const double Tolerance;
  std::vector<std::uint32_t> Pieces; // facets
  std::vector<std::uint32_t> PartOf; // of each piece
  std::vector<BorderEdge> Border;    // ascending
  skd::IndexRows PiecesOf;           // of each part
  skd::IndexRows BorderOf;
  std::vector<bool> IsTakenOut;           // of each point
  std::vector<std::vector<Corners>> Made; // of each part; empty: as it was
};
}

std::optional<SkdRoundedFacets> SkdJoinPieces(const SkdPlacement& placement,
  const SkdFacets& facets, const SkdFacetSigns& signs, const std::vector<std::uint32_t>& origins,
  SkdFaceSets& faces)
{
  return Joiner(placement, facets, signs, origins, faces).Join();
}
}
