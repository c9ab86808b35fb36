// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRemapTolerances_h
#define SkdRemapTolerances_h

namespace skdtree
{
/// The tolerances of remapping, and what they are relative to.
namespace remap_tolerances
{
constexpr double LonLatBox = 1e-15;      ///< absolute, on the unit sphere: rounding of boxes
constexpr double OutOfPlane = 1e-6;      ///< of the diagonal: distances of points from the plane
constexpr double UnitRadius = 1e-6;      ///< absolute: a mean radius as near to 1 is 1
constexpr double StraightAngle = 1e-13;  ///< the sine of a reflex angle that counts as straight
constexpr double Hemisphere = 1e-3;      ///< of the radius: the mean corner of half a sphere
constexpr double CellOverlap = 2e-15;    ///< of the smaller cell: less measure is rounding
constexpr double PieceOverlap = 1e-14;   ///< of the smaller piece, whose cuts round more: the same
constexpr double PointWeight = 1e-12;    ///< of the largest of a cell: a negative one is rounding
constexpr double Centroid = 1.5e-14;     ///< of its distance: how well that of an overlap is known
constexpr double OppositeCorners = 1e-6; ///< of the radius: an edge between them has no direction
constexpr double SphereArea = 1e-6;      ///< on the unit sphere: of areas found in two ways
constexpr double CoverGap = 1e-10;       ///< of a cell's measure: less is no gap in its cover
constexpr double Flatness = 1e-12;       ///< of the largest eigenvalue: less spans no direction
constexpr double EdgeOn = 1e-12;         ///< the cosine between normals of facets seen edge-on
constexpr double FlatPolygon = 1e-11;    ///< of the largest distance from its middle: is in a plane
constexpr double SurfaceBorder = 0.05;   ///< of a cell's measure: projections differ so at borders
constexpr double OtherSide = 0.05;       ///< of a surface's area: so few cells may be flipped over
constexpr double Coverage = 1e-5;        ///< of a cell's measure: left by single precision
}
}

#endif
