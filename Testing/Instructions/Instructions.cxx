// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Instructions.cxx
 * @brief the main queries on made meshes, to be counted by valgrind: see count.py
 *
 * Each kind of work is counted by itself and put out under its name. Meshes and queries are the
 * same every time. Ends with 77 when it was compiled without valgrind's header.
 */
#include "Support/CountInstructions.h"
#include "Support/LongCells.h"
#include "Support/RandomSolids.h"
#include "Support/SpatialQueryRun.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSkdTreeBooleanOperation.h"
#include "vtkSkdTreeCellLocator.h"

#include <cmath>
#include <iostream>

namespace
{
using namespace skdtest;

constexpr int NumberOfQueries = 1000;

/// A locator of a mesh, its queries, and where the results go.
class Counted
{
public:
  explicit Counted(vtkDataSet* mesh)
  {
    mesh->GetBounds(this->Box.data());
    this->Locator->SetDataSet(mesh);
  }

  void Build() { this->Locator->BuildLocator(); }

  void CountBuild(const char* name)
  {
    CountInstructions(name, [&] { this->Locator->ForceBuildLocator(); });
  }

  /// Of a tree that is built on query.
  void CountFirstAnswer(const char* name)
  {
    const Point x = this->Around(0.5, 0.7).front();
    this->Locator->LazyBuildOn();
    CountInstructions(name,
      [&]
      {
        this->Locator->ForceBuildLocator();
        Point closest;
        vtkIdType cell;
        int subId;
        double dist2;
        this->Locator->FindClosestPoint(x.data(), closest.data(), cell, subId, dist2);
      });
  }

  /// About points at such a distance from the middle, in half diagonals.
  void CountClosest(const char* name, double nearest, double farthest)
  {
    const std::vector<Point> from = this->Around(nearest, farthest);
    CountInstructions(name,
      [&]
      {
        for (const Point& x : from)
        {
          Point closest;
          vtkIdType cell;
          int subId;
          double dist2;
          this->Locator->FindClosestPoint(x.data(), closest.data(), cell, subId, dist2);
        }
      });
  }

  void CountFirstHits(const char* name)
  {
    const std::vector<Point> ends = this->Around(1.0, 1.1);
    CountInstructions(name,
      [&]
      {
        for (std::size_t i = 0; i < ends.size(); ++i)
        {
          Point hit, pcoords;
          double t;
          int subId;
          vtkIdType cell;
          this->Locator->IntersectWithLine(ends[i].data(), ends[ends.size() - 1 - i].data(), 0.0, t,
            hit.data(), pcoords.data(), subId, cell);
        }
      });
  }

  void CountAllHits(const char* name)
  {
    const std::vector<Point> ends = this->Around(1.0, 1.1);
    vtkNew<vtkPoints> hits;
    CountInstructions(name,
      [&]
      {
        for (std::size_t i = 0; i < ends.size(); ++i)
        {
          this->Locator->IntersectWithLine(
            ends[i].data(), ends[ends.size() - 1 - i].data(), 0.0, hits, this->Ids);
        }
      });
  }

  void CountFindCell(const char* name)
  {
    const std::vector<Point> positions = this->Inside();
    CountInstructions(name,
      [&]
      {
        for (Point x : positions)
        {
          this->Locator->FindCell(x.data());
        }
      });
  }

  void CountBoxes(const char* name, double size)
  {
    const std::vector<Point> centres = this->Around(0.5, 0.6);
    CountInstructions(name,
      [&]
      {
        for (const Point& c : centres)
        {
          Bounds box = Grown({ c[0], c[0], c[1], c[1], c[2], c[2] }, size * Diagonal(this->Box));
          this->Locator->FindCellsWithinBounds(box.data(), this->Ids);
        }
      });
  }

  void CountPairs(const char* name, Counted& other)
  {
    other.Build();
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> ids;
    CountInstructions(name, [&] { this->Locator->FindPairs(other.Locator, offsets, ids); });
  }

  void CountBatch(const char* name)
  {
    vtkNew<vtkDoubleArray> points;
    points->SetNumberOfComponents(3);
    for (const Point& x : this->Around(0.5, 0.7))
    {
      points->InsertNextTuple(x.data());
    }
    vtkNew<vtkIdTypeArray> cells;
    CountInstructions(
      name, [&] { this->Locator->FindClosestPoints(points, cells, nullptr, nullptr); });
  }

private:
  std::vector<Point> Around(double nearest, double farthest)
  {
    std::vector<Point> points(NumberOfQueries);
    for (Point& point : points)
    {
      const double distance = 0.5 * Diagonal(this->Box) * this->Random.Between(nearest, farthest);
      point = Center(this->Box) + distance * this->Random.Direction();
    }
    return points;
  }

  std::vector<Point> Inside()
  {
    std::vector<Point> points(NumberOfQueries);
    for (Point& point : points)
    {
      point = this->Random.InBox(this->Box);
    }
    return points;
  }

  vtkNew<vtkSkdTreeCellLocator> Locator;
  vtkNew<vtkIdList> Ids;
  Bounds Box;
  skdtest::Random Random{ 17 };
};

Point Dented(const Point& p)
{
  return (1.0 + 0.1 * std::sin(7 * p[0]) * std::cos(6 * p[1]) * std::sin(5 * p[2] + 1)) * p;
}

void CountSurface()
{
  const auto mesh = MakePolyData(SphereTriangles(40).Map(Dented));
  const auto moved =
    MakePolyData(Transformed(SphereTriangles(40).Map(Dented), 1.0, { 0.5, 0.3, 0.2 }));
  Counted surface(mesh);
  Counted other(moved);
  surface.CountBuild("build, triangles");
  surface.CountClosest("closest point, near", 0.5, 0.7);
  surface.CountClosest("closest point, far", 3.0, 6.0);
  surface.CountFirstHits("first hit");
  surface.CountAllHits("all hits");
  surface.CountBoxes("cells in a small box", 0.005);
  surface.CountBoxes("cells in a large box", 0.05);
  surface.CountPairs("pairs", other);
  surface.CountBatch("closest points, a batch");
  surface.CountFirstAnswer("first answer, built on query");
}

void CountBoolean()
{
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputData(MakePolyData(SphereTriangles(40).Map(Dented)));
  filter->SetSourceData(
    MakePolyData(Transformed(SphereTriangles(40).Map(Dented), 1.0, { 0.5, 0.3, 0.2 })));
  CountInstructions("union of solids", [&] { filter->Update(); });
  filter->SetOperationToIntersection();
  CountInstructions("another operation on them", [&] { filter->Update(); });
  for (const double shift : { 0.01, 0.02 }) // then it is known which pairs a motion may make
  {
    filter->SetTranslation(shift, 0.0, 0.0);
    filter->Update();
  }
  filter->SetTranslation(0.03, 0.0, 0.0);
  CountInstructions("operation after a motion", [&] { filter->Update(); });
}

/// Of boxes along the axes, whose faces cross in points that are on one line.
void CountUnionOfBoxes()
{
  skdtest::Random random(23);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const Point at = random.InBox({ 0.0, 2.5, 0.0, 2.5, 0.0, 2.5 });
    blocks->SetBlock(i, MakePolyData(Transformed(CubeTriangles(1), 1.0, at)));
  }
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputDataObject(blocks);
  CountInstructions("union of boxes", [&] { filter->Update(); });
}

/// Of spheres that intersect themselves everywhere: triangles meet in threes.
void CountUnionOfNoisySpheres()
{
  skdtest::Random random(29);
  const auto noisy = [&random](const Point& p) {
    return p + 0.15 * random.InBox({ -1, 1, -1, 1, -1, 1 });
  };
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputData(MakePolyData(SphereTriangles(12).Map(noisy)));
  filter->SetSourceData(
    MakePolyData(Transformed(SphereTriangles(12).Map(noisy), 1.0, { 0.5, 0.3, 0.2 })));
  CountInstructions("union of noisy spheres", [&] { filter->Update(); });
}

/// Of thin boxes that cross each other in more pairs of triangles than is usual.
void CountUnionOfRods()
{
  skdtest::Random random(31);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (const Mesh& rod : RandomRods(random, 220, 0.005))
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), MakePolyData(rod));
  }
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputDataObject(blocks);
  CountInstructions("union of rods", [&] { filter->Update(); });
}

/// Of a long plate and boxes that cut slits into it: one triangle is cut by all.
void CountSlits()
{
  Mesh slits;
  const int count = 400;
  for (int i = 0; i < count; ++i)
  {
    skdtest::Append(slits, Transformed(CubeTriangles(1), 1.0, { 2.0 * i + 0.5, 0.5, -0.3 }));
  }
  Mesh plate = CubeTriangles(1);
  plate.Map([count](const Point& p) { return Point{ 2.0 * count * p[0], p[1], 0.3 * p[2] }; });
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputData(MakePolyData(plate));
  filter->SetSourceData(MakePolyData(slits));
  filter->SetOperationToDifference();
  CountInstructions("plate with slits", [&] { filter->Update(); });
}

/// Two fans, at the tips of which all boxes overlap, along an axis that slants.
Mesh Bicone(int count, double slant)
{
  Mesh mesh;
  mesh.Points = { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } };
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    mesh.Points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    const vtkIdType next = 2 + (i + 1) % count;
    mesh.Add(VTK_TRIANGLE, { 2 + i, next, 0 });
    mesh.Add(VTK_TRIANGLE, { next, 2 + i, 1 });
  }
  return mesh.Map(
    [slant](const Point& p) {
      return Point{ p[0] + slant * p[2], p[1] - 0.5 * slant * p[2], p[2] - slant * p[0] };
    });
}

void CountUnionOfBicones()
{
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputData(MakePolyData(Bicone(1000, 0.2)));
  filter->SetSourceData(MakePolyData(Transformed(Bicone(1000, 0.7), 1.0, { 0.3, 0.2, 0.1 })));
  CountInstructions("union of bicones", [&] { filter->Update(); });
}

/// Of a noisy bicone and itself, turned by rounding errors: at the tips each triangle crosses those
/// of the other, in points that are nearly one.
void CountUnionOfNearCopies()
{
  skdtest::Random random(37);
  Mesh bicone = Bicone(40, 0.2).Map(
    [&random](const Point& p) {
      return p + 0.3 * random.InBox({ -1, 1, -1, 1, -1, 1 });
    });
  vtkNew<vtkSkdTreeBooleanOperation> filter;
  filter->SetInputData(MakePolyData(bicone));
  filter->SetSourceData(MakePolyData(bicone.Map(
    [](const Point& p) {
      return Point{ p[0] - 1e-15 * p[1], p[1] + 1e-15 * p[0], p[2] };
    })));
  CountInstructions("union of near copies", [&] { filter->Update(); });
}

/// Cells whose pieces must be searched, not gone through one by one.
void CountExpensiveCells()
{
  for (const auto& [type, name] : { std::pair(VTK_POLY_VERTEX, "closest point, long polyvertex"),
         std::pair(VTK_POLY_LINE, "closest point, long polyline"),
         std::pair(VTK_TRIANGLE_STRIP, "closest point, long strip") })
  {
    const auto mesh = MakeGrid(LongCell(type, 16000));
    Counted cell(mesh);
    cell.Build();
    cell.CountClosest(name, 0.0, 1.0);
  }
  const auto hexahedra = MakeGrid(SeparateQuadraticHexahedra(3));
  QueryPointer query = MakeQuery(hexahedra, SpatialQuery::ADJACENCY);
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(hexahedra);
  CountInstructions("adjacency, curved hexahedra", [&] { query->Update(); });
}

/// Equal cells, which no box tells apart: see SkdEqualCells.
void CountEqualCells()
{
  Mesh mesh = SphereTriangles(10);
  for (int i = 0; i < 4000; ++i)
  {
    mesh.Add(VTK_TRIANGLE, mesh.Cells[7].Points);
    mesh.Add(VTK_VERTEX, { 3 });
  }
  const auto grid = MakeGrid(mesh);
  Counted cells(grid);
  cells.CountBuild("build, equal cells");
  cells.CountClosest("closest point, equal cells", 0.5, 0.7);
  cells.CountFirstHits("first hit, equal cells");
}

void CountVolume(const char* kind, Mesh mesh)
{
  const auto grid = MakeGrid(mesh.Map(Bent));
  Counted volume(grid);
  const std::string name(kind);
  volume.CountBuild(("build, " + name).c_str());
  volume.CountFindCell(("find cell, " + name).c_str());
  volume.CountClosest(("closest point, " + name).c_str(), 0.0, 1.0);
}
}

int main()
{
#ifdef SKDTREE_CANNOT_COUNT
  std::cout << "compiled without valgrind/callgrind.h\n";
  return 77;
#endif
  vtkSMPTools::Initialize(1);
  CountSurface();
  CountBoolean();
  CountUnionOfBoxes();
  CountUnionOfNoisySpheres();
  CountUnionOfBicones();
  CountUnionOfNearCopies();
  CountUnionOfRods();
  CountSlits();
  CountVolume("tetrahedra", Tetrahedra(12));
  CountVolume("hexahedra", Hexahedra(16));
  CountVolume("mixed cells", MixedCells(12));
  CountExpensiveCells();
  CountEqualCells();
  return 0;
}
