// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreePointInOut and the signed distance where one part is made of several bodies, or of one
// that meets itself: what is said for sure is right.

#include "Support/ClosestPointRun.h"
#include "Support/IntegerBodies.h"
#include "Support/TestAmount.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace skdtest;

namespace
{

using Check = std::function<bool(const Point&)>;

/// Expects every answer to be that of the check, and to be sure.
void ExpectSure(const Mesh& mesh, const std::vector<Point>& points, const Check& isInside)
{
  InOutPointer filter = MakeInOut(MakeQueries(points), MakePolyData(mesh));
  const std::vector<double> inside = RunFor(filter, "SkdInside");
  const std::vector<double> confidence = RunFor(filter, "SkdConfidence");
  const std::vector<double> distance =
    RunDistances(MakeSignedFilter(MakeQueries(points), MakePolyData(mesh)));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(inside[i] == 1, isInside(points[i])) << i;
    ASSERT_EQ(confidence[i], 1.0) << i;
    ASSERT_EQ(distance[i] < 0.0, isInside(points[i])) << i;
  }
}

Point Rounded(const Point& p)
{
  return { std::round(p[0]), std::round(p[1]), std::round(p[2]) };
}

bool IsInBox(const Point& x, double low, double high)
{
  return std::all_of(x.begin(), x.end(), [&](double c) { return c > low && c < high; });
}

TEST(PointInOutBodies, CubesThatOverlapAreTheirUnion)
{
  const Mesh a = BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 });
  const Mesh b = BoxTriangles({ 1, 1, 1 }, { 3, 3, 3 });
  const Check isInside = [](const Point& x) { return IsInBox(x, 0, 2) || IsInBox(x, 1, 3); };
  std::vector<Point> points = PointsAround(3.5, 3000);
  points.push_back({ 1.5, 1.5, 1.5 });
  ExpectSure(Together({ a, b }), points, isInside);
  ExpectSure(Together({ Inverted(a), Inverted(b) }), points, isInside);
}

TEST(PointInOutBodies, CubesWithFacesInOnePlaneAreTheirUnion)
{
  const Mesh mesh = Together({ BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 }),
    BoxTriangles({ 1, 0, 0 }, { 3, 2, 2 }), BoxTriangles({ 0, 0, 0 }, { 1, 1, 2 }) });
  ExpectSure(mesh, PointsAround(3.5, 3000),
    [](const Point& x)
    { return x[0] > 0 && x[0] < 3 && x[1] > 0 && x[1] < 2 && x[2] > 0 && x[2] < 2; });
}

// A body that is there twice and touches another with an equal face: the other's own faces are
// there once, its wall with the first three times.
TEST(PointInOutBodies, ABodyThatIsThereTwiceMayTouchAnother)
{
  const Mesh a = BoxTriangles({ 0, 0, 0 }, { 1, 1, 1 });
  const Mesh b = BoxTriangles({ 1, 0, 0 }, { 2, 1, 1 });
  std::vector<Point> points = PointsAround(2.5, 3000);
  ExpectSure(Together({ a, a, b }), points,
    [](const Point& x)
    { return x[0] > 0 && x[0] < 2 && x[1] > 0 && x[1] < 1 && x[2] > 0 && x[2] < 1; });
}

TEST(PointInOutBodies, ASurfaceThatRunsThroughItselfIsWhatItsWindingNumberSays)
{
  // A tube that is bent to a ring which overlaps itself: it goes around once and a quarter.
  constexpr int around = 50, across = 12;
  Mesh tube;
  for (int i = 0; i <= around; ++i)
  {
    const double angle = 2.5 * vtkMath::Pi() * i / around;
    const double drift = 0.4 * i / around;
    for (int k = 0; k < across; ++k)
    {
      const double turn = 2.0 * vtkMath::Pi() * k / across;
      const double radius = 2.0 + 0.5 * std::cos(turn);
      tube.Add(
        { radius * std::cos(angle), radius * std::sin(angle), 0.5 * std::sin(turn) + drift });
    }
  }
  for (int i = 0; i < around; ++i)
  {
    for (int k = 0; k < across; ++k)
    {
      const vtkIdType a = i * across + k, b = i * across + (k + 1) % across;
      tube.Add(VTK_TRIANGLE, { a, b, b + across });
      tube.Add(VTK_TRIANGLE, { a, b + across, a + across });
    }
  }
  for (int k = 1; k + 1 < across; ++k)
  {
    const vtkIdType last = around * across;
    tube.Add(VTK_TRIANGLE, { 0, k + 1, k });
    tube.Add(VTK_TRIANGLE, { last, last + k, last + k + 1 });
  }
  tube.Map([](const Point& p) { return Rounded(1e4 * p); });
  std::vector<Point> points;
  int twice = 0;
  for (Point x : PointsAround(3e4, 6000))
  {
    x = Rounded({ x[0], x[1], 0.4 * x[2] });
    if (const auto number = ExactWindingNumber(tube, x))
    {
      points.push_back(x);
      twice += std::abs(*number) == 2;
    }
  }
  EXPECT_GT(twice, 10);
  ExpectSure(tube, points, [&](const Point& x) { return *ExactWindingNumber(tube, x) != 0; });
}

TEST(PointInOutBodies, WhatIsTurnedAgainstItsReadingIsNotSure)
{
  // Within a cube another that touches it nowhere and is oriented like it: a cavity by parity, no
  // cavity by its winding number. And two that overlap, one of them inside out.
  const Mesh cube = BoxTriangles({ 0, 0, 0 }, { 4, 4, 4 });
  const Mesh inner = BoxTriangles({ 1, 1, 1 }, { 3, 3, 3 });
  const Mesh beside = BoxTriangles({ 2, 2, 2 }, { 6, 6, 6 });
  const auto ask = [](const Mesh& mesh, const Point& x)
  {
    InOutPointer filter = MakeInOut(MakeQueries({ x }), MakePolyData(mesh));
    return std::make_pair(RunFor(filter, "SkdInside")[0], RunFor(filter, "SkdConfidence")[0]);
  };
  using Answer = std::pair<double, double>;
  const Point middle{ 2.1, 2.2, 2.3 };
  EXPECT_EQ(ask(Together({ cube, inner }), middle), Answer(0, 0.5));
  EXPECT_EQ(ask(Together({ cube, Inverted(inner) }), middle), Answer(0, 1.0));
  EXPECT_EQ(ask(Together({ cube, Inverted(inner) }), { 0.5, 0.6, 0.7 }), Answer(1, 1.0));
  EXPECT_EQ(ask(Together({ cube, Inverted(beside) }), { 3.1, 3.2, 3.3 }), Answer(1, 0.5));
  EXPECT_EQ(ask(Together({ cube, Inverted(beside) }), { 5.1, 5.2, 5.3 }), Answer(1, 1.0));
}

TEST(PointInOutBodies, ABodyInACavityThatRunsThroughItsWall)
{
  const Mesh hollow = Together({ BoxTriangles({ 0, 0, 0 }, { 10, 10, 10 }),
    Inverted(BoxTriangles({ 2, 2, 2 }, { 8, 8, 8 })), BoxTriangles({ 7, 4, 4 }, { 9, 6, 6 }) });
  ExpectSure(hollow, PointsAround(10.5, 4000),
    [](const Point& x)
    {
      const bool isInPlug = x[0] > 7 && x[0] < 9 && x[1] > 4 && x[1] < 6 && x[2] > 4 && x[2] < 6;
      return (IsInBox(x, 0, 10) && !IsInBox(x, 2, 8)) || isInPlug;
    });
}

TEST(PointInOutBodies, RowsOfAnImageAreThePoints)
{
  Random random(77);
  std::vector<Mesh> bodies;
  for (int i = 0; i < 5; ++i)
  {
    const Point shift = random.InBox({ -6, 6, -6, 6, -6, 6 });
    bodies.push_back(StarTriangles(random, 9.0).Map([&](const Point& p) { return p + shift; }));
  }
  const PolyDataPointer source = MakePolyData(Together(bodies));
  vtkNew<vtkImageData> image;
  image->SetDimensions(40, 37, 35);
  image->SetSpacing(0.71, 0.73, 0.74);
  image->SetOrigin(-14.01, -13.02, -12.03);
  std::vector<Point> points(static_cast<std::size_t>(image->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    image->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  for (const char* name : { "SkdInside", "SkdConfidence" })
  {
    EXPECT_EQ(
      RunFor(MakeInOut(image, source), name), RunFor(MakeInOut(MakeQueries(points), source), name));
  }
}

/// A body anywhere: coordinates are multiples of `unit`.
Mesh RandomBody(Random& random, double unit, double room)
{
  const auto position = [&] {
    return unit * Rounded(random.InBox({ -room, room, -room, room, -room, room }));
  };
  const Point at = position(), size = position();
  if (random.Index(2))
  {
    const auto length = [&](int axis) { return unit + std::abs(size[axis]); };
    return BoxTriangles(at, at + Point{ length(0), length(1), length(2) });
  }
  return StarTriangles(random, 0.8 * room).Map([&](const Point& p) { return unit * p + at; });
}

/// A part of bodies that are on a coarse lattice half of the time, so that they touch; some inside
/// out, within another, or there twice.
Mesh RandomBodies(Random& random)
{
  const bool isCoarse = random.Index(2) == 0;
  const double unit = isCoarse ? 1000.0 : 1.0;
  const double room = isCoarse ? 6.0 : 6000.0;
  std::vector<Mesh> bodies{ RandomBody(random, unit, room) };
  const int number = 2 + random.Index(4);
  while (static_cast<int>(bodies.size()) < number)
  {
    const int kind = random.Index(8);
    const Mesh& other =
      bodies[static_cast<std::size_t>(random.Index(static_cast<int>(bodies.size())))];
    Mesh body = kind < 2 ? other : RandomBody(random, unit, room);
    if (kind == 1)
    {
      const double factor = 1.0 / (2 + random.Index(2));
      const Point middle = 0.5 * (body.Points.front() + body.Points.back());
      body.Map([&](const Point& p) { return Rounded(middle + factor * (p - middle)); });
    }
    bodies.push_back(kind > 0 && random.Index(4) == 0 ? Inverted(body) : body);
  }
  return Together(bodies);
}

/// Counts of a run of the fuzzer.
struct Tally
{
  int Queries = 0;
  int SurelyWrong = 0;
  int Sure = 0;
};

void AskBodies(std::uint64_t seed, int count, Tally& tally)
{
  Random random(seed);
  const Mesh mesh = RandomBodies(random);
  std::vector<Point> points;
  std::vector<int> numbers;
  while (static_cast<int>(points.size()) < count)
  {
    const Point x = Rounded(random.InBox({ -12e3, 12e3, -12e3, 12e3, -12e3, 12e3 }));
    if (const auto number = ExactWindingNumber(mesh, x))
    {
      points.push_back(x);
      numbers.push_back(*number);
    }
  }
  InOutPointer filter = MakeInOut(MakeQueries(points), MakePolyData(mesh));
  const std::vector<double> inside = RunFor(filter, "SkdInside");
  const std::vector<double> confidence = RunFor(filter, "SkdConfidence");
  ASSERT_EQ(Reported(filter, "OpenEdges"), 0) << seed;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const bool isSure = confidence[i] == 1.0;
    const bool isWrong = (inside[i] == 1) != (numbers[i] != 0);
    ++tally.Queries;
    tally.Sure += isSure;
    tally.SurelyWrong += isSure && isWrong;
    EXPECT_FALSE(isSure && isWrong)
      << "seed " << seed << ", point " << points[i][0] << " " << points[i][1] << " " << points[i][2]
      << ", winding number " << numbers[i];
  }
}

// SKDTREE_FUZZ_PARTS: how many parts, of 100 questions each; default 1000.
TEST(PointInOutBodies, WhatIsSaidForSureIsTheExactWindingNumber)
{
  const char* wanted = std::getenv("SKDTREE_FUZZ_PARTS");
  const int parts = wanted ? std::atoi(wanted) : Amount(1000);
  Tally tally;
  for (int part = 0; part < parts && !HasFailure(); ++part)
  {
    AskBodies(14000 + static_cast<std::uint64_t>(part), 100, tally);
  }
  EXPECT_EQ(tally.Queries, 100 * parts);
  EXPECT_EQ(tally.SurelyWrong, 0);
  EXPECT_GT(tally.Sure, 0.9 * tally.Queries);
}

}
