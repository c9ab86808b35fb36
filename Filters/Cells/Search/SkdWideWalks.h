// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries, the exact test of volume cells and the boxes of cells that trees are built of, compiled
/// for processors with AVX2 and FMA, with eight lanes a register, selected at run time. Answers are
/// identical to the last bit: lanes perform the same operations with the same rounding, however
/// many there are in a register.
///
/// SkdWideWalks.cxx is the only file compiled for AVX2. It has the core in its own namespace, so
/// that no inline function compiled for AVX2 replaces one that must run anywhere. Its interface
/// therefore uses no type of the core: what `View` and `Packets` point to has the same layout under
/// both names.
#ifndef SkdWideWalks_h
#define SkdWideWalks_h

#include <cstddef>
#include <cstdint>

namespace skdtree
{
/// A tree of cells and the packets of its leaves.
struct SkdWideTree
{
  const void* View;    ///< skd::CompactTree
  const void* Packets; ///< skd::TrianglePackets
};

/// Measures a cell, and returns the new limit of the search.
struct SkdWideVisitor
{
  template <class Visitor>
  static SkdWideVisitor Of(Visitor& visitor)
  {
    return { [](void* self, std::uint32_t cell) -> double
      { return (*static_cast<Visitor*>(self))(cell); },
      &visitor };
  }

  double operator()(std::uint32_t cell) const { return this->Call(this->Self, cell); }

  double (*Call)(void*, std::uint32_t);
  void* Self;
};

/// Receives a triangle that is hit, and returns the new limit of the search.
struct SkdWideHits
{
  template <class Hit, class Visitor>
  static SkdWideHits Of(Visitor& visitor)
  {
    return { [](void* self, std::uint32_t cell, const void* hit) -> double
      { return (*static_cast<Visitor*>(self))(cell, *static_cast<const Hit*>(hit)); },
      &visitor };
  }

  /// `hit`: skd::TriangleHit
  double (*Call)(void*, std::uint32_t cell, const void* hit);
  void* Self;
};

/// The same of some lines: which of them it is.
struct SkdWidePacketHits
{
  template <class Hit, class Visitor>
  static SkdWidePacketHits Of(Visitor& visitor)
  {
    return { [](void* self, int line, std::uint32_t cell, const void* hit) -> double
      { return (*static_cast<Visitor*>(self))(line, cell, *static_cast<const Hit*>(hit)); },
      &visitor };
  }

  double (*Call)(void*, int line, std::uint32_t cell, const void* hit);
  void* Self;
};

/// Two cells, and whether they are a pair for sure.
struct SkdWidePair
{
  std::uint32_t First;
  std::uint32_t Second;
  bool IsSure;
};

/// Receives some of the pairs that a walk finds, in turn.
struct SkdWidePairs
{
  template <class Visitor>
  static SkdWidePairs Of(const Visitor& visitor)
  {
    return { [](const void* self, const SkdWidePair* pairs, int count)
      { (*static_cast<const Visitor*>(self))(pairs, count); },
      &visitor };
  }

  void (*Call)(const void*, const SkdWidePair*, int);
  const void* Self;
};

/// skd::Nearest, skd::AlongSegment and skd::VisitTriangleHits with the leaf filters of
/// Core/Search/LeafFilters/TriangleLeafFilters.h, and skd::WithinBox of a point with that of
/// PlaneLeafFilter.h.
class SkdWideWalks
{
public:
  /// Whether this build has them, this processor supports them, and the environment variable
  /// SKDTREE_BASELINE is not set.
  static bool AreOn();
  /// For tests, while no query runs. Has no effect if they are not available.
  static void TurnOn(bool on);

  static void Nearest(const SkdWideTree& tree, const double x[3], double limit2, bool onlyNearest,
    const SkdWideVisitor& visitor);
  /// `planes`: skd::PlanePackets; a limit that is negative ends the search.
  static void AboutPoint(
    const SkdWideTree& tree, const void* planes, const double x[3], const SkdWideVisitor& visitor);
  /// skd::ClosestPointInCell of a pyramid, wedge or hexahedron, by its number of points. `from`:
  /// skd::PointArray; sets the cell's points, so many skd::Vector3, and `found`, skd::VolumePoint
  static void ClosestPointInCell(int size, const void* from, const std::uint32_t* ids,
    const double x[3], double limit2, void* points, void* found);
  /// skd::CellElements; `cells`: skd::CellPoints, `frame`: skd::Frame<3>, `to`: skd::Element<3>
  static void ReadElements(const void* cells, const void* frame, double margin,
    const std::uint32_t* numbers, std::size_t count, void* to);
  /// skd::OverlappingBox; `box`: skd::Box3
  static void OverlappingBox(const SkdWideTree& tree, const void* box, double excess,
    const SkdWideVisitor& visitor, const SkdWideVisitor& sure);
  /// skd::OverlappingPairs of trees in one world, from `start` on: skd::TreePair<3>
  static void OverlappingPairs(const SkdWideTree& first, const SkdWideTree& second,
    const void* start, double excess, const SkdWidePairs& visitor);
  /// `segment`: skd::Segment<3>
  static void AlongSegment(const SkdWideTree& tree, const void* segment, double margin,
    bool inOrder, const SkdWideVisitor& visitor);
  static void VisitTriangleHits(const SkdWideTree& tree, const void* segment, double tolerance,
    bool inOrder, const SkdWideHits& visitor);
  /// skd::VisitPacketHits of skd::Segment<3>.
  static bool VisitPacketHits(const SkdWideTree& tree, const void* segments, int count,
    double maxSpread, double tolerance, bool inOrder, const SkdWidePacketHits& visitor);
};
}

#endif
