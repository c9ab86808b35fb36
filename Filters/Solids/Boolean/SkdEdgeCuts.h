// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdEdgeCuts_h
#define SkdEdgeCuts_h

#include "Solids/Boolean/SkdFacePoints.h"
#include "Solids/Boolean/SkdPieceParts.h"
#include "Solids/Boolean/SkdRoundedFacets.h"

#include <map>
#include <set>

namespace skdtree
{
/// Points in which edges of one plane cross, or end on each other to within a tolerance. Edges are
/// given by the points at their ends. O(log n) for each pair, of n edges that are cut.
class SkdEdgeCuts
{
public:
  using Ends = std::pair<std::uint32_t, std::uint32_t>; // of an edge, ascending

  /// `parts` tells the faces that facets are of.
  SkdEdgeCuts(const SkdMovedTriangles& set, const SkdFacets& facets, const SkdPieceParts& parts)
    : Set(set)
    , Facets(facets)
    , Parts(parts)
    , First(static_cast<std::uint32_t>(set.GetPoints().size() + facets.NewPoints.size()))
  {
  }

  static Ends EndsOf(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

  /// The plane of the edges that are given next, by its normal of length 1.
  void SetPlane(const skd::Vector3& normal, double tolerance)
  {
    this->Normal = normal;
    this->Tolerance = tolerance;
  }

  /// Cuts two edges where they cross, or an end of one is on the other.
  void Meet(const Ends& a, const Ends& b);

  bool IsEmpty() const { return this->Cuts.empty(); }
  bool IsCut(const Ends& edge) const { return this->Cuts.count(edge) != 0; }

  /// The points in which an edge is cut, from its lower end on.
  std::vector<std::uint32_t> ListPoints(const Ends& edge) const;

  bool IsNew(std::uint32_t point) const { return point >= this->First; }
  skd::Vector3 At(std::uint32_t point) const
  {
    return this->IsNew(point) ? this->Positions[point - this->First]
                              : this->Facets.GetPosition(this->Set, point);
  }

  /// Facets of a boundary; those that have an edge that is cut, divided there. They pass edges as
  /// often in both directions as before.
  SkdRoundedFacets Split(const SkdFacetSigns& signs) const;

  /// What facets become is collected with the new points that they have.
  class Collector
  {
  public:
    Collector(const SkdEdgeCuts& cuts);
    void Add(const SkdTriangleSet::Corners& corners, std::uint32_t parent, signed char sign);
    SkdRoundedFacets Take();

  private:
    const SkdEdgeCuts& Cuts;
    SkdFacePoints OnFaces;
    SkdRoundedFacets Collected;
    std::vector<SkdSplitPoint> Points;
    std::vector<bool> IsAdded; // new points
  };

private:
  using Corners = SkdTriangleSet::Corners;
  static constexpr std::uint32_t None = 0xffffffffu;
  using Cut = std::pair<double, std::uint32_t>; // how far along from the lower end, and the point

  bool CutAt(const Ends& edge, std::uint32_t point);
  double DistanceOf(const Ends& edge, std::uint32_t point) const;
  bool DoCross(const Ends& a, const Ends& b) const;
  std::uint32_t FindCut(const Ends& edge, const skd::Vector3& x) const;
  void CutBoth(const Ends& a, const Ends& b);
  std::vector<Corners> PiecesOf(std::uint32_t facet) const;

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdPieceParts& Parts;
  skd::Vector3 Normal{};
  double Tolerance = 0.0;
  std::uint32_t First;                 // new point
  std::vector<skd::Vector3> Positions; // of new points
  std::map<Ends, std::vector<Cut>> Cuts;
  std::set<std::pair<Ends, Ends>> Crossings; // pairs of edges
};
}

#endif
