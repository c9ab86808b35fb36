// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdCoplanarOverlaps.h"

#include "Solids/Boolean/SkdBoxSet.h"
#include "Solids/Boolean/SkdEdgeCuts.h"
#include "Solids/Boolean/SkdFacingFacets.h"
#include "Solids/Boolean/SkdFlatFace.h"
#include "Solids/Boolean/SkdRoundedPlane.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace skdtree
{
namespace
{
using BorderEdge = SkdPieceParts::BorderEdge;
using Corners = SkdTriangleSet::Corners;
using Ends = SkdEdgeCuts::Ends;
using Triangle = std::array<skd::Vector3, 3>;

/// Faces of either orientation, in the order in which overlaps become theirs.
struct Owner
{
  std::uint32_t Face;
  bool IsReversed;

  auto AsTuple() const { return std::tie(this->Face, this->IsReversed); }
  bool operator<(const Owner& other) const { return this->AsTuple() < other.AsTuple(); }
  bool operator==(const Owner& other) const { return this->AsTuple() == other.AsTuple(); }
};

/// A part, and a lower face in its plane that it is beside.
struct Neighbour
{
  std::uint32_t Part;
  Owner Lower;

  bool operator<(const Neighbour& other) const
  {
    return this->Part != other.Part ? this->Part < other.Part : this->Lower < other.Lower;
  }
  bool operator==(const Neighbour& other) const
  {
    return this->Part == other.Part && this->Lower == other.Lower;
  }
};

/// A triangle of the set that is of an owner.
struct Owned
{
  Owner Of;
  std::uint32_t Number;
  Triangle At;

  bool operator<(const Owned& other) const
  {
    return this->Of == other.Of ? this->Number < other.Number : this->Of < other.Of;
  }
};

/// A part that lower faces overlap.
struct Overlapped
{
  std::uint32_t Part;
  skd::Vector3 Normal; // of length 1, as the boundary has the part
  double Tolerance;
  std::vector<const Owned*> Above; // triangles that overlap it, ascending
  std::vector<Ends> Outlines;      // around those of each owner
};

/// A facet of the boundary.
struct Facet
{
  Corners Points;
  std::uint32_t Parent;
  signed char Sign;
};

class CoplanarOverlaps
{
public:
  CoplanarOverlaps(const SkdMovedTriangles& set, const SkdFacets& facets,
    const SkdFacetSigns& signs, const SkdPieceParts& parts)
    : Set(set)
    , Facets(facets)
    , Signs(signs)
    , Parts(parts)
    , Faces(parts.GetFaces())
    , Cuts(set, facets, parts)
  {
  }

  std::optional<SkdRoundedFacets> Cut()
  {
    this->FindNeighbours();
    if (this->Neighbours.empty())
    {
      return std::nullopt;
    }
    this->ListOwned();
    this->FindOverlapped();
    if (this->All.empty())
    {
      return std::nullopt;
    }
    const bool isAnyCut = this->CutBorders();
    return isAnyCut ? this->Cuts.Split(this->Signs) : this->CutParts();
  }

private:
  //----------------------------------------------------------------------------
  std::uint32_t OriginOf(std::uint32_t part) const
  {
    return this->Parts.GetOriginOf(this->Parts.GetFirstFacetOf(part));
  }

  Owner OwnerOf(std::uint32_t origin) const
  {
    return { this->Faces.Find(origin / 2), origin % 2 != 0 };
  }

  /// Of the triangle that a part's first piece is of.
  skd::Vector3 ParentAreaOf(std::uint32_t part) const
  {
    const std::uint32_t facet = this->Parts.GetFirstFacetOf(part);
    return AreaOf(this->Set.GetCornerPoints(this->Facets.Parents[facet]));
  }

  /// Of a part's first piece, as the boundary has it; of length 1.
  skd::Vector3 NormalOf(std::uint32_t part) const
  {
    const std::uint32_t facet = this->Parts.GetFirstFacetOf(part);
    const skd::Vector3 area = this->ParentAreaOf(part);
    return (this->Signs[facet] / Norm(area)) * area;
  }

  /// Whether their first pieces are of triangles that are, or nearly.
  bool AreParallel(std::uint32_t a, std::uint32_t b) const
  {
    constexpr double least = 1.0 - 1e-6;
    const skd::Vector3 first = this->ParentAreaOf(a);
    const skd::Vector3 second = this->ParentAreaOf(b);
    const double dot = Dot(first, second);
    return dot * dot > least * least * Norm2(first) * Norm2(second);
  }

  static skd::Vector3 AreaOf(const Triangle& x) { return Cross(x[1] - x[0], x[2] - x[0]); }

  int SignOf(std::uint32_t part) const { return this->Signs[this->Parts.GetFirstFacetOf(part)]; }

  /// Which faces are in the boundary as they are, and reversed.
  std::set<std::pair<Owner, int>> ListSigned() const
  {
    std::set<std::pair<Owner, int>> present;
    for (std::uint32_t part = 0; part < this->Parts.GetNumberOfParts(); ++part)
    {
      present.emplace(this->OwnerOf(this->OriginOf(part)), this->SignOf(part));
    }
    return present;
  }

  /// Parts with a common edge of the boundary and in one plane; the one of the lower face second.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ListBeside() const
  {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const BorderEdge& edge : this->Parts.GetBorder())
    {
      if (edge.Other != SkdPieceParts::None && edge.Part < edge.Other)
      {
        const Owner first = this->OwnerOf(this->OriginOf(edge.Part));
        const Owner second = this->OwnerOf(this->OriginOf(edge.Other));
        if (first.Face != second.Face)
        {
          pairs.push_back(
            first < second ? std::pair(edge.Other, edge.Part) : std::pair(edge.Part, edge.Other));
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    const auto isElsewhere = [this](const auto& pair)
    {
      return !this->AreParallel(pair.first, pair.second) ||
        !this->Faces.AreInOnePlane(this->OriginOf(pair.first) / 2, this->OriginOf(pair.second) / 2);
    };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isElsewhere), pairs.end());
    return pairs;
  }

  /// Of those beside each other the ones of which the lower face has parts that face as the other
  /// part does.
  void FindNeighbours()
  {
    const auto beside = this->ListBeside();
    const auto present = beside.empty() ? std::set<std::pair<Owner, int>>() : this->ListSigned();
    for (const auto& [part, lower] : beside)
    {
      const Owner owner = this->OwnerOf(this->OriginOf(lower));
      const bool doFaceAlike = Dot(this->NormalOf(part), this->NormalOf(lower)) > 0.0;
      const int sign = doFaceAlike ? this->SignOf(lower) : -this->SignOf(lower);
      if (present.count({ owner, sign }) != 0)
      {
        this->Neighbours.push_back({ part, owner });
      }
    }
    std::sort(this->Neighbours.begin(), this->Neighbours.end());
    this->Neighbours.erase(
      std::unique(this->Neighbours.begin(), this->Neighbours.end()), this->Neighbours.end());
  }

  /// The triangles of all lower faces.
  void ListOwned()
  {
    std::vector<bool> isWanted(this->Faces.GetNumberOfTriangles(), false);
    for (const Neighbour& neighbour : this->Neighbours)
    {
      isWanted[neighbour.Lower.Face] = true;
    }
    const auto count = static_cast<std::uint32_t>(this->Set.GetSet().GetTriangles().size());
    for (std::uint32_t triangle = 0; triangle < count; ++triangle)
    {
      const Owner owner = this->OwnerOf(this->Parts.GetOriginOfTriangle(triangle));
      if (isWanted[owner.Face])
      {
        this->OfOwners.push_back({ owner, triangle, this->Set.GetCornerPoints(triangle) });
      }
    }
    std::sort(this->OfOwners.begin(), this->OfOwners.end());
  }

  void FindOverlapped()
  {
    std::vector<skd::Box3> boxes;
    for (const Owned& owned : this->OfOwners)
    {
      boxes.push_back(BoxOf(owned.At));
    }
    const SkdBoxSet tree(std::move(boxes));
    for (auto first = this->Neighbours.begin(); first != this->Neighbours.end();)
    {
      auto last = first;
      std::vector<Owner> owners; // ascending
      for (; last != this->Neighbours.end() && last->Part == first->Part; ++last)
      {
        owners.push_back(last->Lower);
      }
      this->AddOverlapped(first->Part, owners, tree);
      first = last;
    }
  }

  static skd::Box3 BoxOf(const Triangle& triangle)
  {
    return SkdBoxSet::BoxOf(triangle, SkdToleranceOf(triangle));
  }

  /// Adds a part if one of these owners overlaps it.
  void AddOverlapped(std::uint32_t part, const std::vector<Owner>& owners, const SkdBoxSet& tree)
  {
    Overlapped found{ part, this->NormalOf(part), this->Parts.GetToleranceOf(part, part), {}, {} };
    for (const std::uint32_t piece : this->Parts.GetPiecesOf(part))
    {
      const Triangle x = this->Parts.PositionsOf(piece);
      tree.ForEachOverlapping(BoxOf(x),
        [&](std::uint32_t i)
        {
          const Owned& owned = this->OfOwners[i];
          if (std::binary_search(owners.begin(), owners.end(), owned.Of) &&
            FacesAs(owned, found.Normal) &&
            SkdDoOverlap(x, owned.At, found.Normal, found.Tolerance))
          {
            found.Above.push_back(&owned);
          }
        });
    }
    std::sort(found.Above.begin(), found.Above.end());
    found.Above.erase(std::unique(found.Above.begin(), found.Above.end()), found.Above.end());
    if (!found.Above.empty())
    {
      this->ListOutlines(found);
      this->All.push_back(std::move(found));
    }
  }

  /// Faces of solids inside out, or that are taken away, have the other orientation.
  static bool FacesAs(const Owned& owned, const skd::Vector3& normal)
  {
    constexpr double least = 1.0 - 1e-6;
    const skd::Vector3 area = AreaOf(owned.At);
    return std::abs(Dot(area, normal)) > least * Norm(area);
  }

  //----------------------------------------------------------------------------
  /// The edges around each owner's triangles. Of points that are one but for rounding the first is
  /// taken, of the part if it has any.
  void ListOutlines(Overlapped& of) const
  {
    std::vector<std::uint32_t> points;
    for (const std::uint32_t edge : this->Parts.GetBorderOf(of.Part))
    {
      points.push_back(this->Parts.GetBorder()[edge].From);
    }
    for (auto first = of.Above.begin(); first != of.Above.end();)
    {
      const auto last = std::find_if(
        first, of.Above.end(), [&](const Owned* owned) { return !(owned->Of == (*first)->Of); });
      for (const Ends& edge : this->OutlineOf(first, last))
      {
        of.Outlines.push_back(edge);
        points.insert(points.end(), { edge.first, edge.second });
      }
      first = last;
    }
    const SkdBoxSet boxes = this->BoxesOf(points, [](std::uint32_t i) { return std::array{ i }; });
    const auto firstAt = [&](std::uint32_t point)
    {
      const skd::Vector3 x = this->Cuts.At(point);
      auto lowest = static_cast<std::uint32_t>(points.size());
      boxes.ForEachOverlapping(SkdBoxSet::BoxOf(std::array{ x }, of.Tolerance),
        [&](std::uint32_t k)
        {
          const bool isSame = Norm(this->Cuts.At(points[k]) - x) <= of.Tolerance;
          lowest = isSame ? std::min(lowest, k) : lowest;
        });
      return points[lowest];
    };
    for (Ends& edge : of.Outlines)
    {
      edge = SkdEdgeCuts::EndsOf(firstAt(edge.first), firstAt(edge.second));
    }
    const auto isPoint = [](const Ends& edge) { return edge.first == edge.second; };
    of.Outlines.erase(
      std::remove_if(of.Outlines.begin(), of.Outlines.end(), isPoint), of.Outlines.end());
    std::sort(of.Outlines.begin(), of.Outlines.end());
    of.Outlines.erase(std::unique(of.Outlines.begin(), of.Outlines.end()), of.Outlines.end());
  }

  /// Of items by the points that each has.
  template <class Item, class PointsOf>
  SkdBoxSet BoxesOf(const std::vector<Item>& items, const PointsOf& pointsOf) const
  {
    std::vector<skd::Box3> boxes;
    for (const Item& item : items)
    {
      skd::Box3 box;
      for (const std::uint32_t point : pointsOf(item))
      {
        box.Add(this->Cuts.At(point));
      }
      boxes.push_back(box);
    }
    return SkdBoxSet(std::move(boxes));
  }

  static std::array<std::uint32_t, 2> PointsOf(const Ends& edge)
  {
    return { edge.first, edge.second };
  }

  skd::Box3 BoxOf(const Ends& edge, double tolerance) const
  {
    return SkdBoxSet::BoxOf(
      std::array{ this->Cuts.At(edge.first), this->Cuts.At(edge.second) }, tolerance);
  }

  /// The edges that one of an owner's triangles has and no other.
  template <class Iterator>
  std::vector<Ends> OutlineOf(Iterator first, Iterator last) const
  {
    std::vector<Ends> edges;
    for (; first != last; ++first)
    {
      const Corners& corners = this->Set.GetCorners((*first)->Number);
      for (std::size_t i = 0; i < 3; ++i)
      {
        edges.push_back(SkdEdgeCuts::EndsOf(corners[i], corners[(i + 1) % 3]));
      }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Ends> once;
    for (auto edge = edges.begin(); edge != edges.end();)
    {
      const auto next = std::upper_bound(edge, edges.end(), *edge);
      if (next - edge == 1)
      {
        once.push_back(*edge);
      }
      edge = next;
    }
    return once;
  }

  //----------------------------------------------------------------------------
  /// Returns whether any border is cut.
  bool CutBorders()
  {
    bool isAnyCut = false;
    for (const Overlapped& of : this->All)
    {
      const SkdBoxSet boxes = this->BoxesOf(of.Outlines, PointsOf);
      this->Cuts.SetPlane(of.Normal, of.Tolerance);
      for (const std::uint32_t i : this->Parts.GetBorderOf(of.Part))
      {
        const BorderEdge& edge = this->Parts.GetBorder()[i];
        const Ends ends = SkdEdgeCuts::EndsOf(edge.From, edge.To);
        boxes.ForEachOverlapping(this->BoxOf(ends, of.Tolerance),
          [&](std::uint32_t k) { this->Cuts.Meet(ends, of.Outlines[k]); });
        isAnyCut = isAnyCut || this->Cuts.IsCut(ends);
      }
    }
    return isAnyCut;
  }

  /// The boundary with all overlapped parts cut along outlines.
  std::optional<SkdRoundedFacets> CutParts()
  {
    std::vector<bool> isCut(this->Parts.GetNumberOfParts(), false);
    std::vector<Facet> made;
    SkdFlatFace face;
    for (const Overlapped& of : this->All)
    {
      this->CutOutlines(of);
      isCut[of.Part] = this->CutPart(of, face, made);
    }
    return made.empty() ? std::nullopt : std::make_optional(this->Gather(isCut, made));
  }

  /// Where those of several owners cross.
  void CutOutlines(const Overlapped& of)
  {
    const SkdBoxSet boxes = this->BoxesOf(of.Outlines, PointsOf);
    this->Cuts.SetPlane(of.Normal, of.Tolerance);
    for (std::size_t i = 0; i < of.Outlines.size(); ++i)
    {
      boxes.ForEachOverlapping(this->BoxOf(of.Outlines[i], of.Tolerance),
        [&](std::uint32_t k)
        {
          if (k < i)
          {
            this->Cuts.Meet(of.Outlines[k], of.Outlines[i]);
          }
        });
    }
  }

  /// Returns whether it could be cut.
  bool CutPart(const Overlapped& of, SkdFlatFace& face, std::vector<Facet>& made) const
  {
    face.Begin();
    for (const std::uint32_t i : this->Parts.GetBorderOf(of.Part))
    {
      const BorderEdge& edge = this->Parts.GetBorder()[i];
      face.Add(edge.From, edge.To);
    }
    for (const Ends& outline : of.Outlines)
    {
      std::uint32_t from = outline.first;
      for (const std::uint32_t point : this->Cuts.ListPoints(outline))
      {
        face.AddWithin(from, point);
        from = point;
      }
      face.AddWithin(from, outline.second);
    }
    const SkdFlatFace::Triangles* const triangles =
      face.Triangulate(of.Normal, [this](std::uint32_t point) { return this->Cuts.At(point); });
    if (!triangles || !triangles->Right.empty())
    {
      return false;
    }
    std::vector<skd::Box3> boxes;
    for (const Owned* owned : of.Above)
    {
      boxes.push_back(BoxOf(owned->At));
    }
    const SkdBoxSet above(std::move(boxes));
    for (const Corners& corners : triangles->Left)
    {
      made.push_back(this->MakeFacet(of, above, corners));
    }
    return true;
  }

  /// Of the lowest owner that it is in; else of the part.
  Facet MakeFacet(const Overlapped& of, const SkdBoxSet& above, const Corners& corners) const
  {
    const skd::Vector3 middle = (1.0 / 3.0) *
      (this->Cuts.At(corners[0]) + this->Cuts.At(corners[1]) + this->Cuts.At(corners[2]));
    auto lowest = static_cast<std::uint32_t>(of.Above.size());
    above.ForEachOverlapping(SkdBoxSet::BoxOf(std::array{ middle }, of.Tolerance),
      [&](std::uint32_t k)
      {
        const bool isIn = k < lowest && IsIn(middle, of.Above[k]->At, of.Normal);
        lowest = isIn ? k : lowest;
      });
    const std::uint32_t first = this->Parts.GetFirstFacetOf(of.Part);
    Facet facet{ corners, this->Facets.Parents[first], this->Signs[first] };
    if (lowest < of.Above.size())
    {
      const Owned& owned = *of.Above[lowest];
      facet.Parent = owned.Number;
      facet.Sign = Dot(AreaOf(owned.At), of.Normal) > 0.0 ? 1 : -1;
    }
    if (facet.Sign < 0)
    {
      std::swap(facet.Points[1], facet.Points[2]);
    }
    return facet;
  }

  /// As seen along a normal.
  static bool IsIn(const skd::Vector3& x, const Triangle& triangle, const skd::Vector3& normal)
  {
    const double sign = Dot(AreaOf(triangle), normal) > 0.0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const skd::Vector3 edge = triangle[(i + 1) % 3] - triangle[i];
      if (sign * Dot(normal, Cross(edge, x - triangle[i])) < 0.0)
      {
        return false;
      }
    }
    return true;
  }

  SkdRoundedFacets Gather(const std::vector<bool>& isCut, std::vector<Facet>& made) const
  {
    const std::vector<std::uint32_t>& pieces = this->Parts.GetPieces();
    std::uint32_t next = 0;
    for (std::uint32_t facet = 0; facet < this->Signs.size(); ++facet)
    {
      const bool isPiece = next < pieces.size() && pieces[next] == facet;
      const std::uint32_t piece = isPiece ? next++ : SkdPieceParts::None;
      if (this->Signs[facet] != 0 && !(isPiece && isCut[this->Parts.GetPartOf(piece)]))
      {
        made.push_back(
          { this->Facets.Corners[facet], this->Facets.Parents[facet], this->Signs[facet] });
      }
    }
    std::stable_sort(
      made.begin(), made.end(), [](const Facet& a, const Facet& b) { return a.Parent < b.Parent; });
    SkdEdgeCuts::Collector collector(this->Cuts);
    for (const Facet& facet : made)
    {
      collector.Add(facet.Points, facet.Parent, facet.Sign);
    }
    return collector.Take();
  }

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdFacetSigns& Signs;
  const SkdPieceParts& Parts;
  SkdFaceSets& Faces;
  SkdEdgeCuts Cuts;
  std::vector<Neighbour> Neighbours; // ascending
  std::vector<Owned> OfOwners;       // ascending
  std::vector<Overlapped> All;
};
}

std::optional<SkdRoundedFacets> SkdCutOverlaps(const SkdMovedTriangles& set,
  const SkdFacets& facets, const SkdFacetSigns& signs, const SkdPieceParts& parts)
{
  return CoplanarOverlaps(set, facets, signs, parts).Cut();
}
}
