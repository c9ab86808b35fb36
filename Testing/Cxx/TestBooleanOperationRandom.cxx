// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: random pairs of random solids, and operations on results.
//
// SKDTREE_FUZZ_PAIRS in the environment sets how many pairs are tried, SKDTREE_FUZZ_FIRST which is
// the first; a failure names its pair.

#include "Support/ClosedSurface.h"
#include "Support/SolidRun.h"

#include "vtkSMPTools.h"

using namespace skdtest;

namespace
{
struct Pair
{
  Mesh Solids[2];
  std::string What;
};

/// Both are turned, scaled or moved far away, but for tiny ones, whose corners would become one.
void MoveBoth(Random& random, Pair& pair, bool isTiny)
{
  const int any = random.Index(8);
  const int direction = any == 3 && isTiny ? 0 : any;
  const RandomRotation rotation(random, false);
  for (Mesh& solid : pair.Solids)
  {
    if (direction == 0)
    {
      solid.Map(rotation);
    }
    else if (direction < 4)
    {
      solid = Transformed(std::move(solid),
        direction == 1     ? 1e-6
          : direction == 2 ? 1e6
                           : 1.0,
        direction == 3 ? Point{ 1e6, -1e6, 1e6 } : Point{ 0, 0, 0 });
    }
  }
  const char* names[] = { ", both turned", ", both times 1e-6", ", both times 1e6",
    ", both moved by 1e6" };
  pair.What += direction < 4 ? names[direction] : "";
}

/// Turned by next to nothing: faces nearly coincide, and meet at any angle down to rounding.
Mesh Nudged(Random& random, Mesh solid, std::string& what)
{
  const double angle = std::pow(10.0, -1.0 - random.Index(16));
  const Point axis = random.Direction();
  what += ", turned by " + std::to_string(angle);
  return solid.Map([&](const Point& p) { return p + angle * Cross(axis, p); });
}

Pair MakePair(Random& random)
{
  Pair pair;
  pair.Solids[0] = AnySolid(random, pair.What);
  pair.What += " and ";
  const bool isSame = random.Index(6) == 0;
  pair.Solids[1] = isSame ? pair.Solids[0] : AnySolid(random, pair.What);
  pair.What += isSame ? "itself" : "";
  const double sizes[] = { 0.25, 1e-6 };
  const int smaller = random.Index(16);
  if (smaller < 2)
  {
    pair.Solids[1] = Transformed(std::move(pair.Solids[1]), sizes[smaller], { 0, 0, 0 });
    pair.What += ", smaller";
  }
  if (isSame && random.Index(2) == 0)
  {
    pair.Solids[1] = Nudged(random, std::move(pair.Solids[1]), pair.What);
    return pair;
  }
  pair.Solids[1] = MovedAnywhere(random, std::move(pair.Solids[1]), pair.What);
  MoveBoth(random, pair, smaller == 1);
  return pair;
}

void TryPair(int number)
{
  Random random(static_cast<std::uint64_t>(number));
  const Pair pair = MakePair(random);
  SCOPED_TRACE("pair " + std::to_string(number) + ": " + pair.What);
  const Mesh& a = pair.Solids[0];
  const Mesh& b = pair.Solids[1];
  double volume[5];
  for (int operation = 0; operation < 5; ++operation)
  {
    SCOPED_TRACE(operation);
    const Mesh result = Combine(a, b, operation);
    volume[operation] = Measures(result).Volume;
    ExpectSolid(random, { &a, &b }, Combined(operation, InsideTestOf(a), InsideTestOf(b)), result);
  }
  const Measures ofA(a), ofB(b);
  const double bound = 1e-13 * (ofA.Volume + ofB.Volume) + ofA.Rounding + ofB.Rounding;
  EXPECT_NEAR(volume[0] + volume[1], ofA.Volume + ofB.Volume, bound);
  EXPECT_NEAR(volume[2] + volume[1], ofA.Volume, bound);
  EXPECT_NEAR(volume[3] + volume[1], ofB.Volume, bound);
  EXPECT_NEAR(volume[4], volume[2] + volume[3], bound);
}

bool AreSame(const Mesh& a, const Mesh& b)
{
  return a.Points == b.Points &&
    std::equal(a.Cells.begin(), a.Cells.end(), b.Cells.begin(), b.Cells.end(),
      [](const CellSpec& l, const CellSpec& r) { return l.Points == r.Points; });
}

/// A solid that operations have made, by the solids and operations that it is of.
struct MadeSolid
{
  Mesh Surface;
  InsideTest IsInside;
};

MadeSolid MakeLeaf(Random& random, std::string& what)
{
  what += "; ";
  const Mesh solid = MovedAnywhere(random, AnySolid(random, what), what);
  return { solid, InsideTestOf(solid) };
}

int CountFailures()
{
  return testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

void TryTree(int number)
{
  const int before = CountFailures();
  Random random(1000000u + static_cast<std::uint64_t>(number));
  std::string what;
  MadeSolid made = MakeLeaf(random, what);
  for (int step = 0; step < 10; ++step)
  {
    MadeSolid other = MakeLeaf(random, what);
    const int operation =
      random.Index(8) == 0 ? 1 : std::array<int, 4>{ 0, 2, 3, 4 }[random.Index(4)];
    what += ", operation " + std::to_string(operation);
    SCOPED_TRACE("tree " + std::to_string(number) + ": " + what);
    const Measures ofA(made.Surface), ofB(other.Surface);
    const Mesh common = Combine(made.Surface, other.Surface, 1);
    MadeSolid next;
    next.Surface = Combine(made.Surface, other.Surface, operation);
    next.IsInside = Combined(operation, made.IsInside, other.IsInside);
    ExpectSolid(random, { &made.Surface, &other.Surface }, next.IsInside, next.Surface);
    ExpectClosed(MakePolyData(next.Surface));
    const double shared = Measures(common).Volume;
    const double expected[] = { ofA.Volume + ofB.Volume - shared, shared, ofA.Volume - shared,
      ofB.Volume - shared, ofA.Volume + ofB.Volume - 2.0 * shared };
    EXPECT_NEAR(Measures(next.Surface).Volume, expected[operation],
      1e-13 * (ofA.Volume + ofB.Volume) + ofA.Rounding + ofB.Rounding);
    if (CountFailures() > before || next.Surface.Cells.empty())
    {
      return;
    }
    made = std::move(next);
  }
}

TEST(BooleanOperationRandom, Pairs)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40);
  for (int number = first; number < first + count; ++number)
  {
    TryPair(number);
  }
}

/// Faces that are cut share edges with faces that are not, in pairs that face each other.
TEST(BooleanOperationRandom, PairWithEdgesOfFourFaces)
{
  TryPair(1103);
}

TEST(BooleanOperationRandom, TreesOfTenOperations)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = std::max(2, SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 20);
  for (int number = first; number < first + count; ++number)
  {
    TryTree(number);
  }
}

/// Turned by right angles, faces that should be one leave a sliver of four units in the last place.
TEST(BooleanOperationRandom, TreeWithASliver)
{
  TryTree(200058);
}

TEST(BooleanOperationRandom, SameByAnyNumberOfThreads)
{
  for (int number = 0; number < SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 4; ++number)
  {
    Random random(static_cast<std::uint64_t>(number));
    const Pair pair = MakePair(random);
    const int operation = number % 5;
    Mesh one, two;
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ 1 }, [&] { one = Combine(pair.Solids[0], pair.Solids[1], operation); });
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ 2 }, [&] { two = Combine(pair.Solids[0], pair.Solids[1], operation); });
    EXPECT_TRUE(AreSame(one, two)) << number << ": " << pair.What;
  }
}
}
