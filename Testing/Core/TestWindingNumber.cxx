// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/WindingNumber.h"
#include "CoreSolids.h"
#include "CoreSupport.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace coretest;

namespace
{

using Triangles = std::vector<skd::WindingNumber::Triangle>;

skd::Tree<3> TreeOf(const Triangles& triangles)
{
  std::vector<skd::Box3> boxes;
  for (const auto& t : triangles)
  {
    skd::Box3 box;
    for (const Vector3& p : t)
    {
      box.Add(p);
    }
    boxes.push_back(box);
  }
  return skd::BuildTree<3>(skd::MakeTreeInput(boxes, 0.0));
}

/// The octahedron, its faces cut n times and drawn to the unit sphere; normals outward.
Triangles Sphere(int n)
{
  Triangles made;
  for (int octant = 0; octant < 8; ++octant)
  {
    const Vector3 x{ { octant & 1 ? -1.0 : 1.0, 0, 0 } };
    const Vector3 y{ { 0, octant & 2 ? -1.0 : 1.0, 0 } };
    const Vector3 z{ { 0, 0, octant & 4 ? -1.0 : 1.0 } };
    const bool isTurned = x[0] * y[1] * z[2] < 0;
    made.push_back({ x, isTurned ? z : y, isTurned ? y : z });
  }
  for (; n > 0; --n)
  {
    Triangles finer;
    for (const auto& t : made)
    {
      Vector3 middle[3];
      for (int i = 0; i < 3; ++i)
      {
        const Vector3 sum = t[i] + t[(i + 1) % 3];
        middle[i] = (1.0 / skd::Norm(sum)) * sum;
      }
      finer.insert(finer.end(),
        { { t[0], middle[0], middle[2] }, { middle[0], t[1], middle[1] },
          { middle[2], middle[1], t[2] }, { middle[0], middle[1], middle[2] } });
    }
    made.swap(finer);
  }
  return made;
}

/// By the formula of Euler and Eriksson, apart from SolidAngle's own for all but its signs.
double SumOfAngles(const Triangles& triangles, const Vector3& x)
{
  long double sum = 0.0L;
  for (const auto& t : triangles)
  {
    Vector3 unit[3];
    for (int i = 0; i < 3; ++i)
    {
      unit[i] = (1.0 / skd::Norm(t[i] - x)) * (t[i] - x);
    }
    const double volume = skd::Dot(unit[0], skd::Cross(unit[1], unit[2]));
    const double below =
      1.0 + skd::Dot(unit[0], unit[1]) + skd::Dot(unit[1], unit[2]) + skd::Dot(unit[2], unit[0]);
    sum += 2.0L * std::atan2(volume, below);
  }
  return static_cast<double>(sum / (4.0L * 3.14159265358979323846264L));
}

TEST(SolidAngle, OfTheFacesOfACube)
{
  const Vector3 corners[4] = { { { -1, -1, 1 } }, { { 1, -1, 1 } }, { { 1, 1, 1 } },
    { { -1, 1, 1 } } };
  const Vector3 middle{ { 0, 0, 0 } };
  const double sum = skd::SolidAngle(corners[0], corners[1], corners[2], middle) +
    skd::SolidAngle(corners[0], corners[2], corners[3], middle);
  EXPECT_NEAR(sum, 4.0 * std::acos(-1.0) / 6.0, 1e-14);
  EXPECT_NEAR(skd::SolidAngle(corners[2], corners[1], corners[0], middle), -0.5 * sum, 1e-14);
  EXPECT_EQ(skd::SolidAngle(corners[0], corners[1], corners[1], middle), 0.0);
  EXPECT_EQ(skd::SolidAngle(corners[0], corners[1], corners[2], { { 5, 0, 1 } }), 0.0);
}

TEST(WindingNumber, WithoutAccuracyItIsTheSumOfAngles)
{
  Random random(611);
  for (int count : { 0, 1, 2, 7, 8, 9, 65, 700 })
  {
    Triangles soup;
    for (int i = 0; i < count; ++i)
    {
      const Vector3 at = random.Direction<3>();
      soup.push_back({ at, at + random.In(0.0, 1.0) * random.Direction<3>(),
        at + random.In(0.0, 1.0) * random.Direction<3>() });
    }
    const skd::Tree<3> tree = TreeOf(soup);
    const skd::WindingNumber exact(tree, soup, 0.0);
    for (int i = 0; i < 50; ++i)
    {
      const Vector3 x = random.In(0.0, 3.0) * random.Direction<3>();
      ASSERT_NEAR(exact.At(x), SumOfAngles(soup, x), 1e-10) << count;
    }
  }
}

TEST(WindingNumber, WithAccuracyItErrsLittleAndLessWithMore)
{
  Random random(612);
  const Triangles sphere = Sphere(5);
  const skd::Tree<3> tree = TreeOf(sphere);
  double errors[3] = {};
  const double accuracies[3] = { 2.0, 4.0, 8.0 };
  for (int k = 0; k < 3; ++k)
  {
    const skd::WindingNumber winding(tree, sphere, accuracies[k]);
    for (int i = 0; i < 3000; ++i)
    {
      const double radius = i % 2 ? random.In(0.0, 0.995) : random.In(1.001, 3.0);
      const double expected = i % 2 ? 1.0 : 0.0;
      const double error = std::abs(winding.At(radius * random.Direction<3>()) - expected);
      errors[k] = std::max(errors[k], error);
    }
  }
  EXPECT_LT(errors[0], 4e-3);
  EXPECT_LT(errors[1], 2e-4);
  EXPECT_LT(errors[2], 1e-5);
  EXPECT_LT(errors[1], errors[0]);
  EXPECT_LT(errors[2], errors[1]);
}

TEST(WindingNumber, OfPartOfASurfaceItIsTheExactSumToo)
{
  Random random(613);
  Triangles sphere = Sphere(4);
  Triangles part;
  for (std::size_t i = 0; i < sphere.size(); ++i)
  {
    if (sphere[i][0][2] < 0.4)
    {
      part.push_back(i % 7
          ? sphere[i]
          : skd::WindingNumber::Triangle{ sphere[i][0], sphere[i][2], sphere[i][1] });
    }
  }
  const skd::Tree<3> tree = TreeOf(part);
  const skd::WindingNumber winding(tree, part);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 x = random.In(0.0, 2.0) * random.Direction<3>();
    ASSERT_NEAR(winding.At(x), SumOfAngles(part, x), 5e-3);
  }
}

TEST(WindingNumber, TheBoundHoldsAndIsWithinTheTolerance)
{
  Random random(616);
  Triangles part;
  for (const auto& t : Sphere(5))
  {
    if (t[0][2] < 0.7 && random.In(0.0, 1.0) < 0.9)
    {
      part.push_back(t);
    }
  }
  const skd::Tree<3> tree = TreeOf(part);
  const skd::WindingNumber winding(tree, part);
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 x = random.In(0.0, 1.5) * random.Direction<3>();
    const double exact = SumOfAngles(part, x);
    for (const double accuracy : { 1.0, 2.0, 4.0, 8.0 })
    {
      const auto sum = winding.Estimate(x, accuracy);
      ASSERT_LE(std::abs(sum.Number - exact), sum.Bound + 1e-10) << accuracy;
    }
    for (const double tolerance : { 1.0, 0.1, 1e-2, 1e-3, 0.0 })
    {
      const auto sum = winding.Decide(x, tolerance);
      ASSERT_LE(sum.Bound, tolerance);
      ASSERT_LE(std::abs(sum.Number - exact), sum.Bound + 1e-10);
    }
  }
}

TEST(WindingNumber, WhetherItIsAtLeastOneHalfIsExact)
{
  // Through the opening of half a sphere, where the number passes through 1/2.
  Random random(617);
  Triangles half;
  for (const auto& t : Sphere(5))
  {
    if (t[0][2] + t[1][2] + t[2][2] < 0.0)
    {
      half.push_back(t);
    }
  }
  const skd::Tree<3> tree = TreeOf(half);
  const skd::WindingNumber winding(tree, half);
  int wouldBeWrong = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 x{ { random.In(-0.5, 0.5), random.In(-0.5, 0.5), random.In(-0.01, 0.01) } };
    const double exact = SumOfAngles(half, x);
    if (std::abs(exact - 0.5) > 1e-9)
    {
      ASSERT_EQ(winding.Decide(x, 1.0).Number >= 0.5, exact >= 0.5) << exact;
      wouldBeWrong += (winding.Estimate(x, 2.0).Number >= 0.5) != (exact >= 0.5);
    }
  }
  EXPECT_GT(wouldBeWrong, 0);
}

TEST(WindingNumber, TheSumOfMagnitudesIsBoundedFromAbove)
{
  Random random(31);
  Triangles triangles = Sphere(3);
  triangles.resize(triangles.size() / 3);
  const skd::Tree<3> tree = TreeOf(triangles);
  const skd::WindingNumber winding(tree, triangles);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 x = random.In(0.0, 20.0) * random.Direction<3>();
    double exact = 0.0, facing = 0.0; // the latter as if all of it faced x
    for (const auto& t : triangles)
    {
      exact += std::abs(skd::SolidAngle(t[0], t[1], t[2], x)) / (4.0 * std::acos(-1.0));
      const double area = 0.5 * skd::Norm(skd::Cross(t[1] - t[0], t[2] - t[0]));
      double distance2 = skd::Norm2(t[0] - x);
      for (const Vector3& p : t)
      {
        distance2 = std::min(distance2, skd::Norm2(p - x));
      }
      facing += area / (4.0 * std::acos(-1.0) * distance2);
    }
    const double bound = winding.BoundMagnitudes(x);
    ASSERT_GE(bound, std::min(0.5, exact) - 1e-12);
    ASSERT_LE(bound, 0.5);
    ASSERT_LE(bound, std::max(exact, 1.7 * facing) + 1e-12);
  }
}

TEST(WindingNumber, OnATriangleNothingIsRefined)
{
  const Triangles sphere = Sphere(6);
  const skd::Tree<3> tree = TreeOf(sphere);
  const skd::WindingNumber winding(tree, sphere);
  for (std::size_t i = 0; i < sphere.size(); i += 97)
  {
    const auto& t = sphere[i];
    ASSERT_TRUE(winding.Decide(t[0], 0.0).IsOn);
    ASSERT_TRUE(winding.Decide(skd::Lerp(t[0], t[1], 0.3), 0.0).IsOn);
    ASSERT_TRUE(winding.Decide(skd::Lerp(skd::Lerp(t[0], t[1], 0.3), t[2], 0.4), 0.0).IsOn);
  }
}

TEST(WindingNumber, ItDoesNotDependOnPositionOrSize)
{
  Random random(614);
  const Triangles sphere = Sphere(3);
  for (const double factor : { 1e-30, 1e-6, 1.0, 1e8, 1e30 })
  {
    for (const double offset : { 0.0, 1e6 })
    {
      const Vector3 shift = factor * offset * Vector3{ { 1, -2, 3 } };
      Triangles moved = sphere;
      for (auto& t : moved)
      {
        for (Vector3& p : t)
        {
          p = factor * p + shift;
        }
      }
      const skd::Tree<3> tree = TreeOf(moved);
      const skd::WindingNumber winding(tree, moved);
      for (int i = 0; i < 100; ++i)
      {
        const Vector3 x = random.In(0.0, 2.0) * random.Direction<3>();
        const double radius = skd::Norm(x);
        if (radius < 0.9 || radius > 1.1)
        {
          ASSERT_NEAR(winding.At(factor * x + shift), radius < 1.0 ? 1.0 : 0.0, 5e-3)
            << factor << " " << offset;
        }
      }
    }
  }
}

TEST(WindingNumber, OnTheSurfaceAndWithoutAreaItIsFinite)
{
  Triangles sphere = Sphere(2);
  sphere.push_back({ sphere[0][0], sphere[0][0], sphere[0][1] });
  sphere.push_back({ sphere[0][0], sphere[0][0], sphere[0][0] });
  const skd::Tree<3> tree = TreeOf(sphere);
  const skd::WindingNumber winding(tree, sphere);
  for (const auto& t : sphere)
  {
    ASSERT_TRUE(std::isfinite(winding.At(t[0])));
    ASSERT_TRUE(std::isfinite(winding.At(skd::Lerp(t[0], t[1], 0.5))));
  }
  EXPECT_NEAR(winding.At({ { 0.1, 0, 0 } }), 1.0, 5e-3);
}

}
