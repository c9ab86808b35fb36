// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_MortonCode_h
#define skd_Geometry_MortonCode_h

#include <array>
#include <cstdint>

namespace skd
{

/// The Morton code of a cube in a grid: the interleaved bits of its three coordinates, at most ten
/// bits each.
inline std::uint32_t MortonCode(const std::array<std::uint32_t, 3>& cube)
{
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::uint32_t bits = cube[axis]; // two zeros get between any two of them
    bits = (bits | bits << 16) & 0x030000ffu;
    bits = (bits | bits << 8) & 0x0300f00fu;
    bits = (bits | bits << 4) & 0x030c30c3u;
    code |= ((bits | bits << 2) & 0x09249249u) << axis;
  }
  return code;
}

}

#endif
