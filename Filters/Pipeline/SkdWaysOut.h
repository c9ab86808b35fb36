// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWaysOut.h
 * @brief Ways from a point to the outside of a box, to count crossings on (section 6.3).
 */

#ifndef SkdWaysOut_h
#define SkdWaysOut_h

#include <array>
#include <cstdint>

/// A vector from a point within bounds to a point outside.
using SkdWayOut = std::array<double, 3>;

/// Six ways go along the axes, up and down, the shortest first: they meet few boxes. They lean a
/// little, as many surfaces have faces and edges along the axes, and a way within such a face is
/// the costliest to decide. The seventh, so that a vote is never even, goes askew.
std::array<SkdWayOut, 7> SkdWaysOutAlongAxes(const double bounds[6], const double x[3]);

/// Directions spread evenly over the sphere however many are taken: the additive sequence R2, begun
/// somewhere else for each (seed, point).
class SkdRandomWaysOut
{
public:
  SkdRandomWaysOut(const double bounds[6], std::uint64_t seed, std::uint64_t point);

  SkdWayOut Next();

private:
  double Length; // longer than the diagonal
  double U;
  double V;
};

#endif
