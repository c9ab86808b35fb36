// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellShape.h
 * @brief a linear cell as points, segments, triangles and bilinear patches, apart from VTK's code
 */
#ifndef skdtest_CellShape_h
#define skdtest_CellShape_h

#include "Support/MeshBuilder.h"
#include "Support/PrimitiveDistance.h"

#include "vtkCell.h"

#include <optional>

namespace skdtest
{

struct CellShape
{
  int Type = VTK_EMPTY_CELL;
  bool IsKnown = true;  // else the rest is empty and VTK's cell has to be used
  bool IsSolid = false; // the triangles and patches are the boundary of a volume
  Bounds Box = EmptyBounds();
  std::vector<Point> Points;
  std::vector<Point> Vertices;
  std::vector<std::array<Point, 2>> Segments;
  std::vector<std::array<Point, 3>> Triangles;
  std::vector<Patch> Patches;

  void AddTriangle(int a, int b, int c)
  {
    this->Triangles.push_back({ this->Points[a], this->Points[b], this->Points[c] });
  }

  void AddPatch(int a, int b, int c, int d)
  {
    this->Patches.push_back({ this->Points[a], this->Points[b], this->Points[c], this->Points[d] });
  }
};

CellShape MakeShape(vtkCell* cell);

/// The distance to the cell's points, curves and faces; of a solid 0 inside is up to the caller.
double BoundaryDistance(const CellShape& shape, const Point& x);

/// Where the segment p1 p2 crosses a triangle, in extended precision. Not for rays along an edge.
std::optional<double> HitTriangle(const Point& p1, const Point& p2, const std::array<Point, 3>& t);

/// The triangles that a segment sees: patches are cut along their shorter diagonal.
std::vector<std::array<Point, 3>> SeenTriangles(const CellShape& shape);

/// Of a solid, by the parity of a ray in no special direction. Not for points on the boundary.
bool IsInsideByParity(const CellShape& shape, const Point& x);

/// Of a voxel, which may be turned.
bool IsInsideVoxel(const CellShape& shape, const Point& x);

}

#endif
