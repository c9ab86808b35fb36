// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTriangleSplitter.h
 * @brief Triangles of a set, each split along its segments.
 */

#ifndef SkdTriangleSplitter_h
#define SkdTriangleSplitter_h

#include "Core/Geometry/Polygons/ConstrainedTriangulation.h"
#include "Solids/Surfaces/SkdSplitEdges.h"
#include "Solids/Surfaces/SkdSplitRegions.h"

#include <array>
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

  /// Segments of the triangle that it lies on, ascending. More than two are not kept.
  std::array<int, 2> Lines = { -1, -1 };

  bool IsOn(int line) const { return this->Lines[0] == line || this->Lines[1] == line; }
};

/// Positions and exact signs of the corners of pieces in a triangle, which turns left as seen.
class SkdSplitCorners
{
public:
  explicit SkdSplitCorners(const SkdSplitPoints& points)
    : Points(points)
  {
  }

  /// Begins with the corners of a triangle, 0, 1 and 2.
  void Begin(const skd::ProjectedTriangle& triangle);

  /// Adds a point. Returns its number here.
  int Add(std::uint32_t point, unsigned edges);

  /// Notes that a corner lies on a segment. These are numbered in the order of calls.
  void PutOnLine(int corner, int line);

  int Count() const { return static_cast<int>(this->All.size()); }
  const SkdSplitCorner& operator[](int i) const { return this->All[static_cast<std::size_t>(i)]; }

  /// @{ The interface that a constrained triangulation needs.
  int Orient(int a, int b, int c);
  bool IsBetter(int a, int b, int c, int d) const;
  ///@}

private:
  bool AreOnOneLine(int a, int b, int c) const;
  SkdSplitPosition GetSplitPosition(int i) const;
  const skd::ExactPoint& GetExact(int i);

  const SkdSplitPoints& Points;
  int Axis = 0;
  int Sign = 0;
  std::vector<SkdSplitCorner> All;
  std::array<std::optional<skd::ExactPoint>, 3> ExactCorners; // made at the first use
};

/// The corners that points are: a list as long as there are few.
class SkdCornersOfPoints
{
public:
  void Clear()
  {
    this->Few.clear();
    this->Many.clear();
  }

  /// The corner that a point is; this one if it is not known yet.
  int Add(std::uint32_t point, int corner)
  {
    if (!this->Many.empty())
    {
      return this->Many.emplace(point, corner).first->second;
    }
    for (const auto& known : this->Few)
    {
      if (known.first == point)
      {
        return known.second;
      }
    }
    this->Few.emplace_back(point, corner);
    if (this->Few.size() > Most)
    {
      this->Many.insert(this->Few.begin(), this->Few.end());
    }
    return corner;
  }

private:
  static constexpr std::size_t Most = 24;

  std::vector<std::pair<std::uint32_t, int>> Few;
  std::map<std::uint32_t, int> Many; // all, if there are more than few
};

/// Splits one triangle after the other, in the same memory.
class SkdTriangleSplitter
{
public:
  SkdTriangleSplitter(const SkdSplitSegments& segments, const SkdSplitSegments::Side& side,
    const SkdSplitEdges& edges);

  /// Adds the pieces, for the elements of this triangle. Corners are those of the set, or points
  /// counted on from these.
  void Split(std::uint32_t triangle, const SkdSplitElement* first, const SkdSplitElement* last,
    std::vector<SkdTriangleSet::Corners>& pieces);

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
  /// Points that follow each other on a side, between two that are on it already.
  void AddToBorder(int before, int begin, int end, int next);
  void CollectInside(const SkdSplitElement* first, const SkdSplitElement* last);
  template <class Triangulation>
  void AddInside(int begin, int end, Triangulation& made);

  const SkdSplitSegments& Segments;
  const SkdSplitSegments::Side& Side;
  const SkdSplitEdges& Edges;
  SkdTriangleSet::Corners TriangleCorners{};
  SkdSplitCorners Corners;
  SkdCornersOfPoints Known;
  std::vector<std::array<int, 3>> Border; // a point, and the neighbours between which it comes
  std::vector<std::pair<int, int>> Inner; // edges that must be
  std::vector<SkdSplitEdge> Curves;
  std::vector<std::uint32_t> Chain;
  std::vector<int> Slots;
  skd::TriangulationMemory Memory;
};
}

#endif
