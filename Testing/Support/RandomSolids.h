// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RandomSolids.h
 * @brief random closed surfaces, oriented outward, that do not intersect themselves
 */
#ifndef skdtest_RandomSolids_h
#define skdtest_RandomSolids_h

#include "Support/MeshBuilder.h"

#include <string>

namespace skdtest
{

/// A triangulated solid of about unit size, and what it is.
struct RandomSolid
{
  Mesh Triangles;
  std::string Kind;
};

/// Noisy spheres, boxes, tori, prisms, extruded stars, convex hulls, spheres with a cavity, two
/// solids in one, and unions of cubes of a lattice, which may touch in edges and vertices.
RandomSolid MakeRandomSolid(Random& random);

/// One to 27 cubes of a lattice of halves, or none: no triangles.
Mesh RandomCubes(Random& random);

/// Boxes two units long through a ball of that width, in any direction: they cross each other, but
/// hardly where a third one is.
std::vector<Mesh> RandomRods(Random& random, int count, double width);

/// Adds a mesh to another, with points of its own.
void Append(Mesh& mesh, const Mesh& other);

/// A rotation, by any angles or by right ones.
class RandomRotation
{
public:
  RandomRotation(Random& random, bool byRightAngles);
  Point operator()(const Point& p) const;

private:
  Point Rows[3];
};

}

#endif
