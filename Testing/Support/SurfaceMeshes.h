// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceMeshes.h
 * @brief points, curves and surfaces with known shape
 */
#ifndef skdtest_SurfaceMeshes_h
#define skdtest_SurfaceMeshes_h

#include "Support/MeshBuilder.h"

namespace skdtest
{

/// The closed surface of the cube [0, n]^3 as n x n unit quads a face; integer coordinates.
Mesh CubeQuads(int n);

/// A closed triangulated surface with integer corners: lines through edges and vertices are exact.
Mesh CubeTriangles(int n);

/// The six corners (+-size, 0, 0), ... and eight triangles.
Mesh Octahedron(double size);

/// The cube's surface, n x n quads a face, blown up to the sphere of radius 1 about the origin.
/// Its quads are warped.
Mesh SphereQuads(int n);

Mesh SphereTriangles(int n);

/// Planar quads (isosceles trapezoids) around the z axis; radii 1 and 0.35.
Mesh TorusQuads(int around, int across);

Mesh TorusTriangles(int around, int across);

/// n x n unit cells in the plane z = 0, of type VTK_QUAD, VTK_PIXEL or VTK_TRIANGLE (two a square).
Mesh Sheet(int n, int type);

/// Regular hexagons of circumradius 1, none touching, on a tilted plane.
Mesh Hexagons(int n);

/// n strips of 2 n triangles each, on a wavy sheet.
Mesh Strips(int n);

/// A helix of n segments, as lines or as polylines of four segments.
Mesh Helix(int n, int type);

/// n random points in the unit cube, as vertices or as polyvertices of three points.
Mesh Cloud(int n, int type);

/// n random triangles of edge length about `size` in the unit cube: they overlap.
Mesh TriangleSoup(int n, double size);

/// Several meshes as one.
Mesh Together(const std::vector<Mesh>& meshes);

}

#endif
