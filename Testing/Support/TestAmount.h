// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TestAmount_h
#define TestAmount_h

#include <algorithm>
#include <cstdlib>

namespace skdtest
{

/// Whether some cases may stand for all that the same code treats: with sanitizers, which slow it
/// down several times. SKDTREE_FEWER_TESTS in the environment says so.
inline bool FewerTests()
{
  static const bool fewer = std::getenv("SKDTREE_FEWER_TESTS") != nullptr;
  return fewer;
}

/// How many of `number` random cases to try.
inline int Amount(int number)
{
  return FewerTests() ? std::max(1, number / 10) : number;
}

/// At the start of a test that is left out then.
#define SKD_LEAVE_OUT_OF_FEWER_TESTS()                                                             \
  if (skdtest::FewerTests())                                                                       \
  {                                                                                                \
    GTEST_SKIP() << "left out of the shorter run";                                                 \
  }                                                                                                \
  static_assert(true)

}

#endif
