// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Grid/Bricks.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

using skd::Brick;
using skd::Place;

std::multiset<Place> PlacesOf(const std::vector<Brick>& bricks)
{
  std::multiset<Place> places;
  for (const Brick& brick : bricks)
  {
    for (std::int64_t x = brick.Low[0]; x < brick.High[0]; ++x)
    {
      for (std::int64_t y = brick.Low[1]; y < brick.High[1]; ++y)
      {
        for (std::int64_t z = brick.Low[2]; z < brick.High[2]; ++z)
        {
          places.insert({ x, y, z });
        }
      }
    }
  }
  return places;
}

std::vector<Place> Block(const Place& size)
{
  const auto all = PlacesOf({ { { -2, 3, 7 }, { size[0] - 2, size[1] + 3, size[2] + 7 } } });
  return std::vector<Place>(all.begin(), all.end());
}

TEST(Bricks, OfNoPlaceThereAreNone)
{
  EXPECT_TRUE(skd::MakeBricks({}).empty());
}

TEST(Bricks, ABlockIsOneBrick)
{
  for (const Place& size :
    { Place{ 1, 1, 1 }, Place{ 5, 1, 1 }, Place{ 1, 1, 4 }, Place{ 3, 4, 5 } })
  {
    const std::vector<Brick> bricks = skd::MakeBricks(Block(size));
    ASSERT_EQ(bricks.size(), 1u);
    EXPECT_EQ(bricks[0].NumberOfPlaces(), size[0] * size[1] * size[2]);
  }
}

TEST(Bricks, AStepIsTwoBricks)
{
  EXPECT_EQ(skd::MakeBricks({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }).size(), 2u);
}

TEST(Bricks, CoverRandomPlacesOnceInWhateverOrder)
{
  std::mt19937 random(5);
  for (int density = 1; density <= 9; ++density)
  {
    std::vector<Place> places;
    for (const Place& place : Block({ 7, 8, 9 }))
    {
      if (static_cast<int>(random() % 10) < density)
      {
        places.push_back(place);
      }
    }
    const std::vector<Brick> bricks = skd::MakeBricks(places);
    EXPECT_EQ(PlacesOf(bricks), std::multiset<Place>(places.begin(), places.end()));
    EXPECT_LT(bricks.size(), places.size());
    std::shuffle(places.begin(), places.end(), random);
    const std::vector<Brick> again = skd::MakeBricks(places);
    ASSERT_EQ(again.size(), bricks.size());
    for (std::size_t i = 0; i < bricks.size(); ++i)
    {
      EXPECT_EQ(again[i].Low, bricks[i].Low);
      EXPECT_EQ(again[i].High, bricks[i].High);
    }
  }
}

}
