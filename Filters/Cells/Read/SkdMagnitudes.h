// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMagnitudes.h
 * @brief Limits of coordinates beyond which products overflow or underflow.
 *
 * Coordinates that are too large count as not finite, as do the points of a mesh whose largest
 * coordinate is too small but not 0. Their cells are ignored and counted, so that no other code
 * needs to check for overflow and underflow.
 */

#ifndef SkdMagnitudes_h
#define SkdMagnitudes_h

#include "Core/Geometry/Vector.h"

#include <cmath>
#include <sstream>
#include <string>

namespace skdtree
{
/// Range of a mesh's largest absolute coordinate.
struct SkdMagnitudes
{
  double Least;
  double Largest;
};

/// For distances and parametric coordinates: products of six lengths.
constexpr SkdMagnitudes SkdMeasurable{ 1e-50, 1e50 };

/// For tests with boxes, and for distances from linear cells: products of two lengths.
constexpr SkdMagnitudes SkdComparable{ 1e-152, 1e152 };

/// The reason why cells count as not finite, for messages.
inline std::string SkdWhyCellsAreLeftOut(const SkdMagnitudes& magnitudes = SkdMeasurable)
{
  std::ostringstream why;
  why << "their points are NaN, infinite or beyond " << magnitudes.Largest
      << ", or all of them are within " << magnitudes.Least << " of the origin.";
  return why.str();
}

/// Whether a point is finite and within the limits.
inline bool SkdIsWithin(const skd::Vector3& x, double largest)
{
  return std::abs(x[0]) <= largest && std::abs(x[1]) <= largest && std::abs(x[2]) <= largest;
}

/// Whether what is nearest to a point can be asked: its squared distances do not overflow.
inline bool SkdHasDistances(const skd::Vector3& x)
{
  return SkdIsWithin(x, SkdComparable.Largest);
}
}

#endif
