// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/LeafFilters/CoarseCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using skd::Box3;
using skd::CoarseCells;

std::vector<Box3> MakeBoxes(int count, double size, double shift, double scale, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Box3> boxes(static_cast<std::size_t>(count));
  for (Box3& box : boxes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = unit(random);
      box.Min[axis] = shift + scale * low;
      box.Max[axis] = shift + scale * (low + size * unit(random) * unit(random));
    }
  }
  return boxes;
}

Box3 BoundsOf(const std::vector<Box3>& boxes)
{
  Box3 bounds;
  for (const Box3& box : boxes)
  {
    bounds.Add(box);
  }
  return bounds;
}

bool Overlap(const Box3& a, const Box3& b)
{
  bool isApart = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    isApart = isApart || a.Max[axis] < b.Min[axis] || b.Max[axis] < a.Min[axis];
  }
  return !isApart;
}

bool OverlapsAny(const Box3& box, const std::vector<Box3>& boxes)
{
  return std::any_of(
    boxes.begin(), boxes.end(), [&](const Box3& other) { return Overlap(box, other); });
}

Box3 Common(const Box3& a, const Box3& b)
{
  return { skd::Greatest(a.Min, b.Min), skd::Least(a.Max, b.Max) };
}

/// How many of the others are left out, none of which overlaps any.
int CountLeftOut(const std::vector<Box3>& boxes, const std::vector<Box3>& others, double size)
{
  CoarseCells cells(Common(BoundsOf(boxes), BoundsOf(others)), size);
  for (const Box3& box : boxes)
  {
    const auto range = cells.RangeOf(box);
    if (!range.IsEmpty)
    {
      cells.Mark(range);
    }
  }
  int leftOut = 0;
  for (const Box3& other : others)
  {
    const auto range = cells.RangeOf(other);
    const bool isLeftOut = range.IsEmpty || !cells.HasMarks(range);
    EXPECT_FALSE(isLeftOut && OverlapsAny(other, boxes));
    leftOut += isLeftOut;
  }
  return leftOut;
}
}

//------------------------------------------------------------------------------
TEST(CoarseCells, NothingThatOverlapsIsLeftOut)
{
  for (const double scale : { 1.0, 1e-300, 1e300 })
  {
    for (const double shift : { 0.0, 1e6, -3e15 })
    {
      for (const double size : { 0.002, 0.05, 3.0 })
      {
        const auto boxes = MakeBoxes(150, 0.05, shift, scale, 3);
        const auto others = MakeBoxes(200, 0.1, shift, scale, 7);
        CountLeftOut(boxes, others, size * scale);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(CoarseCells, MostThatAreApartAreLeftOut)
{
  const auto boxes = MakeBoxes(150, 0.01, 0.0, 1.0, 3);
  const auto others = MakeBoxes(1000, 0.01, 0.0, 1.0, 7);
  EXPECT_GT(CountLeftOut(boxes, others, 0.02), 950);
}

//------------------------------------------------------------------------------
TEST(CoarseCells, BoxesThatTouchAtTheBorderOfACellAreMet)
{
  std::vector<Box3> boxes;
  std::vector<Box3> others;
  for (int i = 0; i < 64; ++i)
  {
    const double x = i / 8.0;
    boxes.push_back({ { { x, 0.0, 0.0 } }, { { x + 0.125, 8.0, 8.0 } } });
    others.push_back({ { { x + 0.125, x, 0.0 } }, { { x + 0.125, x, x } } }); // flat, at the border
  }
  EXPECT_EQ(CountLeftOut(boxes, others, 0.125), 0);
  EXPECT_EQ(CountLeftOut(others, boxes, 0.125), 0);
}

//------------------------------------------------------------------------------
TEST(CoarseCells, ARegionMayBeFlatOrAPointOrHaveNoEnd)
{
  constexpr double largest = std::numeric_limits<double>::max();
  const std::vector<Box3> flat = { { { { 0.0, 0.0, 1.0 } }, { { 1.0, 1.0, 1.0 } } } };
  const std::vector<Box3> point = { { { { 0.5, 0.5, 1.0 } }, { { 0.5, 0.5, 1.0 } } } };
  const std::vector<Box3> endless = { { { { -largest, -largest, -largest } },
    { { largest, largest, largest } } } };
  for (const auto* boxes : { &flat, &point, &endless })
  {
    for (const auto* others : { &flat, &point, &endless })
    {
      for (const double size : { 0.0, 0.1, largest })
      {
        EXPECT_EQ(CountLeftOut(*boxes, *others, size), 0);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(CoarseCells, WhatIsBeyondTheRegionIsInNoCell)
{
  const CoarseCells cells({ { { 0.0, 0.0, 0.0 } }, { { 1.0, 1.0, 1.0 } } }, 0.1);
  const auto isIn = [&](double min, double max) {
    return !cells.RangeOf({ { { min, 0.2, 0.2 } }, { { max, 0.3, 0.3 } } }).IsEmpty;
  };
  EXPECT_TRUE(isIn(-1.0, 0.0));
  EXPECT_TRUE(isIn(1.0, 7.0));
  EXPECT_TRUE(isIn(-1.0, 7.0));
  EXPECT_FALSE(isIn(-1.0, -0.1));
  EXPECT_FALSE(isIn(1.1, 7.0));
  EXPECT_FALSE(isIn(std::nan(""), -0.1));
  EXPECT_FALSE(isIn(std::nan(""), std::nan("")));
  EXPECT_TRUE(isIn(std::nan(""), 0.5)) << "in doubt it is in";
}
