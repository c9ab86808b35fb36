// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSplitPoints.h
 * @brief The points at which surfaces are split: those of contacts, and crossings of segments
 * between these. Signs are exact, so coincident points are recognized.
 */

#ifndef SkdSplitPoints_h
#define SkdSplitPoints_h

#include "Core/Geometry/DisjointSets.h"
#include "Solids/Surfaces/SkdContactPoints.h"

#include <array>
#include <atomic>
#include <deque>
#include <limits>
#include <optional>

namespace skdtree
{
/// A position, and the axes along which it is exact, a bit each.
struct SkdSplitPosition
{
  const skd::Vector3& X;
  unsigned ExactAxes;
};

/// The exact sign of the area of three points as seen along an axis, if coordinates that are exact
/// tell it.
std::optional<int> SkdOrientByCoordinates(
  const SkdSplitPosition& a, const SkdSplitPosition& b, const SkdSplitPosition& c, int axis);

class SkdSplitPoints
{
public:
  /// Contact points keep their numbers.
  SkdSplitPoints(const SkdContactPoints& contacts, const SkdPlacement& placement);
  ~SkdSplitPoints();
  SkdSplitPoints(const SkdSplitPoints&) = delete;
  SkdSplitPoints& operator=(const SkdSplitPoints&) = delete;

  std::uint32_t GetNumberOfPoints() const { return static_cast<std::uint32_t>(this->Same.Size()); }

  /// Adds the point where the segment between two contact points crosses another of the same plane,
  /// which has an area along the axis.
  std::uint32_t AddCrossing(const std::array<std::uint32_t, 4>& ends, int axis);

  /// @{ Coincident points: merges two, and returns whether they were different; the representative
  /// of a point.
  bool Unite(std::uint32_t a, std::uint32_t b);
  std::uint32_t Find(std::uint32_t point) const;
  ///@}

  /// @{ The position of a point, with the placement's scale: rounded, to within GetError() in each
  /// coordinate; or exact, which is slow at its first use. Thread-safe.
  const skd::Vector3& GetPosition(std::uint32_t point) const { return this->Positions[point]; }
  const skd::ExactPoint& GetExact(std::uint32_t point) const;
  unsigned GetExactAxes(std::uint32_t point) const { return this->ExactAxes[point]; }
  SkdSplitPosition GetSplitPosition(std::uint32_t point) const
  {
    return { this->Positions[point], this->ExactAxes[point] };
  }
  double GetError() const { return this->Error; }

  /// Frees all exact positions. They are found again when asked for. Not thread-safe.
  void ForgetExact() const;

  /// That error, for points whose coordinates have magnitudes up to `extent`.
  static double ErrorOf(double extent)
  {
    return 16.0 * std::numeric_limits<double>::epsilon() * extent;
  }
  ///@}

  /// The exact sign of the area of three points as seen along an axis.
  int Orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const;

  /// The same, where rounded positions have been found not to tell it.
  int OrientExactly(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const;

  /// The exact sign of a - b along an axis.
  int Compare(std::uint32_t a, std::uint32_t b, int axis) const;

  /// An axis along which two points differ; -1 for coincident points.
  int FindAxis(std::uint32_t a, std::uint32_t b) const;

private:
  struct ExactPosition;
  struct Crossing
  {
    std::array<std::uint32_t, 4> Ends;
    int Axis;
  };
  skd::ExactPoint MakeExact(std::uint32_t point) const;
  const skd::ClosePoint& GetClose(std::uint32_t point) const;
  const ExactPosition& AskExact(std::uint32_t point) const;
  unsigned char FindExactAxes(
    const std::array<std::uint32_t, 4>& ends, const skd::Vector3& position) const;

  const SkdContactPoints& Contacts;
  double Error;
  std::vector<Crossing> Crossings;
  std::vector<skd::Vector3> Positions;
  std::vector<unsigned char> ExactAxes;                           // of these, a bit each
  mutable std::deque<std::atomic<const ExactPosition*>> Exact;    // nullptr: not known yet
  mutable std::vector<std::atomic<const skd::ClosePoint*>> Close; // of contact points, the same
  skd::DisjointSets<> Same;                                       // points of one position
};
}

#endif
