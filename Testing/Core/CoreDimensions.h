// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The dimensions that tests of the core run in, and how many elements their scenes have there.
#ifndef coretest_CoreDimensions_h
#define coretest_CoreDimensions_h

#include "CoreScenes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coretest
{

template <int D>
struct Dimension
{
  static constexpr int Value = D;
};

#ifdef SKD_TEST_FEWER_KINDS
using Dimensions = ::testing::Types<Dimension<3>>;
#else
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>, Dimension<6>>;
#endif

struct DimensionNames
{
  template <class Type>
  static std::string GetName(int)
  {
    return "D" + std::to_string(Type::Value);
  }
};

/// The numbers of elements at which the shape of a tree of eights changes, and a larger one.
inline const std::vector<std::size_t>& Counts()
{
  static const std::vector<std::size_t> counts{ 0, 1, 2, 7, 8, 9, 63, 64, 65, 513, 5000 };
  return counts;
}

}

/// The scenes, compiled once (CoreSupport.cxx). `prefix`: extern, or nothing to compile them.
#define CORETEST_INSTANTIATE_SCENES(prefix, D)                                                     \
  prefix template std::vector<coretest::Scene<D>> coretest::AllScenes<D>(std::size_t, bool)

CORETEST_INSTANTIATE_SCENES(extern, 3);
#ifndef SKD_TEST_FEWER_KINDS
CORETEST_INSTANTIATE_SCENES(extern, 2);
CORETEST_INSTANTIATE_SCENES(extern, 6);
#endif

#endif
