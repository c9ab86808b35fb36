// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCopies.h
 * @brief Triangles that are there many times. All pairs of n copies would be n^2 / 2, so only a few
 * of them are searched.
 */

#ifndef SkdCopies_h
#define SkdCopies_h

#include "Core/Geometry/Vector.h"
#include "Core/Search/Tree/RawVector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace skdtree
{
/// A triangle with the same corners as a lower one.
struct SkdDuplicate
{
  std::uint32_t Original; ///< the lowest with these corners
  std::uint32_t Triangle;
  int Sign; ///< 1 if both have the same orientation, else -1

  bool operator<(const SkdDuplicate& other) const
  {
    return this->Original != other.Original ? this->Original < other.Original
                                            : this->Triangle < other.Triangle;
  }
};

/// Ordinary surfaces have fewer triangles of the same corners.
constexpr std::size_t SkdManyCopies = 64;

/// 1 if two triangles with the same corners turn the same way, else -1.
int SkdSignOfCopy(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b);

/// Of triangles of which there are more than SkdManyCopies, all but the first `kept`, ascending.
/// Points of equal coordinates are one. A few nanoseconds for each triangle of others.
std::vector<SkdDuplicate> SkdFindCopies(
  const skd::RawVector<std::array<std::uint32_t, 3>>& triangles, std::size_t numberOfPoints,
  std::size_t mostCopies);
}

#endif
