// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdContactPoints.h
 * @brief The points of contact of pairs of triangles, each of them once.
 *
 * Points are identified by the features they lie on (a vertex; two edges; an edge and a triangle),
 * never by distance, so contacts of adjacent triangles match exactly.
 */

#ifndef SkdContactPoints_h
#define SkdContactPoints_h

#include "Core/Geometry/Predicates/ClosePoint.h"
#include "Core/Geometry/Predicates/ExactPoint.h"
#include "Core/Geometry/Segment.h"
#include "Solids/Surfaces/SkdTrianglePairs.h"

#include <utility>

namespace skdtree
{
class SkdContactPoints
{
public:
  /// How edges are directed before their crossings are computed: as their corners are numbered, or
  /// by coordinates, so that positions are the same to the last bit however points are numbered.
  enum class Directions
  {
    ByNumbers,
    ByCoordinates
  };

  /// Positions are given without the placement's scale. O(n log n) in the number of pairs.
  SkdContactPoints(const SkdPlacement& placement, const std::vector<SkdTrianglePair>& pairs,
    Directions directions = Directions::ByNumbers);

  std::uint32_t GetNumberOfPoints() const { return static_cast<std::uint32_t>(this->Keys.size()); }
  const skd::Vector3& GetPosition(std::uint32_t point) const { return this->Positions[point]; }
  const std::vector<skd::Vector3>& GetPositions() const { return this->Positions; }

  /// What a point lies on, with the placement's scale, however points are numbered.
  struct Location
  {
    std::array<skd::Vector3, 5> Corners; ///< each feature's ascending, of the first set's first
    int Number;                          ///< 1: a corner; 4: two edges; 5: an edge and a triangle

    ///@{
    /// Of an edge and a triangle.
    bool IsTriangleOfSecond;
    std::uint32_t Triangle; ///< in its set
    ///@}
  };
  Location Locate(std::uint32_t point) const;

  /// The exact position of a point, with the placement's scale: slow.
  skd::ExactPoint GetExact(std::uint32_t point) const;

  /// The same in pairs of doubles; nothing is known of a point where two edges cross.
  skd::ClosePoint GetClose(std::uint32_t point) const;

  /// Whether three points are on one edge of a set by what they are: then they are on a line, as
  /// the exact positions would tell much more slowly.
  bool AreOnOneEdge(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  /// The axes, a bit each, along which a position (with the placement's scale) is that of a point
  /// exactly: those that an edge or triangle which it is on is normal to.
  unsigned FindExactAxes(std::uint32_t point, const skd::Vector3& position) const;

  /// Point `i` of the contact of a pair.
  std::uint32_t GetPoint(std::size_t pair, int i) const
  {
    return this->Points[this->Offsets[pair] + static_cast<std::size_t>(i)];
  }

private:
  /// Two parts, each a corner (c, c), an edge (lower corner, higher corner) or the inside of a
  /// triangle (t, Inside); twice the same corner of a point that is one. The second set's corners
  /// and triangles are counted on from the first's.
  struct Feature
  {
    std::uint32_t A;
    std::uint32_t B;

    bool operator==(const Feature& other) const { return this->A == other.A && this->B == other.B; }
    /// Insides last: numbers of triangles are not compared with those of corners, of which there
    /// are more as long as equal points are several.
    bool operator<(const Feature& other) const
    {
      if (this->IsInside() != other.IsInside())
      {
        return other.IsInside();
      }
      return this->A != other.A ? this->A < other.A : this->B < other.B;
    }
    bool IsCorner() const { return this->A == this->B; }
    bool IsInside() const { return this->B == Inside; }
  };
  using Key = std::pair<Feature, Feature>;
  static constexpr std::uint32_t Inside = 0xffffffffu;

  Feature MakeFeature(bool isOfSecond, std::uint32_t triangle, skd::TriangleFeature feature) const;
  Key MakeKey(const SkdTrianglePair& pair, const skd::ContactPoint& point) const;
  std::vector<Key> MakeKeys(const std::vector<SkdTrianglePair>& pairs);
  void MakeCornersOne(const std::vector<SkdTrianglePair>& pairs, std::vector<Key>& keys) const;
  static bool IsOn(const Feature& edge, const Key& key);
  skd::Vector3 FindPosition(const Key& key, Directions directions) const;
  unsigned FindExactAxes(const Feature& feature, const skd::Vector3& position) const;
  const skd::Vector3& CornerAt(std::uint32_t corner) const;
  skd::Segment<3> EdgeAt(const Feature& edge) const;
  skd::Segment<3> AscendingEdgeAt(const Feature& edge) const;
  void OrderEdges(skd::Segment<3>& edge, skd::Segment<3>& other) const;
  std::array<skd::Vector3, 3> TriangleAt(std::uint32_t triangle) const;

  const SkdMovedTriangles& First;
  const SkdMovedTriangles* Second;  // nullptr of one alone
  std::vector<std::size_t> Offsets; // where the points of a pair begin
  std::vector<std::uint32_t> Points;
  std::vector<Key> Keys; // ascending
  std::vector<skd::Vector3> Positions;
};
}

#endif
