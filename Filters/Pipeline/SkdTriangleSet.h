// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTriangleSet.h
 * @brief All surfaces of a data object as one set of triangles with a tree, kept while unchanged.
 */

#ifndef SkdTriangleSet_h
#define SkdTriangleSet_h

#include "Core/Geometry/Vector.h"
#include "Core/Tree/LazyTree.h"
#include "Pipeline/SkdKeptMesh.h"
#include "Pipeline/SkdLeaves.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkPoints;

/// The surface cells of all leaves and the outer faces of their volume cells, cut into triangles
/// without new points (polygons by SkdTriangulation, so that neighbours keep meeting). Points of
/// equal coordinates are one, be they of different leaves. Ghost cells are left out.
class SkdTriangleSet
{
public:
  using Corners = std::array<std::uint32_t, 3>;

  /// A cell that triangles come from: an index in the list of leaves, and a cell there.
  struct Cell
  {
    int Leaf;
    vtkIdType Id;

    bool operator<(const Cell& other) const
    {
      return this->Leaf != other.Leaf ? this->Leaf < other.Leaf : this->Id < other.Id;
    }
  };

  /// Makes the set that of `leaves`. Returns whether it had to be built, or was the same.
  bool Update(const std::vector<SkdLeaf>& leaves);

  const std::vector<skd::Vector3>& GetPoints() const { return this->Points; }
  const std::vector<Corners>& GetTriangles() const { return this->Triangles; }
  const skd::LazyTree<3>& GetTree() const { return this->Tree; }

  ///@{
  /// The cells that have triangles, by ascending (leaf, id), and of each triangle its place there.
  /// Triangles are in the order of their cells.
  const std::vector<Cell>& GetCells() const { return this->Cells; }
  std::uint32_t GetCellOf(std::uint32_t triangle) const { return this->CellOf[triangle]; }
  ///@}

  /// A point of a leaf that is a point of the set; -1 of one that its surface has added.
  struct Origin
  {
    std::uint32_t Point;
    int Leaf;
    vtkIdType Id;

    bool operator<(const Origin& o) const
    {
      return this->Point != o.Point
        ? this->Point < o.Point
        : (this->Leaf != o.Leaf ? this->Leaf < o.Leaf : this->Id < o.Id);
    }
  };

  /// Where the points come from: all that are one in the set, ascending. O(n log n).
  std::vector<Origin> FindOrigins() const;

  /// Faces that have points that are not finite, or fewer than three different ones.
  vtkIdType GetNumberOfFacesLeftOut() const { return this->LeftOut; }

  /// The largest magnitude of a coordinate.
  double GetReach() const { return this->Reach; }

private:
  struct Face
  {
    Cell Origin;
    std::size_t First; // of its corners
    int Size;
  };
  class Faces;

  void Build(const std::vector<SkdLeaf>& leaves);
  void TakePoints(vtkPoints* points);
  void AddTriangle(const vtkIdType* corners);
  void BuildTree();

  std::vector<SkdKeptMesh> Meshes;
  std::vector<Origin> Origins;
  bool IsBuilt = false;
  std::vector<skd::Vector3> Points;
  std::vector<Corners> Triangles;
  std::vector<Cell> Cells;
  std::vector<std::uint32_t> CellOf;
  skd::LazyTree<3> Tree{ skd::TreeInput<3>{} };
  vtkIdType LeftOut = 0;
  double Reach = 0.0;
};

#endif
