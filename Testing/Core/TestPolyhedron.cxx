// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Cells/MeanValue.h"
#include "CoreSolids.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{

bool Holds(const Solid& solid, const Vector3& x)
{
  return skd::Contains(solid.View(), solid.View().Bounds(), x);
}

/// Turns some faces the other way around.
Solid SomeReversed(Solid solid)
{
  bool isReversed = true;
  for (std::size_t at = 0; at < solid.Faces.size(); at += 1 + solid.Faces[at])
  {
    if (isReversed)
    {
      const auto first = solid.Faces.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      std::reverse(first, first + solid.Faces[at]);
    }
    isReversed = !isReversed;
  }
  return solid;
}

TEST(Polyhedron, HoldsWhatItsPartsHold)
{
  Random random(421);
  for (const double factor : Factors())
  {
    const auto position = [factor](const Vector3& p) { return factor * Rotated(p); };
    const Solid solid = SomeReversed(Prism(Notched(), 2.0)).Map(position);
    for (int i = 0; i < 5000; ++i)
    {
      const Vector3 x = random.Point<3>(-0.5, 3.5);
      ASSERT_EQ(Holds(solid, position(x)), LeastDistance2(PartsOfNotched(2.0), x) == 0.0)
        << x[0] << " " << x[1] << " " << x[2];
    }
  }
}

TEST(Polyhedron, ParityIsExactThroughEdgesAndVertices)
{
  const Solid solid = Prism(Notched(), 2.0);
  for (double x = -0.5; x < 4.0; x += 0.5)
  {
    for (double y = -0.5; y < 4.0; y += 0.5)
    {
      for (const double z : { -0.5, 0.5, 1.0, 2.5 })
      {
        const Vector3 at{ { x, y, z } };
        const Boxes<3> parts = PartsOfNotched(2.0);
        const bool isOnBoundary = x == 0 || x == 3 || y == 0 || y == 3 ||
          ((x == 1 || x == 2) && y >= 1) || (x >= 1 && x <= 2 && y == 1);
        if (!isOnBoundary)
        {
          ASSERT_EQ(Holds(solid, at), LeastDistance2(parts, at) == 0.0)
            << x << " " << y << " " << z;
        }
      }
    }
  }
}

TEST(Polyhedron, NeighboursShareAWarpedFace)
{
  Random random(422);
  Solid solid = Prism(Regular(6), 1.0);
  solid.Map([&](const Vector3& p) { return p + 0.1 * random.Direction<3>(); });
  Solid above; // the prism on the same warped top, its points in the other order
  const auto n = static_cast<std::uint32_t>(6);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    above.Points.push_back(solid.Points[n + (n - i) % n]);
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    above.Points.push_back(above.Points[i] + Vector3{ { 0.0, 0.0, 1.0 } });
  }
  above.Faces = Prism(Regular(6), 1.0).Faces;
  const std::uint32_t bottom[7] = { 6, 0, 1, 2, 3, 4, 5 };
  std::copy(bottom, bottom + 7, above.Faces.begin());
  int found = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 x = random.Point<3>(0.8, 1.2) - Vector3{ { random.In(0.6, 1.4), 1.0, 0.0 } };
    const int holders = Holds(solid, x) + Holds(above, x);
    ASSERT_EQ(holders, 1) << x[0] << " " << x[1] << " " << x[2];
    found += Holds(solid, x);
  }
  EXPECT_GT(found, 1000);
  EXPECT_LT(found, 19000);
}

TEST(Polyhedron, NearestPointOfItsFacesIsThatOfItsParts)
{
  Random random(423);
  for (const double factor : Factors())
  {
    const auto position = [factor](const Vector3& p) { return factor * Rotated(p); };
    const Solid solid = Prism(Notched(), 2.0).Map(position);
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 x = random.Point<3>(-2.0, 5.0);
      const double expected2 = LeastDistance2(PartsOfNotched(2.0), x);
      if (expected2 == 0.0)
      {
        continue;
      }
      const double limit2 = 4.0 * expected2 * factor * factor;
      const auto found = skd::ClosestPointOnFaces(solid.View(), position(x), limit2);
      ASSERT_NEAR(std::sqrt(found.Dist2) / factor, std::sqrt(expected2), 1e-14);
      ASSERT_NEAR(Norm(found.Point - position(x)) / factor, std::sqrt(expected2), 1e-14);
    }
  }
}

TEST(Polyhedron, FarFromItAllFacesAreBeyondTheLimit)
{
  const Solid solid = Prism(Regular(5), 1.0);
  const Vector3 x{ { 10, 0, 0 } };
  EXPECT_EQ(
    skd::ClosestPointOnFaces(solid.View(), x, 4.0).Dist2, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(skd::ClosestPointOnFaces(solid.View(), x, 100.0).Dist2, 81.0, 1e-12);
}

TEST(Polyhedron, AFlatOneHoldsNothing)
{
  const Solid flat = Prism(Regular(5), 0.0);
  EXPECT_FALSE(Holds(flat, { { 0.1, 0.1, 0.0 } }));
  EXPECT_NEAR(skd::ClosestPointOnFaces(flat.View(), { { 0.1, 0.1, 0.0 } }, 1.0).Dist2, 0.0, 1e-30);
}

//------------------------------------------------------------------------------
void ExpectWeightsGiveThePoint(const Solid& solid, const Vector3& x, double size)
{
  std::vector<double> weights(solid.Points.size());
  ASSERT_TRUE(skd::MeanValueWeights(solid.View(), x, weights.data()));
  ASSERT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12);
  ASSERT_LE(Norm(Mean(weights, solid.Points) - x), 1e-11 * size);
}

TEST(MeanValue, WeightsGiveThePoint)
{
  Random random(431);
  for (const double factor : Factors())
  {
    const auto position = [factor](const Vector3& p) { return factor * Rotated(p); };
    const Solid solid = Prism(Notched(), 2.0).Map(position);
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 x = position(random.Point(PartsOfNotched(2.0)[random.Below(3)]));
      ASSERT_NO_FATAL_FAILURE(ExpectWeightsGiveThePoint(solid, x, factor));
    }
  }
}

TEST(MeanValue, WeightsGiveThePointHoweverCloseToAFace)
{
  const Solid solid = Prism(Regular(6), 1.0).Map(Rotated);
  for (double height = 0.1; height > 1e-15; height *= 0.3)
  {
    const Vector3 x = Rotated({ { 0.2, 0.1, height } });
    ASSERT_NO_FATAL_FAILURE(ExpectWeightsGiveThePoint(solid, x, 1.0)) << height;
  }
}

// Some of the points lie in planes of faces that they are outside of.
TEST(MeanValue, WeightsGiveThePointInPlanesOfFaces)
{
  const Solid solid = Prism(Notched(), 2.0);
  for (const double off : { 0.0, 1e-16, 1e-13, 1e-11, 1e-9, 1e-6 })
  {
    const Vector3 x{ { 0.5, 1.0 + off, 0.75 } };
    ASSERT_NO_FATAL_FAILURE(ExpectWeightsGiveThePoint(solid, x, 1.0)) << off;
  }
}

TEST(MeanValue, WeightsOfAConvexOneAreNotNegative)
{
  Random random(432);
  const Solid solid = Prism(Regular(6), 1.0);
  std::vector<double> weights(solid.Points.size());
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 x = random.Point<3>(-0.6, 0.6) + Vector3{ { 0, 0, 0.5 } };
    if (!Holds(solid, x))
    {
      continue;
    }
    ASSERT_TRUE(skd::MeanValueWeights(solid.View(), x, weights.data()));
    ASSERT_GE(*std::min_element(weights.begin(), weights.end()), -1e-12);
  }
}

TEST(MeanValue, WeightsOfATetrahedronAreItsOwn)
{
  Solid solid;
  solid.Points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  solid.Faces = { 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2 };
  std::vector<double> weights(4);
  ASSERT_TRUE(skd::MeanValueWeights(solid.View(), { { 0.1, 0.2, 0.3 } }, weights.data()));
  const double expected[4] = { 0.4, 0.1, 0.2, 0.3 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(weights[i], expected[i], 1e-14);
  }
}

TEST(MeanValue, WeightsOnAFaceAreThoseOfItsPoints)
{
  Random random(433);
  const Solid solid = Prism(Regular(6), 1.0);
  std::vector<double> weights(solid.Points.size());
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 x{ { random.In(-0.5, 0.5), random.In(-0.5, 0.5), 1.0 } };
    const auto nearest = skd::FindNearestTriangle(solid.View(), x, 1.0);
    skd::FaceWeights(solid.View(), nearest, weights.data());
    ASSERT_LE(Norm(Mean(weights, solid.Points) - x), 1e-15);
    ASSERT_EQ(std::count(weights.begin(), weights.begin() + 6, 0.0), 6);
    ASSERT_GE(*std::min_element(weights.begin(), weights.end()), 0.0);
  }
}

}
