// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBoolean.h
 * @brief Boolean combinations of two closed surfaces, from both split along their contacts.
 */

#ifndef SkdBoolean_h
#define SkdBoolean_h

#include "Surfaces/SkdSplitTriangles.h"

enum class SkdBooleanOperation
{
  Union,
  Intersection,
  Difference,
  ReverseDifference,
  SymmetricDifference
};

/// The edges along which triangles do not pass as often in one direction as in the other: those of
/// gaps, and between triangles turned against each other.
struct SkdBadEdges
{
  vtkIdType Count = 0;
  SkdSplitEdge First{ 0, 0 };
};
SkdBadEdges SkdFindBadEdges(const SkdTriangleSet::Corners* triangles, std::size_t count);

/// Six times the signed volume within closed triangles.
double SkdSixVolumes(const SkdPlacedTriangles& set);

/// A triangle of the result.
struct SkdBooleanPiece
{
  SkdTriangleSet::Corners Corners; ///< numbers of SkdBooleanResult::Points
  int Side;                        ///< 0: of the first surface, 1: of the second
  std::uint32_t Parent;            ///< the triangle there
};

/// A point of the result: as a surface has it, the first if both do. `Local` is a number of its set
/// or, counted on from these, of its split result's new points.
struct SkdBooleanPoint
{
  skd::Vector3 Position; ///< with the placement's scale
  int Side;
  std::uint32_t Local;
};

struct SkdBooleanResult
{
  std::vector<SkdBooleanPiece> Pieces;
  std::vector<SkdBooleanPoint> Points;
};

/// What bounds the combination of two solids, with the solid behind each face. Both surfaces must
/// be closed and oriented; one whose volume is negative is turned over. Regions between contacts
/// are classified as a whole: by exact signs at an edge in which a piece meets two faces of the
/// other surface or, without one, by the winding number of the other surface at one point. Faces
/// that coincide are found by the exact contacts and their orientation, and are there once.
SkdBooleanResult SkdCombine(const SkdPlacement& placement,
  const std::vector<SkdTrianglePair>& pairs, const SkdContactPoints& contacts,
  const SkdSplitSegments& segments, const std::array<SkdSplitResult, 2>& split,
  SkdBooleanOperation operation);

#endif
