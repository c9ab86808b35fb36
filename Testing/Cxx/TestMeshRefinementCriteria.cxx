// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeMeshRefinement: the criteria, each cell examined; and where new points go.

#include "Support/BruteForce.h"
#include "Support/ClosestPointRun.h"
#include "Support/MeshRefinementRun.h"
#include "Support/NamedMeshes.h"

#include "vtkMultiBlockDataSet.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

PolyDataPointer MakeSheet(int n)
{
  return MakePolyData(Transformed(Triangulated(Sheet(n, VTK_QUAD)), 1.0 / n, { 0, 0, 0 }));
}

PolyDataPointer MakeBall(double radius, const Point& centre)
{
  return MakePolyData(Transformed(SphereTriangles(16), radius, centre));
}

/// Calls visit(cell, level) for all cells.
template <typename Visit>
void ForEachCell(vtkDataSet* mesh, const Visit& visit)
{
  const std::vector<double> levels = CellValues(mesh, "SkdLevel");
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    mesh->GetCell(id, cell);
    visit(cell, static_cast<int>(levels[static_cast<std::size_t>(id)]));
  }
}

Point MiddleOf(vtkCell* cell)
{
  Point middle{ 0, 0, 0 };
  const std::vector<Point> corners = CornersOf(cell);
  for (const Point& corner : corners)
  {
    middle = middle + (1.0 / static_cast<double>(corners.size())) * corner;
  }
  return middle;
}

/// Whether a triangle of a flat sheet meets a tilted flat triangle, both large: by where the edges
/// of each cross the other's plane. Independent of the filter's own test.
bool Crosses(const std::vector<Point>& a, const std::vector<Point>& b)
{
  const auto meets = [](const Point& p, const Point& q, const std::vector<Point>& t)
  {
    const Point normal = AreaVector(t);
    const double high = Dot(normal, p - t[0]);
    const double low = Dot(normal, q - t[0]);
    if (high * low > 0 || high == low)
    {
      return false;
    }
    const Point x = Lerp(p, q, high / (high - low));
    for (int i = 0; i < 3; ++i)
    {
      if (Dot(Cross(t[(i + 1) % 3] - t[i], x - t[i]), normal) < 0)
      {
        return false;
      }
    }
    return true;
  };
  for (int i = 0; i < 3; ++i)
  {
    if (meets(a[i], a[(i + 1) % 3], b) || meets(b[i], b[(i + 1) % 3], a))
    {
      return true;
    }
  }
  return false;
}

TEST(MeshRefinementCriteria, ACellIsRefinedExactlyWhereAPartMeetsIt)
{
  Mesh one;
  one.Add(VTK_TRIANGLE,
    { one.Add(Point{ 0.1, 0.13, -0.31 }), one.Add(Point{ 0.83, 0.27, 0.42 }),
      one.Add(Point{ 0.37, 0.91, 0.29 }) });
  auto sheet = MakeSheet(6);
  RefinementPointer filter = MakeRefinement(sheet, MakePolyData(one), 5, 1);
  vtkDataSet* refined = RunRefinement(filter);
  int met = 0;
  ForEachCell(refined,
    [&](vtkCell* cell, int level)
    {
      if (Crosses(CornersOf(cell), one.Points))
      {
        EXPECT_EQ(level, 5);
        ++met;
      }
    });
  EXPECT_GT(met, 50);
  // Each cell that is refined is met itself: the parent of each part of the last level.
  const vtkIdType fine = refined->GetNumberOfCells();
  filter->SetMaximumLevel(4);
  vtkDataSet* coarse = RunRefinement(filter);
  vtkIdType refinedAgain = 0;
  ForEachCell(coarse,
    [&](vtkCell* cell, int level)
    { refinedAgain += level == 4 && Crosses(CornersOf(cell), one.Points); });
  EXPECT_EQ(coarse->GetNumberOfCells() + 3 * refinedAgain, fine);
}

TEST(MeshRefinementCriteria, BlindRefinesMore)
{
  Mesh one;
  one.Add(VTK_TRIANGLE,
    { one.Add(Point{ 0.1, 0.13, -0.31 }), one.Add(Point{ 0.83, 0.27, 0.42 }),
      one.Add(Point{ 0.37, 0.91, 0.29 }) });
  RefinementPointer filter = MakeRefinement(MakeSheet(6), MakePolyData(one), 4);
  const vtkIdType exact = RunRefinement(filter)->GetNumberOfCells();
  filter->SetOverlapTest(vtkSkdTreeMeshRefinement::BLIND);
  EXPECT_GT(RunRefinement(filter)->GetNumberOfCells(), exact);
}

TEST(MeshRefinementCriteria, AVolumeCellThatHoldsOrIsHeldIsMet)
{
  auto grid = MakeGrid(Transformed(Tetrahedra(2), 0.5, { 0, 0, 0 }));
  RefinementPointer within = MakeRefinement(grid, MakeBall(0.02, { 0.31, 0.13, 0.22 }), 1, 1);
  EXPECT_EQ(RunRefinement(within)->GetNumberOfCells(), grid->GetNumberOfCells() + 7);
  auto around = MakeGrid(Transformed(Hexahedra(1), 9.0, { -4, -4, -4 }));
  RefinementPointer inside = MakeRefinement(grid, around, 1, 1);
  EXPECT_EQ(RunRefinement(inside)->GetNumberOfCells(), 8 * grid->GetNumberOfCells());
}

TEST(MeshRefinementCriteria, PartsOfAllKindsAreMet)
{
  for (const NamedMesh& mesh : AllMeshes())
  {
    DataSetPointer part = mesh.Make();
    Bounds box;
    part->GetBounds(box.data());
    const double size = 1.1 * Diagonal(box);
    const Point low{ box[0] - 0.03 * size, box[2] - 0.03 * size, box[4] - 0.03 * size };
    RefinementPointer filter =
      MakeRefinement(MakeGrid(Transformed(Tetrahedra(3), size / 3, low)), part, 1, 1);
    EventCounter events(filter);
    vtkDataSet* refined = RunRefinement(filter);
    EXPECT_EQ(events.Errors, 0);
    BruteForce reference(part);
    // Cells that are not refined have no part in their middle.
    ForEachCell(refined,
      [&](vtkCell* cell, int level)
      {
        if (level == 0)
        {
          EXPECT_GT(reference.FindNearest(MiddleOf(cell)).Distance, 0.0) << mesh.Name;
        }
      });
    EXPECT_GT(refined->GetNumberOfCells(), 6 * 27) << mesh.Name;
  }
}

TEST(MeshRefinementCriteria, DistanceBandsCoverAllThatIsNearer)
{
  auto ball = MakeBall(0.2, { 0.5, 0.5, 0.35 });
  BruteForce reference(ball);
  for (int method : { 0, 1 })
  {
    RefinementPointer filter = MakeRefinement(MakeSheet(4), ball, 5, method);
    filter->AddDistanceBand(0.2, 4);
    filter->AddDistanceBand(0.35, 2);
    vtkDataSet* refined = RunRefinement(filter);
    int found[2] = { 0, 0 };
    ForEachCell(refined,
      [&](vtkCell* cell, int level)
      {
        const double distance = reference.FindNearest(MiddleOf(cell)).Distance;
        EXPECT_GE(level, distance <= 0.2 ? 4 : distance <= 0.35 ? 2 : 0);
        ++found[level >= 4];
      });
    EXPECT_TRUE(found[0] > 10 && found[1] > 10);
  }
}

TEST(MeshRefinementCriteria, PartsHaveLevelsAndInsidesOfTheirOwn)
{
  auto blocks = MakeBlocks({ MakeBall(0.2, { 0.25, 0.25, 0 }), MakeBall(0.2, { 0.75, 0.75, 0 }) });
  RefinementPointer filter = MakeRefinement(MakeSheet(8), blocks, 4, 1);
  filter->AddPartLevel(1, 1);
  filter->SetInsideLevel(2);
  vtkDataSet* refined = RunRefinement(filter);
  int inside = 0;
  ForEachCell(refined,
    [&](vtkCell* cell, int level)
    {
      const Point middle = MiddleOf(cell);
      const bool isInFirst = Distance(middle, { 0.25, 0.25, 0 }) < 0.19;
      const bool isInSecond = Distance(middle, { 0.75, 0.75, 0 }) < 0.19;
      EXPECT_GE(level, isInFirst || isInSecond ? 2 : 0);
      EXPECT_LE(level, middle[0] + middle[1] < 0.9 ? 2 : 4);
      inside += isInFirst || isInSecond;
    });
  EXPECT_GT(inside, 100);
  EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
}

bool Holds(vtkCell* cell, const Point& x)
{
  double closest[3], pcoords[3], dist2, weights[8];
  int subId;
  return cell->EvaluatePosition(x.data(), closest, subId, pcoords, dist2, weights) == 1;
}

/// The sheet cuts an upright box in a square: bent are its corners.
TEST(MeshRefinementCriteria, WhereAPartIsFlatTheMinimumSurfaceLevelIsEnough)
{
  auto box = MakePolyData(Transformed(CubeTriangles(2), 0.26, { 0.21, 0.19, -0.3 }));
  const Point corners[] = { { 0.21, 0.19, 0 }, { 0.73, 0.19, 0 }, { 0.73, 0.71, 0 },
    { 0.21, 0.71, 0 } };
  for (int method : { 0, 1 })
  {
    RefinementPointer filter = MakeRefinement(MakeSheet(4), box, 6, method);
    const vtkIdType all = RunRefinement(filter)->GetNumberOfCells();
    filter->RefineByNormalDeviationOn();
    filter->SetNormalDeviation(20.0);
    filter->SetMinimumSurfaceLevel(2);
    vtkDataSet* refined = RunRefinement(filter);
    EXPECT_LT(3 * refined->GetNumberOfCells(), all);
    int found[2] = { 0, 0 };
    ForEachCell(refined,
      [&](vtkCell* cell, int level)
      {
        double away = 1.0;
        for (int i = 0; i < 4; ++i)
        {
          const bool isAtCorner = Holds(cell, corners[i]);
          const bool isOnSide = Holds(cell, Lerp(corners[i], corners[(i + 1) % 4], 0.49));
          EXPECT_TRUE(!isAtCorner || level >= 6) << level;
          EXPECT_TRUE(!isOnSide || level >= 2) << level;
          found[0] += isAtCorner;
          found[1] += isOnSide;
          away = std::min(away, Distance(MiddleOf(cell), corners[i]));
        }
        EXPECT_TRUE(away < 0.2 || level <= 2 + (method == 0)) << level;
      });
    EXPECT_TRUE(found[0] >= 4 && found[1] >= 4);
  }
}

TEST(MeshRefinementCriteria, LayersGrowAroundWhatIsRefined)
{
  const Point x{ 0.61, 0.37, 0.0 };
  Mesh point;
  point.Add(VTK_VERTEX, { point.Add(x) });
  for (int method : { 0, 1 })
  {
    vtkIdType last = 0;
    for (int layers = 0; layers <= 2; ++layers)
    {
      RefinementPointer filter = MakeRefinement(MakeSheet(4), MakePolyData(point), 4, method);
      filter->SetGrowingLayers(layers);
      vtkDataSet* refined = RunRefinement(filter);
      EXPECT_GT(refined->GetNumberOfCells(), last);
      last = refined->GetNumberOfCells();
      const double side = 0.25 / 8; // of the cells that were cut last
      ForEachCell(refined,
        [&](vtkCell* cell, int level)
        {
          const Point middle = MiddleOf(cell);
          const double away = std::max(std::abs(middle[0] - x[0]), std::abs(middle[1] - x[1]));
          EXPECT_TRUE(away > 0.45 * layers * side || level >= 4) << away / side;
          EXPECT_TRUE(away < (layers + 4.0) * 2 * side || level < 4) << away / side;
        });
      EXPECT_NEAR(MeasuresOf(refined).Sum, 1.0, 1e-12);
      EXPECT_TRUE(method == 1 || FindHangingPoints(refined, 1e-10).empty());
    }
  }
}

/// A field on the sheet that jumps at x = 0.4.
PolyDataPointer MakeStep(int n)
{
  auto sheet = MakeSheet(n);
  sheet->GetPointData()->AddArray(MakeArray("Height", sheet->GetNumberOfPoints(),
    [&](vtkIdType i) { return sheet->GetPoint(i)[0] > 0.4 ? 5.0 : 1.0; }));
  sheet->GetCellData()->AddArray(MakeArray("Row", sheet->GetNumberOfCells(),
    [&](vtkIdType i) { return MiddleOf(sheet->GetCell(i))[0] > 0.4 ? 5.0 : 1.0; }));
  return sheet;
}

TEST(MeshRefinementCriteria, AFieldAsksWhereItVariesIsSteepOrOfInterest)
{
  // The field lies on a finer sheet that is a little above.
  auto field = MakeStep(64);
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    const double* x = field->GetPoint(i);
    field->GetPoints()->SetPoint(i, x[0], x[1], 0.001);
  }
  for (const char* name : { "Height", "Row" })
  {
    for (int test = 0; test < 3; ++test)
    {
      RefinementPointer filter = MakeRefinement(MakeSheet(4), nullptr, 3, 1);
      filter->SetFieldData(field);
      filter->AddFieldArray(name);
      filter->SetFieldTest(test);
      filter->SetFieldThreshold(test == 1 ? 100 : 2);
      filter->SetFieldRange(4, 6);
      EventCounter events(filter);
      vtkDataSet* refined = RunRefinement(filter);
      if (std::string(name) == "Row" && test == 1)
      {
        EXPECT_EQ(events.Warnings, 1); // gradients are of point data
        continue;
      }
      int fine = 0;
      ForEachCell(refined,
        [&](vtkCell* cell, int level)
        {
          Bounds box;
          cell->GetBounds(box.data());
          const bool isAtStep = box[0] < 0.4 - 1.0 / 64 && box[1] > 0.4 + 1.0 / 64;
          const bool isHigh = box[0] > 0.43;
          const bool isLow = box[1] < 0.36;
          EXPECT_TRUE(!isAtStep || level == 3) << name << test;
          EXPECT_TRUE(!isHigh || test == 2 || level < 3 || box[0] < 0.6) << name << test;
          EXPECT_TRUE(!isHigh || test != 2 || level == 3) << name << test;
          EXPECT_TRUE(!isLow || level < 3 || box[1] > 0.3) << name << test;
          fine += level == 3;
        });
      EXPECT_GT(fine, 50) << name << test;
    }
  }
}

TEST(MeshRefinementCriteria, WithoutAFieldTheInputsOwnArraysAsk)
{
  auto sheet = MakeStep(8);
  RefinementPointer filter = MakeRefinement(sheet, nullptr, 2);
  filter->AddFieldArray("Height");
  filter->SetFieldThreshold(1.5);
  vtkDataSet* refined = RunRefinement(filter);
  EXPECT_GT(refined->GetNumberOfCells(), sheet->GetNumberOfCells() + 50);
}

//------------------------------------------------------------------------------
TEST(MeshRefinementPlacement, OnASpherePointsStayOnTheSphere)
{
  const Point centre{ 3, -2, 1 };
  for (int method : { 0, 1 })
  {
    auto ball = MakePolyData(Transformed(Octahedron(1), 1, centre));
    RefinementPointer filter = MakeRefinement(ball, nullptr, 4, method);
    filter->SetMinimumLevel(4);
    filter->SetPointPlacement(vtkSkdTreeMeshRefinement::SPHERE);
    filter->SetSphereCenter(3, -2, 1);
    vtkDataSet* refined = RunRefinement(filter);
    for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    {
      Point x;
      refined->GetPoint(i, x.data());
      EXPECT_NEAR(Distance(x, centre), 1.0, 1e-14);
    }
    const MeshMeasures measures = MeasuresOf(refined);
    EXPECT_EQ(measures.Euler, 2);
    EXPECT_GT(measures.Sum, 0.99 * 16 * std::atan(1));
    EXPECT_GT(measures.Least, 0);
  }
}

TEST(MeshRefinementPlacement, OnASurfacePointsAreWhereItIsNearest)
{
  auto surface = MakePolyData(Transformed(SphereTriangles(40), 1.0, { 0, 0, 0 }));
  BruteForce reference(surface);
  auto cube = MakePolyData(Transformed(Welded(CubeQuads(2)), 0.55, { -0.55, -0.55, -0.55 }));
  RefinementPointer filter = MakeRefinement(cube, nullptr, 2);
  filter->SetMinimumLevel(2);
  filter->SetSurfaceData(surface);
  filter->SetPointPlacement(vtkSkdTreeMeshRefinement::SURFACE);
  vtkDataSet* refined = RunRefinement(filter);
  for (vtkIdType i = cube->GetNumberOfPoints(); i < refined->GetNumberOfPoints(); ++i)
  {
    Point x;
    refined->GetPoint(i, x.data());
    EXPECT_NEAR(reference.FindNearest(x).Distance, 0.0, 1e-14);
  }
}

TEST(MeshRefinementPlacement, OfVolumesOnlyTheBorderIsPutOnTheSurface)
{
  auto surface = MakePolyData(Transformed(SphereTriangles(40), 1.0, { 0, 0, 0 }));
  BruteForce reference(surface);
  for (const Mesh& mesh : { Tetrahedra(2), Hexahedra(2), Wedges(2), Pyramids(2) })
  {
    for (int method : { 0, 1 })
    {
      auto grid = MakeGrid(Transformed(mesh, 0.6, { -0.6, -0.6, -0.6 }));
      RefinementPointer filter = MakeRefinement(grid, nullptr, 2, method);
      filter->SetMinimumLevel(2);
      filter->SetSurfaceData(surface);
      filter->SetPointPlacement(vtkSkdTreeMeshRefinement::SURFACE);
      filter->Update();
      vtkDataSet* placed = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      RefinementPointer flat = MakeRefinement(grid, nullptr, 2, method);
      flat->SetMinimumLevel(2);
      vtkDataSet* before = RunRefinement(flat);
      ASSERT_EQ(before->GetNumberOfPoints(), placed->GetNumberOfPoints());
      int moved = 0;
      for (vtkIdType i = grid->GetNumberOfPoints(); i < placed->GetNumberOfPoints(); ++i)
      {
        Point x, old;
        before->GetPoint(i, old.data());
        placed->GetPoint(i, x.data());
        const double depth = std::max({ std::abs(old[0]), std::abs(old[1]), std::abs(old[2]) });
        const bool isOfBorder = depth > 0.6 - 1e-12;
        const double distance = reference.FindNearest(x).Distance;
        EXPECT_TRUE(isOfBorder ? distance < 1e-14 : distance > 1e-3) << distance;
        moved += isOfBorder;
      }
      EXPECT_GT(moved, 20);
    }
  }
}

TEST(MeshRefinementPlacement, WithoutASurfacePointsStayAndAWarningSaysSo)
{
  RefinementPointer filter = MakeRefinement(MakeSheet(2), nullptr, 1);
  filter->SetMinimumLevel(1);
  filter->SetPointPlacement(vtkSkdTreeMeshRefinement::SURFACE);
  EventCounter events(filter);
  const MeshMeasures measures = MeasuresOf(RunRefinement(filter));
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("no surface"), std::string::npos);
  EXPECT_NEAR(measures.Sum, 1.0, 1e-14);
}

}
