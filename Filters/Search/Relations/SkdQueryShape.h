// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdQueryShape.h
 * @brief The query object q of section 3, and tests by the boxes of cells.
 *
 * A shape is a ball (a point, when its radius is 0), a plane, or a set of simplices: a box, which
 * may be rotated and flat, a line, a cell. All are closed. A shape that is not finite, or a ball of
 * negative radius, is invalid: no cell is related to it.
 */

#ifndef SkdQueryShape_h
#define SkdQueryShape_h

#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Simplices/SimplexSet.h"
#include "Core/Geometry/Sphere.h"

#include <memory>
#include <optional>
#include <vector>

namespace skdtree
{
class SkdCellOutline;

/// The relations of section 3 between object and shape: equal, a common point, encloses the shape,
/// enclosed by it, a common boundary, among the nearest.
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
  /// A cell, with its points, edges and faces for adjacency.
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
  /// Whether it is a box along the axes: its bounds.
  bool IsAlignedBox() const { return this->IsAligned; }

  /// A distance that is not more is 0 to within rounding: 8 units in the last place of the largest
  /// coordinate of the shape or of the mesh.
  double Rounding(const SkdCellTree& tree) const;

  ///@{
  /// The cells whose safety boxes come as near as `maxDistance`, by no more than their bounding
  /// boxes (of planes and lines: themselves), ascending. The tree must not be bare. FindMaybeNear:
  /// these, and some more, which IsNear() then rejects.
  std::vector<std::uint32_t> FindNear(const SkdCellTree& tree, double maxDistance) const;
  std::vector<std::uint32_t> FindMaybeNear(const SkdCellTree& tree, double maxDistance) const;
  bool IsNear(const SkdCellTree& tree, const skd::Box3& safetyBox, double maxDistance) const;
  ///@}

  ///@{
  /// Section 4: the distances of the nearest and the farthest points of a box and the shape (of a
  /// plane, the box's farthest from it). A cell stands for its box: these are then optimistic and
  /// pessimistic about it, and so they are if a cell is the shape, for that stands for its box too.
  double OptimisticDistance(const skd::Box3& box) const;
  double PessimisticDistance(const skd::Box3& box) const;
  /// A fast lower bound of the optimistic distance.
  double LowerBound(const skd::Box3& box) const;
  ///@}

  /// Whether the cell's box allows the relation to within a tolerance, Nearest left out: true for
  /// all cells for which it holds, and some more. All: its safety box has a point in common with
  /// the shape (if that is a cell, with its safety box). Besides, Enclosure: its safety box holds
  /// the shape's bounding box; Containment: its bounding box is within that one; ExactMatch: both
  /// are equal.
  bool IsCandidate(
    SkdRelation relation, const SkdCellTree& tree, std::uint32_t cell, double tolerance) const;

  /// The sides of the bounds, a bit each, that a point is beyond by more than the distance: what is
  /// straight between points that are all beyond one side is not nearer. None of a plane.
  unsigned char SidesOf(const skd::Vector3& x, double maxDistance) const;

  /// Whether a box lies entirely in the shape, so that its contents need no test.
  bool IsSureToHold(const skd::Box3& box) const;

  ///@{
  /// Balls and boxes along the axes hold all that is straight between points that they hold. What
  /// such a point is to them, and what the points of a cell are.
  struct Corner
  {
    double Farthest2; ///< its squared distance from the ball's centre, or the box's farthest point
    bool IsIn;
  };
  struct Corners
  {
    bool AreSomeIn;
    bool AreAllIn;
    double Farthest;    ///< of the farthest of them from the farthest point of the shape
    double Pessimistic; ///< PessimisticDistance() of the cell's safety box
  };
  bool LooksAtCorners() const { return this->TheKind == Kind::Ball || this->IsAligned; }
  Corner LookAt(const skd::Vector3& x) const;
  /// Nothing of other shapes, of cells that are not straight, and in meshes with curved cells.
  /// `known`: what LookAt() finds for each point of the mesh, or nullptr.
  std::optional<Corners> LookAtCorners(
    const SkdCellTree& tree, std::uint32_t cell, const Corner* known) const;
  ///@}

private:
  static SkdQueryShape MakeSet(Kind kind, skd::SimplexSet set);
  bool IsAsSegment(const SkdCellTree& tree, double maxDistance) const;
  double PessimisticFromCorners(const skd::Box3& box) const;
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
}

#endif
