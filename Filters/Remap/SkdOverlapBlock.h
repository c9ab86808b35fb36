// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapBlock.h
 * @brief Convex pieces of cells, as they are kept.
 */

#ifndef SkdOverlapBlock_h
#define SkdOverlapBlock_h

#include "Core/Geometry/Overlap/Moments.h"
#include "Core/Geometry/Overlap/SolidTopology.h"

#include "vtkType.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace skdtree
{
/// A convex piece of a cell: a segment, a polygon, a cell between meridians and parallels (corners
/// are then West, East and South, North), or a polyhedron. A cell is the sum of its pieces, which
/// count negative where cells are concave.
struct SkdOverlapPiece
{
  std::uint32_t FirstCorner;
  std::uint16_t Size; ///< corners
  std::int8_t Sign;
  bool IsLonLat;
  const skd::SolidTopology* Topology; ///< of a polyhedron
  skd::Vector3 Reference;             ///< a point of it
  double Radius;                      ///< how far from there it goes
  skd::Moments Own;                   ///< about the reference, without the sign
};

/// What is known of a polygon by its outline.
struct SkdPolygonMark
{
  std::int8_t Orientation =
    0;                  ///< on a sphere 1 if counter-clockwise as it was given, seen from outside
  bool IsLarge = false; ///< more than an eighth of the sphere
  bool CrossesItself = false;
};

/// Some cells that follow each other.
struct SkdOverlapBlock
{
  std::vector<SkdPolygonMark> Marks;     ///< of each cell
  std::vector<std::uint32_t> FirstPiece; ///< of each cell, and one more
  std::vector<SkdOverlapPiece> Pieces;
  std::vector<skd::Vector3> Corners;
  std::deque<skd::SolidTopology> Topologies; ///< of polyhedra that are no tetrahedra and so on

  ///@{
  /// If requested: the point of each corner, or -1 - (where in Weights those of its cell's points
  /// begin) of a corner that is none. OwnPoints are the points of cells that have such corners,
  /// from FirstOwnPoint of each cell on.
  std::vector<vtkIdType> PointIds;
  std::vector<double> Weights;
  std::vector<vtkIdType> OwnPoints;
  std::vector<std::size_t> FirstOwnPoint;
  ///@}
};

/// What is to be read of a mesh.
struct SkdOverlapReading
{
  bool IsLonLat = false;
  bool SkipsGhosts = true;
  bool IntoSimplices = false; ///< with the points, or their weights, of the simplices' corners
};
}

#endif
