// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: surfaces with gaps, whose inside is found by generalized winding
// numbers, against the same surfaces without gaps.

#include "Support/Folders.h"
#include "Support/RealMeshes.h"
#include "Support/Reported.h"
#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"
#include "Support/TestAmount.h"

#include <filesystem>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

Mesh Ball()
{
  return Outward(SphereTriangles(12))
    .Map(
      [](const Point& p) {
        return Point{ p[0] + 0.01, p[1] + 0.02, p[2] + 0.03 };
      });
}

/// Without the faces of which `isOut` is true of the middle.
Mesh Without(const Mesh& mesh, const std::function<bool(const Point&)>& isOut)
{
  Mesh left;
  left.Points = mesh.Points;
  for (const CellSpec& cell : mesh.Cells)
  {
    const Point middle = (1.0 / 3.0) *
      (mesh.Points[cell.Points[0]] + mesh.Points[cell.Points[1]] + mesh.Points[cell.Points[2]]);
    if (!isOut(middle))
    {
      left.Cells.push_back(cell);
    }
  }
  return left;
}

/// With a gap on top.
Mesh OpenBall()
{
  return Without(Ball(), [](const Point& p) { return p[2] > 0.95; });
}

struct Outcome
{
  Mesh Surface;
  double BadEdges = 0.0;
  int Warnings = 0;
  std::string Warning;
};

Outcome CombineOpen(const Mesh& a, const Mesh& b, int operation, int rule = Filter::NONZERO)
{
  vtkNew<Filter> filter;
  filter->SetInputData(0, MakePolyData(a));
  filter->SetSourceData(MakePolyData(b));
  filter->SetOperation(operation);
  filter->SetInsideRule(rule);
  filter->SetOpenSurfacesToWindingNumber();
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 0) << events.Error;
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  const Outcome outcome{ MeshOf(output), Reported(output, "BadEdges"), events.Warnings,
    events.Warning };
  EXPECT_EQ(static_cast<double>(CountBadEdges(outcome.Surface)), outcome.BadEdges);
  return outcome;
}

/// Cuts the ball far from its gap.
Mesh Tool()
{
  return BoxTriangles({ -3, -3, -3 }, { 3, 0.1, -0.3 });
}

TEST(BooleanOperationScans, ClosedAwayFromGaps)
{
  const Mesh open = OpenBall();
  const std::ptrdiff_t gap = CountBadEdges(open);
  ASSERT_GT(gap, 3);
  for (int operation = 0; operation < 5; ++operation)
  {
    SCOPED_TRACE(operation);
    const Mesh whole = Combine(Ball(), Tool(), operation);
    const Outcome outcome = CombineOpen(open, Tool(), operation);
    const bool isFarFromGap =
      operation == Filter::INTERSECTION || operation == Filter::REVERSE_DIFFERENCE;
    EXPECT_EQ(outcome.BadEdges, isFarFromGap ? 0.0 : static_cast<double>(gap));
    // The same faces but for those in the gap.
    const std::size_t missing = isFarFromGap ? 0 : Ball().Cells.size() - open.Cells.size();
    EXPECT_EQ(outcome.Surface.Cells.size() + missing, whole.Cells.size());
    EXPECT_EQ(outcome.Warnings, 1);
    EXPECT_NE(outcome.Warning.find("generalized winding number"), std::string::npos);
  }
}

TEST(BooleanOperationScans, BothMayBeOpen)
{
  const Mesh open = OpenBall();
  const Mesh other = Without(
    Transformed(Ball(), 1.1, { 0.8, 0.4, -0.2 }), [](const Point& p) { return p[0] > 1.7; });
  const Outcome both = CombineOpen(open, other, Filter::UNION);
  EXPECT_EQ(both.BadEdges, static_cast<double>(CountBadEdges(open) + CountBadEdges(other)));
  EXPECT_EQ(CombineOpen(open, other, Filter::INTERSECTION).BadEdges, 0.0);
}

/// Where a tool passes through a gap, the output is open there only.
TEST(BooleanOperationScans, OpenByTheGapThatIsCut)
{
  const Mesh tool = BoxTriangles({ 0.05, -3, -3 }, { 3, 3, 3 });
  const Outcome outcome = CombineOpen(OpenBall(), tool, Filter::DIFFERENCE);
  EXPECT_GT(outcome.BadEdges, 0.0);
  std::map<std::pair<vtkIdType, vtkIdType>, int> passes;
  for (const CellSpec& cell : outcome.Surface.Cells)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = cell.Points[i];
      const vtkIdType b = cell.Points[(i + 1) % 3];
      passes[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  const Mesh open = OpenBall();
  for (const auto& [edge, sum] : passes)
  {
    const bool isByTheGap =
      std::max(outcome.Surface.Points[edge.first][2], outcome.Surface.Points[edge.second][2]) > 0.5;
    EXPECT_TRUE(sum == 0 || isByTheGap);
  }
}

TEST(BooleanOperationScans, ClosedSurfacesAreCombinedAsWithoutTheRule)
{
  for (int operation = 0; operation < 5; ++operation)
  {
    const Mesh expected = Combine(Ball(), Tool(), operation);
    const Outcome outcome = CombineOpen(Ball(), Tool(), operation);
    EXPECT_EQ(outcome.Surface.Points, expected.Points);
    EXPECT_EQ(outcome.Warnings, 0);
  }
}

/// Inside out, a surface has no inside where the number must be positive.
TEST(BooleanOperationScans, NumbersAreRoundedForTheInsideRule)
{
  const Mesh rotated = Inverted(OpenBall());
  EXPECT_GT(CombineOpen(rotated, Tool(), Filter::INTERSECTION).Surface.Cells.size(), 0u);
  EXPECT_EQ(
    CombineOpen(rotated, Tool(), Filter::INTERSECTION, Filter::POSITIVE).Surface.Cells.size(), 0u);
}

TEST(BooleanOperationScans, TheErrorNamesTheRule)
{
  vtkNew<Filter> filter;
  filter->SetInputData(0, MakePolyData(OpenBall()));
  filter->SetSourceData(MakePolyData(Tool()));
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("Open Surfaces to Winding Number"), std::string::npos);
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), 0);
}

TEST(BooleanOperationScans, BunnyWithFiveHoles)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  const std::string file = ExtraDataFolder() + "/A_surface/bunny.stl";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << "no " << file;
  }
  vtkNew<Filter> filter;
  filter->SetInputData(0, ReadMesh(file));
  filter->SetSourceData(MakePolyData(BoxTriangles({ -0.03, 0.1, -1 }, { 1, 1, 1 })));
  filter->SetOpenSurfacesToWindingNumber();
  filter->SetOperationToIntersection();
  EventCounter events(filter);
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  EXPECT_EQ(Reported(output, "BadEdges"), 0.0);
  EXPECT_EQ(Reported(output, "OpenEdges"), 223.0);
  const double common = Reported(output, "Volume");
  filter->SetOperationToDifference();
  filter->Update();
  output = filter->GetOutputDataObject(0);
  EXPECT_EQ(Reported(output, "BadEdges"), 223.0); // around the holes
  const double all = Reported(output, "InputVolume");
  EXPECT_NEAR(common + Reported(output, "Volume"), all, 1e-12 * all);
  EXPECT_EQ(events.Warnings, 2);
}
}
