// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTriangleSplitter.h
 * @brief One triangle of a set, split along its segments.
 */

#ifndef SkdTriangleSplitter_h
#define SkdTriangleSplitter_h

#include "Solids/Surfaces/SkdSplitRegions.h"
#include "Solids/Surfaces/SkdSplitSegments.h"

#include <map>
#include <optional>

namespace skdtree
{
/// A corner of pieces: one of the triangle's, or a point.
struct SkdSplitCorner
{
  skd::Vector3 X;
  std::uint32_t Point; ///< SkdSplitSegments::None of the triangle's own
  unsigned Edges;      ///< of the triangle that it lies on, a bit each
};

/// Positions and exact signs of the corners of pieces in a triangle, which turns left as seen.
class SkdSplitCorners
{
public:
  SkdSplitCorners(const SkdSplitPoints& points, const skd::ProjectedTriangle& triangle);

  /// Adds a point. Returns its number here; 0, 1 and 2 are the triangle's corners.
  int Add(std::uint32_t point, unsigned edges);

  int Count() const { return static_cast<int>(this->All.size()); }
  const SkdSplitCorner& operator[](int i) const { return this->All[static_cast<std::size_t>(i)]; }

  /// @{ The interface that a constrained triangulation needs.
  int Orient(int a, int b, int c);
  bool IsBetter(int a, int b, int c, int d) const;
  ///@}

private:
  SkdSplitPosition GetSplitPosition(int i) const;
  const skd::ExactPoint& GetExact(int i);

  const SkdSplitPoints& Points;
  const int Axis;
  const int Sign;
  std::vector<SkdSplitCorner> All;
  std::array<std::optional<skd::ExactPoint>, 3> ExactCorners; // made at the first use
};

class SkdTriangleSplitter
{
public:
  SkdTriangleSplitter(
    const SkdSplitSegments& segments, const SkdSplitSegments::Side& side, std::uint32_t triangle);

  /// The pieces, for the elements of this triangle. Corners are those of the set, or points counted
  /// on from these.
  std::vector<SkdTriangleSet::Corners> Split(
    const SkdSplitElement* first, const SkdSplitElement* last);

  ///@{
  /// After Split(): the corners of pieces, their numbers as above, and the edges along curves.
  const SkdSplitCorners& GetCorners() const { return this->Corners; }
  std::uint32_t IdOf(int corner) const;
  const std::vector<SkdSplitEdge>& GetCurves() const { return this->Curves; }
  ///@}

private:
  std::uint32_t Find(std::uint32_t point) const { return this->Segments.GetPoints().Find(point); }
  void CollectCorners(const SkdSplitElement* first, const SkdSplitElement* last);
  void CollectEdges();
  void CollectInside(const SkdSplitElement* first, const SkdSplitElement* last);

  const SkdSplitSegments& Segments;
  const SkdSplitSegments::Side& Side;
  const SkdTriangleSet::Corners TriangleCorners;
  SkdSplitCorners Corners;
  std::map<std::uint32_t, int> Known;     // the corner that a point is
  std::vector<std::array<int, 3>> Border; // a point, and the neighbours between which it comes
  std::vector<std::pair<int, int>> Inner; // edges that must be
  std::vector<SkdSplitEdge> Curves;
};
}

#endif
