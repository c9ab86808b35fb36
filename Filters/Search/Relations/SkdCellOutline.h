// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCellOutline.h
 * @brief The points, edges and faces of a cell, and those shared with another cell.
 */

#ifndef SkdCellOutline_h
#define SkdCellOutline_h

#include "Core/Geometry/Vector.h"

#include <vector>

class vtkCell;

namespace skdtree
{
/// What adjacent cells must at least have in common.
enum class SkdSharedPart
{
  Point,
  Edge,
  Face
};

class SkdCellOutline
{
public:
  /// A cell of dimension 2 is its own face, one of dimension 1 its own edge; each segment of a
  /// polyline is an edge.
  explicit SkdCellOutline(vtkCell* cell);

  /// Whether the two have a point, an edge or a face in common: all points of it within the
  /// tolerance of each other. Two cells of the same dimension with the same points are identical
  /// and share nothing. A volume cell without explicit edges (a convex point set) shares an edge if
  /// it shares two points, and a face if three.
  bool Shares(const SkdCellOutline& other, SkdSharedPart part, double tolerance) const;

private:
  using Part = std::vector<int>; // of its points, ascending

  void AddPart(std::vector<Part>& parts, vtkCell* part, vtkCell* cell);
  void AddSteps();

  bool HasParts() const { return this->Dimension < 3 || !this->Edges.empty(); }

  int Dimension;
  std::vector<skd::Vector3> Points;
  std::vector<Part> Edges;
  std::vector<Part> Faces;
};
}

#endif
