// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The thresholds of cells, each with what it is relative to. The range of coordinates is in
/// SkdMagnitudes.h.
#ifndef SkdTolerances_h
#define SkdTolerances_h

namespace skdtree
{
namespace SkdTolerances
{

/// The step of differences for first derivatives, in a cell's parameters.
constexpr double FirstDifference = 1e-5;
/// The last step of the search for where a cell is farthest from its chord, in its parameters.
constexpr double DeviationStep = 1e-4;
/// Of the squared distance of a piece of a cell, relative to it.
constexpr double PieceDistance2 = 1e-14;
/// Of the length of an edge, or the size of a side, of a curved cell: those that depart less from a
/// straight one are straight. Far above what single precision leaves of the points.
constexpr double StraightSide = 1e-6;
/// Of a cell's interpolation functions, which are about 1: what their Bernstein form may be off by.
constexpr double SameFunction = 1e-9;
/// Of their coefficients: less is 0.
constexpr double NoTerm = 1e-14;
/// Of the degree that a number of points makes, a whole number.
constexpr double Degree = 1e-9;

}
}

#endif
