// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSphereCell_h
#define SkdSphereCell_h

#include "Core/Geometry/Box.h"

#include <utility>
#include <vector>

namespace skdtree
{
/// A polygon on a sphere about the origin, its edges great-circle arcs: what directions it holds.
/// It may be concave, hold a pole or cross the date line, and be oriented either way, but is less
/// than a hemisphere. Edges of no length do not count. One object a thread: memory is reused.
class SkdSphereCell
{
public:
  /// False of fewer than three distinct corners, and of corners that are no directions: such a cell
  /// holds nothing.
  bool Set(const std::vector<skd::Vector3>& corners);

  /// Whether a direction, of any length, is in the cell. Signs are exact; the rim is in.
  bool Contains(const skd::Vector3& x) const;

  /// Holds all points of the unit sphere that are in the cell.
  const skd::Box3& GetBox() const { return this->Box; }

private:
  struct Piece // convex, its corners turning left: those of Loops from First to before Last
  {
    std::size_t First;
    std::size_t Last;
  };

  bool FindCentre();
  void SetBox();
  int FindOrientation() const;
  void AddLoop(bool isReversed);
  void AddTriangles();
  bool PieceContains(const Piece& piece, const skd::Vector3& x) const;

  std::vector<skd::Vector3> Corners; // distinct from the one before
  std::vector<skd::Vector3> Flat;    // the same on the plane that touches the sphere at the centre
  std::vector<skd::Vector3> Loops;
  std::vector<Piece> Pieces;
  skd::Vector3 Centre;
  skd::Box3 Box;
};
}

#endif
