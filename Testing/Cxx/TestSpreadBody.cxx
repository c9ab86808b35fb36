// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Bodies whose cells lie on several processes (threads in their place): nearest faces and sides are
// those of the body on one process, to the last bit.

#include "Support/MeshPieces.h"
#include "Support/ThreadTransport.h"

#include "Bodies/SkdSignedSource.h"
#include "Exchange/Bodies/SkdSpreadBody.h"
#include "Exchange/SkdJoinedPieces.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <string>
#include <tuple>

using namespace skdtest;
using namespace skdtree;

namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/// What is said of a point.
struct Answer
{
  SkdNearest Nearest{ {}, Infinite, -1, -1 };
  bool IsInside = false;

  auto Key() const
  {
    return std::tie(this->Nearest.Distance2, this->Nearest.Block, this->Nearest.CellId);
  }
};

struct Answers
{
  std::vector<Answer> List;
  bool IsFit = true;
  bool IsDecided = true;
  vtkIdType Faces = 0;
  vtkIdType OpenEdges = 0;
};

/// Every third cell turned around.
Mesh Flipped(Mesh mesh)
{
  for (std::size_t i = 0; i < mesh.Cells.size(); i += 3)
  {
    std::reverse(mesh.Cells[i].Points.begin(), mesh.Cells[i].Points.end());
  }
  return mesh;
}

Mesh Moved(Mesh mesh, double scale, double by)
{
  return mesh.Map(
    [=](const Point& p) {
      return Point{ scale * p[0] + by, scale * p[1], scale * p[2] };
    });
}

/// In the bounds of a mesh and a little beyond, also on it.
std::vector<skd::Vector3> QueryPoints(vtkDataSet* mesh, int n)
{
  Random random(17);
  double bounds[6];
  mesh->GetBounds(bounds);
  std::vector<skd::Vector3> points(static_cast<std::size_t>(n));
  for (skd::Vector3& x : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double size = bounds[2 * axis + 1] - bounds[2 * axis];
      x[axis] = bounds[2 * axis] + size * random.Between(-0.1, 1.1);
    }
  }
  for (vtkIdType i = 0; i < std::min<vtkIdType>(mesh->GetNumberOfPoints(), 20); ++i)
  {
    points.emplace_back();
    mesh->GetPoint(i, points.back().X);
  }
  return points;
}

Answers AskWhole(vtkDataSet* mesh, const std::vector<skd::Vector3>& points)
{
  SkdSignedSource source;
  source.Update({ { mesh, 0 } }, 1e-9, 1e-4);
  Answers answers;
  answers.Faces = source.GetNumberOfFaces();
  answers.OpenEdges = source.GetNumberOfOpenEdges();
  for (const skd::Vector3& x : points)
  {
    answers.List.push_back({ *source.FindNearest(x.X, Infinite), source.IsInside(x.X) });
  }
  return answers;
}

/// Process p asks for the sides of every n-th of the points, from the p-th on.
Answers AskPieces(const Pieces& pieces, const std::vector<skd::Vector3>& points)
{
  const std::size_t processes = pieces.size();
  Answers answers;
  answers.List.resize(points.size());
  std::mutex mutex;
  ThreadTransport::RunOwners(static_cast<int>(processes),
    [&](std::unique_ptr<SkdTransport> transport)
    {
      const auto rank = static_cast<std::size_t>(transport->GetRank());
      SkdSpreadSource spread;
      spread.Update(std::move(transport), pieces[rank]);
      SkdSpreadBody body;
      body.Update(spread, 1e-9);
      std::vector<char> isInside(points.size(), 0);
      vtkNew<vtkAlgorithm> algorithm;
      SkdLoop loop(algorithm, static_cast<vtkIdType>(points.size()), 0.0, 1.0);
      const bool isDecided = !body.IsFit() ||
        body.FindSides(
          points.size(), [&](std::size_t i) { return points[i]; },
          [&](std::size_t i) { return i % processes == rank; },
          [&](std::size_t i, bool is) { isInside[i] = is ? 1 : 0; }, loop) == SkdSpreadResult::Done;
      const std::lock_guard<std::mutex> lock(mutex);
      answers.IsFit = answers.IsFit && body.IsFit();
      answers.IsDecided = answers.IsDecided && isDecided;
      answers.Faces = body.GetNumberOfFaces();
      answers.OpenEdges = body.GetNumberOfOpenEdges();
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        answers.List[i].IsInside = answers.List[i].IsInside || isInside[i] != 0;
        if (const auto nearest = body.FindNearest(points[i].X, Infinite))
        {
          const Answer other{ *nearest, false };
          if (other.Key() < answers.List[i].Key())
          {
            answers.List[i].Nearest = *nearest;
          }
        }
      }
    });
  return answers;
}

Pieces PiecesOf(const PieceCase& some, const std::vector<int>& owners, int processes)
{
  Pieces pieces;
  for (int process = 0; process < processes; ++process)
  {
    Mesh own;
    own.Points = some.Whole.Points;
    for (std::size_t i = 0; i < some.Whole.Cells.size(); ++i)
    {
      if (owners[i] == process)
      {
        own.Cells.push_back(some.Whole.Cells[i]);
      }
    }
    pieces.push_back(some.Make(Compact(own)));
  }
  return pieces;
}

void ExpectSame(const Answers& whole, const Answers& pieces)
{
  ASSERT_TRUE(pieces.IsDecided);
  EXPECT_EQ(whole.Faces, pieces.Faces);
  EXPECT_EQ(whole.OpenEdges, pieces.OpenEdges);
  for (std::size_t i = 0; i < whole.List.size(); ++i)
  {
    const Answer& a = whole.List[i];
    const Answer& b = pieces.List[i];
    ASSERT_EQ(a.Key(), b.Key()) << "point " << i;
    ASSERT_TRUE(std::equal(a.Nearest.Point, a.Nearest.Point + 3, b.Nearest.Point)) << i;
    ASSERT_EQ(a.IsInside, b.IsInside) << "point " << i;
  }
}

std::vector<PieceCase> Bodies()
{
  const Mesh ball = SphereTriangles(8);
  return {
    { "Ball", ball, true },
    { "Turned", Flipped(ball), true },
    { "Two balls", Together({ Flipped(ball), Moved(ball, -0.5, 3.0) }), true },
    { "Hexahedra", Hexahedra(3), false },
    { "Polyhedra", Polyhedra(2), false },
    { "Volumes and a sheet", Together({ Hexahedra(3), Moved(ball, 0.5, 9.0) }), false },
  };
}
}

TEST(SpreadBody, IsThatOfOneProcess)
{
  for (const PieceCase& some : Bodies())
  {
    for (const int processes : { 1, 2, 3, 5 })
    {
      SCOPED_TRACE(some.Name + " on " + std::to_string(processes));
      const Pieces pieces =
        PiecesOf(some, RandomOwners(some.Whole, processes, processes), processes);
      const auto whole = SkdJoinPieces(pieces).Mesh;
      const std::vector<skd::Vector3> points = QueryPoints(whole, 200);
      const Answers found = AskPieces(pieces, points);
      EXPECT_TRUE(found.IsFit);
      ExpectSame(AskWhole(whole, points), found);
    }
  }
}

// What needs all of the surface on one process says so, and is not answered.
TEST(SpreadBody, SaysWhereItIsUnfit)
{
  const Mesh ball = SphereTriangles(8);
  Mesh open = ball;
  open.Cells.pop_back();
  const PieceCase some{ "Open", open, true };
  const Pieces pieces = PiecesOf(some, RandomOwners(open, 3, 3), 3);
  const auto whole = SkdJoinPieces(pieces).Mesh;
  const std::vector<skd::Vector3> points = QueryPoints(whole, 20);
  const Answers found = AskPieces(pieces, points);
  EXPECT_FALSE(found.IsFit);
  EXPECT_EQ(3, found.OpenEdges);
  EXPECT_EQ(AskWhole(whole, points).Faces, found.Faces);
}

TEST(SpreadBody, IsNotDecidedWhereBodiesAreNested)
{
  const Mesh ball = SphereTriangles(8);
  const Mesh both = Together({ ball, Moved(ball, 0.5, 0.0) });
  const PieceCase some{ "Nested", both, true };
  const Pieces pieces = PiecesOf(some, RandomOwners(both, 3, 4), 3);
  const Answers found = AskPieces(pieces, QueryPoints(SkdJoinPieces(pieces).Mesh, 200));
  EXPECT_TRUE(found.IsFit);
  EXPECT_FALSE(found.IsDecided);
}
