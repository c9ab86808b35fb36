// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SameAnswers.h
 * @brief two locators of the same data set give the same answers
 */
#ifndef skdtest_SameAnswers_h
#define skdtest_SameAnswers_h

#include "Support/LocatorCalls.h"

#include <gtest/gtest.h>

namespace skdtest
{

inline void ExpectSameAnswers(
  vtkSkdTreeCellLocator* a, vtkSkdTreeCellLocator* b, vtkDataSet* data, const std::string& name)
{
  Random random(120);
  Bounds box;
  data->GetBounds(box.data());
  for (int i = 0; i < 40; ++i)
  {
    const Point x = random.InBox(Grown(box, 0.2));
    const Point y = random.InBox(Grown(box, 0.2));
    ASSERT_EQ(FindClosest(a, x), FindClosest(b, x)) << name;
    ASSERT_EQ(FindFirstHit(a, x, y), FindFirstHit(b, x, y)) << name;
    ASSERT_EQ(FindCell(a, x), FindCell(b, x)) << name;
    ASSERT_EQ(FindAlongLine(a, x, y), FindAlongLine(b, x, y)) << name;
    ASSERT_EQ(FindClosestCells(a, x, 5).Cells, FindClosestCells(b, x, 5).Cells) << name;
  }
}

}

#endif
