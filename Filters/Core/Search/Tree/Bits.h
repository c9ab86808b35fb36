// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Tree_Bits_h
#define skd_Tree_Bits_h

#include <cstdint>

namespace skd
{

/// The number of the lowest bit that is set, of at least one.
inline int LowestBit(unsigned bits)
{
#if defined(__GNUC__)
  return __builtin_ctz(bits);
#else
  int lowest = 0;
  while ((bits >> lowest & 1u) == 0)
  {
    ++lowest;
  }
  return lowest;
#endif
}

/// The number of the highest bit that is set, of at least one, of eight.
inline int HighestBit(unsigned bits)
{
#if defined(__GNUC__)
  return 31 ^ __builtin_clz(bits); // of which GCC makes one instruction
#else
  int highest = 31;
  while ((bits >> highest & 1u) == 0)
  {
    --highest;
  }
  return highest;
#endif
}

/// Calls visit(lane) for each bit that is set, from the lowest.
template <class Visit>
void ForEachLane(unsigned wanted, Visit visit)
{
  while (wanted != 0)
  {
    visit(LowestBit(wanted));
    wanted &= wanted - 1;
  }
}

/// That many bits, from the lowest.
inline unsigned LowBits(std::uint32_t count)
{
  return (1u << count) - 1u;
}

}

#endif
