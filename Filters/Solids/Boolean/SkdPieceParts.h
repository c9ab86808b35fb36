// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdPieceParts_h
#define SkdPieceParts_h

#include "Core/Geometry/Rows.h"
#include "Solids/Boolean/SkdBooleanRule.h"
#include "Solids/Boolean/SkdFaceSets.h"

#include <algorithm>

namespace skdtree
{
/// The pieces in a boundary of faces that are cut, and of some others, the connected parts of one
/// face that they are, and the edges around these. O(n log n) for n pieces.
class SkdPieceParts
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;

  /// An edge around a part, which is on its left, as the boundary has it: of a part that is
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

  /// `origins` as for SkdJoinPieces. The faces of `facing` facets are looked at as if they were
  /// cut, and those that lie on a face that is cut, but for rounding, and face as it does.
  SkdPieceParts(const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
    const std::vector<std::uint32_t>& origins, SkdFaceSets& faces,
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& facing);

  /// Makes the parts of each pair one: they lie in one plane and face opposite ways. One may be in
  /// several pairs, with parts that are in no others.
  void Merge(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);

  /// Frees all but which pieces each part has.
  void ForgetBorders();

  const std::vector<std::uint32_t>& GetPieces() const { return this->Pieces; } ///< facets
  std::uint32_t GetPartOf(std::uint32_t piece) const { return this->PartOf[piece]; }
  std::uint32_t GetPartOfFacet(std::uint32_t facet) const
  {
    const auto at = std::lower_bound(this->Pieces.begin(), this->Pieces.end(), facet);
    return this->PartOf[static_cast<std::size_t>(at - this->Pieces.begin())];
  }
  std::size_t GetNumberOfParts() const { return this->PiecesOf.size(); }

  /// The part that a piece was of before parts were merged.
  std::uint32_t GetUnmergedPartOf(std::uint32_t piece) const
  {
    return this->Unmerged.empty() ? this->PartOf[piece] : this->Unmerged[piece];
  }

  /// Edges within parts that are merged, where two of those that face alike meet; ascending by
  /// part.
  const std::vector<BorderEdge>& GetSeams() const { return this->Seams; }

  SkdFaceSets& GetFaces() const { return this->Faces; }
  const std::vector<std::uint32_t>& GetOrigins() const { return this->Origins; }
  skd::IndexRows::Row GetPiecesOf(std::uint32_t part) const { return this->PiecesOf[part]; }
  bool IsMerged(std::uint32_t part) const
  {
    return !this->AreMerged.empty() && this->AreMerged[part];
  }

  /// Whether a piece faces the other way than the first one of its part.
  bool IsOpposite(std::uint32_t piece) const
  {
    return !this->AreOpposite.empty() && this->AreOpposite[piece];
  }
  std::uint32_t GetFirstFacetOf(std::uint32_t part) const
  {
    return this->Pieces[this->PiecesOf[part][0]];
  }

  std::array<skd::Vector3, 3> PositionsOf(std::uint32_t piece) const
  {
    return this->Facets.GetPositions(this->Set, this->Pieces[piece]);
  }
  skd::Vector3 GetPosition(std::uint32_t point) const
  {
    return this->Facets.GetPosition(this->Set, point);
  }
  double GetWidthOf(std::uint32_t piece) const { return this->Widths[piece]; } ///< least height

  /// Of points where two parts meet.
  double GetToleranceOf(std::uint32_t a, std::uint32_t b) const
  {
    return std::max(this->ToleranceOf[a], this->ToleranceOf[b]);
  }

  /// Twice the triangle of the face that a facet is of, and 1 more if that is reversed.
  std::uint32_t GetOriginOf(std::uint32_t facet) const
  {
    return this->GetOriginOfTriangle(this->Facets.Parents[facet]);
  }

  /// The same of a triangle of the placed set.
  std::uint32_t GetOriginOfTriangle(std::uint32_t triangle) const
  {
    return this->Origins.empty() ? 2 * triangle : this->Origins[triangle];
  }

  const std::vector<BorderEdge>& GetBorder() const { return this->Border; } ///< ascending
  skd::IndexRows::Row GetBorderOf(std::uint32_t part) const { return this->BorderOf[part]; }

  /// The edge of a part that begins at a point, if there is one only.
  const BorderEdge* FindNext(std::uint32_t point, std::uint32_t part) const;

  /// Calls visit(edge) for each edge that begins at a point.
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

private:
  /// A piece at one of its edges, from a corner to the next.
  struct Use
  {
    std::uint64_t Ends;  // of the edge, the lower one first, as one number: uses are sorted by it
    std::uint32_t Piece; // among those that are looked at
    bool IsForward;      // from the lower end to the higher

    Use() = default;
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

  std::size_t CountPoints() const
  {
    return this->Set.GetPoints().size() + this->Facets.NewPoints.size();
  }
  void FindCut(
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& facing, std::vector<bool>& isCut);
  void ListPieces(const std::vector<bool>& isCut);
  bool FindLaidOnCut(std::vector<bool>& isCut);
  bool IsLaidOnPiece(std::uint32_t facet) const;
  bool IsLaidOn(std::uint32_t facet, std::uint32_t piece) const;
  void ListUses();
  void FindParts();
  void FindBorder();
  bool IsForward(const Use& use) const;
  bool AreOfOneFace(const Use& a, const Use& b) const;
  bool AreInOnePlane(std::uint32_t a, std::uint32_t b) const;
  bool AreOppositeOfOnePart(const Use& a, const Use& b) const;
  void AddSeam(const Use& a, const Use& b);
  void AddBorder(const Use* first, const Use* last);
  static BorderEdge* LeaveOutInner(BorderEdge* first, BorderEdge* last);
  static void PairUp(BorderEdge* first, BorderEdge* last);

  template <class Visit>
  void ForEachEdge(const Visit& visit) const;

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdFacetSigns& Signs;
  const std::vector<std::uint32_t>& Origins;
  SkdFaceSets& Faces;
  std::vector<std::uint32_t> Pieces;
  std::vector<double> Widths;        // of each piece
  std::vector<double> Tolerances;    // of each piece, by the triangle that it is of
  std::vector<Use> Uses;             // ascending
  std::vector<std::uint32_t> PartOf; // of each piece
  std::vector<BorderEdge> Border;
  std::vector<double> ToleranceOf; // each part
  skd::IndexRows PiecesOf;         // of each part
  skd::IndexRows BorderOf;
  std::vector<std::uint32_t> Unmerged; // part of each piece before; empty: none is merged
  std::vector<BorderEdge> Seams;
  std::vector<bool> AreMerged;   // parts; empty: none
  std::vector<bool> AreOpposite; // pieces; empty: none
};
}

#endif
