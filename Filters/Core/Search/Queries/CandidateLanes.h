// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Queries_CandidateLanes_h
#define skd_Queries_CandidateLanes_h

#include <cstdint>
#include <vector>

namespace skd
{

/// Some children of a node, one bit each. They are elements if the node is a leaf, else nodes that
/// represent all elements below them.
struct CandidateLanes
{
  std::uint32_t Node;
  std::uint32_t Lanes;
};

/// The initial candidates of a root box: the whole tree.
inline std::vector<CandidateLanes> AllCandidates()
{
  return { { 0u, ~0u } };
}

}

#endif
