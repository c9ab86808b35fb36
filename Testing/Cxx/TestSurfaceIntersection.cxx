// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeSurfaceIntersection: pairs, curves and overlaps.

#include "Support/SurfaceIntersectionRun.h"

#include "Core/Geometry/Intersection/TriangleContact.h"
#include "Support/Folders.h"
#include "Support/NamedMeshes.h"
#include "Support/RealMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/TestAmount.h"

#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <set>

using namespace skdtest;

namespace
{

using Triangle = std::array<skd::Vector3, 3>;
using CellIdPairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

Triangle TriangleOf(const Mesh& mesh, std::size_t cell)
{
  Triangle corners;
  for (int i = 0; i < 3; ++i)
  {
    const Point& p = mesh.Points[mesh.Cells[cell].Points[i]];
    corners[i] = { { p[0], p[1], p[2] } };
  }
  return corners;
}

int CountShared(const Triangle& a, const Triangle& b)
{
  int count = 0;
  for (const skd::Vector3& x : a)
  {
    count += static_cast<int>(std::count(b.begin(), b.end(), x));
  }
  return count;
}

CellIdPairs BruteForce(const Mesh& first, const Mesh& second)
{
  CellIdPairs pairs;
  for (std::size_t i = 0; i < first.Cells.size(); ++i)
  {
    for (std::size_t k = 0; k < second.Cells.size(); ++k)
    {
      if (skd::FindContact(TriangleOf(first, i), TriangleOf(second, k)).Count > 0)
      {
        pairs.emplace_back(i, k);
      }
    }
  }
  return pairs;
}

CellIdPairs BruteForce(const Mesh& mesh)
{
  CellIdPairs pairs;
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    for (std::size_t k = i + 1; k < mesh.Cells.size(); ++k)
    {
      const Triangle a = TriangleOf(mesh, i);
      const Triangle b = TriangleOf(mesh, k);
      const int shared = CountShared(a, b);
      if (shared == 3 || skd::FindContact(a, b).Count > shared)
      {
        pairs.emplace_back(i, k);
      }
    }
  }
  return pairs;
}

class LatticePairs : public testing::TestWithParam<int>
{
};

TEST_P(LatticePairs, OfTwoSurfacesAreThoseOfBruteForce)
{
  const Mesh first = LatticeTriangles(150, GetParam(), 1);
  const Mesh second = LatticeTriangles(120, GetParam(), 2);
  auto filter = MakeIntersection(MakePolyData(first), MakePolyData(second));
  const CellIdPairs expected = BruteForce(first, second);
  EXPECT_EQ(RunCellPairs(filter), expected);
  EXPECT_GT(expected.size(), 100u);
}

TEST_P(LatticePairs, WithinOneSurfaceAreThoseOfBruteForce)
{
  const Mesh mesh = LatticeTriangles(200, GetParam(), 3);
  const CellIdPairs expected = BruteForce(mesh);
  EXPECT_EQ(RunCellPairs(MakeIntersection(MakePolyData(mesh))), expected);
  EXPECT_EQ(RunCellPairs(MakeIntersection(MakePolyData(Welded(mesh)))), expected);
  EXPECT_GT(expected.size(), 100u);
}

TEST_P(LatticePairs, AreTheSameFarAwayTinyAndHuge)
{
  const Mesh first = LatticeTriangles(100, GetParam(), 4);
  const Mesh second = LatticeTriangles(100, GetParam(), 5);
  const CellIdPairs expected = BruteForce(first, second);
  const double far = std::ldexp(1.0, 40);
  for (const double factor : { 1.0, std::ldexp(1.0, -900), std::ldexp(1.0, 900) })
  {
    for (const Point& offset : { Point{ 0, 0, 0 }, Point{ far * factor, -far * factor, 0 } })
    {
      auto filter = MakeIntersection(MakePolyData(Transformed(first, factor, offset)),
        MakePolyData(Transformed(second, factor, offset)));
      EXPECT_EQ(RunCellPairs(filter), expected) << factor << " " << offset[0];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Reaches, LatticePairs, testing::Values(2, 4, 8));

TEST(SurfaceIntersection, RandomPairsAreThoseOfBruteForce)
{
  const Mesh first = TriangleSoup(300, 0.2);
  const Mesh second = Transformed(TriangleSoup(300, 0.1), 1.0, { 0.01, 0.02, 0.03 });
  EXPECT_EQ(RunCellPairs(MakeIntersection(MakePolyData(first), MakePolyData(second))),
    BruteForce(first, second));
  EXPECT_EQ(RunCellPairs(MakeIntersection(MakePolyData(first))), BruteForce(first));
}

// Two spheres of radius 1 whose centres are 1 apart meet in a circle of radius sqrt(3) / 2.
TEST(SurfaceIntersection, TwoSpheresMeetInOneClosedCurve)
{
  const Mesh sphere = SphereTriangles(24);
  auto filter = MakeIntersection(
    MakePolyData(sphere), MakePolyData(Transformed(sphere, 1.0, { 0.31, 0.67, 0.6745 })));
  filter->Update();
  vtkPolyData* curves = OutputOf(filter, 0);
  ASSERT_EQ(curves->GetNumberOfLines(), 1);
  EXPECT_EQ(curves->GetNumberOfVerts(), 0);
  EXPECT_EQ(curves->GetCellData()->GetArray("SkdCurveClosed")->GetTuple1(0), 1.0);
  const double length = curves->GetCellData()->GetArray("SkdCurveLength")->GetTuple1(0);
  const double radius = std::sqrt(1.0 - 0.25 * (0.31 * 0.31 + 0.67 * 0.67 + 0.6745 * 0.6745));
  EXPECT_NEAR(length, 2.0 * vtkMath::Pi() * radius, 0.02);
  EXPECT_NEAR(length, LengthOfCurves(curves), 1e-12);
  EXPECT_EQ(OutputOf(filter, 1)->GetNumberOfCells(), 0);
  EXPECT_EQ(Reported(filter, "Curves"), 1.0);
}

TEST(SurfaceIntersection, CurvesAreOnBothOfTheirCells)
{
  const Mesh first = SphereTriangles(8);
  const Mesh second = Transformed(SphereTriangles(7), 0.9, { 0.3, 0.4, 0.5 });
  auto filter = MakeIntersection(MakePolyData(first), MakePolyData(second));
  filter->Update();
  const auto segments = SegmentsOf(OutputOf(filter, 0));
  EXPECT_GT(segments.size(), 20u);
  const auto miss = [](const Mesh& mesh, vtkIdType cell, const Point& x)
  {
    const auto& ids = mesh.Cells[cell].Points;
    const Point normal =
      Cross(mesh.Points[ids[1]] - mesh.Points[ids[0]], mesh.Points[ids[2]] - mesh.Points[ids[0]]);
    return std::abs(Dot(normal, x - mesh.Points[ids[0]])) / Length(normal);
  };
  for (const auto& [p, q, a, b] : segments)
  {
    for (const Point& x : { p, q })
    {
      EXPECT_LT(miss(first, a, x), 1e-15);
      EXPECT_LT(miss(second, b, x), 1e-15);
    }
  }
}

TEST(SurfaceIntersection, JoinedOrNotTheSegmentsAreTheSame)
{
  const Mesh mesh = LatticeTriangles(60, 6, 9);
  auto filter = MakeIntersection(MakePolyData(mesh));
  filter->Update();
  const auto joined = SegmentsOf(OutputOf(filter, 0));
  EXPECT_LT(OutputOf(filter, 0)->GetNumberOfLines(), static_cast<vtkIdType>(joined.size()));
  filter->JoinCurvesOff();
  filter->Update();
  EXPECT_EQ(SegmentsOf(OutputOf(filter, 0)), joined);
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfLines(), static_cast<vtkIdType>(joined.size()));
}

// A fold of two triangles, its ridge straight through a quad: one segment on each side of the
// diagonal, and each only once though both triangles meet the quad there.
TEST(SurfaceIntersection, AnEdgeInAFaceIsThereOnce)
{
  Mesh ridge;
  ridge.Points = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, -1, 1 }, { 0, 1, 1 } };
  ridge.Add(VTK_TRIANGLE, { 0, 1, 2 });
  ridge.Add(VTK_TRIANGLE, { 0, 1, 3 });
  auto filter = MakeIntersection(MakePolyData(ridge), MakePolyData(Square(-2, -3, 7)));
  filter->Update();
  EXPECT_DOUBLE_EQ(LengthOfCurves(OutputOf(filter, 0)), 2.0);
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfLines(), 1);
  EXPECT_EQ(RunCellPairs(filter), (CellIdPairs{ { 0, 0 }, { 1, 0 } }));
}

TEST(SurfaceIntersection, ATipThatTouchesIsAVertex)
{
  const Mesh tip = Transformed(Octahedron(1.0), 1.0, { 0.25, 0.5, 1.0 });
  auto filter = MakeIntersection(MakePolyData(tip), MakePolyData(Square(-2, -3, 7)));
  for (const CellPair& pair : RunPairs(filter))
  {
    EXPECT_EQ(pair.Contact, 1);
    EXPECT_EQ(pair.FirstPoint, (Point{ 0.25, 0.5, 0.0 }));
  }
  EXPECT_EQ(PairsOf(filter).size(), 4u);
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfVerts(), 1);
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfLines(), 0);
}

TEST(SurfaceIntersection, SquaresOfOnePlaneOverlap)
{
  auto filter = MakeIntersection(MakePolyData(Square(0, 0, 1)), MakePolyData(Square(0.5, 0.25, 1)));
  EXPECT_EQ(RunCellPairs(filter), (CellIdPairs{ { 0, 0 } }));
  EXPECT_EQ(PairsOf(filter)[0].Contact, 3);
  EXPECT_DOUBLE_EQ(AreaOfPolygons(OutputOf(filter, 1)), 0.5 * 0.75);
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfCells(), 0);
}

TEST(SurfaceIntersection, ACubeOnATableTouchesWithItsFloor)
{
  auto cube = MakePolyData(Transformed(CubeQuads(3), 1.0, { 0.5, 0.25, 0.0 }));
  auto filter = MakeIntersection(cube, MakePolyData(Square(-2, -3, 7)));
  filter->Update();
  EXPECT_DOUBLE_EQ(AreaOfPolygons(OutputOf(filter, 1)), 9.0);
  EXPECT_DOUBLE_EQ(LengthOfCurves(OutputOf(filter, 0)), 12.0);
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfLines(), 1) << "the walls meet the table in a ring";
}

TEST(SurfaceIntersection, ASurfaceOverlapsItsCopyEverywhere)
{
  auto sphere = MakePolyData(SphereTriangles(6));
  auto filter = MakeIntersection(sphere, sphere);
  CellIdPairs same;
  for (const CellPair& pair : RunPairs(filter))
  {
    if (pair.Contact == 3)
    {
      same.push_back(pair.Cells());
      EXPECT_EQ(pair.First, pair.Second);
    }
  }
  EXPECT_EQ(static_cast<vtkIdType>(same.size()), sphere->GetNumberOfCells());
  EXPECT_DOUBLE_EQ(AreaOfPolygons(OutputOf(filter, 1)), AreaOfPolygons(sphere));
  EXPECT_EQ(OutputOf(filter, 0)->GetNumberOfCells(), 0) << "edges inside of the overlap";
}

class SoundSurface : public testing::TestWithParam<NamedMesh>
{
};

TEST_P(SoundSurface, DoesNotMeetItself)
{
  EXPECT_EQ(RunPairs(MakeIntersection(GetParam().Make())).size(), 0u);
}

std::vector<NamedMesh> SoundSurfaces()
{
  return { { "Sphere", [] { return MakePolyData(SphereTriangles(7)); } },
    { "SphereQuads", [] { return MakePolyData(SphereQuads(7)); } },
    { "Soup", [] { return MakePolyData(Soup(TorusTriangles(20, 9))); } },
    { "Float", [] { return MakePolyData(TorusQuads(20, 9), VTK_FLOAT); } },
    { "Hexagons", [] { return MakePolyData(Hexagons(5)); } },
    { "Strips", [] { return MakePolyData(Strips(5)); } },
    { "Cube", [] { return MakeGrid(CubeQuads(4)); } } };
}
INSTANTIATE_TEST_SUITE_P(Meshes, SoundSurface, testing::ValuesIn(SoundSurfaces()), NameOfMesh());

TEST(SurfaceIntersection, ARepeatedCellOverlapsItsTwin)
{
  Mesh mesh = SphereTriangles(4);
  mesh.Cells.push_back(mesh.Cells[5]);
  const auto last = static_cast<vtkIdType>(mesh.Cells.size()) - 1;
  auto filter = MakeIntersection(MakePolyData(mesh));
  EXPECT_EQ(RunCellPairs(filter), (CellIdPairs{ { 5, last } }));
  EXPECT_EQ(PairsOf(filter)[0].Contact, 3);
}

TEST(SurfaceIntersection, AFoldOntoTheNeighbourIsFound)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5, 0.25, 0 }, { 0.5, -1, 0 } };
  mesh.Add(VTK_TRIANGLE, { 0, 1, 2 });
  mesh.Add(VTK_TRIANGLE, { 0, 1, 4 }); // across the edge
  mesh.Add(VTK_TRIANGLE, { 0, 1, 3 }); // folded back
  EXPECT_EQ(RunCellPairs(MakeIntersection(MakePolyData(mesh))), (CellIdPairs{ { 0, 2 } }));
}

/// A surface of the list of real data, with the pairs and facets that meet there as others count
/// them with exact arithmetic, of triangles by vtkTriangleFilter (other cuts of faces that are not
/// flat meet otherwise), copies of a facet not counted.
struct Counted
{
  std::string File;
  std::size_t Pairs;
  std::size_t Facets;
};

std::vector<Counted> CountedSurfaces()
{
  std::vector<Counted> all;
  std::ifstream list(ExtraDataFolder() + "/README.md");
  const std::regex name(R"(^\| (\S+) \()");
  const std::regex count(R"((\d+) self-intersecting facet pairs in (\d+) facets)");
  for (std::string line; std::getline(list, line);)
  {
    std::smatch file;
    std::smatch numbers;
    if (!std::regex_search(line, file, name))
    {
      continue;
    }
    for (const char* folder : { "/A_surface/", "/F_curves/" })
    {
      const std::string path = ExtraDataFolder() + folder + file[1].str();
      const bool isThere = std::filesystem::exists(path);
      if (isThere && std::regex_search(line, numbers, count))
      {
        all.push_back({ path, std::stoul(numbers[1]), std::stoul(numbers[2]) });
      }
      else if (isThere && line.find("no self-intersection") != std::string::npos)
      {
        all.push_back({ path, 0, 0 });
      }
    }
  }
  return all;
}

std::array<Point, 3> CornersOf(vtkPolyData* triangles, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  triangles->GetCellPoints(cell, ids);
  std::array<Point, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    triangles->GetPoint(ids->GetId(i), corners[i].data());
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

TEST(SurfaceIntersection, OfRealSurfacesPairsAreAsManyAsOthersCount)
{
  const std::vector<Counted> surfaces = CountedSurfaces();
  if (surfaces.empty())
  {
    GTEST_SKIP() << "no list of real data in " << ExtraDataFolder();
  }
  if (FewerTests())
  {
    GTEST_SKIP() << "many and large";
  }
  EXPECT_GT(surfaces.size(), 30u);
  for (const Counted& surface : surfaces)
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(ReadMesh(surface.File));
    triangles->PassLinesOff();
    triangles->PassVertsOff();
    triangles->Update();
    std::size_t pairs = 0;
    std::set<vtkIdType> facets;
    for (const CellPair& pair : RunPairs(MakeIntersection(triangles->GetOutput())))
    {
      if (CornersOf(triangles->GetOutput(), pair.First) !=
        CornersOf(triangles->GetOutput(), pair.Second))
      {
        ++pairs;
        facets.insert({ pair.First, pair.Second });
      }
    }
    EXPECT_EQ(pairs, surface.Pairs) << surface.File;
    EXPECT_EQ(facets.size(), surface.Facets) << surface.File;
  }
}

/// A needle meets a star in its middle, none of those between its tips does, at any magnitude.
TEST(SurfaceIntersection, ConcavePolygonsOfAnyMagnitudeAreCutAlike)
{
  for (const double scale : { 1e-300, 1e-170, 1e-90, 1.0, 1e90, 1e170, 1e300 })
  {
    SCOPED_TRACE(scale);
    Mesh star;
    Ids corners;
    for (int i = 0; i < 10; ++i)
    {
      const double radius = i % 2 == 0 ? 1.0 : 0.2;
      const double angle = 0.62831853071795865 * i;
      corners.push_back(star.Add({ radius * std::cos(angle), radius * std::sin(angle), 0.0 }));
    }
    star.Add(VTK_POLYGON, corners);
    Mesh needles;
    for (int i = 0; i < 6; ++i)
    {
      const double angle = 0.62831853071795865 * (2 * i + 1);
      const double radius = i == 5 ? 0.0 : 0.5; // between tips, but for the last
      const Point at{ radius * std::cos(angle), radius * std::sin(angle), -1.0 };
      const vtkIdType first = needles.Add(at);
      needles.Add(at + Point{ 0.01, 0.0, 2.0 });
      needles.Add(at + Point{ 0.0, 0.01, 2.0 });
      needles.Add(VTK_TRIANGLE, { first, first + 1, first + 2 });
    }
    auto filter = MakeIntersection(MakePolyData(Transformed(star, scale, { 0, 0, 0 })),
      MakePolyData(Transformed(needles, scale, { 0, 0, 0 })));
    EXPECT_EQ(RunCellPairs(filter), (CellIdPairs{ { 0, 5 } }));
  }
}

// Its faces of many corners are not flat. Cut along short diagonals, as the filter does, they pass
// each other; cut as vtkTriangleFilter does, they do not.
TEST(SurfaceIntersection, FacesThatAreNotFlatMeetAsTheyAreCut)
{
  const std::string file = ExtraDataFolder() + "/A_surface/double-torus-example.vtp";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << "no " << file;
  }
  EXPECT_EQ(RunPairs(MakeIntersection(ReadMesh(file))).size(), 0u);
}

}
