// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tolerances of geometry and predicates, each with its reference length or value. "Parameters"
/// are those of a cell, a patch or a line, in [0, 1].
#ifndef skd_Geometry_Tolerances_h
#define skd_Geometry_Tolerances_h

namespace skd::tolerances
{

/// Of products of the unit rows of a rigid motion.
constexpr double Orthonormal = 1e-9;
/// Of a triple product, relative to the cube of its vectors' lengths.
constexpr double TripleProduct = 1e-14;
/// A sum of triple products that is larger has lost no low part.
constexpr double LeastProduct = 1e-200;
/// Of the difference of two products, relative to both.
constexpr double CrossProduct = 1e-15;
/// Numbers between these: products of three neither over- nor underflow.
constexpr double LeastFactor = 1e-75;
/// See LeastFactor.
constexpr double LargestFactor = 1e75;
/// Coordinates between these: the determinants of segments' contacts do not over- or underflow.
constexpr double LeastCoordinate = 1e-40;
/// See LeastCoordinate.
constexpr double LargestCoordinate = 1e90;

// Distances to patches
/// Newton's last step to a root, in parameters.
constexpr double PolynomialRoot = 1e-15;
/// Newton's last but one step to a minimum, in parameters: the next is of its square.
constexpr double ConvexStep = 1e-9;
/// Squared distance at which a point counts as on the patch, relative to its squared sides.
constexpr double OnPatch2 = 1e-24;
/// Of a squared distance from a plane, relative to the squared size of the patch.
constexpr double PlaneGap2 = 1e-14;

// Segments and patches
/// The longest step that repairs a root, in parameters: a longer one leads elsewhere.
constexpr double PolishStep = 1e-3;
/// A discriminant that may be 0, relative to the square of b.
constexpr double DoubleRoot = 1e-14;
/// How far a hit may be beyond the patch, in parameters.
constexpr double BesidePatch = 1e-9;

// Inverse maps of cells
/// What residual is rounding, relative to the greatest coordinate as seen from x.
constexpr double Residual = 3.6e-15;
/// Half the width of the least box that is searched for a root, in parameters.
constexpr double LeastBox = 1e-14;
/// Of the volume of four corners, relative to the cube of the greatest coordinate.
constexpr double Volume = 5e-15;
/// The same, computed with twice the digits.
constexpr double AccurateVolume = 1e-28;
/// Of a squared distance from a plane, relative to that of the farthest corner.
constexpr double CellGap2 = 4e-15;
/// The least that a step has to promise, relative to the squared residual.
constexpr double LeastGain = 1e-15;
/// How much of what a step promises has to come true.
constexpr double GainShare = 1e-4;
/// The damping that is begun with, relative to the Hessian's diagonal.
constexpr double FirstDamping = 1e-3;
/// Less damping is none.
constexpr double LastDamping = 1e-7;
/// Where the Hessian has less on its diagonal than that of its largest, it is damped as if.
constexpr double LeastCurvature = 1e-3;
/// The step of differences of first derivatives, in parameters.
constexpr double SecondDifference = 1e-4;
/// A pivot that is positive for certain, relative to the entry on the diagonal.
constexpr double Pivot = 1e-13;
/// How far from the plane of a part of a domain a point on it may be, in parameters.
constexpr double OnPart = 1e-12;
/// How far beside a part of a domain a minimum may be that is used for it, in its own parameters.
constexpr double NearPart = 1e-6;
/// Of the polynomial of a squared distance, relative to its size.
constexpr double SquareRounding = 1e-14;
/// A force of a constraint that is not rounding, relative to the gradient.
constexpr double Force = 1e-14;

}

#endif
