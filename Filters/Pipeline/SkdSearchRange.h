// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSearchRange_h
#define SkdSearchRange_h

#include <tuple>

namespace skdtree
{
/// Whether positions are compared by their directions from the origin, too, as on a sphere.
enum class SkdByDirections
{
  Never,
  OnSpheres, ///< if all points that a process has of the mesh that asks are at one radius
  Always
};

/// How far a cell may be from what a process has, and still be near it: a distance, and a fraction
/// of the diagonal of the cell's box, together.
struct SkdSearchRange
{
  double Distance = 0.0;
  double OfDiagonal = 0.0;

  /// The same fraction of the diagonals of the boxes of a process's own cells.
  double OfOwnDiagonal = 0.0;

  /// The neighbours of cells that are near are wanted, too.
  bool WithNeighbours = false;

  /// The nearest cell is wanted, too, of each point and cell that a process has, and the nearest
  /// point or middle of a cell.
  bool WithNearest = false;

  /// Points and middles of cells are what is searched, those with a value if the nearest are
  /// wanted: they are not brought where points are of no cell or have no value.
  bool IsOfSamples = false;

  /// Of meshes that nearly coincide, if no process has volume cells and the own one is on no
  /// sphere: cells are near as far as they and the own ones are large, and the nearest is wanted.
  bool IsOfNearSurfaces = false;

  /// But not if all points of both meshes have one coordinate in common: then they are in a plane.
  bool IsUnlessFlat = false;

  /// The searched mesh is to have no blocks.
  bool IsOfOneMesh = false;

  /// Faces are what is searched: cells are not brought where some are no faces, or there are points
  /// without cells.
  bool IsOfFaces = false;

  /// Outer faces of volume cells are what is searched: cells are not brought where some may be
  /// covered by several others (SkdVoxelLattice).
  bool IsOfOuterFaces = false;

  /// Both meshes are searched, each near what a process has of the other.
  bool IsMutual = false;

  /// The cells of a process's own piece are wanted, too, wherever they are, for sums over all
  /// cells, and what the whole looks like: see SkdJoinedShape.
  bool WithOwn = false;

  ///@{
  /// Of meshes on a sphere. Points in degrees are longitudes and latitudes.
  SkdByDirections Directions = SkdByDirections::Never;
  bool IsOwnInDegrees = false;
  bool IsSearchedInDegrees = false;
  ///@}

  /// Not on spheres.
  bool IsNotForSpheres = false;

  /// All of it, to be compared.
  auto Tie() const
  {
    return std::tie(this->Distance, this->OfDiagonal, this->OfOwnDiagonal, this->WithNeighbours,
      this->WithNearest, this->IsOfSamples, this->IsOfNearSurfaces, this->IsUnlessFlat,
      this->IsOfOneMesh, this->IsOfFaces, this->IsOfOuterFaces, this->IsMutual, this->WithOwn,
      this->Directions, this->IsOwnInDegrees, this->IsSearchedInDegrees, this->IsNotForSpheres);
  }

  bool operator==(const SkdSearchRange& other) const { return this->Tie() == other.Tie(); }
  bool operator!=(const SkdSearchRange& other) const { return !(*this == other); }
};
}

#endif
