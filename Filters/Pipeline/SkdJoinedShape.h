// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdJoinedShape.h
 * @brief What a mesh looks like as a whole, of which each process has some cells.
 */

#ifndef SkdJoinedShape_h
#define SkdJoinedShape_h

#include "Core/Geometry/Box.h"
#include "vtkDataSet.h"

#include <array>
#include <limits>
#include <optional>

namespace skdtree
{
struct SkdJoinedShape
{
  vtkIdType Points = 0;
  int Dimension = -1; ///< the largest of its cells that are shown
  skd::Box3 Bounds;   ///< of the points
  ///@{
  /// Distances of the points from the origin, and the sum and number of those that are positive.
  double LeastRadius = std::numeric_limits<double>::max();
  double GreatestRadius = 0.0;
  double SumOfRadii = 0.0;
  vtkIdType PointsOffOrigin = 0;
  ///@}
  skd::Vector3 Normal{ { 0.0, 0.0, 0.0 } }; ///< SkdPlaneNormalOf
  vtkIdType NormalOf = -1;                  ///< the cell that it is of
  bool IsStructured = false;
  std::array<int, 3> CellsAlong{ { 0, 0, 0 } }; ///< each axis, of structured grids

  void AddPoint(const skd::Vector3& x);

  /// The normal of a cell: the longest is taken, of equal ones that of the lowest id.
  void AddNormal(const skd::Vector3& normal, vtkIdType id);

  /// What another process has.
  void Add(const SkdJoinedShape& other);

  /// If all points are on a sphere about the origin, its radius.
  std::optional<double> GetRadius() const;

  /// All points at one radius.
  void MoveToSphere(double radius);

  ///@{
  /// Kept as field data of the mesh that a process has.
  static std::optional<SkdJoinedShape> Of(vtkDataSet* mesh);
  void KeepIn(vtkDataSet* mesh) const;
  ///@}
};

/// The highest dimension of a mesh's cells that are shown, or, if it has a shape, of the whole; -1
/// if there are none.
int SkdDimensionOf(vtkDataSet* mesh);

/// The mean distance of the points of a mesh or, if it has a shape, of the whole, from the origin
/// if all have that distance, to a part in 10^5, and they are not all in a plane across an axis.
/// Nothing else.
std::optional<double> SkdRadiusOf(vtkDataSet* mesh);

/// How many of the first cells give the normal of a plane: enough to meet one that is no sliver.
constexpr vtkIdType SkdCellsForNormal = 1000;

/// The normal of the plane through the first three corners of a cell, twice as long as their
/// triangle's area; zero of a cell with fewer.
skd::Vector3 SkdNormalOfCorners(vtkDataSet* mesh, vtkIdType cell);

/// Of those of the first cells of a mesh (of the whole, if it has a shape) the longest, whose
/// direction rounding changes least. Any cell of a mesh in a plane would do.
skd::Vector3 SkdPlaneNormalOf(vtkDataSet* mesh);
}

#endif
