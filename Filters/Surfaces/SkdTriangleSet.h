// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTriangleSet.h
 * @brief All surfaces of a data object as one set of triangles with a tree, kept while unchanged.
 */

#ifndef SkdTriangleSet_h
#define SkdTriangleSet_h

#include "Core/Geometry/Vector.h"
#include "Core/Mesh/Processes.h"
#include "Core/Tree/LazyTree.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdKeptMesh.h"
#include "Surfaces/SkdTriangleReader.h"

#include <array>
#include <cstdint>
#include <vector>

/// The surface cells of all blocks and the outer faces of their volume cells, cut into triangles
/// without new points (polygons by SkdTriangulation, so that neighbours keep meeting). Ghost cells
/// are left out.
///
/// A set is read first and, where that pays, completed: only then it has a tree, and points of
/// equal coordinates, be they of different blocks, are one.
class SkdTriangleSet
{
public:
  using Corners = SkdReadTriangles::Corners;
  using Cell = SkdTriangleCell;
  using PointList = skd::RawVector<skd::Vector3>;
  using TriangleList = skd::RawVector<Corners>;

  /// Makes the set that of `blocks`, curved faces as facets within a chordal deviation, a share of
  /// the diagonal of all (see SkdChordalLength). Returns whether it had to be read, or was the
  /// same.
  bool Update(const std::vector<SkdBlock>& blocks, double chordalDeviation,
    const skd::Processes* processes = nullptr);

  /// The deviation as a length; 0 if no cell is curved.
  double GetChordalLength() const { return this->ChordalLength; }

  ///@{
  /// Makes equal points one and begins the tree, unless that was done. O(n).
  void Complete();
  bool IsComplete() const { return this->HasTree; }
  ///@}

  /// What Complete() does to points, for the corners of some triangles: those of equal coordinates
  /// become the first of all that have them. Numbers change, not which of two is the lower, so what
  /// is told in their order is the same. About a nanosecond a point of the set, no hash table of
  /// all.
  void MakeCornersOne(const std::vector<std::uint32_t>& triangles);

  const PointList& GetPoints() const { return this->Read.Points; }
  const TriangleList& GetTriangles() const { return this->Read.Triangles; }
  const skd::LazyTree<3>& GetTree() const { return this->Tree; }

  ///@{
  /// The cells that have triangles, by ascending (block, id), and of each triangle its place there.
  /// Triangles are in the order of their cells.
  const skd::RawVector<Cell>& GetCells() const { return this->Read.Cells; }
  std::uint32_t GetCellOf(std::uint32_t triangle) const { return this->Read.CellOf[triangle]; }
  ///@}

  /// A point of a block that is a point of the set; -1 of one that its surface has added.
  struct Origin
  {
    std::uint32_t Point;
    int Block;
    vtkIdType Id;

    bool operator<(const Origin& o) const
    {
      return this->Point != o.Point
        ? this->Point < o.Point
        : (this->Block != o.Block ? this->Block < o.Block : this->Id < o.Id);
    }
  };

  /// Where the points of a complete set come from: all that are one in it, ascending. O(n log n).
  std::vector<Origin> FindOrigins() const;

  /// Faces that have points that are not finite, or fewer than three different ones.
  vtkIdType GetNumberOfFacesLeftOut() const { return this->Read.LeftOut; }

  const skd::Box3& GetBounds() const { return this->Read.Bounds; }

  /// The largest magnitude of a coordinate.
  double GetLargestCoordinate() const;

  /// No triangle is less than about this wide; less than most are where triangles are small.
  double GetLeastWidth() const;

private:
  void BuildTree();

  std::vector<SkdKeptMesh> Meshes;
  double ChordalLength = 0.0;
  SkdReadTriangles Read;
  std::vector<std::uint32_t> PointOf; // of each point that was read, when complete
  bool IsRead = false;
  bool HasTree = false;
  skd::LazyTree<3> Tree{ skd::TreeInput<3>{} };
};

#endif
