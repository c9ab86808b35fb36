// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Tree/CellElements.h"
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

/// Cells of `size` points each, or of 1 to 8 if that is 0.
struct Cells
{
  Cells(std::size_t number, std::size_t size, std::size_t points, Random& random)
  {
    for (std::size_t i = 0; i < number; ++i)
    {
      const std::size_t own = size > 0 ? size : static_cast<std::size_t>(random.In(1.0, 9.0));
      for (std::size_t k = 0; k < own; ++k)
      {
        this->Ids.push_back(
          static_cast<std::uint32_t>(random.In(0.0, static_cast<double>(points))));
      }
      this->Offsets.push_back(this->Ids.size());
    }
  }

  std::vector<std::uint32_t> IdsOf(std::uint32_t cell) const
  {
    const auto at = [this](std::uint64_t offset)
    { return this->Ids.begin() + static_cast<std::ptrdiff_t>(offset); };
    return { at(this->Offsets[cell]), at(this->Offsets[cell + 1]) };
  }

  std::vector<std::uint32_t> Ids;
  std::vector<std::uint64_t> Offsets{ 0 };
};

TYPED_TEST(OutwardRounding, ElementsAreTheRoundedBoxesOfCells)
{
  constexpr std::size_t points = 50;
  Random random(5);
  const auto coordinates = Coordinates<TypeParam>(points, 1.0, random);
  const skd::PointArray array = ArrayOf(coordinates);
  const auto frame = skd::Frame<3>::Of(skd::Box3({ { -1.0, -1.0, -1.0 } }, { { 1.5, 1.0, 1.0 } }));
  constexpr double margin = 1e-9;
  for (const std::uint32_t size : { 0, 1, 3, 4, 6, 8 })
  {
    const Cells cells(100, size, points, random);
    const skd::CellPoints view{ array, cells.Ids.data(), size > 0 ? nullptr : cells.Offsets.data(),
      size };
    const std::vector<std::uint32_t> numbers{ 99, 0, 7, 7, 42 };
    std::vector<skd::Element<3>> elements(numbers.size());
    skd::CellElements(view, frame, margin).Read(numbers.data(), numbers.size(), elements.data());
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      const auto expected = frame.OutwardWithin(BoxOf(array, cells.IdsOf(numbers[i])), margin);
      EXPECT_EQ(std::memcmp(&elements[i].Box, &expected, sizeof(expected)), 0) << size;
      EXPECT_EQ(elements[i].Index, numbers[i]);
    }
  }
}

TEST(EncloseInMemory, IsEnclose)
{
  Random random(6);
  skd::FloatBox<3> box = skd::NoBox<3>(), expected = box;
  for (std::uint32_t i = 0; i < 100; ++i)
  {
    skd::Element<3> element{ {}, i };
    for (int axis = 0; axis < 3; ++axis)
    {
      element.Box.Min[axis] = static_cast<float>(random.In(-1.0, 1.0));
      element.Box.Max[axis] = element.Box.Min[axis] + static_cast<float>(random.In(0.0, 1.0));
    }
    skd::EncloseInMemory(box, element);
    skd::Enclose(expected, element.Box);
    EXPECT_EQ(std::memcmp(&box, &expected, sizeof(box)), 0) << i;
  }
}
}
