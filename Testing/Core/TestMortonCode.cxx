// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/MortonCode.h"

#include <gtest/gtest.h>

namespace
{

TEST(MortonCode, HasTheBitsOfAllThreeInTurn)
{
  for (std::uint32_t i = 0; i < 1024; ++i)
  {
    const std::array<std::uint32_t, 3> cube{ i, 1023 - i, i * 37 % 1024 };
    std::uint32_t expected = 0;
    for (int bit = 0; bit < 30; ++bit)
    {
      expected |= (cube[bit % 3] >> (bit / 3) & 1u) << bit;
    }
    ASSERT_EQ(skd::MortonCode(cube), expected);
  }
}

}
