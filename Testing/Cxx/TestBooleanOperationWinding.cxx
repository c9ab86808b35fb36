// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: random inputs that intersect themselves, have faces twice or solids
// inside out: inside is what the rule makes of the winding number. Also cuts by a plane that is
// open, and places in at least k solids.
//
// SKDTREE_FUZZ_PAIRS and SKDTREE_FUZZ_FIRST as in TestBooleanOperationRandom.cxx.

#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkMultiBlockDataSet.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

/// One to four solids anywhere, as one surface; some are inside out, or there twice.
Mesh AnyOverlaps(Random& random, std::string& what)
{
  Mesh mesh;
  const int count = 1 + random.Index(4);
  for (int i = 0; i < count; ++i)
  {
    what += i > 0 ? " + " : "";
    const Mesh solid = MovedAnywhere(random, AnySolid(random, what), what);
    const bool isTurned = random.Index(4) == 0;
    what += isTurned ? ", inside out" : "";
    Append(mesh, isTurned ? Inverted(solid) : solid);
    if (random.Index(6) == 0)
    {
      what += ", twice";
      Append(mesh, solid);
    }
  }
  return mesh;
}

/// All operations are right, and their volumes add up.
void CheckOperations(Random& random, const Mesh& a, const Mesh& b, int rule)
{
  const InsideTest inA = InsideTestOf(a, rule);
  const InsideTest inB = InsideTestOf(b, rule);
  double volume[5];
  for (int operation = 0; operation < 5; ++operation)
  {
    SCOPED_TRACE(operation);
    const Mesh result = Combine(a, b, operation, rule);
    volume[operation] = Measures(result).Volume;
    ExpectSolid(random, { &a, &b }, Combined(operation, inA, inB), result);
  }
  const double bound = 1e-13 * (1.0 + volume[0] + volume[1]) + Measures(a).Rounding;
  EXPECT_NEAR(volume[0], volume[1] + volume[2] + volume[3], bound);
  EXPECT_NEAR(volume[4], volume[2] + volume[3], bound);
}

void TryPair(int number)
{
  Random random(2000000u + static_cast<std::uint64_t>(number));
  std::string what;
  const Mesh a = AnyOverlaps(random, what);
  what += " and ";
  const Mesh b = AnyOverlaps(random, what);
  const int rule = random.Index(3);
  SCOPED_TRACE("pair " + std::to_string(number) + ", rule " + std::to_string(rule) + ": " + what);
  CheckOperations(random, a, b, rule);
}

/// Three to six solids, as blocks of one input.
void TryMany(int number)
{
  Random random(3000000u + static_cast<std::uint64_t>(number));
  std::string what;
  std::vector<Mesh> solids(3 + random.Index(4));
  std::vector<const Mesh*> all;
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (Mesh& solid : solids)
  {
    what += "; ";
    solid = MovedAnywhere(random, AnySolid(random, what), what);
    all.push_back(&solid);
    blocks->SetBlock(blocks->GetNumberOfBlocks(), MakePolyData(solid));
  }
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, blocks);
  filter->SetOperationToAtLeast();
  for (int least = 1; least <= 3; ++least)
  {
    SCOPED_TRACE(std::to_string(least) + " of " + std::to_string(number) + what);
    filter->SetMinimumNumberOfSolids(least);
    const auto isInside = [&](const Point& x) -> std::optional<bool>
    {
      int in = 0;
      for (const Mesh& solid : solids)
      {
        const std::optional<long> winding = WindingAt(solid, x);
        if (!winding)
        {
          return std::nullopt;
        }
        in += *winding != 0;
      }
      return in >= least;
    };
    ExpectSolid(random, all, isInside, RunSolid(filter));
  }
}

/// A solid cut by a plane that is larger: both sides are closed, and together the whole.
void TryCut(int number)
{
  Random random(4000000u + static_cast<std::uint64_t>(number));
  std::string what;
  Mesh solid = MovedAnywhere(random, AnySolid(random, what), what);
  const double height = random.Index(2) ? 0.25 * (random.Index(7) - 3) : random.Between(-1.0, 1.0);
  Mesh plane = Transformed(Sheet(1 + random.Index(4), VTK_TRIANGLE), 8.0, { -4, -4, height });
  if (random.Index(2) == 0)
  {
    const RandomRotation rotation(random, random.Index(2) == 0);
    solid.Map(rotation);
    plane.Map(rotation);
  }
  const Point& a = plane.Points[plane.Cells[0].Points[0]];
  const Point normal =
    Cross(plane.Points[plane.Cells[0].Points[1]] - a, plane.Points[plane.Cells[0].Points[2]] - a);
  SCOPED_TRACE("cut " + std::to_string(number) + " at " + std::to_string(height) + ": " + what);
  double sum = 0.0;
  for (const int operation : { Filter::INTERSECTION, Filter::DIFFERENCE })
  {
    const auto isInside = [&](const Point& x) -> std::optional<bool>
    {
      const std::optional<long> winding = WindingAt(solid, x);
      const double above = Dot(normal, x - a) / Length(normal);
      const bool isSure = winding && std::abs(above) > 1e-9;
      const bool isOnSide = (above < 0.0) == (operation == Filter::INTERSECTION);
      return isSure ? std::optional<bool>(*winding != 0 && isOnSide) : std::nullopt;
    };
    const Mesh part = Combine(solid, plane, operation);
    ExpectSolid(random, { &solid }, isInside, part);
    sum += Measures(part).Volume;
  }
  const Measures whole(solid);
  EXPECT_NEAR(sum, whole.Volume, 1e-13 * whole.Volume + whole.Rounding);
}

TEST(BooleanOperationWinding, CutByAPlane)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 2;
  for (int number = first; number < first + count; ++number)
  {
    TryCut(number);
  }
}

TEST(BooleanOperationWinding, PairsOfOverlaps)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 4;
  for (int number = first; number < first + count; ++number)
  {
    TryPair(number);
  }
}

/// Surfaces that intersect themselves everywhere: triangles meet in threes, the points of which lie
/// on three segments. How much that takes is counted: see Testing/Instructions.
TEST(BooleanOperationWinding, SpheresWithNoiseInAllDirections)
{
  for (const double noise : { 0.01, 0.06, 0.2 })
  {
    SCOPED_TRACE(noise);
    Random random(31);
    const auto noisy = [&random, noise](const Point& p) {
      return p + noise * random.InBox({ -1, 1, -1, 1, -1, 1 });
    };
    const Mesh a = SphereTriangles(8).Map(noisy);
    const Mesh b = Transformed(SphereTriangles(8).Map(noisy), 1.0, { 0.5, 0.25, 0.125 });
    CheckOperations(random, a, b, Filter::NONZERO);
    CheckOperations(random, a, a, Filter::ODD);
  }
}

TEST(BooleanOperationWinding, AtLeastSomeOfMany)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 8;
  for (int number = first; number < first + count; ++number)
  {
    TryMany(number);
  }
}
}
