// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Volumes that convex polyhedra have in common: known ones, and parts that sum up to the whole.

#include "Core/Geometry/Overlap/SolidOverlap.h"
#include "CoreSolids.h"
#include "Dice.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{

using skd::SolidTopology;

struct Body
{
  std::vector<Vector3> Corners;
  const SolidTopology* Topology;

  skd::SolidView View() const { return { this->Corners.data(), this->Topology }; }

  template <class Place>
  Body Map(const Place& position) const
  {
    Body moved = *this;
    std::transform(moved.Corners.begin(), moved.Corners.end(), moved.Corners.begin(), position);
    return moved;
  }
};

Body Cube()
{
  return { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
             { { 1, 0, 1 } }, { { 1, 1, 1 } }, { { 0, 1, 1 } } },
    &SolidTopology::Hexahedron() };
}

/// With a positive volume.
Body Tetrahedron(std::vector<Vector3> p)
{
  if (Dot(p[1] - p[0], skd::Cross(p[2] - p[0], p[3] - p[0])) < 0.0)
  {
    std::swap(p[0], p[1]);
  }
  return { p, &SolidTopology::Tetrahedron() };
}

/// The six tetrahedra around a diagonal of a cube.
std::vector<Body> PartsOf(const Body& cube)
{
  static constexpr int around[7] = { 1, 2, 3, 7, 4, 5, 1 };
  std::vector<Body> parts;
  for (int i = 0; i < 6; ++i)
  {
    const auto& c = cube.Corners;
    parts.push_back(Tetrahedron({ c[0], c[around[i]], c[around[i + 1]], c[6] }));
  }
  return parts;
}

skd::Moments Common(const Body& one, const Body& other)
{
  skd::Moments moments;
  const Vector3& origin = one.Corners[0];
  skd::FindOverlap(origin, one.View(), other.View(),
    [&](const skd::ConvexSolid& solid, skd::ClipResult)
    { moments = solid.Moments().Moved(-1.0 * origin); });
  return moments;
}

auto TurnAbout(const Vector3& axis, double angle, const Vector3& centre)
{
  const Vector3 n = (1.0 / Norm(axis)) * axis;
  return [=](const Vector3& x)
  {
    const Vector3 p = x - centre;
    return centre + std::cos(angle) * p + std::sin(angle) * skd::Cross(n, p) +
      (1.0 - std::cos(angle)) * Dot(n, p) * n;
  };
}

const Vector3 Middle{ { 0.5, 0.5, 0.5 } };
const double HalfTurn = std::acos(-1.0);

TEST(OverlapSolids, KnownVolumes)
{
  const Body cube = Cube();
  const auto& c = cube.Corners;
  const Body one = Tetrahedron({ c[0], c[2], c[5], c[7] });
  const Body dual = Tetrahedron({ c[1], c[3], c[4], c[6] });
  EXPECT_NEAR(Common(one, dual).Measure, 1.0 / 6.0, 2e-16);
  const Body rotated = cube.Map(TurnAbout({ { 0, 0, 1 } }, HalfTurn / 4.0, Middle));
  EXPECT_NEAR(Common(cube, rotated).Measure, 0.828427124746190, 1e-15);
  EXPECT_NEAR(Common(rotated, cube).Measure, 0.828427124746190, 1e-15);
  const Body upright = cube.Map(TurnAbout({ { 1, 1, 1 } }, HalfTurn / 3.0, Middle));
  EXPECT_NEAR(Common(cube, upright).Measure, 0.75, 1e-15);
  EXPECT_NEAR(Norm(Common(cube, upright).First - 0.75 * Middle), 0.0, 1e-15);
  EXPECT_EQ(Common(cube, cube).Measure, 1.0);
}

TEST(OverlapSolids, TouchingIsExactlyNothing)
{
  for (const double factor : Factors())
  {
    for (const auto& angle : { 0.0, 0.3 })
    {
      const auto turn = TurnAbout({ { 1, 2, -3 } }, angle, Middle);
      const auto position = [&](const Vector3& x) { return factor * turn(x); };
      for (int i = 0; i < 27; ++i)
      {
        const Vector3 shift{ { i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0 } };
        const Body next = Cube().Map([&](const Vector3& x) { return position(x + shift); });
        const double measure = Common(Cube().Map(position), next).Measure;
        EXPECT_EQ(measure > 0.0, i == 13) << measure;
      }
    }
  }
}

/// Tetrahedra of any shape, slivers too, in the parts of a cube and in the whole.
TEST(OverlapSolids, PartsSumUp)
{
  Dice dice(7);
  for (const double factor : Factors())
  {
    for (int turn = 0; turn < 500; ++turn)
    {
      const double size = std::pow(10.0, -dice.Between(0.0, 4.0));
      const double flat = turn % 3 == 0 ? 1e-6 : 1.0;
      const Vector3 at = Middle + dice.Point(0.7);
      std::vector<Vector3> corners;
      for (int i = 0; i < 4; ++i)
      {
        const Vector3 x = dice.Point(size);
        corners.push_back(factor * (at + Vector3{ { x[0], x[1], flat * x[2] } }));
      }
      const Body body = Tetrahedron(corners);
      const Body cube = Cube().Map([&](const Vector3& x) { return factor * x; });
      const skd::Moments whole = Common(body, cube);
      skd::Moments sum;
      skd::Moments sumOfOthers;
      for (const Body& part : PartsOf(cube))
      {
        sum.Add(Common(body, part), 1.0);
        sumOfOthers.Add(Common(part, body), 1.0);
      }
      const double volume = std::pow(factor * size, 3);
      ASSERT_NEAR(sum.Measure / volume, whole.Measure / volume, 1e-14) << turn;
      ASSERT_NEAR(Norm(sum.First - whole.First) / (volume * factor), 0.0, 1e-14) << turn;
      ASSERT_NEAR(sumOfOthers.Measure / volume, whole.Measure / volume, 1e-14 / size) << turn;
    }
  }
}

/// A wedge and a hexahedron, sheared and far from the origin.
TEST(OverlapSolids, EitherMayBeCut)
{
  Dice dice(11);
  const Body prism{ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
                      { { 1, 0, 1 } }, { { 0, 1, 1 } } },
    &SolidTopology::Wedge() };
  double total = 0.0;
  for (int turn = 0; turn < 300; ++turn)
  {
    const auto spin = TurnAbout(dice.Point(1.0), dice.Between(0.0, 6.0), Middle);
    const Vector3 far{ { 0.0, turn % 2 * 0x1p20, 0.0 } };
    const Vector3 aside = dice.Point(0.5);
    const Body one = Cube().Map([&](const Vector3& x) { return x + far; });
    const Body other = prism.Map(
      [&](const Vector3& x) {
        return spin(x + Vector3{ { 0.4 * x[2], -0.2 * x[0], 0.0 } }) + aside + far;
      });
    const double measure = Common(one, other).Measure;
    ASSERT_NEAR(measure, Common(other, one).Measure, turn % 2 ? 1e-9 : 2e-15);
    total += measure;
  }
  EXPECT_GT(total, 20.0);
}

TEST(OverlapSolids, APyramidIsNotSimple)
{
  const SolidTopology pyramid(
    5, { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } });
  EXPECT_FALSE(pyramid.IsSimple());
  EXPECT_TRUE(SolidTopology::Wedge().IsSimple());
}

}
