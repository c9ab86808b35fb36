// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeMeshes.h
 * @brief the cube [0, n]^3 filled with every kind of linear volume cell
 */
#ifndef skdtest_VolumeMeshes_h
#define skdtest_VolumeMeshes_h

#include "Support/MeshBuilder.h"

namespace skdtest
{

/// The points (i, j, k) of the lattice, then the eight corners of its cube `cell` in VTK's order.
struct Lattice
{
  explicit Lattice(int n)
    : N(n)
  {
  }

  std::vector<Point> Points() const
  {
    std::vector<Point> points;
    for (int id = 0; id < (this->N + 1) * (this->N + 1) * (this->N + 1); ++id)
    {
      const int m = this->N + 1;
      points.push_back({ double(id % m), double(id / m % m), double(id / m / m) });
    }
    return points;
  }

  int NumberOfCubes() const { return this->N * this->N * this->N; }

  Ids Cube(int cell) const
  {
    const int i = cell % this->N;
    const int j = cell / this->N % this->N;
    const int k = cell / this->N / this->N;
    const auto at = [this](int a, int b, int c) -> vtkIdType
    { return (c * (this->N + 1) + b) * (this->N + 1) + a; };
    return { at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
      at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1) };
  }

  int N;
};

/// A smooth map of the cube [0, n]^3 that bends faces; its lattice cells stay valid.
Point Bent(const Point& p);

/// A rotation with no axis in common with the coordinates'.
Point Rotated(const Point& p);

Mesh Hexahedra(int n);

/// Hexahedra whose top and bottom are swapped: negative volume, as some solvers write them.
Mesh InvertedHexahedra(int n);

Mesh Voxels(int n);

/// Each cube as the six tetrahedra about its long diagonal, which match across cubes.
Mesh Tetrahedra(int n);

/// Each cube as two wedges.
Mesh Wedges(int n);

/// Each cube as six pyramids that meet in its centre.
Mesh Pyramids(int n);

/// The face stream of a hexahedron, as vtkUnstructuredGrid wants a polyhedron.
Ids PolyhedronOf(const Ids& c);

Mesh Polyhedra(int n);

/// Cube by cube another kind of cell, and triangles, lines and vertices on top.
Mesh MixedCells(int n);

/// Between random points of the unit cube: about seven times as many tetrahedra as points.
DataSetPointer DelaunayTetrahedra(int numberOfPoints);

}

#endif
