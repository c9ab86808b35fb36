// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProgressRises.h
 * @brief the progress of an update rises to 1
 */
#ifndef skdtest_ProgressRises_h
#define skdtest_ProgressRises_h

#include "Support/FilterRun.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace skdtest
{

/// In more than so many steps.
inline void ExpectProgressToRise(vtkAlgorithm* algorithm, std::size_t steps)
{
  ProgressWatch watch(algorithm);
  algorithm->Update();
  EXPECT_GT(watch.Seen.size(), steps);
  EXPECT_TRUE(std::is_sorted(watch.Seen.begin(), watch.Seen.end()));
  EXPECT_EQ(watch.Seen.back(), 1.0);
  algorithm->RemoveObserver(watch.Command);
}

}

#endif
