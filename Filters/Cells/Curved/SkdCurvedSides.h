// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurvedSides_h
#define SkdCurvedSides_h

#include "Cells/Read/SkdShape.h"
#include "Core/Geometry/Vector.h"

#include <array>
#include <vector>

class vtkCell;

namespace skdtree
{
/// The sides of a curved volume cell as flat triangles, which depend on the side alone: those of
/// two cells that share a side, be they of different types, are the same to rounding.
///
/// An edge is straight if it departs from its chord by no more than SkdTolerances::StraightSide,
/// and is cut as its chord then. A side is straight if its edges are, and it is flat or bilinear to
/// the same tolerance: it is the triangle of its corners, or the four triangles of the corners of a
/// quadrilateral and their mean, as that of a linear cell is for which nothing is said of its
/// inside. Other sides are cut into 8 parts along each parameter, with diagonals that run towards
/// the middle from all four sides, so that it does not matter how the side is put down.
///
/// Reuses its memory; one a thread.
class SkdCurvedSides
{
public:
  /// Of a triangle's corner: where it is, and about where in the straight cell of the same corners
  /// (that of the linear type of VTK, but the tip of a pyramid is above the middle of its base).
  struct Point
  {
    skd::Vector3 X;
    skd::Vector3 Reference;
  };
  using Triangle = std::array<int, 3>;

  /// SkdShape::None of types that are no curved volume cells.
  static SkdShape ShapeOf(int cellType);

  /// Reads the sides of a cell of such a type, with finite points.
  void Read(vtkCell* cell);

  /// Whether all sides are: then the cell is the linear one of its first points.
  bool AreStraight() const;

  /// Cuts the sides; `isFine`: straight ones as finely as suits the degree of the cell's functions.
  void Cut(bool isFine);

  const std::vector<Point>& GetPoints() const { return this->Points; }
  /// All outward or all inward, if they are not on sides that VTK orders differently.
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /// A point within the cell.
  const Point& GetMiddle() const { return this->Middle; }

  /// VTK's parametric coordinates of a point in the straight cell.
  skd::Vector3 ToVTK(const skd::Vector3& reference) const;

private:
  static constexpr int Parts = 8;

  struct Side
  {
    int Size = 0;     ///< corners: 3 or 4
    int Corners[4]{}; ///< numbers of the cell's points
    int NumberOfPoints = 0;
    bool IsReversed = false; ///< against the order of the linear cell's face
    bool IsStraight = false;
    skd::Vector3 X[Parts + 1][Parts + 1]; ///< along its first edge, along its last
  };

  template <class Linear>
  void ReadSides(vtkCell* cell);
  template <class Linear>
  static bool IsReversed(const Side& side);
  void ReadSide(vtkCell* face, Side& side);
  bool StraightenEdge(Side& side, int edge) const;
  bool IsInsideStraight(const Side& side) const;
  void SetMiddle(vtkCell* cell);

  void CutStraight(const Side& side, int parts);
  void CutCurved(const Side& side);
  template <class At>
  void AddTriangle(const Side& side, int parts, const At& at);
  void Add(const Side& side, int a, int b, int c);
  skd::Vector3 ReferenceAt(const Side& side, int i, int j) const;
  skd::Vector3 ReferenceOf(int corner) const;

  SkdShape Shape = SkdShape::None;
  int Type = 0;
  std::vector<Side> Sides;
  std::vector<Point> Points;
  std::vector<Triangle> Triangles;
  Point Middle;
};
}

#endif
