// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapTypes.h
 * @brief What is asked of overlaps, and what is known of each mesh.
 */

#ifndef SkdOverlapTypes_h
#define SkdOverlapTypes_h

#include "Core/Geometry/Vector.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace skdtree
{
/// What the cells of both meshes are pieces of. Cells of another dimension are left out.
enum class SkdOverlapSpace
{
  Line,   ///< lines and polylines that lie on each other, straight piece by straight piece: lengths
  Plane,  ///< polygons in one plane, anywhere in space: areas
  Sphere, ///< polygons on a sphere about the origin: areas on it
  Volume, ///< polyhedra: volumes
  CurvedSurface ///< polygons of two surfaces in space that nearly coincide: the donor's areas
};

inline bool SkdHasPolygons(SkdOverlapSpace space)
{
  return space != SkdOverlapSpace::Line && space != SkdOverlapSpace::Volume;
}

/// Which facets of two surfaces that nearly coincide have anything to do with each other.
struct SkdFacetRules
{
  int Side = 0;             ///< 1 if normals are alike, -1 if they are opposite, 0: either
  double Distance = 0.0;    ///< at most; 0: half the diameter of the larger one
  double LeastCosine = 0.0; ///< of the angle between normals, whatever their sense

  bool Faces(double cosine) const
  {
    return std::abs(cosine) > this->LeastCosine && this->Side * cosine >= 0.0;
  }

  /// Of facets that go so far from their middles.
  double DistanceFor(double radius, double other) const
  {
    return this->Distance > 0.0 ? this->Distance : std::max(radius, other);
  }

  bool operator==(const SkdFacetRules& other) const
  {
    return std::tie(this->Side, this->Distance, this->LeastCosine) ==
      std::tie(other.Side, other.Distance, other.LeastCosine);
  }
};

struct SkdOverlapSettings
{
  SkdOverlapSpace Space = SkdOverlapSpace::Volume;

  ///@{
  /// Of the sphere: cells of that mesh whose corners are on two meridians and two parallels are
  /// bounded by these; edges are arcs of great circles otherwise.
  bool DonorIsLonLat = false;
  bool TargetIsLonLat = false;
  ///@}

  /// Of the sphere; of both meshes only directions from the origin are taken. 0: the mean distance
  /// of the donor's points from the origin.
  double Radius = 0.0;

  SkdFacetRules Facets; ///< of curved surfaces

  bool SkipsGhosts = true; ///< cells that vtkGhostType marks have no overlap and no measure
};

/// One mesh as it was measured.
struct SkdOverlapCells
{
  std::vector<double> Measures;        ///< of each cell by its id; 0 of cells left out
  std::vector<skd::Vector3> Centroids; ///< Cartesian; on a sphere within it. Zero of cells left out
  std::vector<double> Covered;         ///< the sum of a cell's overlaps
  ///@{
  /// Of curved surfaces, whose overlaps are measured on the donor: of a target's cells, what of
  /// their own measure is covered; of a donor's the normals, of length 1.
  std::vector<double> OwnCovered;
  std::vector<skd::Vector3> Normals;
  ///@}
  /// Of a donor, the sum of their moments (SkdOverlapTable): nothing of a cell that is all covered.
  std::vector<skd::Vector3> CoveredMoments;
  /// Of a target that lies in pieces, whether this process counts each cell (SkdOwnCellsOf); empty:
  /// all count. What covers a donor, and integrals, are of those that do.
  std::vector<unsigned char> Counts;
  vtkIdType LeftOut = 0;           ///< not finite, empty, of another dimension
  std::vector<vtkIdType> TooLarge; ///< polygons larger than a hemisphere, left out as well
  std::vector<vtkIdType> Crossing; ///< polygons that cross themselves

  bool IsCounted(std::size_t cell) const { return this->Counts.empty() || this->Counts[cell]; }

  /// How much of a target's cell, by its own measure, is where so much of its overlaps is.
  double OwnMeasureOf(std::size_t cell, double covered) const
  {
    return this->OwnCovered.empty() || !(this->Covered[cell] > 0.0)
      ? covered
      : covered * (this->OwnCovered[cell] / this->Covered[cell]);
  }
};

/// Rows of target cells, columns of donor points, ascending (CSR): the integral over the target
/// cell of a point's function. A row sums up to what of the cell is covered; the sum over a target
/// that covers the donor is the integral over the donor, whatever the target.
///
/// Of lines, triangles, tetrahedra, and cells with flat faces the function is 1 at the point, 0 at
/// all others, and linear on simplices between the points. A warped face is the four triangles (of
/// a polygon: as many as it has edges) of its edges and the mean of its corners, where the
/// function has the mean of its values there. On a sphere linear means: as on the flat triangle of
/// the three points, constant along its normal.
///
/// Of curved cells it is linear on the simplices that they are cut into, with the values of the
/// cell's own functions at corners on the cell's sides, and so much more, at the corner in the
/// middle of a volume cell, at all corners of another, that its integral over the cell is that of
/// the cell's own function (of what is quadratic on each simplex exactly).
struct SkdOverlapPointTable
{
  std::vector<std::size_t> Rows; ///< one more than there are target cells
  std::vector<vtkIdType> Columns;
  std::vector<double> Weights;
  std::vector<double> Masses; ///< of each point: the integral of its function over the donor
  bool IsSigned = false;      ///< whether weights are negative, and not for rounding
};
}

#endif
