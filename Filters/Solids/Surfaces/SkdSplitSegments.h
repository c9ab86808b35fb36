// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSplitSegments.h
 * @brief The segments along which triangles are split, with all points that lie on them.
 *
 * Pairs of triangles give segments: their intersection, or the sides of the polygon in which they
 * overlap. Within one triangle, segments of several pairs may cross, touch and overlap; such a
 * point belongs to each of them, also in the other triangle of the segment. The points on segments
 * and edges are therefore computed until no further ones appear: then both surfaces have the same
 * points along all curves. All tests use exact signs.
 */

#ifndef SkdSplitSegments_h
#define SkdSplitSegments_h

#include "Solids/Surfaces/SkdSplitPoints.h"

#include <array>
#include <limits>
#include <optional>
#include <tuple>

namespace skdtree
{
/// A segment between two points, or with A = B a lone point.
struct SkdSplitSegment
{
  std::uint32_t A;
  std::uint32_t B;
  bool IsCurve;                       ///< a curve, or the border of an overlap
  std::uint32_t Pair;                 ///< that it is all of the contact of; None if of several
  std::vector<std::uint32_t> Between; ///< the points on it, from A to B
  bool IsNew = true;                  ///< or has new points
};

/// A segment in a triangle.
struct SkdSplitElement
{
  std::uint32_t Triangle;
  std::uint32_t Segment;
  skd::TriangleFeature FeatureOfA; ///< of the triangle
  skd::TriangleFeature FeatureOfB;

  /// The edges of the triangle that it lies on, a bit each.
  unsigned GetEdges() const
  {
    return skd::EdgesAt(this->FeatureOfA) & skd::EdgesAt(this->FeatureOfB);
  }
  bool operator<(const SkdSplitElement& other) const
  {
    return this->Triangle != other.Triangle ? this->Triangle < other.Triangle
                                            : this->Segment < other.Segment;
  }
  bool operator==(const SkdSplitElement& other) const
  {
    return this->Triangle == other.Triangle && this->Segment == other.Segment;
  }
};

/// A point on an edge between two corners of a set, the lower first.
struct SkdSplitEdgePoint
{
  std::uint32_t From;
  std::uint32_t To;
  std::uint32_t Point;
};

/// What is found where two segments of a triangle meet.
struct SkdSplitEvent
{
  enum Kinds
  {
    Same, ///< points A and B have one position
    On,   ///< point B is on segment A
    Cross ///< segments A and B cross, as seen along the axis
  };
  Kinds Kind;
  std::uint32_t A;
  std::uint32_t B;
  int Axis;

  bool operator<(const SkdSplitEvent& o) const
  {
    return std::tie(this->Kind, this->A, this->B, this->Axis) < std::tie(o.Kind, o.A, o.B, o.Axis);
  }
};

class SkdSplitSegments
{
public:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  /// Of more than `mostEvents` points where segments meet each other none is used: see IsTooMany().
  SkdSplitSegments(const SkdPlacement& placement, const std::vector<SkdTrianglePair>& pairs,
    const SkdContactPoints& contacts,
    std::size_t mostEvents = std::numeric_limits<std::size_t>::max());

  /// Whether more segments meet each other than was allowed. The same for any number of threads.
  bool IsTooMany() const { return this->HasTooMany; }

  const SkdSplitPoints& GetPoints() const { return this->Points; }
  const SkdSplitSegment& GetSegment(std::uint32_t segment) const { return this->Segments[segment]; }

  /// All points of a segment, including its ends, as representatives; consecutive ones differ.
  void GetChain(std::uint32_t segment, std::vector<std::uint32_t>& chain) const;

  /// The segments and points that split one of the sets (1: the second).
  struct Side
  {
    const SkdMovedTriangles* Set = nullptr;
    std::vector<SkdSplitElement> Elements;     ///< ascending
    std::vector<SkdSplitEdgePoint> EdgePoints; ///< by edge, along it
    std::vector<std::uint32_t> CornerOf;       ///< of each point, the set's corner there or None
  };
  const Side& GetSide(int side) const { return this->Sides[side]; }

  /// Frees what is no longer asked for once triangles are split: all but points and sets.
  void ForgetSegments()
  {
    this->Segments = std::vector<SkdSplitSegment>();
    for (Side& side : this->Sides)
    {
      side = { side.Set, {}, {}, {} };
    }
  }

private:
  struct PairSegment;

  std::vector<PairSegment> ListSegments() const;
  void AddElements(const std::vector<PairSegment>& list);
  void AddElementsOf(const PairSegment& of, std::uint32_t segment);

  /// What happens where the new segments of a side's triangles meet others of the same triangle,
  /// ascending, each once. In parallel; of a triangle with n segments O(n log n) plus what overlaps
  /// along an axis. Once there are more than allowed, others are left out. (SkdSplitEvents.cxx)
  std::vector<SkdSplitEvent> FindEvents(int side) const;
  bool FindAll();
  void MarkAsOld();
  void Apply(const std::vector<SkdSplitEvent>& events);
  std::uint32_t AddCrossing(const SkdSplitEvent& event);

  /// Of each event the first one that is surely the same crossing.
  std::vector<std::uint32_t> FindFirstCrossings(const std::vector<SkdSplitEvent>& events) const;
  std::optional<std::array<std::uint32_t, 3>> FindThree(const SkdSplitEvent& event) const;
  void AddBetween(std::uint32_t segment, std::uint32_t point);
  void SortBetween(SkdSplitSegment& segment);
  bool MeetAtEdges(Side& side);
  void CollectEdgePoints(Side& side) const;
  void SortEdgePoints(Side& side);
  bool TakeFromEdge(const Side& side, const SkdSplitElement& element);
  void UniteCorners();

  const std::vector<SkdTrianglePair>& Pairs;
  const SkdContactPoints& Contacts;
  SkdSplitPoints Points;
  std::vector<SkdSplitSegment> Segments;
  std::array<Side, 2> Sides;
  bool IsOfOne;
  std::size_t MostEvents;
  bool HasTooMany = false;
};
}

#endif
