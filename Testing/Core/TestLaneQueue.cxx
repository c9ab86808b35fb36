// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/LaneQueue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

using skd::LaneQueue;

constexpr float Infinity = std::numeric_limits<float>::infinity();

/// The lanes in the order in which they are taken.
std::vector<int> TakenLanes(unsigned lanes, const float* keys, float limit)
{
  LaneQueue queue;
  queue.Put(lanes, keys);
  std::vector<int> taken;
  for (int lane; (lane = queue.Take(limit)) != LaneQueue::None;)
  {
    taken.push_back(lane);
  }
  return taken;
}

TEST(LaneQueue, GivesTheLeastKeyFirst)
{
  const float keys[8] = { 3.0f, 0.0f, 7.0f, 1e-45f, 1e30f, 0.5f, Infinity, 2.0f };
  EXPECT_EQ(TakenLanes(0xff, keys, Infinity), (std::vector<int>{ 1, 3, 5, 7, 0, 2, 4, 6 }));
}

TEST(LaneQueue, HoldsOnlyWhatWasPut)
{
  const float keys[8] = { 3.0f, 0.0f, 7.0f, 1.0f, 9.0f, 0.5f, 8.0f, 2.0f };
  EXPECT_EQ(TakenLanes(0x00, keys, Infinity), std::vector<int>());
  EXPECT_EQ(TakenLanes(0x80, keys, Infinity), std::vector<int>{ 7 });
  EXPECT_EQ(TakenLanes(0x95, keys, Infinity), (std::vector<int>{ 7, 0, 2, 4 }));
}

TEST(LaneQueue, OfEqualKeysGivesTheLowestLaneFirst)
{
  const float keys[8] = { 2.0f, 1.0f, 1.0f, 2.0f, 1.0f, 1.0f, 1.0f, 1.0f };
  EXPECT_EQ(TakenLanes(0xff, keys, 2.0f), (std::vector<int>{ 1, 2, 4, 5, 6, 7, 0, 3 }));
}

TEST(LaneQueue, LeavesWhatIsAboveTheLimit)
{
  const float keys[8] = { 3.0f, 0.0f, 7.0f, 1.0f, 9.0f, 0.5f, 8.0f, 2.0f };
  EXPECT_EQ(TakenLanes(0xff, keys, 2.0f), (std::vector<int>{ 1, 5, 3, 7 }));
  EXPECT_EQ(TakenLanes(0xff, keys, 0.0f), std::vector<int>{ 1 });
  EXPECT_EQ(TakenLanes(0xff, keys, -1.0f), std::vector<int>());
}

TEST(LaneQueue, IsInOrderButForTheLastBits)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> exponent(-20.0f, 20.0f);
  for (int trial = 0; trial < 2000; ++trial)
  {
    float keys[8];
    std::generate(keys, keys + 8, [&] { return std::exp2(exponent(random)); });
    const auto lanes = static_cast<unsigned>(random() & 0xffu);
    const float limit = keys[random() % 8];
    const std::vector<int> taken = TakenLanes(lanes, keys, limit);
    constexpr float rounding = 1.0f + 8 * std::numeric_limits<float>::epsilon();
    for (std::size_t i = 1; i < taken.size(); ++i)
    {
      EXPECT_LE(keys[taken[i - 1]], keys[taken[i]] * rounding);
    }
    for (int lane = 0; lane < 8; ++lane)
    {
      const bool isTaken = std::count(taken.begin(), taken.end(), lane) == 1;
      const bool isPut = (lanes >> lane & 1u) != 0;
      EXPECT_TRUE(isPut || !isTaken);
      EXPECT_TRUE(isTaken || !isPut || keys[lane] > limit); // none is lost
      EXPECT_TRUE(!isTaken || keys[lane] <= limit * rounding);
    }
  }
}

}
