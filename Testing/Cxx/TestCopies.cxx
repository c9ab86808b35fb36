// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Very many triangles with the same corners, of which there would be very many pairs: Boolean
// Operation counts them all, Surface Intersection the first of them.

#include "Support/SolidRun.h"
#include "Support/SurfaceMeshes.h"

#include "vtkSkdTreeSurfaceIntersection.h"
#include "vtkTable.h"

using namespace skdtest;

namespace
{
constexpr int Many = 2000;
constexpr vtkIdType Used = 64; // of each triangle, by Surface Intersection

/// A tetrahedron that is there many times, with points of their own or not; every second one is
/// turned, up to `rotated` of them.
Mesh Tetrahedra(int count, int rotated = 0, bool haveOwnPoints = false)
{
  const Mesh one = [&]
  {
    Mesh mesh;
    for (const Point& p :
      { Point{ 0, 0, 0 }, Point{ 1, 0, 0 }, Point{ 0, 1, 0 }, Point{ 0, 0, 1 } })
    {
      mesh.Add(p);
    }
    for (const Ids& ids : { Ids{ 0, 2, 1 }, Ids{ 0, 1, 3 }, Ids{ 1, 2, 3 }, Ids{ 0, 3, 2 } })
    {
      mesh.Add(VTK_TRIANGLE, ids);
    }
    return mesh;
  }();
  Mesh all = one;
  for (int i = 1; i < count; ++i)
  {
    const Mesh next = i % 2 == 1 && i < 2 * rotated ? Inverted(one) : one;
    if (haveOwnPoints)
    {
      Append(all, next);
    }
    else
    {
      all.Cells.insert(all.Cells.end(), next.Cells.begin(), next.Cells.end());
    }
  }
  return all;
}

Mesh Box()
{
  return BoxTriangles({ 0.1, 0.1, 0.1 }, { 1.1, 1.1, 1.1 });
}

TEST(Copies, CountInABooleanOperationAsOftenAsTheyAreThere)
{
  const Mesh one = Tetrahedra(1);
  for (int operation = 0; operation < 5; ++operation)
  {
    SCOPED_TRACE(operation);
    const auto volume = [&](const Mesh& mesh, int rule = vtkSkdTreeBooleanOperation::NONZERO)
    { return Measures(Combine(mesh, Box(), operation, rule)).Volume; };
    const double solid = volume(one);
    const double empty = volume(Mesh());
    const auto odd = vtkSkdTreeBooleanOperation::ODD;
    const auto positive = vtkSkdTreeBooleanOperation::POSITIVE;
    EXPECT_NEAR(volume(Tetrahedra(Many)), solid, 1e-14);
    EXPECT_NEAR(volume(Tetrahedra(Many), odd), empty, 1e-14);
    EXPECT_NEAR(volume(Tetrahedra(Many + 1), odd), solid, 1e-14);
    EXPECT_NEAR(volume(Tetrahedra(Many, Many / 2)), empty, 1e-14);
    EXPECT_NEAR(volume(Tetrahedra(Many + 1, Many / 2), positive), solid, 1e-14);
  }
}

TEST(Copies, OfBothInputsAreCombined)
{
  for (int operation = 0; operation < 5; ++operation)
  {
    const Mesh many = Combine(Tetrahedra(Many, 0, true), Tetrahedra(Many), operation);
    EXPECT_NEAR(Measures(many).Volume, operation < 2 ? 1.0 / 6.0 : 0.0, 1e-15) << operation;
  }
}

/// Rows and cells of an intersection; one warning if triangles are left out.
struct Intersection
{
  vtkNew<vtkSkdTreeSurfaceIntersection> Filter;
  EventCounter Events{ this->Filter };
  vtkIdType Rows = 0;
  vtkIdType Cells = 0;

  Intersection(const Mesh& input, const Mesh* source, bool splits)
  {
    this->Filter->SetInputData(MakePolyData(input));
    if (source)
    {
      this->Filter->SetSourceData(MakePolyData(*source));
    }
    this->Filter->SetSplitSurfaces(splits);
    this->Run();
  }

  void Run()
  {
    this->Filter->Update();
    this->Rows = vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2))->GetNumberOfRows();
    this->Cells = this->Filter->GetOutputDataObject(4)->GetNumberOfElements(vtkDataObject::CELL);
  }
};

TEST(Copies, OfASurfaceThatMeetsItselfTheFirstAreListed)
{
  for (const bool haveOwnPoints : { false, true })
  {
    const Intersection found(Tetrahedra(Many, 0, haveOwnPoints), nullptr, true);
    EXPECT_EQ(found.Rows, 4 * Used * (Used - 1) / 2);
    EXPECT_EQ(found.Cells, 4 * Used);
    EXPECT_EQ(found.Events.Warnings, 1);
    EXPECT_NE(found.Events.Warning.find("more than 64 times"), std::string::npos);
  }
  const Intersection few(Tetrahedra(Used), nullptr, false);
  EXPECT_EQ(few.Rows, 4 * Used * (Used - 1) / 2);
  EXPECT_EQ(few.Events.Warnings, 0);
}

TEST(Copies, OfTwoSurfacesTheFirstAreListedByEverySearch)
{
  const Mesh box = Box();
  const Intersection one(Tetrahedra(1), &box, false);
  ASSERT_GT(one.Rows, 0);
  Intersection found(Tetrahedra(Many, 0, true), &box, false);
  EXPECT_EQ(found.Rows, Used * one.Rows);
  EXPECT_EQ(found.Events.Warnings, 1);
  found.Filter->Modified(); // a search in trees
  found.Run();
  EXPECT_EQ(found.Rows, Used * one.Rows);
  EXPECT_EQ(found.Events.Warnings, 2);
  const Mesh many = Tetrahedra(Many);
  const Intersection same(many, &many, false);
  const Mesh single = Tetrahedra(1);
  EXPECT_EQ(same.Rows, Used * Used * Intersection(single, &single, false).Rows);
}

/// A first search looks at triangles near the other surface only.
TEST(Copies, BesideASurfaceThatIsFarAreFoundByAFirstSearchToo)
{
  Mesh spheres = Transformed(SphereTriangles(30), 1.0, { 5.0, 0.0, 0.0 });
  Append(spheres, Tetrahedra(200, 0, true));
  Mesh source = Transformed(SphereTriangles(30), 1.0, { -5.0, 0.0, 0.0 });
  Append(source, Box());
  const Mesh box = Box();
  const vtkIdType rows = Used * Intersection(Tetrahedra(1), &box, false).Rows;
  Intersection found(spheres, &source, false);
  EXPECT_EQ(found.Rows, rows);
  EXPECT_EQ(found.Events.Warnings, 1);
  found.Filter->Modified();
  found.Run();
  EXPECT_EQ(found.Rows, rows);
}
}
