// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoreSupport.h"

#include "Core/Search/Queries/WithinBox.h"

using namespace coretest;

namespace
{

using Rule = skd::SplitRule;

/// Boxes that fill the unit cube, each edge between 1 / n and `most` times that, about random
/// places.
Boxes<3> Clutter(std::size_t count, double most, std::uint32_t seed)
{
  Random random(seed);
  const double edge = 1.0 / std::cbrt(double(count));
  Boxes<3> boxes;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double half = 0.5 * edge * std::pow(most, random.In(0.0, 1.0));
    const skd::Vector3 middle{ { random.In(0.0, 1.0), random.In(0.0, 1.0), random.In(0.0, 1.0) } };
    boxes.push_back(skd::Box3(middle, middle).Inflated(half));
  }
  return boxes;
}

/// n^3 unit cubes side by side, each `growth` times as far along x as the one before.
Boxes<3> Bricks(int n, double growth)
{
  Boxes<3> boxes;
  double x = 0.0;
  double width = 1.0;
  for (int i = 0; i < n; ++i)
  {
    for (int rest = 0; rest < n * n; ++rest)
    {
      const double y = rest % n;
      const double z = rest / n;
      boxes.push_back(skd::Box3({ { x, y, z } }, { { x + width, y + 1.0, z + 1.0 } }));
    }
    x += width;
    width *= growth;
  }
  return boxes;
}

skd::ElementSizes<3> SizesOf(const Boxes<3>& boxes)
{
  return skd::ElementSizes<3>(InputOf(boxes, 8).Elements);
}

/// A lattice whose steps grow from layer to layer in every direction, its bricks larger than steps.
Boxes<3> GradedLattice(int n, double growth, double overlap)
{
  std::vector<double> at{ 0.0 };
  for (int i = 0; i < n; ++i)
  {
    at.push_back(at.back() + std::pow(growth, i));
  }
  Boxes<3> boxes;
  for (int cell = 0; cell < n * n * n; ++cell)
  {
    const int i = cell % n;
    const int j = cell / n % n;
    const int k = cell / n / n;
    const skd::Vector3 low{ { at[i], at[j], at[k] } };
    const skd::Vector3 high{ { at[i + 1], at[j + 1], at[k + 1] } };
    boxes.push_back(skd::Box3(low - overlap * (high - low), high + overlap * (high - low)));
  }
  return boxes;
}

/// How many nodes the searches for the middles of all boxes open, in all.
std::size_t CountOpened(const Boxes<3>& boxes, Rule rule)
{
  const auto tree = skd::BuildTree<3>(InputOf(boxes, 8, rule));
  const CountedTree<skd::Tree<3>> counted(tree);
  auto visitor = [](std::uint32_t) { return true; };
  for (const skd::Box3& box : boxes)
  {
    const skd::Vector3 x = box.Centroid();
    skd::WithinBox<3, decltype(visitor)> query(tree.GetFrame(), skd::Box3(x, x), visitor);
    skd::Walk(counted, query);
  }
  return counted.Opened;
}

TEST(SplitRule, BricksOfOneSizeTouchAndDoNotDiffer)
{
  const auto sizes = SizesOf(Bricks(12, 1.0));
  EXPECT_NEAR(sizes.Overlap(), 1.0, 1e-3);
  EXPECT_NEAR(sizes.Spread(), 1.0, 1e-3);
  EXPECT_EQ(sizes.Choose(), Rule::Median);
}

TEST(SplitRule, BricksOfManySizesAreSplitByArea)
{
  const auto sizes = SizesOf(Bricks(12, 2.0));
  EXPECT_NEAR(sizes.Overlap(), 1.0, 1e-3);
  EXPECT_GT(sizes.Spread(), 2.0);
  EXPECT_EQ(sizes.Choose(), Rule::SurfaceArea);
}

TEST(SplitRule, OverlapIsTheNumberOfBoxesAtAPlaceSeenFromASample)
{
  const Boxes<3> few = Clutter(3000, 4.0, 1);
  const Boxes<3> many = Clutter(30000, 4.0, 1);
  double volume = 0.0;
  for (const skd::Box3& box : many)
  {
    const skd::Vector3 size = box.Max - box.Min;
    volume += size[0] * size[1] * size[2];
  }
  const skd::Vector3 all = BoundsOf(many).Max - BoundsOf(many).Min;
  EXPECT_NEAR(SizesOf(many).Overlap(), volume / (all[0] * all[1] * all[2]), 0.1 * volume);
  EXPECT_NEAR(SizesOf(few).Spread(), SizesOf(many).Spread(), 0.1);
}

TEST(SplitRule, SurfacesAreSplitAtTheMedianHoweverTheyDiffer)
{
  Boxes<3> boxes = Bricks(12, 2.0);
  for (skd::Box3& box : boxes)
  {
    box.Min[2] = box.Max[2] = box.Min[0] * 1e-3;
  }
  EXPECT_EQ(SizesOf(boxes).Choose(), Rule::Median);
}

TEST(SplitRule, SetsWithoutVolumeAreSplitAtTheMedian)
{
  const skd::Vector3 origin{ { 0.0, 0.0, 0.0 } };
  EXPECT_EQ(SizesOf({}).Choose(), Rule::Median);
  EXPECT_EQ(SizesOf(Boxes<3>(100, skd::Box3(origin, origin))).Choose(), Rule::Median);
  EXPECT_EQ(SizesOf({ skd::Box3(origin, origin) }).Choose(), Rule::Median);
}

TEST(SplitRule, AutomaticIsWhatTheSizesSayAndTheOthersAreThemselves)
{
  const Boxes<3> even = Bricks(8, 1.0);
  const Boxes<3> uneven = Bricks(8, 2.0);
  EXPECT_EQ(skd::BuildTree<3>(InputOf(even, 8, Rule::Automatic)).Rule(), Rule::Median);
  EXPECT_EQ(skd::BuildTree<3>(InputOf(even, 8, Rule::SurfaceArea)).Rule(), Rule::SurfaceArea);
  EXPECT_EQ(skd::BuildTree<3>(InputOf(uneven, 8, Rule::Automatic)).Rule(), Rule::SurfaceArea);
  EXPECT_EQ(skd::BuildTree<3>(InputOf(uneven, 8, Rule::Median)).Rule(), Rule::Median);
}

TEST(SplitRule, ByAreaSearchesOfUnevenBoxesOpenFewerNodes)
{
  const Boxes<3> boxes = GradedLattice(30, 1.3, 0.4);
  EXPECT_LT(CountOpened(boxes, Rule::SurfaceArea), 0.85 * CountOpened(boxes, Rule::Median));
}

/// Two heaps far apart, one with three times as many as the other.
TEST(AreaSplit, CutsWhereTheGapIs)
{
  Random random(5);
  Boxes<3> boxes;
  for (int i = 0; i < 64; ++i)
  {
    const double x = i < 16 ? random.In(0.0, 1.0) : random.In(100.0, 101.0);
    const skd::Vector3 middle{ { x, random.In(0.0, 150.0), random.In(0.0, 1.0) } };
    boxes.push_back(skd::Box3(middle, middle));
  }
  const auto input = InputOf(boxes, 8);
  const skd::AreaSplit<3> split(input.Elements.data(), input.Elements.data() + 64, 8);
  const auto free = split.Best({ 8, 1, 7 }, 1);
  EXPECT_EQ(free.Axis, 0);
  EXPECT_EQ(free.Left, 2u);
  EXPECT_GE(split.Best({ 8, 3, 5 }, 1).Left, 3u);
  EXPECT_LE(split.Best({ 8, 3, 5 }, 1).Left, 5u);
}

TEST(AreaSplit, HalvesWhatIsAllInOnePlaceAcrossTheLongestAxis)
{
  const skd::Vector3 middle{ { 1.0, 2.0, 3.0 } };
  for (const std::size_t count : { 16, 5000 })
  {
    const auto input = InputOf(Boxes<3>(count, skd::Box3(middle, middle).Inflated(0.5)), 8);
    const auto leaves = static_cast<std::uint64_t>((count + 7) / 8);
    const skd::AreaSplit<3> split(input.Elements.data(), input.Elements.data() + count, 8);
    const auto position = split.Best({ leaves, 1, leaves - 1 }, 2);
    EXPECT_EQ(position.Axis, 2);
    EXPECT_EQ(position.Left, leaves / 2);
  }
}

}
