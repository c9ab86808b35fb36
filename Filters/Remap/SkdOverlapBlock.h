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
  double Reach;                       ///< how far from there it goes
  skd::Moments Own;                   ///< about the reference, without the sign
};

/// Some cells that follow each other.
struct SkdOverlapBlock
{
  std::vector<std::uint32_t> FirstPiece; ///< of each cell, and one more
  std::vector<SkdOverlapPiece> Pieces;
  std::vector<skd::Vector3> Corners;
  std::vector<vtkIdType> PointIds;           ///< of the corners, if requested
  std::deque<skd::SolidTopology> Topologies; ///< of polyhedra that are no tetrahedra and so on
};

/// What is to be read of a mesh.
struct SkdOverlapReading
{
  bool IsLonLat = false;
  bool SkipsGhosts = true;
  bool IntoSimplices = false; ///< triangles and tetrahedra of the cells' own points, with their ids
};

#endif
