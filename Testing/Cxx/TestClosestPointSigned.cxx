// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeClosestPoint: the sign of the distance.

#include "Support/BruteForce.h"
#include "Support/ClosestPointRun.h"
#include "Support/EventCounter.h"
#include "Support/Folders.h"
#include "Support/NamedMeshes.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"
#include "Support/WindingReference.h"

#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

using namespace skdtest;

namespace
{

bool IsInside(const Mesh& triangles, const Point& x)
{
  return std::abs(WindingNumber(triangles, x)) > 0.5;
}

/// Signed distance to the boundary of the box [0, a] x [0, b] x [0, c].
double BoxDistance(const Point& size, const Point& x)
{
  Point beyond;
  double inner = -std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double q = std::abs(x[axis] - 0.5 * size[axis]) - 0.5 * size[axis];
    beyond[axis] = std::max(q, 0.0);
    inner = std::max(inner, q);
  }
  return Length(beyond) + std::min(inner, 0.0);
}

/// Points of the lattice with spacing 0.5 and random ones: most in line with corners and edges.
std::vector<Point> BoxQueries(const Point& size)
{
  std::vector<Point> points;
  for (double z = -0.5; z <= size[2] + 0.5; z += 0.5)
  {
    for (double y = -0.5; y <= size[1] + 0.5; y += 0.5)
    {
      for (double x = -0.5; x <= size[0] + 0.5; x += 0.5)
      {
        points.push_back({ x, y, z });
      }
    }
  }
  Random random(3);
  for (int i = 0; i < 200; ++i)
  {
    points.push_back(random.InBox({ -1, size[0] + 1, -1, size[1] + 1, -1, size[2] + 1 }));
  }
  return points;
}

void ExpectBoxDistances(vtkDataObject* source, const Point& size, int warnings = 0)
{
  const std::vector<Point> points = BoxQueries(size);
  FilterPointer filter = MakeSignedFilter(MakeQueries(points), source);
  EventCounter events(filter);
  const std::vector<double> distances = RunDistances(filter);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_NEAR(distances[i], BoxDistance(size, points[i]), 1e-14)
      << points[i][0] << " " << points[i][1] << " " << points[i][2];
  }
  EXPECT_EQ(events.Warnings, warnings) << events.Warning;
  EXPECT_EQ(events.Errors, 0) << events.Error;
  EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
}

Mesh Reoriented(Mesh mesh, int seed)
{
  Random random(seed);
  for (CellSpec& cell : mesh.Cells)
  {
    if (random.Index(2))
    {
      std::reverse(cell.Points.begin(), cell.Points.end());
    }
  }
  return mesh;
}

TEST(ClosestPointSigned, OfASphereItIsAnalytic)
{
  const Mesh sphere = SphereTriangles(40);
  Random random(17);
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i)
  {
    points.push_back(random.Between(0, 2) * random.Direction());
  }
  const std::vector<double> distances =
    RunDistances(MakeSignedFilter(MakeQueries(points), MakePolyData(sphere)));
  const double sagitta = 2e-3; // the triangles' edges are up to 0.07 long
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_NEAR(distances[i], Length(points[i]) - 1.0, sagitta);
  }
}

TEST(ClosestPointSigned, SignIsThatOfTheWindingNumberHoweverFacesAreOriented)
{
  const Mesh shapes[] = { TorusTriangles(20, 10), SphereTriangles(5), CubeTriangles(3),
    Octahedron(1.0),
    Together({ SphereTriangles(6), Transformed(SphereTriangles(3), 0.5, { 0, 0, 0 }) }) };
  for (const Mesh& shape : shapes)
  {
    auto source = MakePolyData(Reoriented(Soup(shape), 1));
    const std::vector<Point> points = RandomQueries(source, 1000);
    FilterPointer filter = MakeSignedFilter(MakeQueries(points), source);
    const std::vector<double> distances = RunDistances(filter);
    BruteForce reference(source);
    const bool isNested = &shape == &shapes[4];
    const bool isOctahedron = &shape == &shapes[3];
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Point& x = points[i];
      const bool isInside = isNested ? IsInside(SphereTriangles(6), x) &&
          !IsInside(Transformed(SphereTriangles(3), 0.5, { 0, 0, 0 }), x)
        : isOctahedron ? std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]) < 1.0
                       : IsInside(shape, x);
      ASSERT_EQ(distances[i] < 0, isInside) << i;
      ASSERT_NEAR(std::abs(distances[i]), reference.FindNearest(x).Distance, reference.Tolerance());
    }
  }
}

TEST(ClosestPointSigned, OfCubesItIsAnalyticAtPointsInLineWithEverything)
{
  ExpectBoxDistances(MakePolyData(CubeQuads(3)), { 3, 3, 3 });
  ExpectBoxDistances(MakePolyData(CubeTriangles(3)), { 3, 3, 3 });
  ExpectBoxDistances(MakePolyData(Soup(CubeTriangles(3)), VTK_FLOAT, true), { 3, 3, 3 });
}

TEST(ClosestPointSigned, OfVolumesItIsThatToTheirBoundary)
{
  for (const Mesh& mesh : { Hexahedra(3), Tetrahedra(3), Wedges(3), Pyramids(3), Voxels(3),
         Polyhedra(3), InvertedHexahedra(3) })
  {
    ExpectBoxDistances(MakeGrid(mesh), { 3, 3, 3 });
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  ExpectBoxDistances(image, { 3, 3, 3 });
}

/// The faces that one cell alone has, ghosts not counted, quads cut along the shorter diagonal.
Mesh BoundaryOf(vtkDataSet* source)
{
  std::map<std::vector<Point>, std::pair<int, std::vector<Point>>> faces;
  vtkUnsignedCharArray* ghosts = source->GetCellGhostArray();
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < source->GetNumberOfCells(); ++id)
  {
    source->GetCell(id, cell);
    for (int i = 0; (!ghosts || !ghosts->GetValue(id)) && i < cell->GetNumberOfFaces(); ++i)
    {
      vtkCell* face = cell->GetFace(i);
      std::vector<Point> corners(face->GetNumberOfPoints());
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        face->GetPoints()->GetPoint(static_cast<vtkIdType>(k), corners[k].data());
      }
      if (face->GetCellType() == VTK_PIXEL)
      {
        std::swap(corners[2], corners[3]);
      }
      std::vector<Point> sorted = corners;
      std::sort(sorted.begin(), sorted.end());
      ++faces[sorted].first;
      faces[sorted].second = corners;
    }
  }
  Mesh mesh;
  for (auto& [sorted, face] : faces)
  {
    std::vector<Point>& p = face.second;
    if (p.size() == 4 && Distance(p[0], p[2]) > Distance(p[1], p[3]))
    {
      std::rotate(p.begin(), p.begin() + 1, p.end());
    }
    Ids ids;
    for (std::size_t k = 0; face.first == 1 && k < p.size(); ++k)
    {
      ids.push_back(mesh.Add(p[k]));
    }
    if (!ids.empty())
    {
      mesh.Add(VTK_POLYGON, ids);
    }
  }
  return Triangulated(mesh);
}

TEST(ClosestPointSigned, OfGridsWithHolesAndGhostsItIsThatToWhatIsLeft)
{
  const DataSetPointer sources[] = { MakeExplicitStructured(4), MakeStructured(4),
    Blanked(MakeStructured(4)), MakeGrid(Hexahedra(4).Map(Bent)), MakeGrid(Tetrahedra(3).Map(Bent)),
    MakeGrid(Wedges(3).Map(Bent)) };
  for (const DataSetPointer& source : sources)
  {
    for (bool marks : { false, true })
    {
      if (marks)
      {
        MarkGhosts(source, { 0, 5, 21, 22 }, vtkDataSetAttributes::HIDDENCELL);
      }
      const Mesh boundary = BoundaryOf(source);
      BruteForce reference(MakePolyData(boundary));
      const std::vector<Point> points = RandomQueries(source, 300);
      FilterPointer filter = MakeSignedFilter(MakeQueries(points), source);
      const std::vector<double> distances = RunDistances(filter);
      EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const double expected = reference.FindNearest(points[i]).Distance;
        ASSERT_NEAR(
          distances[i], IsInside(boundary, points[i]) ? -expected : expected, reference.Tolerance())
          << source->GetClassName() << " " << i;
      }
    }
  }
}

/// Centres of cells are outside where the cell is not shown, and inside elsewhere.
void ExpectOutsideUnlessShown(vtkDataSet* mesh, const std::function<bool(vtkIdType)>& isShown)
{
  std::vector<Point> points;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    Bounds box;
    mesh->GetCellBounds(id, box.data());
    points.push_back(Center(box));
  }
  const std::vector<double> distances = RunDistances(MakeSignedFilter(MakeQueries(points), mesh));
  int outside = 0;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    EXPECT_EQ(distances[static_cast<std::size_t>(id)] > 0, !isShown(id)) << id;
    outside += distances[static_cast<std::size_t>(id)] > 0 ? 1 : 0;
  }
  EXPECT_GT(outside, 0);
}

TEST(ClosestPointSigned, BlankedCellsAreOutside)
{
  vtkSmartPointer<vtkUniformGrid> grid = Blanked(MakeUniformGrid(4));
  ExpectOutsideUnlessShown(grid, [&](vtkIdType id) { return grid->IsCellVisible(id) != 0; });
}

TEST(ClosestPointSigned, CellsThatAreRefinedElsewhereAreOutside)
{
  const std::vector<DataSetPointer> meshes{ MakeImage(4), MakeStructured(4),
    MakeExplicitStructured(4), MakeGrid(Hexahedra(4)) };
  for (const DataSetPointer& mesh : meshes)
  {
    Ids refined;
    for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); id += 3)
    {
      refined.push_back(id);
    }
    MarkGhosts(mesh, refined, vtkDataSetAttributes::REFINEDCELL);
    ExpectOutsideUnlessShown(mesh, [](vtkIdType id) { return id % 3 != 0; });
  }
}

TEST(ClosestPointSigned, CellsOfVolumesAreThoseThatHaveTheNearestFace)
{
  auto source = MakeGrid(Hexahedra(3));
  FilterPointer filter =
    MakeSignedFilter(MakeQueries({ { 1.5, 1.5, 0.2 }, { 2.5, 0.5, 9 }, { 1, 1, -1 } }), source);
  EXPECT_EQ(RunArray(filter, "SkdClosestCellId"), (std::vector<double>{ 4, 20, 0 }));
}

TEST(ClosestPointSigned, FacesBetweenVolumesOfDifferentBlocksAreNoBoundary)
{
  const Mesh cube = Hexahedra(4);
  const auto half = [&](bool upper)
  { return MakeGrid(Part(cube, [=](std::size_t cell) { return (cell >= 32) == upper; })); };
  ExpectBoxDistances(MakeBlocks({ half(false), half(true) }), { 4, 4, 4 });
}

TEST(ClosestPointSigned, ABoundaryThatComesWithItsVolumeIsNotCountedTwice)
{
  ExpectBoxDistances(
    MakeBlocks({ MakePolyData(CubeQuads(3)), MakeGrid(Hexahedra(3)) }), { 3, 3, 3 });
  Mesh both = Hexahedra(3);
  const Mesh wall = CubeQuads(3);
  ExpectBoxDistances(MakeGrid(Together({ both, wall })), { 3, 3, 3 });
  // A sheet within, as meshers write it between regions.
  ExpectBoxDistances(
    MakeGrid(Together({ both, Transformed(Sheet(3, VTK_QUAD), 1.0, { 0, 0, 1 }) })), { 3, 3, 3 });
}

TEST(ClosestPointSigned, ASurfaceInPiecesIsClosedAsAWhole)
{
  const Mesh cube = CubeQuads(3);
  std::vector<PolyDataPointer> sides;
  for (std::size_t side = 0; side < 6; ++side)
  {
    sides.push_back(MakePolyData(Part(cube, [=](std::size_t cell) { return cell / 9 == side; })));
  }
  ExpectBoxDistances(
    MakeBlocks({ sides[0], sides[1], MakeBlocks({ sides[2], sides[3], sides[4] }), sides[5] }),
    { 3, 3, 3 });
}

TEST(ClosestPointSigned, FacesWrittenRepeatedlyCountOnce)
{
  const Mesh cube = CubeTriangles(2);
  ExpectBoxDistances(MakePolyData(Together({ cube, cube })), { 2, 2, 2 });
  const Mesh some = Part(cube, [](std::size_t cell) { return cell % 5 == 0; });
  ExpectBoxDistances(MakePolyData(Together({ cube, some })), { 2, 2, 2 });
}

TEST(ClosestPointSigned, AFaceBetweenTouchingBodiesHasInsideOnBothSides)
{
  const Mesh left = CubeQuads(2);
  const Mesh right = Transformed(CubeQuads(2), 1.0, { 2, 0, 0 });
  FilterPointer filter = MakeSignedFilter(
    MakeQueries({ { 1.9, 1, 1 }, { 2.25, 1, 1 }, { 2, 1, 3 }, { 2, 0.5, 1 }, { 4.5, 1, 1 } }),
    MakePolyData(Together({ left, right })));
  EventCounter events(filter);
  const std::vector<double> distances = RunDistances(filter);
  const std::vector<double> expected = { 1.9 - 2, -0.25, 1, 0, 0.5 };
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(distances[i], expected[i], 1e-15) << i; // the face itself stays searched
  }
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
}

TEST(ClosestPointSigned, PolygonsAndStripsBoundToo)
{
  // A prism on an L, whose hexagon is not convex: its caps are polygons, its sides one strip.
  const double corners[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  Mesh mesh;
  Ids bottom, top, sides;
  for (const auto& corner : corners)
  {
    bottom.push_back(mesh.Add(Point{ corner[0], corner[1], 0 }));
    top.push_back(mesh.Add(Point{ corner[0], corner[1], 1 }));
  }
  for (int i = 0; i <= 6; ++i)
  {
    sides.push_back(bottom[i % 6]);
    sides.push_back(top[i % 6]);
  }
  mesh.Add(VTK_POLYGON, bottom);
  mesh.Add(VTK_POLYGON, top);
  mesh.Add(VTK_TRIANGLE_STRIP, sides);
  FilterPointer filter = MakeSignedFilter(
    MakeQueries({ { 0.5, 0.5, 0.5 }, { 1.5, 1.5, 0.5 }, { 1.5, 0.75, 0.5 }, { 1.25, 1.5, 0.5 } }),
    MakePolyData(mesh));
  EventCounter events(filter);
  EXPECT_EQ(RunDistances(filter), (std::vector<double>{ -0.5, 0.5, -0.25, 0.25 }));
  EXPECT_EQ(RunArray(filter, "SkdClosestCellId")[2], 2);
  EXPECT_EQ(events.Warnings, 0) << events.Warning;
}

TEST(ClosestPointSigned, AnOpenSurfaceWarnsOnceAndTheSignGoesByVote)
{
  const Mesh sphere = SphereQuads(8);
  const Mesh open = Part(sphere, [](std::size_t cell) { return cell != 100 && cell != 200; });
  FilterPointer filter = MakeSignedFilter(
    MakeQueries({ { 0, 0, 0 }, { 0.4, 0.3, -0.2 }, { 2, 0, 0 }, { 0.9, 0.9, 0.9 } }),
    MakePolyData(open));
  EventCounter events(filter);
  const std::vector<double> distances = RunDistances(filter);
  EXPECT_LT(distances[0], 0);
  EXPECT_LT(distances[1], 0);
  EXPECT_GT(distances[2], 0);
  EXPECT_GT(distances[3], 0);
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Warning.find("8 open edges"), std::string::npos) << events.Warning;
  EXPECT_EQ(Reported(filter, "OpenEdges"), 8);
}

TEST(ClosestPointSigned, ASourceWithoutASurfaceWarnsAndGivesNoSign)
{
  auto source = MakePolyData(Helix(50, VTK_LINE));
  auto queries = MakeQueries(RandomQueries(source, 50));
  FilterPointer filter = MakeSignedFilter(queries, source);
  EventCounter events(filter);
  EXPECT_EQ(RunDistances(filter), RunDistances(MakeFilter(queries, source)));
  EXPECT_EQ(events.Warnings, 1);
}

TEST(ClosestPointSigned, VerticesAndLinesBesideASurfaceAreNotSearched)
{
  Mesh mesh = CubeQuads(2);
  mesh.Add(VTK_VERTEX, { mesh.Add(Point{ 1, 1, 5 }) });
  FilterPointer filter = MakeSignedFilter(MakeQueries({ { 1, 1, 4.5 } }), MakePolyData(mesh));
  EXPECT_EQ(RunDistances(filter)[0], 2.5);
  filter->SignedDistanceOff();
  EXPECT_EQ(RunDistances(filter)[0], 0.5);
}

TEST(ClosestPointSigned, GhostCellsAreNoBoundary)
{
  Mesh mesh = Together({ CubeQuads(2), Transformed(CubeQuads(1), 1.0, { 0.5, 0.5, 0.5 }) });
  auto source = MakePolyData(mesh);
  MarkGhosts(source, { 24, 25, 26, 27, 28, 29 }, vtkDataSetAttributes::HIDDENCELL);
  ExpectBoxDistances(source, { 2, 2, 2 });
}

TEST(ClosestPointSigned, FacesThatAreNotFiniteAreLeftOut)
{
  Mesh mesh = CubeTriangles(2);
  const vtkIdType nowhere = mesh.Add(Point{ NAN, 0, 0 });
  mesh.Add(VTK_TRIANGLE, { 0, 1, nowhere });
  ExpectBoxDistances(MakePolyData(mesh), { 2, 2, 2 }, 1);
}

TEST(ClosestPointSigned, OfARealSurfaceItIsThatOfTheWindingNumber)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((DataFolder() + "/fly_brain_lateral_horn.vtp").c_str());
  reader->Update();
  vtkPolyData* source = reader->GetOutput();
  Mesh mesh;
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
  {
    Point p;
    source->GetPoint(i, p.data());
    mesh.Add(p);
  }
  for (vtkIdType i = 0; i < source->GetNumberOfCells(); ++i)
  {
    vtkIdList* ids = source->GetCell(i)->GetPointIds();
    mesh.Add(VTK_TRIANGLE, Ids(ids->begin(), ids->end()));
  }
  const std::vector<Point> points = RandomQueries(source, 2000);
  FilterPointer filter = MakeSignedFilter(MakeQueries(points), source);
  const std::vector<double> distances = RunDistances(filter);
  EXPECT_EQ(Reported(filter, "OpenEdges"), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(distances[i] < 0, IsInside(mesh, points[i])) << i;
  }
}

}
