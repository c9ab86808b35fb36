// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that meet for the first time are looked at otherwise than those with trees: by a coarse
// grid and a packed R-tree of what is near, or trees of it. The results are the same, to the last
// bit and in their order.

#include "Support/SurfaceIntersectionRun.h"

#include "Support/SurfaceMeshes.h"
#include "Support/TestAmount.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// All that the outputs have, in their order.
using Everything = std::vector<double>;

void AddData(vtkFieldData* data, Everything& all)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
    {
      for (int component = 0; component < array->GetNumberOfComponents(); ++component)
      {
        all.push_back(array->GetComponent(k, component));
      }
    }
  }
}

void AddGeometry(vtkPolyData* output, Everything& all)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    all.insert(all.end(), output->GetPoint(i), output->GetPoint(i) + 3);
  }
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, ids);
    all.insert(all.end(), ids->begin(), ids->end());
    all.push_back(-1.0);
  }
}

Everything RunAll(vtkSkdTreeSurfaceIntersection* filter)
{
  filter->Update();
  Everything all;
  for (const int port : { 0, 1, 3 })
  {
    AddGeometry(OutputOf(filter, port), all);
    AddData(OutputOf(filter, port)->GetPointData(), all);
    AddData(OutputOf(filter, port)->GetCellData(), all);
  }
  AddData(vtkTable::SafeDownCast(filter->GetOutputDataObject(2))->GetRowData(), all);
  for (const char* name : { "Triangles", "FacesLeftOut", "TrianglesWithoutArea" })
  {
    all.push_back(Reported(filter, name));
  }
  return all;
}

/// Each triangle with points of its own.
Mesh Apart(const Mesh& mesh)
{
  Mesh apart;
  for (const auto& cell : mesh.Cells)
  {
    Ids ids;
    for (const vtkIdType id : cell.Points)
    {
      ids.push_back(apart.Add(mesh.Points[static_cast<std::size_t>(id)]));
    }
    apart.Add(cell.Type, ids);
  }
  return apart;
}

/// The first look, and one after the surfaces have been searched elsewhere.
void ExpectSame(const Mesh& first, const Mesh& second, double clearance, const Point& shift)
{
  auto filter = MakeIntersection(MakePolyData(first), MakePolyData(second));
  filter->SetClearance(clearance);
  filter->SetTranslation(shift.data());
  const Everything atFirst = RunAll(filter);
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 2.0);
  filter->SetTranslation(1e3, 0.0, 0.0);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TreesBuilt"), 0.0);
  filter->SetTranslation(shift.data());
  EXPECT_TRUE(RunAll(filter) == atFirst) << "clearance " << clearance << ", shift " << shift[0];
}

void ExpectSameAnyhow(const Mesh& first, const Mesh& second)
{
  for (const double clearance : { 0.0, 0.02 })
  {
    ExpectSame(first, second, clearance, { 0, 0, 0 });
    ExpectSame(first, second, clearance, { 0.01, 0.2, -0.1 });
  }
}

}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionLooks, AFirstLookAtSpheresIsAsALaterOne)
{
  const Mesh sphere = Transformed(SphereTriangles(24), 1.0, { 0, 0, 0 });
  const Mesh other = Transformed(SphereTriangles(31), 1.0, { 0.9, 0.28, 0.15 });
  ExpectSameAnyhow(sphere, other);
  ExpectSameAnyhow(Apart(sphere), Apart(other));
  ExpectSameAnyhow(sphere, Apart(other));
  ExpectSameAnyhow(sphere, Transformed(SphereTriangles(3), 0.1, { 1.0, 0, 0 })); // few beside many
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionLooks, AFirstLookAtSpecialContactsIsAsALaterOne)
{
  Mesh lattice = LatticeTriangles(150, 6, 3);
  Mesh other = LatticeTriangles(150, 6, 4);
  ExpectSameAnyhow(lattice, other);
  const Mesh far = Transformed(LatticeTriangles(2000, 6, 5), 1.0, { 5, 5, 5 }); // few are near
  ExpectSameAnyhow(far, lattice);
  ExpectSameAnyhow(lattice, far);
  const Mesh sphere = Transformed(SphereTriangles(16), 1.0, { 0, 0, 0 });
  ExpectSameAnyhow(sphere, sphere);
  ExpectSameAnyhow(sphere, Transformed(SphereTriangles(16), 1.0, { 2, 0, 0 })); // touch at most
}

//------------------------------------------------------------------------------
// Many that overlap many are left to trees.
TEST(SurfaceIntersectionLooks, AFirstLookAtLargeAndSmallTrianglesIsAsALaterOne)
{
  SKD_LEAVE_OUT_OF_FEWER_TESTS();
  const Mesh large = Transformed(LatticeTriangles(300, 6, 6), 3.0, { -9, -9, -9 });
  const Mesh small = Transformed(LatticeTriangles(2500, 6, 7), 0.01, { 0, 0, 0 });
  ExpectSame(large, small, 0.0, { 0, 0, 0 });
  ExpectSame(small, large, 0.001, { 0, 0, 0 });
  ExpectSame(large, Transformed(LatticeTriangles(9000, 6, 7), 0.1, { 0, 0, 0 }), 0.0, { 0, 0, 0 });
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionLooks, AFirstLookAtManyIsAsALaterOne)
{
  const Mesh sphere = Transformed(SphereTriangles(60), 1.0, { 0, 0, 0 });
  const Mesh other = Transformed(SphereTriangles(71), 1.0, { 0.9, 0.28, 0.15 });
  ExpectSameAnyhow(sphere, other);
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionLooks, AFirstLookAtTinyAndFarSurfacesIsAsALaterOne)
{
  for (const double scale : { 1e-30, 1.0, 1e90 })
  {
    ExpectSame(Transformed(SphereTriangles(16), scale, { 0, 0, 0 }),
      Transformed(SphereTriangles(19), scale, { 0.9 * scale, 0.2 * scale, 0 }), 0.0, { 0, 0, 0 });
  }
  const Mesh far = Transformed(SphereTriangles(16), 1.0, { 1e8, -3e8, 0 });
  ExpectSameAnyhow(far, Transformed(SphereTriangles(19), 1.0, { 1e8 + 0.5, -3e8, 0.5 }));
}

//------------------------------------------------------------------------------
// The intersections of one surface with itself: by a packed R-tree, and by a tree that the set has
// from a search with a clearance, or because boxes overlap too much on the grid of the packed one.
TEST(SurfaceIntersectionLooks, ASurfaceMeetsItselfByAPackedRTreeAsByATree)
{
  const auto spheres = [](double scale)
  {
    return Together({ Transformed(SphereTriangles(16), scale, { 0, 0, 0 }),
      Transformed(SphereTriangles(19), scale, { 0.9 * scale, 0.2 * scale, 0 }) });
  };
  Mesh uneven = spheres(1e-4); // tiny beside one triangle
  uneven.Add(VTK_TRIANGLE,
    { uneven.Add({ -50, -50, -50 }), uneven.Add({ 90, 0, 1 }), uneven.Add({ 0, 90, 7 }) });
  for (const Mesh& mesh : { spheres(1.0), Apart(spheres(1.0)), spheres(1e-30), uneven,
         LatticeTriangles(150, 6, 3), LatticeTriangles(150, 3, 4), SphereTriangles(40) })
  {
    auto filter = MakeIntersection(MakePolyData(mesh), nullptr);
    const Everything atFirst = RunAll(filter);
    filter->SetClearance(1e-300); // for the tree
    filter->Update();
    filter->SetClearance(0.0);
    EXPECT_TRUE(RunAll(filter) == atFirst) << mesh.Cells.size() << " cells";
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceIntersectionLooks, TrianglesThatLoseTheirAreaByAMotionAreLeftOut)
{
  Mesh sliver;
  sliver.Add(VTK_TRIANGLE,
    { sliver.Add({ 0, 0, 0 }), sliver.Add({ 1, 0, 0 }), sliver.Add({ 0.5, 1e-14, 0 }) });
  auto filter = MakeIntersection(
    MakePolyData(Transformed(SphereTriangles(16), 1.0, { 0, 0, 0 })), MakePolyData(sliver));
  filter->Update();
  EXPECT_EQ(Reported(filter, "TrianglesWithoutArea"), 0.0);
  filter->SetTranslation(0.0, 1e4, 0.0); // rounds 1e-14 away
  filter->Update();
  EXPECT_EQ(Reported(filter, "TrianglesWithoutArea"), 1.0);
  filter->SetTranslation(0.0, 0.0, 0.0);
  filter->Update();
  EXPECT_EQ(Reported(filter, "TrianglesWithoutArea"), 0.0);
}
