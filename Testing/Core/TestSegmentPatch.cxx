// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/Distance/BilinearPatch.h"
#include "Core/Geometry/Intersection/SegmentPatch.h"
#include "CoreSolids.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{

Vector3 OnPatch(const Vector3* p, double r, double s)
{
  return skd::Lerp(skd::Lerp(p[0], p[1], r), skd::Lerp(p[3], p[2], r), s);
}

skd::PatchHits Hits(const Vector3* patch, const Vector3& from, const Vector3& to)
{
  return skd::IntersectPatch(skd::SegmentView(skd::Segment<3>{ from, to }), patch);
}

bool Has(const skd::PatchHits& hits, double t, double tolerance)
{
  bool has = false;
  for (int i = 0; i < hits.Count; ++i)
  {
    has |= std::abs(hits.T[i] - t) <= tolerance;
  }
  return has;
}

void RandomPatch(Random& random, double warp, double factor, Vector3* patch)
{
  const Vector3 square[4] = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } } };
  for (int i = 0; i < 4; ++i)
  {
    const Vector3 shift{ { random.In(-warp, warp), random.In(-warp, warp),
      random.In(-warp, warp) } };
    patch[i] = factor * Rotated(square[i] + shift);
  }
}

TEST(SegmentPatch, FindsEveryPositionThatASegmentIsLaidThrough)
{
  Random random(511);
  for (const double factor : Factors())
  {
    for (const double warp : { 0.0, 1e-9, 1e-3, 0.4 })
    {
      for (int i = 0; i < 2000; ++i)
      {
        Vector3 patch[4];
        RandomPatch(random, warp, factor, patch);
        const double r = i % 5 == 0 ? random.Below(2) : random.In(0.0, 1.0);
        const double s = i % 7 == 0 ? random.Below(2) : random.In(0.0, 1.0);
        const Vector3 at = OnPatch(patch, r, s);
        const Vector3 along = factor * random.Direction<3>();
        const Vector3 ruling[2] = { OnPatch(patch, 1, s) - OnPatch(patch, 0, s),
          OnPatch(patch, r, 1) - OnPatch(patch, r, 0) };
        const Vector3 normal = skd::Cross(ruling[0], ruling[1]);
        const double slope = std::abs(skd::Dot(normal, along)) / (factor * factor * factor);
        if (slope < 0.05)
        {
          continue; // a tangent, nearly
        }
        const skd::PatchHits hits = Hits(patch, at - along, at + 2.0 * along);
        ASSERT_TRUE(Has(hits, 1.0 / 3.0, 1e-11)) << factor << " " << warp << " " << i;
      }
    }
  }
}

TEST(SegmentPatch, EachHitIsOnThePatch)
{
  Random random(512);
  for (int i = 0; i < 20000; ++i)
  {
    Vector3 patch[4];
    RandomPatch(random, 0.6, 1.0, patch);
    const Vector3 from = 2.0 * random.Direction<3>();
    const Vector3 to = from + 4.0 * random.Direction<3>();
    const skd::PatchHits hits = Hits(patch, from, to);
    for (int k = 0; k < hits.Count; ++k)
    {
      const Vector3 at = skd::Lerp(from, to, hits.T[k]);
      const double distance = std::sqrt(skd::ClosestPointOnPatch(patch, at).Dist2);
      ASSERT_LT(distance, 1e-7) << i;
    }
    ASSERT_TRUE(hits.Count < 2 || hits.T[0] <= hits.T[1]);
  }
}

TEST(SegmentPatch, ASaddleIsHitTwice)
{
  Random random(514);
  for (int i = 0; i < 5000; ++i)
  {
    const Vector3 saddle[4] = { { { 0, 0, 0 } }, { { 1, 0, 0.5 } }, { { 1, 1, 0 } },
      { { 0, 1, 0.5 } } };
    const Vector3 a = OnPatch(saddle, random.In(0.0, 0.4), random.In(0.0, 0.4));
    const Vector3 b = OnPatch(saddle, random.In(0.6, 1.0), random.In(0.6, 1.0));
    const skd::PatchHits hits = Hits(saddle, a - 0.5 * (b - a), b + 0.5 * (b - a));
    ASSERT_EQ(hits.Count, 2) << i;
    ASSERT_NEAR(hits.T[0], 0.25, 1e-11);
    ASSERT_NEAR(hits.T[1], 0.75, 1e-11);
  }
}

TEST(SegmentPatch, OfAFlatOneItIsWhatItsTrianglesSay)
{
  Random random(513);
  for (int i = 0; i < 20000; ++i)
  {
    const Vector3 u{ { 1, random.In(-0.5, 0.5), random.In(-0.5, 0.5) } };
    const Vector3 v{ { random.In(-0.5, 0.5), 1, random.In(-0.5, 0.5) } };
    const Vector3 patch[4] = { { { 0, 0, 0 } }, u, u + v, v };
    const Vector3 from = 2.0 * random.Direction<3>();
    const skd::SegmentView view(skd::Segment<3>{ from, from + 4.0 * random.Direction<3>() });
    const auto first = skd::Intersect(view, patch[0], patch[1], patch[2]);
    const auto second = skd::Intersect(view, patch[0], patch[2], patch[3]);
    const skd::PatchHits hits = skd::IntersectPatch(view, patch);
    ASSERT_EQ(hits.Count > 0, first || second) << i;
    if (hits.Count > 0)
    {
      ASSERT_NEAR(hits.T[0], first ? first->T : second->T, 1e-10);
    }
  }
}

TEST(SegmentPatch, CollapsedOnesAreTrianglesOrNothing)
{
  const Vector3 a{ { 0, 0, 0 } }, b{ { 1, 0, 0 } }, c{ { 0, 1, 0 } };
  const Vector3 from{ { 0.2, 0.2, -1 } }, to{ { 0.3, 0.2, 1 } };
  for (int turn = 0; turn < 4; ++turn)
  {
    const Vector3 corners[4] = { a, b, c, c };
    Vector3 patch[4];
    for (int i = 0; i < 4; ++i)
    {
      patch[i] = corners[(i + turn) % 4];
    }
    EXPECT_TRUE(Has(Hits(patch, from, to), 0.5, 1e-12)) << turn;
  }
  const Vector3 point[4] = { a, a, a, a };
  const Vector3 line[4] = { a, b, b, a };
  EXPECT_EQ(Hits(point, from, to).Count, 0);
  EXPECT_EQ(Hits(line, from, to).Count, 0);
  EXPECT_EQ(Hits(point, from, from).Count, 0);
}

}
