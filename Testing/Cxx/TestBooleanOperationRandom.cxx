// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: random pairs of random solids, and operations on results.
//
// SKDTREE_FUZZ_PAIRS in the environment sets how many pairs are tried, SKDTREE_FUZZ_FIRST which is
// the first; a failure names its pair.

#include "Support/EventCounter.h"
#include "Support/IntegerBodies.h"
#include "Support/RandomSolids.h"
#include "Support/WindingReference.h"

#include "vtkFieldData.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeBooleanOperation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

int SetInEnvironment(const char* name, int otherwise)
{
  const char* set = std::getenv(name);
  return set ? std::atoi(set) : otherwise;
}

bool IsSolid(int operation, bool a, bool b)
{
  return std::array<bool, 5>{ a || b, a && b, a && !b, b && !a, a != b }[operation];
}

Mesh MeshOf(vtkPolyData* surface)
{
  Mesh mesh;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Point x;
    surface->GetPoint(i, x.data());
    mesh.Add(x);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    mesh.Add(VTK_TRIANGLE, { ids->begin(), ids->end() });
  }
  return mesh;
}

Mesh Combine(const Mesh& a, const Mesh& b, int operation)
{
  vtkNew<Filter> filter;
  EventCounter events(filter); // inputs that touch themselves are warned of
  filter->SetInputData(0, MakePolyData(a));
  filter->SetSourceData(MakePolyData(b));
  filter->SetOperation(operation);
  filter->Update();
  EXPECT_EQ(events.Errors, 0) << events.Error;
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(output->GetFieldData()->GetArray("SkdReportBadEdges")->GetTuple1(0), 0.0);
  return MeshOf(output);
}

/// Edges that are not passed as often in one direction as in the other.
std::ptrdiff_t CountBadEdges(const Mesh& mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> passes;
  for (const CellSpec& cell : mesh.Cells)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = cell.Points[i];
      const vtkIdType b = cell.Points[(i + 1) % 3];
      passes[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  return std::count_if(
    passes.begin(), passes.end(), [](const auto& edge) { return edge.second != 0; });
}

/// Volume, area, and the volume by which they may be wrong if each point is rounded.
struct Measures
{
  double Volume = 0.0;
  double Area = 0.0;
  double Rounding = 0.0;

  explicit Measures(const Mesh& mesh)
  {
    const Point origin = mesh.Points.empty() ? Point{} : mesh.Points[0];
    double largest = 0.0;
    for (const CellSpec& cell : mesh.Cells)
    {
      const Point a = mesh.Points[cell.Points[0]] - origin;
      const Point b = mesh.Points[cell.Points[1]] - origin;
      const Point c = mesh.Points[cell.Points[2]] - origin;
      this->Volume += Dot(a, Cross(b, c)) / 6.0;
      this->Area += 0.5 * Length(Cross(b - a, c - a));
      for (const double x : mesh.Points[cell.Points[0]])
      {
        largest = std::max(largest, std::abs(x));
      }
    }
    this->Rounding = std::numeric_limits<double>::epsilon() * largest * this->Area;
  }
};

/// Nothing on the surface.
std::optional<bool> IsInside(const Mesh& solid, const Point& x)
{
  const double winding = WindingNumber(solid, x);
  const bool isSure = std::abs(winding - std::round(winding)) < 1e-3;
  return isSure ? std::optional<bool>(std::lround(winding) != 0) : std::nullopt;
}

using InOut = std::function<std::optional<bool>(const Point&)>;

InOut InOutOf(const Mesh& solid)
{
  return [solid](const Point& x) { return IsInside(solid, x); };
}

InOut Combined(int operation, InOut a, InOut b)
{
  return [operation, a = std::move(a), b = std::move(b)](const Point& x) -> std::optional<bool>
  {
    const std::optional<bool> inA = a(x);
    const std::optional<bool> inB = b(x);
    return inA && inB ? std::optional<bool>(IsSolid(operation, *inA, *inB)) : std::nullopt;
  };
}

/// Where results must agree: anywhere around both, and near middles of their faces.
std::vector<Point> MakeQueries(Random& random, const std::vector<const Mesh*>& solids)
{
  std::vector<Point> queries;
  for (const Mesh* solid : solids)
  {
    Bounds box = EmptyBounds();
    for (const Point& p : solid->Points)
    {
      Extend(box, p);
    }
    for (int i = 0; i < 10 && !solid->Cells.empty(); ++i)
    {
      const Ids& ids = solid->Cells[random.Index(static_cast<int>(solid->Cells.size()))].Points;
      const Point& corner = solid->Points[ids[0]];
      const Point middle = (1.0 / 3.0) * (corner + solid->Points[ids[1]] + solid->Points[ids[2]]);
      const double from = std::max(2e-3 * Distance(corner, middle), 1e-6 * Diagonal(box));
      queries.push_back(middle + from * random.Direction());
      queries.push_back(random.InBox(box));
    }
  }
  return queries;
}

struct Pair
{
  Mesh Solids[2];
  std::string What;
};

Mesh AnySolid(Random& random, std::string& what)
{
  for (;;)
  {
    RandomSolid solid = MakeRandomSolid(random);
    if (!solid.Triangles.Cells.empty())
    {
      what += solid.Kind;
      const bool isTurned = Measures(solid.Triangles).Volume < 0.0;
      return isTurned ? Turned(solid.Triangles) : solid.Triangles;
    }
  }
}

/// Moves a solid by nothing, by quarters, or by anything; turns it or does not.
Mesh MovedAnywhere(Random& random, Mesh solid, std::string& what)
{
  const int turn = random.Index(3);
  if (turn > 0)
  {
    solid.Map(RandomRotation(random, turn == 1));
    what += turn == 1 ? ", turned by right angles" : ", turned";
  }
  const int way = random.Index(3);
  const auto quarters = [&] { return 0.25 * (random.Index(9) - 4); };
  const Point by = way == 0 ? Point{ 0, 0, 0 }
    : way == 1              ? Point{ quarters(), quarters(), quarters() }
                            : random.InBox({ -0.7, 0.7, -0.7, 0.7, -0.7, 0.7 });
  what += way == 0 ? "" : way == 1 ? ", moved by quarters" : ", moved";
  return Placed(std::move(solid), 1.0, by);
}

/// Both are turned, scaled or moved far away, but for tiny ones, whose corners would become one.
void MoveBoth(Random& random, Pair& pair, bool isTiny)
{
  const int any = random.Index(8);
  const int way = any == 3 && isTiny ? 0 : any;
  const RandomRotation rotation(random, false);
  for (Mesh& solid : pair.Solids)
  {
    if (way == 0)
    {
      solid.Map(rotation);
    }
    else if (way < 4)
    {
      solid = Placed(std::move(solid),
        way == 1     ? 1e-6
          : way == 2 ? 1e6
                     : 1.0,
        way == 3 ? Point{ 1e6, -1e6, 1e6 } : Point{ 0, 0, 0 });
    }
  }
  const char* names[] = { ", both turned", ", both times 1e-6", ", both times 1e6",
    ", both moved by 1e6" };
  pair.What += way < 4 ? names[way] : "";
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
    pair.Solids[1] = Placed(std::move(pair.Solids[1]), sizes[smaller], { 0, 0, 0 });
    pair.What += ", smaller";
  }
  pair.Solids[1] = MovedAnywhere(random, std::move(pair.Solids[1]), pair.What);
  MoveBoth(random, pair, smaller == 1);
  return pair;
}

void ExpectSolid(
  Random& random, const std::vector<const Mesh*>& solids, const InOut& isInside, const Mesh& result)
{
  EXPECT_EQ(CountBadEdges(result), 0);
  for (const Point& x : MakeQueries(random, solids))
  {
    if (const std::optional<bool> isIn = isInside(x))
    {
      EXPECT_NEAR(WindingNumber(result, x), *isIn ? 1.0 : 0.0, 1e-3)
        << x[0] << " " << x[1] << " " << x[2];
    }
  }
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
    ExpectSolid(random, { &a, &b }, Combined(operation, InOutOf(a), InOutOf(b)), result);
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
  InOut IsInside;
};

MadeSolid MakeLeaf(Random& random, std::string& what)
{
  what += "; ";
  const Mesh solid = MovedAnywhere(random, AnySolid(random, what), what);
  return { solid, InOutOf(solid) };
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

TEST(BooleanOperationRandom, TreesOfTenOperations)
{
  const int first = SetInEnvironment("SKDTREE_FUZZ_FIRST", 0);
  const int count = std::max(2, SetInEnvironment("SKDTREE_FUZZ_PAIRS", 40) / 20);
  for (int number = first; number < first + count; ++number)
  {
    TryTree(number);
  }
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
