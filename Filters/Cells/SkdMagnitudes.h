// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMagnitudes.h
 * @brief Coordinates so large or small that what is computed of them is no number any more.
 *
 * One rule for all: a coordinate that is too large counts as not finite, and the points of a mesh
 * whose largest coordinate is too small, but not 0, do likewise. So their cells are left out and
 * counted, and nobody else has to ask whether a product overflows, or comes to nothing.
 */

#ifndef SkdMagnitudes_h
#define SkdMagnitudes_h

#include "Core/Geometry/Vector.h"

#include <cmath>
#include <sstream>
#include <string>

/// Range of a mesh's largest coordinate, without its sign.
struct SkdMagnitudes
{
  double Least;
  double Largest;
};

/// For distances and places in cells: six lengths are multiplied.
constexpr SkdMagnitudes SkdMeasurable{ 1e-50, 1e50 };

/// For what compares boxes and cells with boxes, and for distances from flat cells: two are.
constexpr SkdMagnitudes SkdComparable{ 1e-152, 1e152 };

/// What is wrong with cells that are counted as not finite, for messages.
inline std::string SkdWhyCellsAreLeftOut(const SkdMagnitudes& magnitudes = SkdMeasurable)
{
  std::ostringstream why;
  why << "their points are NaN, infinite or beyond " << magnitudes.Largest
      << ", or all of them are within " << magnitudes.Least << " of the origin.";
  return why.str();
}

/// Whether a point is not too far off, and finite.
inline bool SkdIsWithin(const skd::Vector3& x, double largest)
{
  return std::abs(x[0]) <= largest && std::abs(x[1]) <= largest && std::abs(x[2]) <= largest;
}

#endif
