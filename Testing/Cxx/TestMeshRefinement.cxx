// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeMeshRefinement: what refined meshes are as a whole, by looking at all of their cells.

#include "Support/MeshRefinementRun.h"
#include "Support/NamedMeshes.h"
#include "Support/VolumeMeshes.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// Moves inner points of a mesh about at random, a little: no two edges are equally long.
Mesh Shaken(Mesh mesh, double by, const std::function<bool(const Point&)>& isInner)
{
  Random random(7);
  return mesh.Map(
    [&](const Point& p)
    {
      const Point to = random.InBox({ -by, by, -by, by, -by, by });
      return isInner(p) ? p + to : p;
    });
}

Mesh InUnitCube(const Mesh& mesh, int n)
{
  return Transformed(mesh, 1.0 / n, { 0, 0, 0 });
}

bool IsInnerOfFour(const Point& p)
{
  return p[0] > 0 && p[0] < 4 && p[1] > 0 && p[1] < 4 && p[2] > 0 && p[2] < 4;
}

Mesh FlatTriangles()
{
  Mesh sheet = Shaken(Sheet(5, VTK_QUAD), 0.25,
    [](const Point& p) { return p[0] > 0 && p[0] < 5 && p[1] > 0 && p[1] < 5; });
  sheet.Map([](const Point& p) { return Point{ p[0], p[1], 0 }; });
  return InUnitCube(Triangulated(sheet), 5);
}

/// Hexagons, quads and triangles together, without a gap.
Mesh Honeycomb()
{
  Mesh mesh;
  const double h = std::sqrt(3.0) / 2.0;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      const double x = 1.5 * column;
      const double y = 2.0 * h * (row + 0.5 * (column % 2));
      Ids ids;
      for (const auto& c : { Point{ 1, 0, 0 }, Point{ 0.5, h, 0 }, Point{ -0.5, h, 0 },
             Point{ -1, 0, 0 }, Point{ -0.5, -h, 0 }, Point{ 0.5, -h, 0 } })
      {
        ids.push_back(mesh.Add(
          Point{ std::round(256 * (x + c[0])) / 256, std::round(256 * (y + c[1])) / 256, 0 }));
      }
      mesh.Add(VTK_POLYGON, ids);
    }
  }
  return Transformed(Welded(mesh), 0.25, { 0.25, 0.25, 0 });
}

struct Case
{
  const char* Name;
  Mesh (*Make)();
  long Euler;
};

const Case Cases[] = {
  { "Triangles", [] { return FlatTriangles(); }, 1 },
  { "Quads", [] { return InUnitCube(Sheet(4, VTK_QUAD), 4); }, 1 },
  { "Pixels", [] { return InUnitCube(Sheet(4, VTK_PIXEL), 4); }, 1 },
  { "Hexagons", [] { return Honeycomb(); }, 1 },
  { "Torus",
    [] {
      return Transformed(TorusTriangles(12, 8), 0.35, { 0.5, 0.5, 0.2 });
    },
    0 },
  { "Cube", [] { return InUnitCube(Welded(CubeQuads(3)), 3); }, 2 },
  { "Tetrahedra", [] { return InUnitCube(Shaken(Tetrahedra(4), 0.15, &IsInnerOfFour), 4); }, 1 },
  { "Hexahedra", [] { return InUnitCube(Shaken(Hexahedra(4), 0.1, &IsInnerOfFour), 4); }, 1 },
  { "Voxels", [] { return InUnitCube(Voxels(3), 3); }, 1 },
  { "Wedges", [] { return InUnitCube(Wedges(3), 3); }, 1 },
  { "Pyramids", [] { return InUnitCube(Pyramids(3), 3); }, 1 },
};

class MeshRefinement : public testing::TestWithParam<Case>
{
public:
  static GridPointer MakeMesh() { return MakeGrid(GetParam().Make()); }
};

PolyDataPointer MakePart()
{
  return MakePolyData(Transformed(SphereTriangles(8), 0.3, { 0.6, 0.5, 0.05 }));
}

bool IsVolumeMesh(vtkDataSet* mesh)
{
  return mesh->GetCell(0)->GetCellDimension() == 3;
}

/// Faces of a warped hexahedron are no planes: the sum of volumes is that of its triangles.
double SlackOf(const std::string& name)
{
  return name == "Hexahedra" ? 1e-2 : 1e-12;
}

TEST_P(MeshRefinement, BisectionLeavesNoHangingPointAndKeepsTheWhole)
{
  GridPointer mesh = MakeMesh();
  const MeshMeasures before = MeasuresOf(mesh);
  ASSERT_EQ(before.Euler, GetParam().Euler);
  for (int levels = 1; levels <= 2; ++levels)
  {
    RefinementPointer filter = MakeRefinement(mesh, MakePart(), levels);
    vtkDataSet* refined = RunRefinement(filter);
    ASSERT_GT(refined->GetNumberOfCells(), mesh->GetNumberOfCells());
    const MeshMeasures after = MeasuresOf(refined);
    EXPECT_EQ(after.Euler, before.Euler);
    EXPECT_GT(after.Least, 0.0);
    EXPECT_NEAR(after.Sum, before.Sum, SlackOf(GetParam().Name) * before.Sum);
    EXPECT_NEAR(after.OpenMeasure, before.OpenMeasure, 1e-12 * (1 + before.OpenMeasure));
    EXPECT_EQ(after.FacesOfMany, 0);
    EXPECT_EQ(FindHangingPoints(refined, 1e-10).size(), 0u);
    EXPECT_EQ(Reported(filter, "HangingPoints"), 0);
    EXPECT_EQ(Reported(filter, "Cells"), refined->GetNumberOfCells());
  }
}

TEST_P(MeshRefinement, RegularCutsKeepTheWholeAndMarkWhatHangs)
{
  GridPointer mesh = MakeMesh();
  const MeshMeasures before = MeasuresOf(mesh);
  RefinementPointer filter = MakeRefinement(mesh, MakePart(), 2, 1);
  vtkDataSet* refined = RunRefinement(filter);
  ASSERT_GT(refined->GetNumberOfCells(), mesh->GetNumberOfCells());
  const MeshMeasures after = MeasuresOf(refined);
  EXPECT_GT(after.Least, 0.0);
  EXPECT_NEAR(after.Sum, before.Sum, SlackOf(GetParam().Name) * before.Sum);
  vtkDataArray* marks = refined->GetPointData()->GetArray("SkdHanging");
  std::set<vtkIdType> marked;
  for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
  {
    if (marks->GetTuple1(i) != 0)
    {
      marked.insert(i);
    }
  }
  EXPECT_EQ(Reported(filter, "HangingPoints"), marked.size());
  if (std::string(GetParam().Name) != "Hexahedra") // whose faces are warped: points are beside
  {
    EXPECT_EQ(marked, FindHangingPoints(refined, 1e-10));
  }
}

TEST_P(MeshRefinement, EachRegularLevelHasAFixedNumberOfParts)
{
  GridPointer mesh = MakeMesh();
  RefinementPointer filter = MakeRefinement(mesh, nullptr, 9, 1);
  filter->SetMinimumLevel(2);
  vtkDataSet* refined = RunRefinement(filter);
  const std::string name = GetParam().Name;
  const double parts = name == "Pyramids" ? 6 * 10 + 4 * 8
    : name == "Hexagons"                  ? 24
    : IsVolumeMesh(mesh)                  ? 64
                                          : 16;
  EXPECT_EQ(refined->GetNumberOfCells(), parts * mesh->GetNumberOfCells());
  EXPECT_EQ(Reported(filter, "HangingPoints"), 0);
  EXPECT_EQ(MeasuresOf(refined).Euler, GetParam().Euler);
}

/// The least level of the whole mesh is also reached where no other criterion does.
TEST_P(MeshRefinement, ALevelHalvesTheSizeOfCells)
{
  GridPointer mesh = MakeMesh();
  const double cells = static_cast<double>(mesh->GetNumberOfCells());
  RefinementPointer filter = MakeRefinement(mesh, nullptr, 9);
  filter->SetMinimumLevel(2);
  vtkDataSet* refined = RunRefinement(filter);
  const std::vector<double> levels = CellValues(refined, "SkdLevel");
  EXPECT_GE(*std::min_element(levels.begin(), levels.end()), 2);
  const double growth = static_cast<double>(refined->GetNumberOfCells()) / cells;
  EXPECT_GE(growth, IsVolumeMesh(mesh) ? 32 : 16);
  EXPECT_LE(growth, IsVolumeMesh(mesh) ? 200 : 48);
}

TEST_P(MeshRefinement, CellsThatThePartMeetsHaveTheMaximumLevel)
{
  GridPointer mesh = MakeMesh();
  for (int method : { 0, 1 })
  {
    RefinementPointer filter = MakeRefinement(mesh, MakeCurve(), 2, method);
    vtkDataSet* refined = RunRefinement(filter);
    const std::vector<double> levels = CellValues(refined, "SkdLevel");
    auto curve = MakeCurve();
    vtkNew<vtkGenericCell> cell;
    int met = 0;
    for (vtkIdType id = 0; IsVolumeMesh(mesh) && id < refined->GetNumberOfCells(); ++id)
    {
      refined->GetCell(id, cell);
      for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
      {
        double closest[3], pcoords[3], dist2, weights[8];
        int subId;
        if (cell->EvaluatePosition(curve->GetPoint(i), closest, subId, pcoords, dist2, weights) ==
          1)
        {
          EXPECT_GE(levels[static_cast<std::size_t>(id)], 2);
          ++met;
        }
      }
    }
    EXPECT_TRUE(met > 0 || !IsVolumeMesh(mesh));
  }
}

TEST_P(MeshRefinement, PointsKeepTheirIdsAndDataAreInterpolated)
{
  GridPointer mesh = WithData(MakeMesh());
  for (int method : { 0, 1 })
  {
    RefinementPointer filter = MakeRefinement(mesh, MakePart(), 2, method);
    vtkDataSet* refined = RunRefinement(filter);
    vtkDataArray* linear = refined->GetPointData()->GetArray("Linear");
    ASSERT_NE(linear, nullptr);
    for (vtkIdType i = 0; i < refined->GetNumberOfPoints(); ++i)
    {
      Point x, old;
      refined->GetPoint(i, x.data());
      EXPECT_NEAR(linear->GetTuple1(i), Linear(x), 1e-12);
      if (i < mesh->GetNumberOfPoints())
      {
        mesh->GetPoint(i, old.data());
        EXPECT_EQ(x, old);
      }
    }
    const std::vector<double> parents = CellValues(refined, "SkdParentCellId");
    const std::vector<double> numbers = CellValues(refined, "Number");
    std::vector<double> sums(static_cast<std::size_t>(mesh->GetNumberOfCells()), 0.0);
    vtkNew<vtkGenericCell> cell;
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
      EXPECT_EQ(numbers[i], 10 * parents[i]);
      refined->GetCell(static_cast<vtkIdType>(i), cell);
      sums[static_cast<std::size_t>(parents[i])] += Measure(cell);
    }
    for (std::size_t i = 0; i < sums.size() && SlackOf(GetParam().Name) < 1e-6; ++i)
    {
      mesh->GetCell(static_cast<vtkIdType>(i), cell);
      EXPECT_NEAR(sums[i], Measure(cell), 1e-12);
    }
  }
}

/// The same cells, as sets of points, whatever the numbering.
std::multiset<std::set<Point>> ShapesOf(vtkDataSet* mesh)
{
  std::multiset<std::set<Point>> shapes;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    mesh->GetCell(id, cell);
    const std::vector<Point> corners = CornersOf(cell);
    shapes.insert({ corners.begin(), corners.end() });
  }
  return shapes;
}

TEST_P(MeshRefinement, TheResultDoesNotDependOnNumbers)
{
  const Mesh mesh = GetParam().Make();
  Mesh rotated;
  const auto last = static_cast<vtkIdType>(mesh.Points.size()) - 1;
  rotated.Points.assign(mesh.Points.rbegin(), mesh.Points.rend());
  for (auto cell = mesh.Cells.rbegin(); cell != mesh.Cells.rend(); ++cell)
  {
    Ids ids;
    for (const vtkIdType id : cell->Points)
    {
      ids.push_back(last - id);
    }
    rotated.Add(cell->Type, ids);
  }
  for (int method : { 0, 1 })
  {
    RefinementPointer first = MakeRefinement(MakeGrid(mesh), MakePart(), 2, method);
    RefinementPointer second = MakeRefinement(MakeGrid(rotated), MakePart(), 2, method);
    EXPECT_EQ(ShapesOf(RunRefinement(first)), ShapesOf(RunRefinement(second))) << method;
  }
}

TEST(MeshRefinementAngles, StayAboveHalfOfTheSmallest)
{
  GridPointer mesh = MakeGrid(FlatTriangles());
  RefinementPointer filter = MakeRefinement(mesh, MakePart(), 7);
  vtkDataSet* refined = RunRefinement(filter);
  EXPECT_GT(refined->GetNumberOfCells(), 10000);
  const double before = MeasuresOf(mesh).SmallestAngle;
  const double after = MeasuresOf(refined).SmallestAngle;
  EXPECT_GE(after, 0.5 * before * (1 - 1e-9));
  EXPECT_NEAR(Reported(filter, "MinimumAngleBefore"), before, 1e-9);
  EXPECT_NEAR(Reported(filter, "MinimumAngle"), after, 1e-9);
}

/// By how many levels two cells differ at most that have so many points in common, corners of one
/// of them.
double LargestStep(vtkDataSet* mesh, int points)
{
  const std::vector<double> levels = CellValues(mesh, "SkdLevel");
  vtkNew<vtkGenericCell> a, b;
  double most = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCell(i, a);
    Bounds box;
    a->GetBounds(box.data());
    for (vtkIdType k = 0; k < mesh->GetNumberOfCells(); ++k)
    {
      mesh->GetCell(k, b);
      int shared = 0;
      for (const Point& x : CornersOf(b))
      {
        double closest[3], pcoords[3], dist2, weights[8];
        int subId;
        shared += Contains(Grown(box, 1e-10), x) &&
          a->EvaluatePosition(x.data(), closest, subId, pcoords, dist2, weights) >= 0 &&
          dist2 < 1e-20;
      }
      const double step = levels[static_cast<std::size_t>(k)] - levels[static_cast<std::size_t>(i)];
      most = shared >= points ? std::max(most, step) : most;
    }
  }
  return most;
}

TEST_P(MeshRefinement, BalanceBoundsHowLevelsDiffer)
{
  GridPointer mesh = MakeMesh();
  const bool isVolume = IsVolumeMesh(mesh);
  const std::vector<Point> corners = CornersOf(mesh->GetCell(mesh->GetNumberOfCells() / 2));
  Mesh point;
  point.Add(VTK_VERTEX, { point.Add(Lerp(Lerp(corners[0], corners[1], 0.5), corners[2], 0.3)) });
  vtkIdType last = 0;
  for (int balance = 0; balance <= 3; ++balance)
  {
    RefinementPointer filter = MakeRefinement(mesh, MakePolyData(point), isVolume ? 3 : 4, 1);
    filter->AddDistanceBand(0.0, 9); // the point may be beside the mesh
    filter->SetBalance(balance);
    vtkDataSet* refined = RunRefinement(filter);
    EXPECT_GE(refined->GetNumberOfCells(), last);
    last = refined->GetNumberOfCells();
    const int dimension = isVolume ? 3 : 2;
    const double most =
      LargestStep(refined, balance == 0 ? dimension : std::max(1, dimension + 1 - balance));
    EXPECT_TRUE(balance == 0 ? most >= 1 : most == 1) << balance << " " << most;
  }
}

INSTANTIATE_TEST_SUITE_P(All, MeshRefinement, testing::ValuesIn(Cases), NameOfMesh());

}
