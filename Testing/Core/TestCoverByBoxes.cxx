// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// A few boxes that contain many: each of the given in one of them, no more than asked for, and
// tight where the given lie in groups.

#include "Core/Search/Tree/CoverByBoxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{
using skd::Box3;

std::vector<Box3> RandomBoxes(std::size_t number, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> position(-1.0, 1.0);
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < number; ++i)
  {
    Box3 box;
    for (int corner = 0; corner < 2; ++corner)
    {
      box.Add(
        skd::Vector3{ { position(random), 100.0 * position(random), 0.01 * position(random) } });
    }
    boxes.push_back(box);
  }
  return boxes;
}

bool IsIn(const Box3& box, const std::vector<Box3>& cover)
{
  return std::any_of(
    cover.begin(), cover.end(), [&](const Box3& one) { return one.Contains(box); });
}

TEST(CoverByBoxes, ContainsEachOfThem)
{
  for (const std::size_t number : { 1, 2, 3, 7, 64, 65, 1000 })
  {
    for (int levels : { 0, 1, 3, 6 })
    {
      const std::vector<Box3> boxes = RandomBoxes(number, 7u * static_cast<unsigned int>(number));
      const std::vector<Box3> cover = skd::CoverByBoxes<3>::Of(boxes, levels);
      EXPECT_EQ(cover.size(), std::min(number, std::size_t(1) << levels));
      for (const Box3& box : boxes)
      {
        EXPECT_TRUE(IsIn(box, cover)) << number << " " << levels;
      }
    }
  }
}

TEST(CoverByBoxes, LeavesOutWhatIsEmpty)
{
  EXPECT_TRUE(skd::CoverByBoxes<3>::Of({}, 6).empty());
  EXPECT_TRUE(skd::CoverByBoxes<3>::Of({ Box3(), Box3() }, 6).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const skd::Vector3 broken{ { nan, 0.0, 0.0 } };
  const skd::Vector3 zero{ { 0.0, 0.0, 0.0 } };
  EXPECT_EQ(skd::CoverByBoxes<3>::Of({ Box3(), { broken, broken }, { zero, zero } }, 6).size(), 1u);
}

// Points in two groups: no box reaches from one to the other.
TEST(CoverByBoxes, ParesDownToGroups)
{
  std::vector<Box3> boxes;
  for (int i = 0; i < 50; ++i)
  {
    for (double group : { 0.0, 1000.0 })
    {
      const skd::Vector3 point{ { group + i, -double(i % 7), 0.5 } };
      boxes.push_back({ point, point });
    }
  }
  for (const Box3& box : skd::CoverByBoxes<3>::Of(boxes, 1))
  {
    EXPECT_LT(box.Length(0), 50.0);
  }
}

// So many that halves are taken about the median; also where most lie in one place, so that no
// sample halves them.
TEST(CoverByBoxes, HalvesVeryMany)
{
  constexpr std::size_t number = 20000;
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < number; ++i)
  {
    const skd::Vector3 point{ { double(i % 200), double(i / 200), 0.0 } };
    boxes.push_back({ point, point });
  }
  double area = 0.0;
  for (const Box3& box : skd::CoverByBoxes<3>::Of(boxes, 6))
  {
    area += box.Length(0) * box.Length(1);
  }
  EXPECT_LT(area, number);
  for (std::size_t i = 0; i < number - 10; ++i)
  {
    boxes[i] = boxes.front();
  }
  const std::vector<Box3> cover = skd::CoverByBoxes<3>::Of(boxes, 6);
  EXPECT_EQ(cover.size(), 64u);
  EXPECT_TRUE(std::all_of(
    boxes.begin(), boxes.end(), [&cover](const Box3& box) { return IsIn(box, cover); }));
}

}
