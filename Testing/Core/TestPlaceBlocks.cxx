// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Meshing/Grid/PlaceBlocks.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

using skd::LatticePoint;
using skd::PlaceBlock;

std::multiset<LatticePoint> PlacesOf(const std::vector<PlaceBlock>& blocks)
{
  std::multiset<LatticePoint> places;
  for (const PlaceBlock& block : blocks)
  {
    for (std::int64_t x = block.Low[0]; x < block.High[0]; ++x)
    {
      for (std::int64_t y = block.Low[1]; y < block.High[1]; ++y)
      {
        for (std::int64_t z = block.Low[2]; z < block.High[2]; ++z)
        {
          places.insert({ x, y, z });
        }
      }
    }
  }
  return places;
}

std::vector<LatticePoint> Block(const LatticePoint& size)
{
  const auto all = PlacesOf({ { { -2, 3, 7 }, { size[0] - 2, size[1] + 3, size[2] + 7 } } });
  return std::vector<LatticePoint>(all.begin(), all.end());
}

TEST(PlaceBlocks, OfNoPlaceThereAreNone)
{
  EXPECT_TRUE(skd::JoinPlaces({}).empty());
}

TEST(PlaceBlocks, ACuboidIsOneBlock)
{
  for (const LatticePoint& size : { LatticePoint{ 1, 1, 1 }, LatticePoint{ 5, 1, 1 },
         LatticePoint{ 1, 1, 4 }, LatticePoint{ 3, 4, 5 } })
  {
    const std::vector<PlaceBlock> blocks = skd::JoinPlaces(Block(size));
    ASSERT_EQ(blocks.size(), 1u);
    EXPECT_EQ(blocks[0].NumberOfPlaces(), size[0] * size[1] * size[2]);
  }
}

TEST(PlaceBlocks, AStepIsTwoBlocks)
{
  EXPECT_EQ(skd::JoinPlaces({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }).size(), 2u);
}

TEST(PlaceBlocks, CoverRandomPlacesOnceInWhateverOrder)
{
  std::mt19937 random(5);
  for (int density = 1; density <= 9; ++density)
  {
    std::vector<LatticePoint> places;
    for (const LatticePoint& place : Block({ 7, 8, 9 }))
    {
      if (static_cast<int>(random() % 10) < density)
      {
        places.push_back(place);
      }
    }
    const std::vector<PlaceBlock> blocks = skd::JoinPlaces(places);
    EXPECT_EQ(PlacesOf(blocks), std::multiset<LatticePoint>(places.begin(), places.end()));
    EXPECT_LT(blocks.size(), places.size());
    std::shuffle(places.begin(), places.end(), random);
    const std::vector<PlaceBlock> again = skd::JoinPlaces(places);
    ASSERT_EQ(again.size(), blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      EXPECT_EQ(again[i].Low, blocks[i].Low);
      EXPECT_EQ(again[i].High, blocks[i].High);
    }
  }
}

}
