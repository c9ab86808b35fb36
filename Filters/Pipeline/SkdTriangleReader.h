// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTriangleReader.h
 * @brief The faces of data sets as triangles, read once and in a row.
 */

#ifndef SkdTriangleReader_h
#define SkdTriangleReader_h

#include "Core/Geometry/Box.h"
#include "Core/Tree/RawVector.h"
#include "Pipeline/SkdTriangulation.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

class SkdLeafSurface;
class vtkDataSet;

/// A cell that triangles come from: an index in the list of leaves, and a cell there.
struct SkdTriangleCell
{
  int Leaf;
  vtkIdType Id;

  bool operator<(const SkdTriangleCell& other) const
  {
    return this->Leaf != other.Leaf ? this->Leaf < other.Leaf : this->Id < other.Id;
  }
};

/// A point of a data set, -1 of one that its surface has added.
struct SkdTrianglePoint
{
  int Leaf;
  vtkIdType Id;
};

/// Triangles and their points, these in the order in which faces first have them. Points of equal
/// coordinates stay several.
struct SkdReadTriangles
{
  using Corners = std::array<std::uint32_t, 3>;

  skd::RawVector<skd::Vector3> Points;
  skd::RawVector<SkdTrianglePoint> Origins; ///< of each point
  skd::RawVector<Corners> Triangles;        ///< in the order of their cells
  skd::RawVector<SkdTriangleCell> Cells;    ///< ascending
  skd::RawVector<std::uint32_t> CellOf;     ///< of each triangle its place in Cells
  vtkIdType LeftOut = 0;                    ///< faces that are none
  skd::Box3 Bounds;                         ///< of the points

  /// No triangle, as the points are, is less than about this wide.
  double LeastWidth = std::numeric_limits<double>::infinity();
};

class SkdTriangleReader
{
public:
  SkdTriangleReader();

  void Read(int leaf, vtkDataSet* mesh);

  /// What was read, in order.
  SkdReadTriangles Take();

private:
  using Corners = SkdReadTriangles::Corners;
  static constexpr std::uint32_t Unknown = 0xffffffffu;
  static constexpr std::uint32_t NotFinite = 0xfffffffeu;

  void MakeRoom(const SkdLeafSurface& surface);
  std::uint32_t IdOf(int leaf, const SkdLeafSurface& surface, vtkIdType corner);
  std::uint32_t Visit(int leaf, const SkdLeafSurface& surface, vtkIdType corner);
  bool AreSame(std::uint32_t a, std::uint32_t b) const;
  void AddTriangle(const SkdTriangleCell& cell, const Corners& corners);
  void AddPolygon(const SkdTriangleCell& cell);
  void Append(const SkdTriangleCell& cell, const Corners& corners);
  void Sort();

  SkdReadTriangles To;
  bool IsSorted = true;
  std::vector<std::uint32_t> Ids; // of the points of the leaf that is read
  std::vector<vtkIdType> Polygon; // the corners of the face that is read, and these points
  vtkNew<vtkPoints> Local;
  std::vector<vtkIdType> Order;
  SkdTriangulation Triangulation;
};

#endif
