// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWaysOut.h
 * @brief Rays from a point to the outside of a box, for counting crossings (section 6.3).
 */

#ifndef SkdWaysOut_h
#define SkdWaysOut_h

#include <array>
#include <cstdint>

/// A vector from a point within bounds to a point outside.
using SkdWayOut = std::array<double, 3>;

/// Six rays go along the axes in both directions, the shortest first, because they intersect few
/// boxes. They are slightly tilted, because many surfaces have faces and edges along the axes, and
/// a ray within such a face is the most expensive to decide. A seventh, oblique ray avoids ties.
std::array<SkdWayOut, 7> SkdWaysOutAlongAxes(const double bounds[6], const double x[3]);

/// Directions uniformly distributed over the sphere for any number of them: the additive sequence
/// R2, with a different start for each (seed, point).
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
