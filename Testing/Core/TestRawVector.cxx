// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/RawVector.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace
{

constexpr std::size_t LargeCount = skd::LargePages::Least / sizeof(std::uint32_t);

std::uintptr_t PositionInPage(const void* address)
{
  return reinterpret_cast<std::uintptr_t>(address) % skd::LargePages::PageSize;
}

TEST(RawVector, KeepsItsValuesWhenItGrowsLarge)
{
  skd::RawVector<std::uint32_t> values;
  for (std::uint32_t i = 0; i < 3 * LargeCount; ++i)
  {
    values.push_back(i);
  }
  values.shrink_to_fit();
  for (std::uint32_t i = 0; i < 3 * LargeCount; ++i)
  {
    ASSERT_EQ(values[i], i);
  }
}

TEST(RawVector, BeginsWithALargePageFromTheLeastSizeOn)
{
  for (const std::size_t count : { LargeCount, LargeCount + 1, 5 * LargeCount / 2 })
  {
    const skd::RawVector<std::uint32_t> values(count);
    EXPECT_EQ(PositionInPage(values.data()), 0u) << count;
    EXPECT_EQ(values.capacity(), count);
  }
}

TEST(RawVector, IsWrittenToItsLastValueOnEitherSideOfTheLeastSize)
{
  for (const std::size_t count : { LargeCount - 1, LargeCount, LargeCount + 1 })
  {
    skd::RawVector<std::uint32_t> values(count);
    values.front() = 1u;
    values.back() = 2u;
    skd::RawVector<std::uint32_t> moved;
    moved.swap(values);
    EXPECT_EQ(moved.front() + moved.back(), 3u) << count;
  }
}

TEST(RawVector, KeepsTheAlignmentOfItsValues)
{
  struct alignas(64) Row
  {
    char Bytes[64];
  };
  for (const std::size_t count : { std::size_t(1), std::size_t(3), 2 * LargeCount / 64 + 1 })
  {
    const skd::RawVector<Row> rows(count);
    EXPECT_EQ(PositionInPage(rows.data()) % alignof(Row), 0u) << count;
  }
}

TEST(RawVector, RefusesMoreThanThereCanBe)
{
  skd::RawVector<std::uint64_t> values;
  EXPECT_THROW(values.reserve(std::numeric_limits<std::size_t>::max() / 2), std::length_error);
  skd::RawAllocator<std::uint64_t> allocator;
  EXPECT_THROW(allocator.allocate(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
}

}
