// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdQueryShape.h
 * @brief What a mesh is asked about (section 3's object q), and what the boxes of cells say of it.
 *
 * A shape is a ball (a point, when its radius is 0), a plane, or a set of simplices: a box, which
 * may be turned and flat, a line, a cell. All are closed. One that is not finite, or a ball of a
 * negative radius, is not usable: nothing is related to it.
 */

#ifndef SkdQueryShape_h
#define SkdQueryShape_h

#include "Cells/SkdCellTree.h"
#include "Core/Geometry/SimplexSet.h"
#include "Core/Geometry/Sphere.h"

#include <memory>
#include <vector>

class SkdCellOutline;

/// The kinds of section 3, the object's relation to the shape: it is the same, has a point in
/// common, encloses the shape, is enclosed by it, has a common boundary, is among the nearest.
enum class SkdRelation
{
  ExactMatch,
  Overlap,
  Enclosure,
  Containment,
  Adjacency,
  Nearest
};

class SkdQueryShape
{
public:
  enum class Kind
  {
    Ball,
    Plane,
    Box,
    Line,
    Cell
  };

  static SkdQueryShape MakeBall(const skd::Vector3& centre, double radius);
  static SkdQueryShape MakePlane(const skd::Vector3& origin, const skd::Vector3& normal);
  static SkdQueryShape MakeLine(const skd::Vector3& a, const skd::Vector3& b);
  /// The box from a corner along three axes, whose lengths are those of its edges; 0 for a flat
  /// one.
  static SkdQueryShape MakeBox(const skd::Vector3& corner, const skd::Vector3 (&edges)[3]);
  /// A cell, and its points, edges and faces if it is asked for neighbours.
  static SkdQueryShape MakeCell(const SkdCellTree& tree, std::uint32_t cell,
    const SkdCellSource& source, std::shared_ptr<const SkdCellOutline> outline);

  Kind GetKind() const { return this->TheKind; }
  bool IsUsable() const { return this->Usable; }
  const skd::Sphere<3>& GetBall() const { return this->Ball; }
  const skd::Plane<3>& GetPlane() const { return this->Plane; }
  const skd::SimplexSet& GetSet() const { return this->Set; } ///< of a box, line or cell
  const SkdCellOutline* GetOutline() const { return this->Outline.get(); } ///< of a cell

  /// Of all but planes.
  const skd::Box3& GetBounds() const { return this->Bounds; }

  /// A distance that is not more is 0 to within rounding: 8 units in the last place of the largest
  /// coordinate of the shape or of the mesh.
  double Rounding(const SkdCellTree& tree) const;

  /// The cells whose safety boxes may come as near as `reach`, ascending.
  std::vector<std::uint32_t> FindNear(const SkdCellTree& tree, double reach) const;

  ///@{
  /// Section 4: the distances of the nearest and the farthest points of a box and the shape (of a
  /// plane, the box's farthest from it). A cell stands for its box: these are then optimistic and
  /// pessimistic about it, and so they are if a cell is the shape, for that stands for its box too.
  double OptimisticDistance(const skd::Box3& box) const;
  double PessimisticDistance(const skd::Box3& box) const;
  /// Less than the optimistic distance, or equal, and quickly found.
  double LowerBound(const skd::Box3& box) const;
  ///@}

  /// Whether the cell's box allows the relation to within a tolerance, Nearest left out: true for
  /// all cells for which it holds, and some more. All: its safety box has a point in common with
  /// the shape (if that is a cell, with its safety box). Besides, Enclosure: its safety box holds
  /// the shape's bounding box; Containment: its bounding box is within that one; ExactMatch: both
  /// are equal.
  bool IsCandidate(
    SkdRelation relation, const SkdCellTree& tree, std::uint32_t cell, double tolerance) const;

  /// Whether all of a box is in the shape, so that nothing need be asked of what is in the box.
  bool IsSureToHold(const skd::Box3& box) const;

private:
  static SkdQueryShape MakeSet(Kind kind, skd::SimplexSet set);
  bool AreBoundsRelated(
    SkdRelation relation, const SkdCellTree& tree, std::uint32_t cell, double tolerance) const;

  Kind TheKind = Kind::Ball;
  bool Usable = false;
  bool IsAligned = false; // a box along the axes
  skd::Sphere<3> Ball{ { { 0.0, 0.0, 0.0 } }, 0.0 };
  skd::Plane<3> Plane{ { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 0.0 } } };
  skd::SimplexSet Set;
  skd::Box3 Bounds;
  double Largest = 0.0;
  double SafetyMargin = 0.0; // of a cell's box
  std::shared_ptr<const SkdCellOutline> Outline;
};

#endif
