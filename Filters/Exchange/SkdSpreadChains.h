// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSpreadChains_h
#define SkdSpreadChains_h

#include "Exchange/SkdTransport.h"

#include <cstdint>
#include <vector>

namespace skdtree
{
/// An end of a chain, of a process: 2 c and 2 c + 1 are those of its chain c. Process -1: none.
struct SkdChainEnd
{
  std::int32_t Process = -1;
  std::uint32_t End = 0;
};

/// A chain of a process.
struct SkdChain
{
  std::int32_t Process;
  std::uint32_t Number;
};

/// Of chains whose ends go on as ends of others, also of other processes (`links`, by end, each the
/// other's): for each chain one of those that it hangs together with, the same for all of these. It
/// is the longest, so that least is to be sent to its process; which of several depends on numbers
/// that are mixed, so that no process has much more than others. All processes must call it
/// together. Each knows its own chains alone: of those that hang together in a row, ever more are
/// known from one to the next, twice as many in each round; O(log n) rounds of n in a row, and
/// messages of O(1) for each end in a round.
std::vector<SkdChain> SkdChooseChains(SkdTransport& transport,
  const std::vector<std::uint32_t>& lengths, const std::vector<SkdChainEnd>& links);
}

#endif
