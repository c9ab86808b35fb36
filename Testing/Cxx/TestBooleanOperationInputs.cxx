// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: kinds of cells, and input that is not as it should be: a result that
// is told in the class's comment, or one error and no output.

#include "Support/FilterRun.h"
#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkImageData.h"
#include "vtkStripper.h"

#include <algorithm>
#include <cmath>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

Mesh Ball()
{
  return Transformed(Outward(SphereTriangles(4)), 1.1, { 0.3, 0.2, 0.1 });
}

Mesh Block()
{
  return BoxTriangles({ -1, -1, -1 }, { 1, 1, 1 });
}

double UnionWithBlock(vtkDataObject* data)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, data);
  filter->SetSourceData(MakePolyData(Block()));
  return Measures(RunSolid(filter)).Volume;
}

double UnionWithBlock(const Mesh& mesh)
{
  return UnionWithBlock(MakePolyData(mesh));
}

/// One error, and no output.
std::string ErrorOf(const Mesh& mesh, int warnings = 0)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakePolyData(mesh));
  filter->SetSourceData(MakePolyData(Block()));
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_EQ(events.Warnings, warnings);
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), 0);
  return events.Error;
}

TEST(BooleanOperationInputs, StripsKeepTheirOrientation)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(MakePolyData(Ball()));
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  EXPECT_NEAR(UnionWithBlock(stripper->GetOutput()), UnionWithBlock(Ball()), 1e-13);
}

TEST(BooleanOperationInputs, WhatIsNoFaceIsPassedOver)
{
  const double expected = UnionWithBlock(Ball());
  Mesh mesh = Ball();
  mesh.Add(VTK_VERTEX, { mesh.Add(Point{ 5, 5, 5 }) });
  mesh.Add(VTK_LINE, { 0, 1 });
  mesh.Add(Point{ 1e30, 0, 0 });
  mesh.Add(Point{ std::nan(""), 0, 0 });
  EXPECT_NEAR(UnionWithBlock(mesh), expected, 1e-13);
}

TEST(BooleanOperationInputs, TrianglesWithoutAreaAreLeftOut)
{
  const double expected = UnionWithBlock(Ball());
  Mesh mesh = Ball();
  mesh.Add(VTK_TRIANGLE, { 0, 0, 1 });
  mesh.Add(VTK_TRIANGLE, { 3, 3, 3 });
  const vtkIdType a = mesh.Add(Point{ 5, 0, 0 });
  mesh.Add(Point{ 6, 0, 0 });
  mesh.Add(Point{ 7, 0, 0 });
  mesh.Add(VTK_TRIANGLE, { a, a + 1, a + 2 });
  mesh.Add(VTK_TRIANGLE, { a, a + 2, a + 1 });
  EXPECT_NEAR(UnionWithBlock(mesh), expected, 1e-13);
}

/// Too thin for a line along an axis through any point that there is a number for.
TEST(BooleanOperationInputs, NeedlesLaidOnEachOtherBoundNothing)
{
  Mesh mesh;
  mesh.Add(Point{ 0x1.2aaaaaaaaaaabp+1, 0x1.2aaaaaaaaaaabp+2, -0x1.5555555555555p+0 });
  mesh.Add(Point{ 0x1.5555555555555p+1, 0x1.5555555555555p+2, -0x1.5555555555555p-1 });
  mesh.Add(Point{ 0x1.2aaaaaaaaaaabp+1, 0x1.2aaaaaaaaaaabp+2, -0x1.5555555555554p+0 });
  mesh.Add(VTK_TRIANGLE, { 0, 1, 2 });
  mesh.Add(VTK_TRIANGLE, { 0, 2, 1 });
  EXPECT_NEAR(UnionWithBlock(mesh), 8.0, 1e-13);
  Append(mesh, Ball());
  EXPECT_NEAR(UnionWithBlock(mesh), UnionWithBlock(Ball()), 1e-13);
}

TEST(BooleanOperationInputs, SolidsThatContainNothing)
{
  Mesh flat = Ball();
  flat.Map([](const Point& p) { return Point{ p[0], p[1], 0.5 }; });
  EXPECT_NEAR(UnionWithBlock(flat), 8.0, 1e-13);
  Mesh canceled = Ball();
  Append(canceled, Inverted(Ball()));
  EXPECT_NEAR(UnionWithBlock(canceled), 8.0, 1e-13);
  EXPECT_NEAR(UnionWithBlock(Mesh()), 8.0, 1e-13);
}

TEST(BooleanOperationInputs, VoxelsOfAnImage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  EXPECT_NEAR(UnionWithBlock(image), 15.0, 1e-13);
}

TEST(BooleanOperationInputs, OpenSurfacesAreAnError)
{
  Mesh open = Ball();
  open.Cells.pop_back();
  EXPECT_NE(ErrorOf(open).find("3 edges are open"), std::string::npos);
  Mesh rotated = Ball();
  std::swap(rotated.Cells[7].Points[0], rotated.Cells[7].Points[1]);
  const std::string ofTurned = ErrorOf(rotated);
  EXPECT_NE(
    ofTurned.find("0 edges are open and 3 are between faces of opposite"), std::string::npos)
    << ofTurned;
  EXPECT_EQ(ofTurned.find("holes"), std::string::npos) << ofTurned;
  Mesh endless = Ball();
  endless.Points[5][1] = std::numeric_limits<double>::infinity();
  EXPECT_NE(ErrorOf(endless, 1).find("not a closed"), std::string::npos);
}

/// The volume of a union, in units of `scale`, which may be out of range to the third power.
double UnionInUnitsOf(double scale, const Mesh& a, const Mesh& b)
{
  const auto scaled = [scale](const Mesh& mesh) { return Transformed(mesh, scale, { 0, 0, 0 }); };
  Mesh result = Combine(scaled(a), scaled(b), 0);
  result.Map([scale](const Point& p) { return Point{ p[0] / scale, p[1] / scale, p[2] / scale }; });
  return Measures(result).Volume;
}

TEST(BooleanOperationInputs, AnyMagnitude)
{
  for (const double scale : { 1e-300, 1e-160, 1e-90, 1e-30, 1e30, 1e90, 1e160, 1e300 })
  {
    EXPECT_NEAR(UnionInUnitsOf(scale, Ball(), Block()), UnionWithBlock(Ball()), 1e-12) << scale;
  }
}

/// Beyond what exact signs have room for: one warning, which tells that, and what is large is
/// right.
TEST(BooleanOperationInputs, WhatIsTooSmallBesideTheLargestIsLeftOutWithAWarning)
{
  for (const double scale : { 1e60, 1e100, 1e150, 1e300 })
  {
    vtkNew<Filter> filter;
    filter->SetInputData(MakePolyData(Ball()));
    filter->SetSourceData(MakePolyData(Transformed(Block(), scale, { 3 * scale, 0, 0 })));
    EventCounter events(filter);
    filter->Update();
    EXPECT_EQ(events.Errors, 0) << events.Error;
    const bool isBeyond = scale > 1e79;
    EXPECT_EQ(events.Warnings, isBeyond ? 1 : 0) << events.Warning;
    EXPECT_EQ(events.Warning.find("1e-80 times the largest") != std::string::npos, isBeyond);
    const auto cells = static_cast<vtkIdType>(Block().Cells.size());
    EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL),
      isBeyond ? cells : cells + static_cast<vtkIdType>(Ball().Cells.size()));
  }
}

/// A body that is small beside others, but within the range of exact signs, is not lost.
TEST(BooleanOperationInputs, SizesMayDifferByManyOrders)
{
  for (const double scale : { 1e8, 1e12, 1e16, 1e40 })
  {
    const Mesh large = Transformed(Block(), scale, { 3 * scale, 0, 0 });
    const Mesh both = Combine(Ball(), large, 0);
    EXPECT_EQ(both.Cells.size(), Ball().Cells.size() + Block().Cells.size()) << scale;
    EXPECT_EQ(Combine(Ball(), large, 1).Cells.size(), 0u) << scale;
  }
}

/// What two small bodies are together does not depend on a large one elsewhere: its rounding is not
/// theirs.
TEST(BooleanOperationInputs, SmallBodiesAreCombinedAsWithoutALargeOne)
{
  Mesh turned = Block();
  turned.Map(Rotated);
  const Mesh other = Transformed(turned, 0.7, { 0.9, 0.4, 0.3 });
  for (const double scale : { 1e11, 1e13, 1e15, 1e18, 1e60 })
  {
    const Mesh large = Transformed(Block(), scale, { 3 * scale, 3 * scale, 3 * scale });
    Mesh both = turned;
    Append(both, large);
    for (const auto operation : { Filter::UNION, Filter::INTERSECTION })
    {
      const Mesh alone = Combine(turned, other, operation);
      Mesh beside = Combine(both, other, operation);
      const std::size_t rest = operation == Filter::UNION ? large.Cells.size() : 0;
      ASSERT_EQ(beside.Cells.size(), alone.Cells.size() + rest) << scale;
      const auto isOfLarge = [&](const CellSpec& cell)
      { return std::abs(beside.Points[static_cast<std::size_t>(cell.Points[0])][0]) > 100.0; };
      beside.Cells.erase(
        std::remove_if(beside.Cells.begin(), beside.Cells.end(), isOfLarge), beside.Cells.end());
      EXPECT_DOUBLE_EQ(Measures(beside).Volume, Measures(alone).Volume) << scale;
    }
  }
}

TEST(BooleanOperationInputs, AnAbortWhileSurfacesAreSplitLeavesNothing)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, MakePolyData(Outward(SphereTriangles(40))));
  filter->SetSourceData(
    MakePolyData(Transformed(Outward(SphereTriangles(37)), 1.0, { 0.5, 0.3, 0.1 })));
  const std::vector<double> found = AbortAt(filter, 0.65);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  const auto isLate = [](double progress) { return progress > 0.7 && progress < 1.0; };
  EXPECT_TRUE(std::none_of(found.begin(), found.end(), isLate));
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), 0);
  EXPECT_GT(Measures(RunSolid(filter)).Volume, 5.0);
}

/// At any time an abort leaves nothing, or all, and what is cached by then is right; also while a
/// Source is moved.
TEST(BooleanOperationInputs, AnAbortAtAnyTimeLeavesNothingOrAll)
{
  const Mesh body = Outward(SphereTriangles(16));
  const Mesh tool = Transformed(Outward(SphereTriangles(13)), 1.0, { 0.4, 0.3, 0.1 });
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, MakePolyData(body));
  filter->SetSourceData(MakePolyData(tool));
  int aborted = 0;
  for (int step = 0; step < 12; ++step)
  {
    const double shift = 0.03125 * step;
    filter->SetTranslation(shift, 0, 0);
    const std::vector<double> found = AbortAt(filter, 0.1 * (step + 1) - 0.05);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end())) << step;
    const vtkIdType left = filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL);
    const Mesh all = RunSolid(filter);
    EXPECT_TRUE(left == 0 || left == static_cast<vtkIdType>(all.Cells.size())) << step;
    aborted += left == 0;
    vtkNew<Filter> other;
    other->SetInputDataObject(0, MakePolyData(body));
    other->SetSourceData(MakePolyData(tool));
    other->SetTranslation(shift, 0, 0);
    EXPECT_EQ(all.Points, RunSolid(other).Points) << step;
  }
  EXPECT_GT(aborted, 4);
}
}
