// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoreDimensions.h"

using namespace coretest;

namespace
{

template <class Type>
class BoxTest : public ::testing::Test
{
public:
  static constexpr int D = Type::Value;
  const skd::Box<D> Unit{ Filled<D>(0.0), Filled<D>(1.0) };
};
TYPED_TEST_SUITE(BoxTest, Dimensions, DimensionNames);

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

TYPED_TEST(BoxTest, IsEmptyWhenNew)
{
  constexpr int D = TypeParam::Value;
  const skd::Box<D> box;
  EXPECT_TRUE(box.IsEmpty());
  EXPECT_EQ(box.Min[0], std::numeric_limits<double>::max());
  EXPECT_EQ(box.Max[D - 1], std::numeric_limits<double>::lowest());
  EXPECT_EQ(box.Diagonal(), 0.0);
}

TYPED_TEST(BoxTest, OfOnePointIsNotEmpty)
{
  constexpr int D = TypeParam::Value;
  skd::Box<D> box;
  box.Add(Filled<D>(-3.0));
  EXPECT_FALSE(box.IsEmpty());
  EXPECT_TRUE(box.Contains(Filled<D>(-3.0)));
}

TYPED_TEST(BoxTest, IsEmptyWhenOneAxisIs)
{
  skd::Box<TypeParam::Value> box = this->Unit;
  std::swap(box.Min[TypeParam::Value - 1], box.Max[TypeParam::Value - 1]);
  EXPECT_TRUE(box.IsEmpty());
}

TYPED_TEST(BoxTest, IsEmptyWithNaN)
{
  skd::Box<TypeParam::Value> box = this->Unit;
  box.Min[TypeParam::Value - 1] = NaN;
  EXPECT_TRUE(box.IsEmpty());
}

TYPED_TEST(BoxTest, AddingMakesTheLeastBoxOfAll)
{
  constexpr int D = TypeParam::Value;
  Random random(1);
  std::vector<skd::Vector<D>> points;
  skd::Box<D> box;
  for (int i = 0; i < 50; ++i)
  {
    points.push_back(random.Point<D>(-1.0, 1.0));
    box.Add(points.back());
  }
  for (int axis = 0; axis < D; ++axis)
  {
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end(),
      [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    EXPECT_EQ(box.Min[axis], (*least)[axis]);
    EXPECT_EQ(box.Max[axis], (*greatest)[axis]);
  }
}

TYPED_TEST(BoxTest, AddingAnEmptyBoxChangesNothing)
{
  skd::Box<TypeParam::Value> box = this->Unit;
  box.Add(skd::Box<TypeParam::Value>());
  EXPECT_TRUE(box.Min == this->Unit.Min && box.Max == this->Unit.Max);
}

TYPED_TEST(BoxTest, InflatesOnEverySide)
{
  constexpr int D = TypeParam::Value;
  const skd::Box<D> grown = this->Unit.Inflated(0.5);
  EXPECT_TRUE(grown.Min == Filled<D>(-0.5) && grown.Max == Filled<D>(1.5));
}

TYPED_TEST(BoxTest, StaysEmptyWhenInflated)
{
  EXPECT_TRUE(skd::Box<TypeParam::Value>().Inflated(1e308).IsEmpty());
}

TYPED_TEST(BoxTest, CentroidOfTheLargestBoxDoesNotOverflow)
{
  constexpr int D = TypeParam::Value;
  const double largest = std::numeric_limits<double>::max();
  const skd::Box<D> box(Filled<D>(0.5 * largest), Filled<D>(largest));
  EXPECT_TRUE(box.Centroid() == Filled<D>(0.75 * largest));
}

TYPED_TEST(BoxTest, LongestAxisIsTheLongestOrTheLowestOfEqual)
{
  constexpr int D = TypeParam::Value;
  EXPECT_EQ(this->Unit.LongestAxis(), 0);
  for (int axis = 0; axis < D; ++axis)
  {
    skd::Box<D> box = this->Unit;
    box.Max[axis] = 2.0;
    EXPECT_EQ(box.LongestAxis(), axis);
  }
}

TYPED_TEST(BoxTest, DiagonalIsFromCornerToCorner)
{
  EXPECT_DOUBLE_EQ(this->Unit.Diagonal(), std::sqrt(static_cast<double>(TypeParam::Value)));
}

TYPED_TEST(BoxTest, ContainsItsBoundaryAndNothingBeyond)
{
  constexpr int D = TypeParam::Value;
  EXPECT_TRUE(this->Unit.Contains(this->Unit.Min));
  EXPECT_TRUE(this->Unit.Contains(this->Unit.Max));
  EXPECT_TRUE(this->Unit.Contains(this->Unit));
  skd::Vector<D> beyond = Filled<D>(0.5);
  beyond[D - 1] = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(this->Unit.Contains(beyond));
  EXPECT_FALSE(this->Unit.Contains(this->Unit.Inflated(1e-15)));
}

TYPED_TEST(BoxTest, OverlapsWhatItTouchesAndNothingBeyond)
{
  constexpr int D = TypeParam::Value;
  const skd::Box<D> touching(Filled<D>(1.0), Filled<D>(2.0));
  EXPECT_TRUE(this->Unit.Overlaps(touching));
  EXPECT_TRUE(touching.Overlaps(this->Unit));
  skd::Box<D> apart = this->Unit;
  apart.Min[D - 1] = std::nextafter(1.0, 2.0);
  apart.Max[D - 1] = 2.0;
  EXPECT_FALSE(this->Unit.Overlaps(apart));
  EXPECT_FALSE(apart.Overlaps(this->Unit));
}

TYPED_TEST(BoxTest, EmptyOverlapsNothing)
{
  EXPECT_FALSE(skd::Box<TypeParam::Value>().Overlaps(this->Unit));
  EXPECT_FALSE(this->Unit.Overlaps(skd::Box<TypeParam::Value>()));
}

TYPED_TEST(BoxTest, NaNMeansNo)
{
  constexpr int D = TypeParam::Value;
  skd::Vector<D> point = Filled<D>(0.5);
  point[D - 1] = NaN;
  EXPECT_FALSE(this->Unit.Contains(point));
  EXPECT_FALSE(this->Unit.Overlaps(skd::Box<D>(point, point)));
}

}
