// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Meshing/Grid/LatticeBlocks.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

using skd::LatticeBlock;
using skd::LatticePoint;

std::multiset<LatticePoint> PointsOf(const std::vector<LatticeBlock>& blocks)
{
  std::multiset<LatticePoint> points;
  for (const LatticeBlock& block : blocks)
  {
    for (std::int64_t x = block.Low[0]; x < block.High[0]; ++x)
    {
      for (std::int64_t y = block.Low[1]; y < block.High[1]; ++y)
      {
        for (std::int64_t z = block.Low[2]; z < block.High[2]; ++z)
        {
          points.insert({ x, y, z });
        }
      }
    }
  }
  return points;
}

std::vector<LatticePoint> Block(const LatticePoint& size)
{
  const auto all = PointsOf({ { { -2, 3, 7 }, { size[0] - 2, size[1] + 3, size[2] + 7 } } });
  return std::vector<LatticePoint>(all.begin(), all.end());
}

TEST(LatticeBlocks, OfNoPointThereAreNone)
{
  EXPECT_TRUE(skd::JoinIntoBlocks({}).empty());
}

TEST(LatticeBlocks, ACuboidIsOneBlock)
{
  for (const LatticePoint& size : { LatticePoint{ 1, 1, 1 }, LatticePoint{ 5, 1, 1 },
         LatticePoint{ 1, 1, 4 }, LatticePoint{ 3, 4, 5 } })
  {
    const std::vector<LatticeBlock> blocks = skd::JoinIntoBlocks(Block(size));
    ASSERT_EQ(blocks.size(), 1u);
    EXPECT_EQ(blocks[0].NumberOfPoints(), size[0] * size[1] * size[2]);
  }
}

TEST(LatticeBlocks, AStepIsTwoBlocks)
{
  EXPECT_EQ(skd::JoinIntoBlocks({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }).size(), 2u);
}

TEST(LatticeBlocks, CoverRandomPlacesOnceInWhateverOrder)
{
  std::mt19937 random(5);
  for (int density = 1; density <= 9; ++density)
  {
    std::vector<LatticePoint> points;
    for (const LatticePoint& point : Block({ 7, 8, 9 }))
    {
      if (static_cast<int>(random() % 10) < density)
      {
        points.push_back(point);
      }
    }
    const std::vector<LatticeBlock> blocks = skd::JoinIntoBlocks(points);
    EXPECT_EQ(PointsOf(blocks), std::multiset<LatticePoint>(points.begin(), points.end()));
    EXPECT_LT(blocks.size(), points.size());
    std::shuffle(points.begin(), points.end(), random);
    const std::vector<LatticeBlock> again = skd::JoinIntoBlocks(points);
    ASSERT_EQ(again.size(), blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      EXPECT_EQ(again[i].Low, blocks[i].Low);
      EXPECT_EQ(again[i].High, blocks[i].High);
    }
  }
}

}
