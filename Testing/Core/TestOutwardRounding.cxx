// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/OutwardRounding.h"
#include "CoreDimensions.h"

#include <cstring>

using namespace coretest;

namespace
{
/// Points of which some share coordinates, or have zeros of either sign, or are tiny.
template <class Number>
std::vector<Number> Coordinates(std::size_t points, double size, Random& random)
{
  std::vector<Number> all;
  for (std::size_t i = 0; i < 3 * points; ++i)
  {
    const double special[] = { 0.0, -0.0, size, -size, 1e-30 * size, -1e-30 * size };
    const auto which = static_cast<std::size_t>(random.In(0.0, 12.0));
    all.push_back(static_cast<Number>(which < 6 ? special[which] : random.In(-size, size)));
  }
  return all;
}

skd::PointArray ArrayOf(const std::vector<float>& coordinates)
{
  return { coordinates.data(), nullptr };
}

skd::PointArray ArrayOf(const std::vector<double>& coordinates)
{
  return { nullptr, coordinates.data() };
}

std::vector<std::uint32_t> SomeIds(std::size_t points, Random& random)
{
  std::vector<std::uint32_t> ids(static_cast<std::size_t>(random.In(1.0, 9.0)));
  for (std::uint32_t& id : ids)
  {
    id = static_cast<std::uint32_t>(random.In(0.0, static_cast<double>(points)));
  }
  return ids;
}

skd::Box3 BoxOf(const skd::PointArray& points, const std::vector<std::uint32_t>& ids)
{
  skd::Box3 box;
  for (const std::uint32_t id : ids)
  {
    box.Add(points.At(id));
  }
  return box;
}

template <class Number>
class OutwardRounding : public testing::Test
{
};

using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(OutwardRounding, Numbers);

TYPED_TEST(OutwardRounding, BoundsAreThoseOfOnePointAfterTheOther)
{
  constexpr std::size_t points = 50;
  Random random(3);
  for (const double size : { 1e-20, 1.0, 1e30 })
  {
    const auto coordinates = Coordinates<TypeParam>(points, size, random);
    const skd::PointArray array = ArrayOf(coordinates);
    for (int i = 0; i < 300; ++i)
    {
      const auto ids = SomeIds(points, random);
      skd::PointBounds bounds;
      bounds.Add(array, ids.data(), ids.size());
      const skd::Box3 expected = BoxOf(array, ids);
      EXPECT_EQ(bounds.Box().Min, expected.Min);
      EXPECT_EQ(bounds.Box().Max, expected.Max);
    }
  }
}

TYPED_TEST(OutwardRounding, IsThatOfTheFrameToTheLastBit)
{
  constexpr std::size_t points = 50;
  Random random(4);
  for (const double size : { 1e-20, 1.0, 1e30 })
  {
    const auto coordinates = Coordinates<TypeParam>(points, size, random);
    const skd::PointArray array = ArrayOf(coordinates);
    const skd::Vector3 far{ { size, size, size } };
    const auto frame = skd::Frame<3>::Of(skd::Box3(-1.0 * far, random.In(1.0, 3.0) * far));
    for (const double margin : { 0.0, 1e-6 * size })
    {
      const skd::OutwardRounding rounding(frame, margin);
      for (int i = 0; i < 300; ++i)
      {
        const auto ids = SomeIds(points, random);
        skd::PointBounds bounds;
        bounds.Add(array, ids.data(), ids.size());
        skd::FloatBox<3> rounded;
        rounding.Round(bounds, rounded);
        const auto expected = frame.OutwardWithin(BoxOf(array, ids), margin);
        EXPECT_EQ(std::memcmp(&rounded, &expected, sizeof(rounded)), 0);
      }
    }
  }
}

TEST(PointBounds, ABoxIsAsItsCorners)
{
  const skd::Box3 box({ { -1.0, 2.0, -3.0 } }, { { 4.0, 5.0, -2.0 } });
  skd::PointBounds bounds;
  bounds.Add(box);
  EXPECT_EQ(bounds.Box().Min, box.Min);
  EXPECT_EQ(bounds.Box().Max, box.Max);
}
}
