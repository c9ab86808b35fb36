// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCellOutline.h
 * @brief The points, edges and faces of a cell, and which of them another cell has, too.
 */

#ifndef SkdCellOutline_h
#define SkdCellOutline_h

#include "Core/Geometry/Vector.h"

#include <vector>

class vtkCell;

/// What neighbours have in common, at least.
enum class SkdSharedPart
{
  Point,
  Edge,
  Face
};

class SkdCellOutline
{
public:
  /// A cell of dimension 2 is a face of its own, and one of dimension 1 its own edge, or when it is
  /// a polyline an edge a segment.
  explicit SkdCellOutline(vtkCell* cell);

  /// Whether the two have a point, an edge or a face in common: all points of it within the
  /// tolerance of each other. Two cells of the same dimension and the same points are one: they
  /// share nothing. A volume cell that does not know its edges (a convex point set) shares an edge
  /// if it shares two points, and a face if three.
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

#endif
