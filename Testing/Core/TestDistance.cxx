// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Distance/Distance.h"
#include "CoreDimensions.h"

using namespace coretest;

namespace
{

/// The points of a box that matter: a lattice over it with its corners, edges and faces.
template <int D>
std::vector<skd::Vector<D>> Samples(const skd::Box<D>& box)
{
  const int side = D <= 3 ? 9 : 3;
  std::vector<skd::Vector<D>> samples(static_cast<std::size_t>(std::pow(side, D)));
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    std::size_t rest = i;
    for (int axis = 0; axis < D; ++axis, rest /= side)
    {
      const double t = static_cast<double>(rest % side) / (side - 1);
      samples[i][axis] = (1.0 - t) * box.Min[axis] + t * box.Max[axis];
    }
  }
  return samples;
}

/// The point of a box that is nearest to q: each coordinate clamped.
template <int D>
skd::Vector<D> Nearest(const skd::Vector<D>& q, const skd::Box<D>& box)
{
  skd::Vector<D> nearest;
  for (int axis = 0; axis < D; ++axis)
  {
    nearest[axis] = std::clamp(q[axis], box.Min[axis], box.Max[axis]);
  }
  return nearest;
}

template <class Type>
class DistanceTest : public ::testing::Test
{
protected:
  static constexpr int D = Type::Value;

  skd::Box<D> RandomBox()
  {
    const skd::Box<D> box =
      BoxAround(this->TheRandom.template Point<D>(-1.0, 1.0), this->RandomHalf());
    return box;
  }
  skd::Vector<D> RandomPoint() { return this->TheRandom.template Point<D>(-2.0, 2.0); }

  Random TheRandom{ 11 };

private:
  skd::Vector<D> RandomHalf()
  {
    skd::Vector<D> half = this->TheRandom.template Point<D>(0.0, 1.0);
    half[0] = this->TheRandom.Below(3) == 0 ? 0.0 : half[0];
    return half;
  }
};
TYPED_TEST_SUITE(DistanceTest, Dimensions, DimensionNames);

constexpr double Rounding = 1e-14;

TYPED_TEST(DistanceTest, LeastFromAPointIsThatOfTheClampedPoint)
{
  for (int i = 0; i < 200; ++i)
  {
    const auto box = this->RandomBox();
    const auto q = this->RandomPoint();
    EXPECT_NEAR(skd::MinDistance2(q, box), skd::Distance2(q, Nearest(q, box)), Rounding);
  }
}

TYPED_TEST(DistanceTest, AllPointsOfABoxAreBetweenLeastAndGreatest)
{
  for (int i = 0; i < 30; ++i)
  {
    const auto box = this->RandomBox();
    const auto q = this->RandomPoint();
    for (const auto& sample : Samples(box))
    {
      EXPECT_LE(skd::MinDistance2(q, box), skd::Distance2(q, sample) + Rounding);
      EXPECT_GE(skd::MaxDistance2(q, box), skd::Distance2(q, sample) - Rounding);
    }
  }
}

TYPED_TEST(DistanceTest, GreatestFromAPointIsThatOfACorner)
{
  for (int i = 0; i < 50; ++i)
  {
    const auto box = this->RandomBox();
    const auto q = this->RandomPoint();
    double greatest = 0.0;
    for (const auto& sample : Samples(box))
    {
      greatest = std::max(greatest, skd::Distance2(q, sample));
    }
    EXPECT_NEAR(skd::MaxDistance2(q, box), greatest, Rounding);
  }
}

TYPED_TEST(DistanceTest, LeastIsZeroInsideAndOnTheBoundaryOnly)
{
  constexpr int D = TypeParam::Value;
  const skd::Box<D> unit(Filled<D>(0.0), Filled<D>(1.0));
  EXPECT_EQ(skd::MinDistance2(Filled<D>(0.5), unit), 0.0);
  EXPECT_EQ(skd::MinDistance2(Filled<D>(1.0), unit), 0.0);
  EXPECT_GT(skd::MinDistance2(Filled<D>(1.0 + 1e-15), unit), 0.0);
}

TYPED_TEST(DistanceTest, OfAPointToAPointIsTheirDistance)
{
  for (int i = 0; i < 50; ++i)
  {
    const auto p = this->RandomPoint();
    const auto q = this->RandomPoint();
    const skd::Box<TypeParam::Value> box(p, p);
    EXPECT_DOUBLE_EQ(skd::MinDistance2(q, box), skd::Distance2(p, q));
    EXPECT_DOUBLE_EQ(skd::MaxDistance2(q, box), skd::Distance2(p, q));
  }
}

TYPED_TEST(DistanceTest, OfASphereIsThatOfItsNearestAndFarthestPoints)
{
  for (int i = 0; i < 200; ++i)
  {
    const auto box = this->RandomBox();
    const skd::Sphere<TypeParam::Value> sphere{ this->RandomPoint(), this->TheRandom.In(0.0, 2.0) };
    const double toCentre = std::sqrt(skd::MinDistance2(sphere.Centre, box));
    const double least = toCentre > sphere.Radius ? toCentre - sphere.Radius : 0.0;
    EXPECT_NEAR(skd::MinDistance(sphere, box), least, Rounding);
    const double greatest = std::sqrt(skd::MaxDistance2(sphere.Centre, box)) + sphere.Radius;
    EXPECT_NEAR(skd::MaxDistance(sphere, box), greatest, Rounding);
  }
}

TYPED_TEST(DistanceTest, PointsOfASphereAndABoxAreBetweenLeastAndGreatest)
{
  constexpr int D = TypeParam::Value;
  for (int i = 0; i < 20; ++i)
  {
    const auto box = this->RandomBox();
    const skd::Sphere<D> sphere{ this->RandomPoint(), this->TheRandom.In(0.0, 2.0) };
    for (const auto& sample : Samples(box))
    {
      const auto onSphere = sphere.Centre + sphere.Radius * this->TheRandom.template Direction<D>();
      const double distance = skd::Norm(onSphere - sample);
      EXPECT_LE(skd::MinDistance(sphere, box), distance + Rounding);
      EXPECT_GE(skd::MaxDistance(sphere, box), distance - Rounding);
    }
  }
}

TYPED_TEST(DistanceTest, OfASphereOfNoRadiusIsThatOfItsCentre)
{
  const auto box = this->RandomBox();
  const auto q = this->RandomPoint();
  const skd::Sphere<TypeParam::Value> sphere{ q, 0.0 };
  EXPECT_EQ(skd::MinDistance(sphere, box), std::sqrt(skd::MinDistance2(q, box)));
  EXPECT_EQ(skd::MaxDistance(sphere, box), std::sqrt(skd::MaxDistance2(q, box)));
}

TYPED_TEST(DistanceTest, BetweenBoxesIsTheLeastAndGreatestOverThePointsOfOne)
{
  for (int i = 0; i < 30; ++i)
  {
    const auto a = this->RandomBox();
    const auto b = this->RandomBox();
    double greatest = 0.0;
    for (const auto& sample : Samples(a))
    {
      EXPECT_LE(skd::MinDistance2(a, b), skd::MinDistance2(sample, b) + Rounding);
      greatest = std::max(greatest, skd::MaxDistance2(sample, b));
    }
    EXPECT_NEAR(skd::MaxDistance2(a, b), greatest, Rounding);
  }
}

TYPED_TEST(DistanceTest, LeastBetweenBoxesIsReached)
{
  for (int i = 0; i < 200; ++i)
  {
    const auto a = this->RandomBox();
    const auto b = this->RandomBox();
    // Where the boxes' intervals overlap any common coordinate will do: b's, clamped to a and back.
    const auto inB = Nearest(Nearest(b.Centroid(), a), b);
    const auto inA = Nearest(inB, a);
    EXPECT_NEAR(skd::MinDistance2(a, b), skd::Distance2(inA, inB), Rounding);
  }
}

TYPED_TEST(DistanceTest, BetweenBoxesIsSymmetric)
{
  for (int i = 0; i < 50; ++i)
  {
    const auto a = this->RandomBox();
    const auto b = this->RandomBox();
    EXPECT_EQ(skd::MinDistance2(a, b), skd::MinDistance2(b, a));
    EXPECT_EQ(skd::MaxDistance2(a, b), skd::MaxDistance2(b, a));
  }
}

TYPED_TEST(DistanceTest, LeastBetweenBoxesIsZeroExactlyWhenTheyOverlap)
{
  constexpr int D = TypeParam::Value;
  const skd::Box<D> unit(Filled<D>(0.0), Filled<D>(1.0));
  EXPECT_EQ(skd::MinDistance2(unit, skd::Box<D>(Filled<D>(1.0), Filled<D>(2.0))), 0.0);
  for (int i = 0; i < 200; ++i)
  {
    const auto a = this->RandomBox();
    const auto b = this->RandomBox();
    EXPECT_EQ(skd::MinDistance2(a, b) == 0.0, a.Overlaps(b));
  }
}

}
