// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies of one part that overlap, with triangles missing: what vtkSkdTreePointInOut is sure of,
// and the sign of a distance, are those of the complete bodies, wherever the gaps are far away.

#include "Core/Geometry/Measures/SolidAngle.h"
#include "Support/ClosestPointRun.h"
#include "Support/IntegerBodies.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

using namespace skdtest;

namespace
{

Point Rounded(const Point& p)
{
  return { std::round(p[0]), std::round(p[1]), std::round(p[2]) };
}

/// Complete bodies in one mesh, and the same without some triangles.
struct Bodies
{
  Mesh Whole;
  Mesh Open;
  Mesh Missing;

  /// The share of directions in which a point sees something missing, at most.
  double GetShareMissing(const Point& x) const
  {
    double sum = 0.0;
    for (const CellSpec& cell : this->Missing.Cells)
    {
      skd::Vector3 p[3];
      for (int k = 0; k < 3; ++k)
      {
        std::copy_n(this->Missing.Points[cell.Points[k]].data(), 3, p[k].X);
      }
      sum += std::abs(skd::SeeAngle(p[0], p[1], p[2], { { x[0], x[1], x[2] } }).Angle);
    }
    return sum / (4.0 * vtkMath::Pi());
  }
};

void Remove(int number, Random& random, Bodies& bodies)
{
  std::set<int> missing;
  while (static_cast<int>(missing.size()) < number)
  {
    missing.insert(random.Index(static_cast<int>(bodies.Whole.Cells.size())));
  }
  const auto isMissing = [&](std::size_t cell)
  { return missing.count(static_cast<int>(cell)) > 0; };
  bodies.Open = Part(bodies.Whole, [&](std::size_t cell) { return !isMissing(cell); });
  bodies.Missing = Part(bodies.Whole, isMissing);
}

/// A few bodies, mostly overlapping, with up to five triangles missing.
Bodies RandomBodies(Random& random)
{
  std::vector<Mesh> each;
  const int number = 1 + random.Index(4);
  for (int i = 0; i < number; ++i)
  {
    const Point at = Rounded(random.InBox({ -4e3, 4e3, -4e3, 4e3, -4e3, 4e3 }));
    const double size = 1500.0 + random.Index(6000);
    each.push_back(StarTriangles(random, size).Map([&](const Point& p) { return p + at; }));
  }
  Bodies bodies;
  bodies.Whole = Together(each);
  Remove(random.Index(6), random, bodies);
  return bodies;
}

/// Points that are on no triangle and see little of what is missing, and their winding numbers in
/// the complete bodies.
std::vector<Point> FarPoints(
  const Bodies& bodies, Random& random, int count, std::vector<int>& numbers)
{
  std::vector<Point> points;
  for (int i = 0; i < 20 * count && static_cast<int>(points.size()) < count; ++i)
  {
    const Point x = Rounded(random.InBox({ -8e3, 8e3, -8e3, 8e3, -8e3, 8e3 }));
    const auto number = ExactWindingNumber(bodies.Whole, x);
    if (number && bodies.GetShareMissing(x) < 0.05)
    {
      points.push_back(x);
      numbers.push_back(*number);
    }
  }
  return points;
}

struct Answers
{
  std::vector<double> Inside;
  std::vector<double> Confidence;
};

Answers AnswersOf(const std::vector<Point>& points, const Mesh& mesh)
{
  InOutPointer filter = MakeInOut(MakeQueries(points), MakePolyData(mesh));
  return { RunFor(filter, "SkdInside"), RunFor(filter, "SkdConfidence") };
}

int FuzzParts()
{
  const char* wanted = std::getenv("SKDTREE_FUZZ_PARTS");
  return wanted ? std::atoi(wanted) : 150;
}

/// The radius of a ball's mesh.
Mesh Ball(int fineness, double radius, const Point& middle)
{
  return Outward(SphereTriangles(fineness))
    .Map([&](const Point& p) { return Rounded((radius / Length(p)) * p + middle); });
}

TEST(PointInOutOpen, ABallThatCrossesABallWithAGapAtItsFarSide)
{
  Bodies bodies;
  bodies.Whole = Together({ Ball(8, 1e4, { 0, 0, 0 }), Ball(6, 3e3, { 9e3, 0, 0 }) });
  const std::size_t farthest = [&]
  {
    std::size_t found = 0;
    const auto at = [&](std::size_t cell)
    { return bodies.Whole.Points[bodies.Whole.Cells[cell].Points[0]][0]; };
    for (std::size_t cell = 0; cell < bodies.Whole.Cells.size(); ++cell)
    {
      found = at(cell) < at(found) ? cell : found;
    }
    return found;
  }();
  bodies.Open = Part(bodies.Whole, [&](std::size_t cell) { return cell != farthest; });
  Random random(5);
  std::vector<Point> points;
  while (points.size() < 400)
  {
    const Point x = Rounded(random.InBox({ 6e3, 10e3, -3e3, 3e3, -3e3, 3e3 }));
    if (ExactWindingNumber(bodies.Whole, x) == 2)
    {
      points.push_back(x);
    }
  }
  const Answers answers = AnswersOf(points, bodies.Open);
  const std::vector<double> distances =
    RunDistances(MakeSignedFilter(MakeQueries(points), MakePolyData(bodies.Open)));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(answers.Inside[i], 1) << i;
    ASSERT_GT(answers.Confidence[i], 0.9) << i;
    ASSERT_LT(distances[i], 0.0) << i;
  }
}

/// Counts of what was asked of the parts of a fuzzer: all, and what was said with confidence.
struct Tally
{
  int Queries = 0;
  int Sure = 0;
  int Wrong = 0;
  int WrongSigns = 0;
};

void AskFar(const Bodies& bodies, Random& random, int part, Tally& tally)
{
  std::vector<int> numbers;
  const std::vector<Point> points = FarPoints(bodies, random, 50, numbers);
  const Answers answers = AnswersOf(points, bodies.Open);
  const std::vector<double> distances =
    RunDistances(MakeSignedFilter(MakeQueries(points), MakePolyData(bodies.Open)));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const bool isSure = answers.Confidence[i] > 0.9;
    const bool isInside = numbers[i] > 0;
    const bool isWrong = isSure && (answers.Inside[i] == 1) != isInside;
    ++tally.Queries;
    tally.Sure += isSure;
    tally.Wrong += isWrong;
    tally.WrongSigns += isSure && (distances[i] < 0.0) != isInside;
    EXPECT_FALSE(isWrong && tally.Wrong < 10)
      << "part " << part << ", point " << points[i][0] << " " << points[i][1] << " " << points[i][2]
      << ", winding number " << numbers[i] << ", confidence " << answers.Confidence[i];
  }
}

// SKDTREE_FUZZ_PARTS: how many parts, of 50 questions each; default 150.
TEST(PointInOutOpen, WhatIsSaidWithConfidenceIsTheExactWindingNumberOfTheCompleteBodies)
{
  Tally tally;
  for (int part = 0; part < FuzzParts(); ++part)
  {
    Random random(31000 + static_cast<std::uint64_t>(part));
    const Bodies bodies = RandomBodies(random);
    AskFar(bodies, random, part, tally);
  }
  EXPECT_EQ(tally.Wrong, 0) << "of " << tally.Queries;
  EXPECT_EQ(tally.WrongSigns, 0) << "of " << tally.Queries;
  RecordProperty("Asked", tally.Queries);
  RecordProperty("Sure", tally.Sure);
  EXPECT_GT(tally.Sure, 0.85 * tally.Queries);
}

// Everything beyond a plane is missing: the winding number decides, and less is sure.
TEST(PointInOutOpen, WhatIsSaidWithConfidenceIsRightWhereMuchIsMissing)
{
  Tally tally;
  for (int part = 0; part < FuzzParts(); ++part)
  {
    Random random(83000 + static_cast<std::uint64_t>(part));
    Bodies bodies = RandomBodies(random);
    const Point across = random.InBox({ -1, 1, -1, 1, -1, 1 });
    const double plane = random.Between(0.0, 3000.0);
    const auto isThere = [&](std::size_t cell)
    { return Dot(bodies.Whole.Points[bodies.Whole.Cells[cell].Points[0]], across) < plane; };
    bodies.Open = Part(bodies.Whole, isThere);
    bodies.Missing = Part(bodies.Whole, [&](std::size_t cell) { return !isThere(cell); });
    AskFar(bodies, random, part, tally);
  }
  EXPECT_EQ(tally.Wrong, 0) << "of " << tally.Queries;
  EXPECT_GT(tally.Sure, 0.5 * tally.Queries);
}

/// The mesh with some bodies turned as a whole, or single triangles anywhere.
Mesh Disoriented(const Mesh& mesh, const Mesh& rotated, Random& random, bool ofTriangles)
{
  Mesh mixed = mesh;
  for (std::size_t cell = 0; ofTriangles && cell < mixed.Cells.size(); ++cell)
  {
    mixed.Cells[cell] = random.Index(3) == 0 ? rotated.Cells[cell] : mixed.Cells[cell];
  }
  return mixed;
}

// Whatever the orientation, the answer with a gap is that without it.
TEST(PointInOutOpen, WithAGapFarAwayTheAnswerIsThatOfTheCompletePart)
{
  int requested = 0, sure = 0;
  for (int part = 0; part < FuzzParts() / 2; ++part)
  {
    Random random(57000 + static_cast<std::uint64_t>(part));
    Bodies bodies = RandomBodies(random);
    if (part % 2)
    {
      bodies.Whole = Together({ bodies.Whole, Inverted(RandomBodies(random).Whole) });
    }
    bodies.Whole = Disoriented(bodies.Whole, Inverted(bodies.Whole), random, part % 4 > 1);
    Remove(1 + random.Index(3), random, bodies);
    std::vector<int> numbers;
    const std::vector<Point> points = FarPoints(bodies, random, 50, numbers);
    const Answers whole = AnswersOf(points, bodies.Whole);
    const Answers open = AnswersOf(points, bodies.Open);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ++requested;
      sure += open.Confidence[i] > 0.9;
      EXPECT_TRUE(
        open.Inside[i] == whole.Inside[i] || open.Confidence[i] <= 0.9 || whole.Confidence[i] < 1.0)
        << "part " << part << ", point " << points[i][0] << " " << points[i][1] << " "
        << points[i][2];
    }
  }
  EXPECT_GT(sure, 0.6 * requested);
}

}
