// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Search/Queries/MonotonePatches.h"
#include "TriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{
using skd::Box3;
using BoxList = std::vector<Box3>;

struct Scene
{
  int Count;
  double Size; ///< of the largest box, where all are in a unit cube
  double Shift = 0.0;
  double Scale = 1.0;
  bool IsFlat = false;
};

BoxList MakeBoxes(const Scene& scene, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  BoxList boxes(static_cast<std::size_t>(scene.Count));
  for (Box3& box : boxes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isThin = scene.IsFlat && axis == 1;
      const double low = isThin ? 0.5 : unit(random);
      const double length = isThin ? 0.0 : scene.Size * unit(random);
      box.Min[axis] = scene.Scale * (scene.Shift + low);
      box.Max[axis] = scene.Scale * (scene.Shift + low + length);
    }
  }
  return boxes;
}

/// What overlaps is visited, nothing twice, and nothing that is farther away than `excess`.
void ExpectRight(const BoxList& boxes, const BoxList& asked, double excess)
{
  const skd::PackedRTree tree(boxes);
  for (const Box3& box : asked)
  {
    std::vector<int> visits(boxes.size(), 0);
    tree.ForEachOverlapping(box, [&](std::uint32_t i) { ++visits.at(i); });
    const Box3 around = box.Inflated(excess);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      ASSERT_LE(visits[i], around.Overlaps(boxes[i]) ? 1 : 0) << i;
      ASSERT_GE(visits[i], box.Overlaps(boxes[i]) ? 1 : 0) << i;
    }
  }
}

/// Each pair that overlaps is visited, nothing twice, and none that is farther apart than `excess`.
void ExpectRightPairs(const BoxList& boxes, double excess)
{
  const skd::PackedRTree tree(boxes);
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  skd::PackedRTree::OverlapLists lists;
  for (std::size_t packet = 0; packet < tree.GetNumberOfPackets(); ++packet)
  {
    EXPECT_TRUE(tree.ForEachOverlapWithin(packet, lists,
      [&](std::uint32_t i, const std::vector<std::uint32_t>& others)
      {
        for (const std::uint32_t k : others)
        {
          EXPECT_TRUE(pairs.insert(std::minmax(i, k)).second) << i << " " << k;
          EXPECT_TRUE(boxes[i].Inflated(excess).Overlaps(boxes[k])) << i << " " << k;
        }
        return true;
      }));
  }
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
  {
    for (std::uint32_t k = i + 1; k < boxes.size(); ++k)
    {
      ASSERT_GE(pairs.count({ i, k }), boxes[i].Overlaps(boxes[k]) ? 1u : 0u) << i << " " << k;
    }
    ASSERT_EQ(pairs.count({ i, i }), 0u) << i;
  }
}

void ExpectRight(const Scene& scene)
{
  const BoxList boxes = MakeBoxes(scene, 3);
  const double steps = 4.0 / 16000.0; // of the lattice, and its rounding
  ExpectRight(boxes, MakeBoxes({ 300, 0.3, scene.Shift, scene.Scale, scene.IsFlat }, 5),
    steps * scene.Scale * (1.0 + scene.Size));
  const BoxList few(boxes.begin(), boxes.begin() + std::min<std::ptrdiff_t>(700, scene.Count));
  ExpectRightPairs(few, 2.0 * steps * scene.Scale * (1.0 + scene.Size));
}
}

//------------------------------------------------------------------------------
TEST(PackedRTree, AllThatOverlapAreVisitedOnce)
{
  for (const int count : { 1, 7, 8, 9, 64, 65, 700, 5000 })
  {
    ExpectRight({ count, 0.05 });
    ExpectRight({ count, 0.0 });
    ExpectRight({ count, 1.0 });
  }
}

//------------------------------------------------------------------------------
TEST(PackedRTree, FlatFarTinyAndHugeOnesAreToo)
{
  ExpectRight({ 500, 0.05, 0.0, 1.0, true });
  ExpectRight({ 500, 0.05, 1e6 });
  ExpectRight({ 500, 0.05, -1e12 });
  ExpectRight({ 500, 0.05, 0.0, 1e-300 });
  ExpectRight({ 500, 0.05, 0.0, 1e300 });
}

//------------------------------------------------------------------------------
TEST(PackedRTree, BoxesThatTouchOverlap)
{
  BoxList boxes;
  for (int i = 0; i < 100; ++i)
  {
    boxes.push_back({ { { 0.1 * i, 0.0, 0.0 } }, { { 0.1 * (i + 1), 1.0, 1.0 } } });
  }
  ExpectRight(boxes, boxes, 0.005);
}

//------------------------------------------------------------------------------
TEST(PackedRTree, EqualOnesAreAllVisited)
{
  const Box3 box({ { 1.0, 2.0, 3.0 } }, { { 1.5, 2.0, 3.0 } });
  ExpectRight(BoxList(77, box), { box }, 0.0);
  ExpectRightPairs(BoxList(77, box), 0.0);
  const Box3 point({ { 1.0, 2.0, 3.0 } }, { { 1.0, 2.0, 3.0 } });
  ExpectRight(BoxList(77, point), { box, point }, 0.0);
}

//------------------------------------------------------------------------------
TEST(PackedRTree, WhatIsFarAwayVisitsNone)
{
  const skd::PackedRTree tree(MakeBoxes({ 300, 0.05 }, 3));
  for (const double x : { -1e300, -1e30, -3.0, 3.0, 1e30, 1e300 })
  {
    const Box3 far({ { x, x, x } }, { { x, x, x } });
    tree.ForEachOverlapping(far, [](std::uint32_t) { FAIL(); });
  }
}

//------------------------------------------------------------------------------
TEST(PackedRTree, PairsEndWhenNoMoreAreWanted)
{
  const skd::PackedRTree tree(MakeBoxes({ 100, 1.0 }, 3));
  int visits = 0;
  skd::PackedRTree::OverlapLists lists;
  EXPECT_FALSE(tree.ForEachOverlapWithin(
    0, lists, [&](std::uint32_t, const std::vector<std::uint32_t>&) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

//------------------------------------------------------------------------------
TEST(PackedRTree, KeysOfARadixSortAscend)
{
  std::mt19937 random(4);
  for (const std::size_t count : { 0, 1, 255, 256, 70000 })
  {
    for (const std::uint32_t most : { 1u, 1000u, 0x3fffffffu })
    {
      std::uniform_int_distribution<std::uint32_t> key(0, most);
      std::vector<std::uint64_t> keys(count);
      for (std::size_t i = 0; i < count; ++i)
      {
        keys[i] = static_cast<std::uint64_t>(key(random)) << 32 | i;
      }
      std::vector<std::uint64_t> sorted = keys;
      std::sort(sorted.begin(), sorted.end());
      skd::SortByHighWord(keys);
      EXPECT_EQ(keys, sorted);
    }
  }
}

//------------------------------------------------------------------------------
TEST(PackedRTree, OfNoneThereIsNone)
{
  const skd::PackedRTree tree{ BoxList() };
  EXPECT_EQ(tree.GetNumberOfPackets(), 0u);
  tree.ForEachOverlapping(
    { { { 0.0, 0.0, 0.0 } }, { { 1.0, 1.0, 1.0 } } }, [](std::uint32_t) { FAIL(); });
}

//------------------------------------------------------------------------------
// Parts of surfaces that are found by it.
namespace
{
using skd::Vector3;
using Mesh = skdtest::TriangleMesh;
using Corners = Mesh::Corners;
using skdtest::HaveMoreInCommon;

/// The triangles that are certified, each of which must have nothing in common with any but shared
/// corners.
std::size_t CountCertified(const Mesh& mesh)
{
  std::vector<skd::Box3> boxes(mesh.Triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (const Vector3& corner : mesh.At(i))
    {
      boxes[i].Add(corner);
    }
  }
  const skd::PackedRTree tree(boxes);
  const skd::MonotonePatches patches(
    tree, boxes.size(), mesh.Points,
    [&mesh](std::uint32_t i) -> const Corners& { return mesh.Triangles[i]; },
    [](std::size_t n, const auto& body)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        body(i);
      }
    });
  std::size_t certified = 0;
  for (std::size_t at = 0; at < boxes.size(); ++at)
  {
    const std::uint32_t i = tree.GetBoxOf(at / 8, static_cast<int>(at % 8));
    if (!patches.Has(at / 8))
    {
      continue;
    }
    ++certified;
    for (std::size_t k = 0; k < boxes.size(); ++k)
    {
      if (k != i && boxes[i].Overlaps(boxes[k]))
      {
        EXPECT_FALSE(HaveMoreInCommon(mesh, i, k)) << i << " " << k;
      }
    }
  }
  return certified;
}

/// A grid of (u, v) in [0, 1]^2, two triangles for each of its squares.
template <class ToSpace>
Mesh MakeGrid(std::uint32_t n, const ToSpace& toSpace)
{
  Mesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i)
  {
    for (std::uint32_t k = 0; k <= n; ++k)
    {
      mesh.Points.push_back(toSpace(double(i) / n, double(k) / n));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    for (std::uint32_t k = 0; k < n; ++k)
    {
      const std::uint32_t a = i * (n + 1) + k;
      const std::uint32_t b = a + n + 1;
      mesh.Triangles.push_back({ a, b, b + 1 });
      mesh.Triangles.push_back({ a, b + 1, a + 1 });
    }
  }
  return mesh;
}

Mesh MakeSheet(std::uint32_t n, double height, double slope)
{
  return MakeGrid(n,
    [&](double u, double v) {
      return Vector3{ { u, v, height + slope * u + 0.02 * std::sin(7.0 * u) * std::cos(5.0 * v) } };
    });
}

/// A closed surface: a cube's six grids, as seen from the middle of a ball.
Mesh MakeBall(std::uint32_t n)
{
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  Mesh ball;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const Mesh grid = MakeGrid(n,
      [&](double u, double v)
      {
        Vector3 x;
        x[axis] = face % 2 == 0 ? 1.0 : -1.0;
        x[(axis + 1) % 3] = face % 2 == 0 ? 2.0 * u - 1.0 : 2.0 * v - 1.0;
        x[(axis + 2) % 3] = face % 2 == 0 ? 2.0 * v - 1.0 : 2.0 * u - 1.0;
        return x;
      });
    for (const Corners& corners : grid.Triangles)
    {
      Corners welded;
      for (int i = 0; i < 3; ++i)
      {
        const Vector3& x = grid.Points[corners[i]];
        const auto count = static_cast<std::uint32_t>(numbers.size());
        welded[i] = numbers.try_emplace({ x[0], x[1], x[2] }, count).first->second;
        if (welded[i] == ball.Points.size())
        {
          ball.Points.push_back((1.0 / Norm(x)) * x);
        }
      }
      ball.Triangles.push_back(welded);
    }
  }
  return ball;
}

Mesh Moved(Mesh mesh, const Vector3& by)
{
  for (Vector3& point : mesh.Points)
  {
    point = point + by;
  }
  return mesh;
}

/// Triangles around a point, over a link whose points go round `turns` times.
Mesh MakeStar(std::uint32_t n, double turns, std::mt19937& random, double noise)
{
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Mesh mesh;
  mesh.Points.push_back({ { noise * unit(random), noise * unit(random), 0.0 } });
  for (std::uint32_t i = 0; i < n; ++i)
  {
    const double angle = 2.0 * 3.141592653589793 * turns * i / n;
    const double radius = 1.0 + noise * unit(random);
    mesh.Points.push_back(
      { { radius * std::cos(angle), radius * std::sin(angle), noise * unit(random) } });
  }
  for (std::uint32_t i = 0; i < n; ++i)
  {
    mesh.Triangles.push_back({ 0, 1 + i, 1 + (i + 1) % n });
  }
  return mesh;
}

/// Each triangle in four, and these again: an open surface so has patches inside.
Mesh Refined(const Mesh& coarse, int times)
{
  if (times == 0)
  {
    return coarse;
  }
  Mesh fine;
  fine.Points = coarse.Points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middleOf = [&](std::uint32_t a, std::uint32_t b)
  {
    const auto count = static_cast<std::uint32_t>(fine.Points.size());
    const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), count);
    if (isNew)
    {
      fine.Points.push_back(0.5 * (coarse.Points[a] + coarse.Points[b]));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : coarse.Triangles)
  {
    const std::uint32_t ab = middleOf(a, b);
    const std::uint32_t bc = middleOf(b, c);
    const std::uint32_t ca = middleOf(c, a);
    fine.Triangles.insert(
      fine.Triangles.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
  }
  return Refined(fine, times - 1);
}
}

//------------------------------------------------------------------------------
TEST(MonotonePatches, MostOfSmoothSurfacesIsFound)
{
  const Mesh ball = MakeBall(24);
  EXPECT_GT(CountCertified(ball), 3 * ball.Triangles.size() / 4);
  const Mesh sheet = MakeSheet(40, 0.0, 0.3);
  EXPECT_GT(CountCertified(sheet), sheet.Triangles.size() / 2); // but along its border
}

TEST(MonotonePatches, WhereSurfacesCrossNoneIsFound)
{
  Mesh balls = MakeBall(20);
  balls.Add(Moved(balls, { { 0.7, 0.11, 0.05 } }));
  const std::size_t certified = CountCertified(balls);
  EXPECT_GT(certified, balls.Triangles.size() / 4);
  EXPECT_LT(certified, balls.Triangles.size());
  Mesh sheets = MakeSheet(30, 0.0, 0.3);
  sheets.Add(MakeSheet(30, 0.1, 0.05));
  EXPECT_GT(CountCertified(sheets), 0u);
  Mesh near = MakeSheet(30, 0.0, 0.3);
  near.Add(MakeSheet(30, 1e-9, 0.3));
  CountCertified(near);
}

TEST(MonotonePatches, CoincidentSurfacesAreNot)
{
  const Mesh ball = MakeBall(12);
  Mesh twice = ball; // with points of its own
  twice.Add(ball);
  EXPECT_EQ(CountCertified(twice), 0u);
  Mesh again = ball; // with the same points
  again.Triangles.insert(again.Triangles.end(), ball.Triangles.begin(), ball.Triangles.end());
  EXPECT_EQ(CountCertified(again), 0u);
  Mesh turned = ball;
  for (const auto& [a, b, c] : ball.Triangles)
  {
    turned.Triangles.push_back({ a, c, b });
  }
  EXPECT_EQ(CountCertified(turned), 0u);
}

TEST(MonotonePatches, StarsThatGoRoundMoreThanOnceAreNot)
{
  std::mt19937 random(7);
  for (const double turns : { 1.0, 2.0, 3.0 })
  {
    const Mesh star = Refined(MakeStar(13, turns, random, 0.0), 3);
    const std::size_t certified = CountCertified(star);
    EXPECT_EQ(certified > 0, turns == 1.0) << turns;
  }
}

TEST(MonotonePatches, RandomStarsAreRight)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<std::uint32_t> number(9, 14);
  for (int i = 0; i < 40; ++i)
  {
    const double noise = 0.3 * (i % 6);
    Mesh star = Refined(MakeStar(number(random), 1.0 + i % 2, random, noise), 3);
    CountCertified(star);
    star.Triangles.push_back({ 0, 1, 2 }); // one edge more
    CountCertified(star);
  }
}

TEST(MonotonePatches, FoldsAreRight)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 40; ++i)
  {
    const double noise = std::pow(10.0, -0.15 * i);
    const Mesh sheet = MakeGrid(16,
      [&](double u, double v)
      {
        return Vector3{ { u + 0.1 * noise * unit(random), v + 0.1 * noise * unit(random),
          0.3 * u + 0.1 * noise * unit(random) } };
      });
    CountCertified(sheet);
    Mesh lattice = sheet; // flat, folded, with points that coincide and triangles without area
    for (Vector3& point : lattice.Points)
    {
      point = { { std::round(24.0 * point[0]), std::round(24.0 * point[1]), 0.0 } };
    }
    CountCertified(lattice);
  }
}

TEST(MonotonePatches, SoupsAreRight)
{
  std::mt19937 random(17);
  for (int i = 0; i < 30; ++i)
  {
    std::uniform_int_distribution<std::uint32_t> corner(0, 9 + 2 * static_cast<std::uint32_t>(i));
    std::uniform_int_distribution<int> lattice(0, 3);
    Mesh soup;
    for (std::uint32_t k = 0; k <= corner.max(); ++k)
    {
      soup.Points.push_back({ { 1.0 * lattice(random), 1.0 * lattice(random), 0.1 * k } });
    }
    for (int k = 0; k < 600; ++k)
    {
      soup.Triangles.push_back({ corner(random), corner(random), corner(random) });
    }
    CountCertified(soup);
  }
}
