// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tolerances of curves and patches, each with its reference value. "Parameters" are those of a
/// curve or a patch, in [0, 1]. What is a length goes by the search's own tolerance (CurvePair,
/// CurvePatchContact).
#ifndef skd_Curves_Tolerances_h
#define skd_Curves_Tolerances_h

namespace skd::tolerances
{

/// Where a bisection ends, in parameters.
constexpr double SignChange = 1e-16;
/// Newton's last step to a root or to a foot, in parameters.
constexpr double FootStep = 1e-15;
/// What a simple root is off by at least, in parameters.
constexpr double RootRounding = 1e-14;
/// The same of an end of a common interval of two curves.
constexpr double OverlapRounding = 1e-13;
/// Roots closer than that are one, in parameters; a range shorter than that is a root.
constexpr double SameParameter = 1e-12;
/// The least step by which a contact is left, and by which two are apart, in parameters.
constexpr double ContactStep = 1e-9;
/// How deep, in parameters, a foot may be beyond the ends of what it is a foot on.
constexpr double OnInterval = 1e-9;
/// What an end of a interval within a patch is off by, in parameters of the curve.
constexpr double PatchOverlap = 1e-9;
/// The same in parameters of the patch.
constexpr double PatchOverlapSide = 1e-8;
/// A root that may be off by more may be none, or two, in parameters.
constexpr double Doubtful = 1e-8;
/// How near feet of one contact are, in parameters of the second curve.
constexpr double SameContact = 1e-6;
/// Of a cell's width: roots beyond its ends by less are its own.
constexpr double CellShare = 1e-6;
/// How near simple roots of one point are, in parameters.
constexpr double SimpleGap = 1e-6;
/// What a root may be off by at most, in parameters.
constexpr double MostSlack = 1e-5;
/// A determinant that is not 0, relative to the lengths of its vectors.
constexpr double Regular = 1e-12;
/// Of sums of some ten terms, relative to their size.
constexpr double SumOfTen = 1e-14;
/// What two halves of a curve may differ from the whole by, relative to its length.
constexpr double ArcLength = 1e-13;
/// What is enough for the distance of two curves, relative to their size.
constexpr double Nearest = 1e-10;

// Patches
/// Parts farther beyond the long side of a triangle are none of it, in parameters.
constexpr double BeyondLongSide = 1e-6;
/// The least part of a patch that is looked at, in parameters.
constexpr double LeastPart = 1e-6;
/// A normal that is long enough to define the tangent plane, relative to the sides' lengths.
constexpr double FlatNormal = 1e-6;
/// A side that has a length, relative to the other.
constexpr double LeastSide = 1e-3;
/// The sine above which a curve crosses a patch at its pole.
constexpr double PoleSlope = 1e-3;
/// A length that can be divided by.
constexpr double LeastDivisor = 1e-300;

}

#endif
