// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSolidArrangement.h
 * @brief Boolean operations on solids by the arrangement of their surfaces.
 *
 * As in Zhou et al. 2016 (SkdArrangement.h) all surfaces are split along all their intersections
 * once, winding numbers tell which solids each region of space is in, and an operation keeps the
 * facets between regions that are solid and regions that are not.
 */

#ifndef SkdSolidArrangement_h
#define SkdSolidArrangement_h

#include "Solids/Boolean/SkdBadEdges.h"
#include "Solids/Boolean/SkdCombineInPairs.h"
#include "Solids/Boolean/SkdNearArrangement.h"
#include "Solids/Boolean/SkdRoundedFacets.h"
#include "Solids/Boolean/SkdSheet.h"
#include "Solids/Boolean/SkdSideNumbers.h"
#include "Solids/Boolean/SkdSolids.h"

#include <optional>
#include <string>

class vtkAlgorithm;

namespace skdtree
{
class SkdSpreadSolids;
class SkdTransport;

/// The faces that an operation keeps.
struct SkdBooleanBoundary
{
  SkdFacetSigns Selected; ///< of the arrangement
  std::optional<SkdRoundedFacets>
    Rounded; ///< these as they are stored, if that makes a difference; if pieces are joined, how
             ///< many were folded, only
  std::optional<SkdRoundedFacets>
    Joined; ///< these with pieces of one face joined, if there are any

  ///@{
  /// If they are known: of it without pieces joined, and of it.
  std::optional<SkdBadEdges> Bad;
  std::optional<SkdBoundaryMeasures> Measures;
  ///@}

  ///@{
  /// Without pieces joined. They pass edges as often in both directions as what is stored; if `Bad`
  /// is not known, they have a table of them.
  const SkdFacetSigns& GetUnjoinedSigns() const
  {
    return this->Rounded ? this->Rounded->Signs : this->Selected;
  }
  const SkdFacets& GetUnjoinedFacets(const SkdArrangement& arrangement) const
  {
    return this->Rounded ? this->Rounded->Facets : arrangement.Facets;
  }
  ///@}

  ///@{
  /// As they are stored.
  const SkdFacetSigns& GetSigns() const
  {
    return this->Joined ? this->Joined->Signs : this->GetUnjoinedSigns();
  }
  SkdFacetSigns& GetSigns()
  {
    return this->Joined ? this->Joined->Signs
      : this->Rounded   ? this->Rounded->Signs
                        : this->Selected;
  }
  const SkdFacets& GetFacets(const SkdArrangement& arrangement) const
  {
    return this->Joined ? this->Joined->Facets : this->GetUnjoinedFacets(arrangement);
  }
  ///@}
};

/// The arrangement of the inputs, and the solids that its regions are in: kept while the inputs are
/// unchanged. To be called in this order: Update, FindSolids, FindWindings, Select. Of very many
/// solids that overlap there is no arrangement but the result of one operation (SkdCombineInPairs):
/// Update finds all of it, each time.
class SkdSolidArrangement
{
public:
  /// The next operation is on the inputs that were dealt out to several processes, or, with
  /// nullptr, on all of them. Then FindWindings must be called by all together; surfaces are closed
  /// over all. Very many solids that overlap must be gathered: Update returns false.
  void SetSpread(const SkdSpreadSolids* spread, SkdTransport* transport)
  {
    this->Spread = spread;
    this->Transport = transport;
  }

  /// Splits the surfaces along all their intersections, unless that is done; `filter` gets the
  /// progress. While the inputs are unchanged but for the motion of the Source, they are not read
  /// again, and intersections of the Input with itself are not searched again: its points stay. The
  /// Source's points are rounded where they are, so pairs of its triangles that this may make are
  /// tested again (SkdDoubtfulPairs). From the second motion on only triangles that are near the
  /// other input are arranged (SkdNearArrangement), where that is enough.
  /// `areInputs` and `rule` (but for the number of solids) are of the operation that follows. False
  /// after an abort.
  bool Update(const SkdBooleanBlocks& blocks, double chordalDeviation, bool areInputs,
    const SkdBooleanRule& rule, vtkAlgorithm* filter);

  /// Finds out which triangles bound which solid: the two inputs; else the blocks if there are
  /// several, else the pieces.
  void FindSolids(const SkdBooleanBlocks& blocks, bool areInputs);

  /// Whether the inside of surfaces that are not closed is found by generalized winding numbers;
  /// else they are refused, or cut.
  void SetRoundsNumbers(bool rounds);
  bool RoundsNumbers() const { return this->AreRounded; }

  /// The first solid whose surface has no inside; none if all have. The Source may be open (a
  /// sheet) in operations that have a use for it.
  std::optional<std::uint32_t> FindUnclosed(SkdBooleanOperation operation) const;

  /// Finds out which solids each region is in, unless that is done. Empty if it could not.
  std::optional<SkdSheetFaults> FindWindings();

  /// Open edges of surfaces whose inside is found by generalized winding numbers.
  vtkIdType CountRoundedEdges() const;

  /// The boundary of what is solid. Facets of a sheet are in it only with `closesCut`; pieces of
  /// one face are joined with `joins`.
  SkdBooleanBoundary Select(const SkdBooleanRule& rule, bool closesCut, bool joins);

  /// The number of parts that a split by `rule` leaves; some may be empty.
  int CountParts(const SkdBooleanRule& rule) const;

  /// Of a boundary that was selected, what is of the Source, with the normals that it has there.
  SkdFacetSigns FindSection(const SkdBooleanBoundary& boundary, const SkdBooleanRule& rule) const;

  /// The flat faces that triangles are of.
  SkdFaceSets& GetFaces() { return this->Faces; }

  ///@{
  /// The volume and area of what is within solids, or a boundary.
  template <class IsSolid>
  SkdBoundaryMeasures Measure(const IsSolid& isSolid) const
  {
    return this->Near ? this->MeasureComponents(isSolid)
                      : this->Measure(this->Arrangement.Facets, this->FindSigns(isSolid));
  }
  SkdBoundaryMeasures Measure(const SkdBooleanBoundary& boundary) const
  {
    return boundary.Measures
      ? *boundary.Measures
      : this->Measure(boundary.GetFacets(this->Arrangement), boundary.GetSigns());
  }
  ///@}

  bool HasWindings() const { return this->Near || !this->Windings.empty(); }

  /// The result of the operation, if Update has found it.
  const std::optional<SkdCombinedSolids>& GetCombined() const { return this->Combined; }

  /// Whether a solid is the Source, and open.
  bool IsSheet(std::uint32_t solid) const
  {
    return this->AreInputs && solid == 1 && this->BadEdges[1].Count > 0 && !this->AreRounded;
  }

  ///@{
  /// For messages.
  std::string NameOf(std::uint32_t solid) const;
  std::string TextOf(const SkdSplitEdge& edge, const SkdFacets& facets) const;
  ///@}

  ///@{
  /// Whether Update split the surfaces; the triangles; where they are; what they are split into.
  bool IsNew() const { return this->WasSplit; }
  const SkdTriangleSet& GetTriangles() const
  {
    return this->Near ? this->Pair->GetSet() : this->Triangles;
  }
  const SkdPlacement& GetPlacement() const { return *this->Placement; }
  const SkdArrangement& GetArrangement() const { return this->Arrangement; }
  ///@}

  ///@{
  /// See SkdAlignFaces: points that were moved, and the bits of each block.
  vtkIdType GetNumberAligned() const { return this->NumberAligned; }
  const std::vector<int>& GetCoordinateBits() const { return this->CoordinateBits; }
  ///@}

  ///@{
  /// Triangles that were arranged, and of these those that are in pieces.
  vtkIdType GetNumberArranged() const
  {
    return this->Near ? this->Near->GetNumberArranged()
                      : static_cast<vtkIdType>(this->Triangles.GetTriangles().size());
  }
  vtkIdType GetNumberSplit() const
  {
    return this->Near ? this->Near->GetNumberSplit() : this->Arrangement.NumberSplit;
  }
  ///@}

  ///@{
  /// The solids and whether they are the two inputs; the winding numbers of each region, or none;
  /// the edges along which the surface of each solid is not closed.
  const SkdSolids& GetSolids() const { return this->Solids; }
  bool AreSolidsInputs() const { return this->AreInputs; }
  const std::vector<SkdRegionWindings>& GetWindings() const { return this->Windings; }
  const std::vector<SkdBadEdges>& GetBadEdges() const { return this->BadEdges; }
  ///@}

private:
  /// The boundary of what is solid, with what generalized winding numbers say of open surfaces.
  template <class IsSolid>
  SkdFacetSigns FindSigns(const IsSolid& isSolid) const
  {
    if (this->Sides.empty())
    {
      return SkdFindBoundary(this->Arrangement, this->Windings, isSolid);
    }
    SkdFacetSigns signs(this->Arrangement.Facets.GetNumberOfFacets());
    for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
    {
      signs[facet] = static_cast<signed char>(
        isSolid(this->WindingsAt(facet, true)) - isSolid(this->WindingsAt(facet, false)));
    }
    return signs;
  }

  SkdRegionWindings WindingsAt(std::uint32_t facet, bool isBehind) const;
  /// What is within each input that is solid, by its components.
  template <class IsSolid>
  SkdBoundaryMeasures MeasureComponents(const IsSolid& isSolid) const
  {
    SkdBoundaryMeasures measures;
    for (const SkdRigidPair::Component& component : this->Pair->GetComponents())
    {
      const auto isSolidAt = [&](int number)
      {
        return isSolid(number == 0
            ? SkdRegionWindings()
            : SkdRegionWindings{ { component.IsOfSource ? 1u : 0u, number } });
      };
      const int sign = isSolidAt(component.InFront + 1) - isSolidAt(component.InFront);
      measures.Volume += sign * component.Volume;
      measures.Area += sign != 0 ? component.Area : 0.0;
    }
    return measures;
  }

  void FindSides();
  bool Read(const SkdBooleanBlocks& blocks, double chordalDeviation, SkdTriangleSet& to);
  std::optional<bool> UpdateTriangles(
    const SkdBooleanBlocks& blocks, double chordalDeviation, bool mayBeNear, vtkAlgorithm* filter);
  bool ArrangeNear(
    const SkdBooleanBlocks& blocks, const skd::RigidMotion& motion, vtkAlgorithm* filter);
  bool PreparePair(const SkdBooleanBlocks& blocks, vtkAlgorithm* filter);
  void ForgetArrangement();
  SkdBooleanBoundary SelectPieces(const SkdBooleanRule& rule, bool closesCut) const;
  bool Arrange(
    const SkdSolids& solids, bool areInputs, const SkdBooleanRule& rule, vtkAlgorithm* filter);
  bool CombineInPairs(const SkdSolids& solids, bool areInputs, const SkdBooleanRule& rule,
    SkdSelfPairs& pairs, vtkAlgorithm* filter);
  SkdSolids MakeSolids(const SkdBooleanBlocks& blocks, bool areInputs) const;
  SkdBoundaryMeasures Measure(const SkdFacets& facets, const SkdFacetSigns& signs) const;
  std::optional<SkdSheetFaults> PlaceSheet();
  bool FindWindingsOverAll();

  std::optional<SkdSelfPairs> FindPairs(std::size_t most, vtkAlgorithm* filter);

  const SkdSpreadSolids* Spread = nullptr;
  SkdTransport* Transport = nullptr;
  SkdTriangleSet Triangles;
  bool IsAligned = false; // the triangles
  vtkIdType NumberAligned = 0;
  std::vector<int> CoordinateBits;      // of each block
  std::optional<SkdTriangleSet> AsRead; // with the Source where it was, if that has moved
  std::optional<skd::RigidMotion> Motion;
  SkdPairCache OfInput;
  int FirstOfSource = 0;
  bool WasSplit = false;
  std::optional<SkdPlacement> Placement; // none: not arranged
  SkdArrangement Arrangement;
  SkdFaceSets Faces;
  std::vector<std::uint32_t> EqualPoints; // see SkdFindEqualPoints
  SkdSolids Solids;
  bool AreInputs = false;
  std::vector<SkdBadEdges> BadEdges;
  std::vector<SkdRegionWindings> Windings; // empty: not known
  bool AreRounded = false;
  std::vector<SkdSideNumbers> Sides; // of surfaces that are not closed, if these are rounded
  std::optional<SkdCombinedSolids> Combined; // none: there is an arrangement
  std::unique_ptr<SkdRigidPair> Pair;        // of the inputs, once the Source has moved twice
  int PairTries = 0;                         // times that it was tried to make one
  std::unique_ptr<SkdNearArrangement> Near;  // none: all triangles are arranged
};
}

#endif
