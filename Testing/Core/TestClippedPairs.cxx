// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/ClippedPairs.h"
#include "TriangleMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace
{
using skd::Vector3;
using Mesh = skdtest::TriangleMesh;
using Corners = Mesh::Corners;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::set<Pair> FindCandidates(const Mesh& mesh)
{
  const auto cornersOf = [&mesh](std::uint32_t i) -> const Corners& { return mesh.Triangles[i]; };
  const skd::ClippedPairs<std::vector<Vector3>, decltype(cornersOf)> pairs(
    mesh.Points, mesh.Triangles.size(), cornersOf);
  std::set<Pair> candidates;
  for (std::size_t part = 0; part < pairs.size(); ++part)
  {
    EXPECT_TRUE(pairs.VisitPart(part,
      [&](std::uint32_t first, const std::vector<std::uint32_t>& others)
      {
        for (const std::uint32_t other : others)
        {
          EXPECT_LT(first, other);
          candidates.emplace(first, other);
        }
        return true;
      }));
  }
  return candidates;
}

/// Each pair that has more in common than corners must be a candidate. Returns how many of these
/// there are for a triangle.
double ExpectAllFound(const Mesh& mesh)
{
  const std::set<Pair> candidates = FindCandidates(mesh);
  for (std::uint32_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    for (std::uint32_t k = i + 1; k < mesh.Triangles.size(); ++k)
    {
      if (candidates.count({ i, k }) == 0)
      {
        EXPECT_FALSE(skdtest::HaveMoreInCommon(mesh, i, k)) << i << " " << k;
      }
    }
  }
  return double(candidates.size()) / double(mesh.Triangles.size());
}

/// A fan around a tip, closed; the curve across from the tip goes around some times.
template <class ToSpace>
void AddFan(Mesh& mesh, std::uint32_t n, const Vector3& tip, double turns, const ToSpace& toSpace)
{
  const auto first = static_cast<std::uint32_t>(mesh.Points.size());
  mesh.Points.push_back(tip);
  for (std::uint32_t i = 0; i < n; ++i)
  {
    mesh.Points.push_back(toSpace(turns * 2.0 * 3.14159265358979323846 * i / n));
    mesh.Triangles.push_back({ first, first + 1 + i, first + 1 + (i + 1) % n });
  }
}

Vector3 OnCircle(double angle)
{
  return { { std::cos(angle), std::sin(angle), 0.1 * std::cos(3.0 * angle) } };
}

Mesh MakeTwoFans(std::uint32_t n, double shift)
{
  Mesh mesh;
  AddFan(mesh, n, { { 0.1, 0.05, 1.0 } }, 1.0, OnCircle);
  AddFan(mesh, n, { { 0.1 + shift, 0.05, 1.0 - shift } }, 1.0,
    [](double angle)
    {
      const Vector3 x = OnCircle(angle);
      return Vector3{ { x[0] + 0.2 * x[1], x[1], 0.3 * x[0] - 0.2 * x[2] } };
    });
  return mesh;
}
}

//------------------------------------------------------------------------------
TEST(ClippedPairs, FansHaveFewCandidates)
{
  for (const double shift : { 0.3, 0.1 })
  {
    EXPECT_LT(ExpectAllFound(MakeTwoFans(300, shift)), 40.0);
  }
  // All boxes overlap at the tips. What is left grows as the triangles do.
  const auto count = [](std::uint32_t n)
  { return double(FindCandidates(MakeTwoFans(n, 0.3)).size()); };
  EXPECT_LT(count(4000), 3.0 * count(2000));
}

//------------------------------------------------------------------------------
TEST(ClippedPairs, FansThatCrossThemselvesAreFound)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const double turns : { 1.0, 2.0, 0.5, 0.0, 7.0 })
  {
    for (const double noise : { 0.0, 0.02, 1.0 })
    {
      Mesh mesh;
      AddFan(mesh, 200, { { 0.0, 0.1, 1.0 } }, turns,
        [&](double angle)
        {
          return Vector3{ { std::cos(angle) + noise * unit(random),
            std::sin(2.0 * angle) + noise * unit(random), noise * unit(random) } };
        });
      ExpectAllFound(mesh);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ClippedPairs, FlatFansOnALatticeAreFound)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> lattice(-2, 2);
  for (int i = 0; i < 8; ++i)
  {
    Mesh mesh; // fans with one or two hubs, points that coincide, triangles without an area
    for (int k = 0; k < 40; ++k)
    {
      mesh.Points.push_back(
        { { 1.0 * lattice(random), 1.0 * lattice(random), 0.25 * (i % 3) * lattice(random) } });
    }
    std::uniform_int_distribution<std::uint32_t> corner(0, 39);
    for (int k = 0; k < 300; ++k)
    {
      mesh.Triangles.push_back(
        { static_cast<std::uint32_t>(k % 2), corner(random), corner(random) });
    }
    ExpectAllFound(mesh);
  }
}

//------------------------------------------------------------------------------
TEST(ClippedPairs, NeedlesHaveFewCandidates)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const double scale : { 1.0, 1e-30, 1e30 })
  {
    Mesh mesh;
    for (std::uint32_t i = 0; i < 1500; ++i)
    {
      const auto draw = [&] {
        return Vector3{ { normal(random), normal(random), normal(random) } };
      };
      const Vector3 from = draw();
      const Vector3 to = draw();
      for (const Vector3& x : { from, to, to + 0.01 * draw() })
      {
        mesh.Points.push_back(scale * x);
      }
      mesh.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    }
    EXPECT_LT(ExpectAllFound(mesh), 60.0); // boxes overlap several hundred others
  }
}

//------------------------------------------------------------------------------
TEST(ClippedPairs, EqualTrianglesAreAllFound)
{
  Mesh mesh;
  mesh.Points = { { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.2, 0.3 } }, { { 0.1, 1.0, 0.7 } } };
  mesh.Triangles.assign(300, { 0, 1, 2 });
  EXPECT_EQ(FindCandidates(mesh).size(), 300u * 299u / 2u);
  mesh.Triangles.assign(300, { 1, 1, 1 }); // of no extent
  EXPECT_EQ(FindCandidates(mesh).size(), 300u * 299u / 2u);
  EXPECT_TRUE(FindCandidates(Mesh()).empty());
}

//------------------------------------------------------------------------------
TEST(ClippedPairs, EndsWhenNoMoreAreWanted)
{
  const Mesh mesh = MakeTwoFans(300, 0.3);
  const auto cornersOf = [&mesh](std::uint32_t i) -> const Corners& { return mesh.Triangles[i]; };
  const skd::ClippedPairs<std::vector<Vector3>, decltype(cornersOf)> pairs(
    mesh.Points, mesh.Triangles.size(), cornersOf);
  int visits = 0;
  bool goesOn = true;
  for (std::size_t part = 0; part < pairs.size() && goesOn; ++part)
  {
    goesOn = pairs.VisitPart(
      part, [&](std::uint32_t, const std::vector<std::uint32_t>&) { return ++visits < 3; });
  }
  EXPECT_FALSE(goesOn);
  EXPECT_EQ(visits, 3);
}
