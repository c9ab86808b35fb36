// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTriangleReader.h
 * @brief The faces of data sets as triangles, read sequentially.
 */

#ifndef SkdTriangleReader_h
#define SkdTriangleReader_h

#include "Bodies/SkdTriangulation.h"
#include "Core/Geometry/Box.h"
#include "Core/Search/Tree/RawVector.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

class vtkDataSet;

namespace skdtree
{
class SkdBlockSurface;

/// A cell that triangles come from: an index in the list of blocks, and a cell there.
struct SkdTriangleCell
{
  int Block;
  vtkIdType Id;

  bool operator<(const SkdTriangleCell& other) const
  {
    return this->Block != other.Block ? this->Block < other.Block : this->Id < other.Id;
  }
};

/// A point of a data set, -1 for one that its surface has added.
struct SkdTrianglePoint
{
  int Block;
  vtkIdType Id;
};

/// The least magnitude of a point's coordinates other than 0, and of another one.
inline double SkdLeastCoordinateOf(double least, const skd::Vector3& x)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double magnitude = std::abs(x[axis]);
    least = magnitude > 0.0 ? std::min(least, magnitude) : least;
  }
  return least;
}

/// Triangles and the points that they have, these in the order of their data sets. Points of equal
/// coordinates are not merged.
struct SkdReadTriangles
{
  using Corners = std::array<std::uint32_t, 3>;

  skd::RawVector<skd::Vector3> Points;
  skd::RawVector<SkdTrianglePoint> Origins; ///< of each point
  skd::RawVector<Corners> Triangles;        ///< in the order of their cells
  skd::RawVector<SkdTriangleCell> Cells;    ///< ascending
  skd::RawVector<std::uint32_t> CellOf;     ///< of each triangle its index in Cells
  vtkIdType LeftOut = 0;                    ///< faces that are none
  vtkIdType CoarseFaces = 0;                ///< see SkdBlockSurface
  skd::Box3 Bounds;                         ///< of the points
  vtkIdType TinyPoints = 0;                 ///< points with coordinates that were taken as 0

  /// No triangle has less than about this as twice its area, seen along the axis where that is
  /// largest.
  double LeastArea = std::numeric_limits<double>::infinity();

  /// The least magnitude of coordinates other than 0.
  double LeastCoordinate = std::numeric_limits<double>::infinity();

  /// Leaves out triangles from one on two corners of which are at one place.
  void LeaveOutCollapsed(std::size_t from);

  /// Finds the bounds, the least area and the least coordinate of points and triangles.
  void FindExtents();
};

/// Reads SkdBlockSurface as SkdBoundary does, but welds no points and compares no faces: surfaces
/// that are used once are read in a fraction of the time. Faces of volume cells begin with their
/// least corner by coordinates, and those of a cell are in the order of these, so that neither
/// depends on how points are numbered, as they do for VTK.
class SkdTriangleReader
{
public:
  void Read(int block, vtkDataSet* mesh, const SkdBlockSurface& surface);

  /// The largest magnitude of a coordinate that was read.
  double GetLargestCoordinate() const { return skd::LargestCoordinate(this->To.Bounds); }

  /// What was read, in order. Coordinates so small beside the largest one that signs would not be
  /// exact (skd::LeastExactCoordinate) are taken as 0; it may be larger than those that were read.
  SkdReadTriangles Take(double largestCoordinate);

private:
  using Corners = SkdReadTriangles::Corners;
  static constexpr std::uint32_t Unused = 0xffffffffu;
  static constexpr std::uint32_t NotFinite = 0xfffffffeu;
  static constexpr std::uint32_t Used = 0xfffffffdu; // and to be numbered

  template <class Corner>
  const vtkIdType* BeginAtLeast(vtkIdType size, const Corner* corners);
  void MarkPoints(const SkdBlockSurface& surface);
  void ReadPoints(int block, const SkdBlockSurface& surface);
  bool AreSame(std::uint32_t a, std::uint32_t b) const;
  bool HasEqualCorners(const Corners& corners) const;
  void AddTriangle(const SkdTriangleCell& cell, const Corners& corners);
  bool TakeArea(const Corners& corners);
  template <class Corner>
  void AddPolygon(const SkdTriangleCell& cell, vtkIdType size, const Corner* corners);
  void Append(const SkdTriangleCell& cell, const Corners& corners, bool hasArea);
  void Sort();
  void TakeTinyAsZero(double largestCoordinate);

  SkdReadTriangles To; // has room for more while a data set is read
  std::size_t NumberOfTriangles = 0;
  std::size_t NumberOfCells = 0;
  bool IsSorted = true;
  bool HasVolumes = false;                       // blocks with volume cells
  std::vector<std::uint32_t> Ids;                // of the points of the block that is read
  std::vector<vtkIdType> Polygon;                // the corners of the face that is read
  std::vector<vtkIdType> Turned;                 // likewise, from its least
  std::optional<SkdTriangulation> Triangulation; // made when it is first needed
};
}

#endif
