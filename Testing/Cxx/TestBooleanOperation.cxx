// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: volumes, closed results, faces that coincide.

#include "Support/EventCounter.h"
#include "Support/Folders.h"
#include "Support/RealMeshes.h"
#include "Support/SurfaceMeshes.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkSkdTreeBooleanOperation.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;

double ReportOf(vtkPolyData* output, const char* what)
{
  vtkDataArray* array = output->GetFieldData()->GetArray((std::string("SkdReport") + what).c_str());
  return array ? array->GetTuple1(0) : vtkMath::Nan();
}

vtkSmartPointer<vtkPolyData> Combine(vtkDataSet* a, vtkDataSet* b, int operation)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, a);
  filter->SetSourceData(b);
  filter->SetOperation(operation);
  filter->Update();
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Six times the volume, by the coordinates alone.
double SixVolumes(vtkPolyData* surface)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    Point x[3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(surface->GetCell(cell)->GetPointId(i), x[i].data());
    }
    sum += Dot(x[0], Cross(x[1], x[2]));
  }
  return sum;
}

/// Edges between coordinates that are not passed as often in one direction as in the other.
std::size_t CountBadEdges(vtkPolyData* surface)
{
  std::map<std::pair<Point, Point>, int> passes;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    for (int i = 0; i < 3; ++i)
    {
      Point a, b;
      surface->GetPoint(surface->GetCell(cell)->GetPointId(i), a.data());
      surface->GetPoint(surface->GetCell(cell)->GetPointId((i + 1) % 3), b.data());
      passes[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  std::size_t bad = 0;
  for (const auto& [edge, sum] : passes)
  {
    bad += sum != 0 && edge.first != edge.second;
  }
  return bad;
}

/// All five combinations are closed, and their volumes add up. Returns the volume of the
/// intersection.
double ExpectVolumesAddUp(vtkDataSet* a, vtkDataSet* b)
{
  double volume[5];
  double ofA = 0.0, ofB = 0.0;
  for (int operation = 0; operation < 5; ++operation)
  {
    auto output = Combine(a, b, operation);
    volume[operation] = SixVolumes(output) / 6.0;
    EXPECT_EQ(CountBadEdges(output), 0u) << operation;
    EXPECT_EQ(ReportOf(output, "BadEdges"), 0.0) << operation;
    ofA = ReportOf(output, "InputVolume");
    ofB = ReportOf(output, "SourceVolume");
    EXPECT_NEAR(ReportOf(output, "Volume"), volume[operation], 1e-12 * (ofA + ofB));
  }
  const double bound = 1e-13 * (ofA + ofB);
  EXPECT_NEAR(volume[0] + volume[1], ofA + ofB, bound);
  EXPECT_NEAR(volume[2] + volume[1], ofA, bound);
  EXPECT_NEAR(volume[3] + volume[1], ofB, bound);
  EXPECT_NEAR(volume[4], volume[2] + volume[3], bound);
  return volume[1];
}

PolyDataPointer Cube(double size, const Point& at)
{
  return MakePolyData(Placed(CubeQuads(1), size, at));
}

TEST(BooleanOperation, TwoSpheres)
{
  auto a = MakePolyData(SphereTriangles(12));
  const double common =
    ExpectVolumesAddUp(a, MakePolyData(Placed(SphereTriangles(11), 0.9, { 0.31, 0.67, 0.5 })));
  EXPECT_GT(common, 0.5);
  EXPECT_LT(common, 2.5);
}

TEST(BooleanOperation, OneWithinTheOther)
{
  auto a = MakePolyData(SphereTriangles(8));
  auto b = MakePolyData(Placed(SphereTriangles(4), 0.3, { 0.1, 0.2, 0.0 }));
  EXPECT_EQ(Combine(a, b, Filter::UNION)->GetNumberOfCells(), a->GetNumberOfCells());
  EXPECT_EQ(Combine(a, b, Filter::DIFFERENCE)->GetNumberOfCells(),
    a->GetNumberOfCells() + b->GetNumberOfCells());
  ExpectVolumesAddUp(a, b);
}

TEST(BooleanOperation, IdenticalSurfaces)
{
  auto a = MakePolyData(TorusTriangles(24, 12));
  EXPECT_EQ(Combine(a, a, Filter::UNION)->GetNumberOfCells(), a->GetNumberOfCells());
  EXPECT_EQ(Combine(a, a, Filter::DIFFERENCE)->GetNumberOfCells(), 0);
  EXPECT_EQ(Combine(a, a, Filter::SYMMETRIC_DIFFERENCE)->GetNumberOfCells(), 0);
  ExpectVolumesAddUp(a, a);
}

struct CubeCase
{
  double Size;
  Point At;
  double Common;
};

TEST(BooleanOperation, BoxesWithCoplanarSides)
{
  auto a = Cube(2, { 0, 0, 0 });
  for (const CubeCase& b :
    { CubeCase{ 2, { 1, 0, 0 }, 4 }, CubeCase{ 2, { 1, 1, 0 }, 2 },
      CubeCase{ 1, { 0.5, 0.5, 0 }, 1 }, CubeCase{ 1, { 0, 0, 0 }, 1 },
      CubeCase{ 1, { 0.5, 0.5, 1 }, 1 }, CubeCase{ 1, { 0.5, 0.5, 1.25 }, 0.75 },
      CubeCase{ 2, { 2, 0, 0 }, 0 }, CubeCase{ 2, { 2, 0.5, 0.25 }, 0 },
      CubeCase{ 1, { 0.25, 0.5, 2 }, 0 }, CubeCase{ 2, { 2, 2, 0 }, 0 },
      CubeCase{ 2, { 2, 2, 2 }, 0 }, CubeCase{ 2, { 2, 2, 1 }, 0 }, CubeCase{ 2, { 5, 0, 0 }, 0 } })
  {
    SCOPED_TRACE(
      testing::Message() << b.Size << " at " << b.At[0] << " " << b.At[1] << " " << b.At[2]);
    EXPECT_NEAR(ExpectVolumesAddUp(a, Cube(b.Size, b.At)), b.Common, 1e-14);
  }
  // what is between faces that face each other is gone
  auto both = Combine(a, Cube(2, { 2, 0, 0 }), Filter::UNION);
  double x[3];
  for (vtkIdType cell = 0; cell < both->GetNumberOfCells(); ++cell)
  {
    int onWall = 0;
    for (int i = 0; i < 3; ++i)
    {
      both->GetPoint(both->GetCell(cell)->GetPointId(i), x);
      onWall += x[0] == 2.0;
    }
    EXPECT_LT(onWall, 3) << cell;
  }
}

TEST(BooleanOperation, InsideOutIsTurned)
{
  auto a = MakePolyData(SphereTriangles(6));
  Mesh turned = Placed(SphereTriangles(6), 1, { 0.5, 0.25, 0.125 });
  for (auto& cell : turned.Cells)
  {
    std::swap(cell.Points[0], cell.Points[1]);
  }
  EXPECT_GT(ExpectVolumesAddUp(a, MakePolyData(turned)), 0.5);
}

TEST(BooleanOperation, PassesDataOn)
{
  const auto withData = [](PolyDataPointer mesh, double value)
  {
    vtkNew<vtkDoubleArray> height, label;
    height->SetName("Height");
    label->SetName("Label");
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      height->InsertNextValue(mesh->GetPoint(i)[2]);
    }
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      label->InsertNextValue(value + static_cast<double>(i));
    }
    mesh->GetPointData()->AddArray(height);
    mesh->GetCellData()->AddArray(label);
    return mesh;
  };
  auto output = Combine(withData(MakePolyData(SphereTriangles(6)), 0),
    withData(MakePolyData(Placed(SphereTriangles(5), 0.8, { 0.4, 0.3, 0.2 })), 1000), 2);
  ASSERT_TRUE(output->GetPointData()->GetArray("Height"));
  ASSERT_TRUE(output->GetCellData()->GetArray("Label"));
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(
      output->GetPointData()->GetArray("Height")->GetTuple1(i), output->GetPoint(i)[2], 1e-14);
  }
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const auto at = [&](const char* name)
    { return output->GetCellData()->GetArray(name)->GetTuple1(i); };
    EXPECT_EQ(at("Label"), 1000.0 * at("SkdInputId") + at("SkdCellId"));
  }
}

TEST(BooleanOperation, OpenSurfacesAreAnError)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, MakePolyData(SphereTriangles(4)));
  filter->SetSourceData(MakePolyData(Sheet(3, VTK_TRIANGLE)));
  EventCounter events(filter);
  filter->Update();
  EXPECT_EQ(events.Errors, 1);
  EXPECT_NE(events.Error.find("Source is not a closed"), std::string::npos) << events.Error;
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), 0);
}

DataSetPointer Moved(vtkDataSet* mesh, const Point& share)
{
  const Point way = mesh->GetLength() * share;
  vtkNew<vtkTransform> move;
  move->Translate(way.data());
  vtkNew<vtkTransformFilter> moved;
  moved->SetTransform(move);
  moved->SetInputData(mesh);
  moved->Update();
  return vtkDataSet::SafeDownCast(moved->GetOutputDataObject(0));
}

DataSetPointer ReadSolid(const std::string& name)
{
  const std::string file = ExtraDataFolder() + "/A_surface/" + name;
  return std::filesystem::exists(file) ? ReadMesh(file) : nullptr;
}

TEST(BooleanOperation, RealSolids)
{
  for (const char* name : { "oblong.vtp", "simpleCar.stl" })
  {
    const DataSetPointer mesh = ReadSolid(name);
    if (!mesh)
    {
      GTEST_SKIP() << "no " << name << " in " << ExtraDataFolder();
    }
    SCOPED_TRACE(name);
    ExpectVolumesAddUp(mesh, Moved(mesh, { 0.1357, 0.0713, 0.0291 }));
  }
}

/// Moved along an axis, so that slanted faces nearly coincide: no winding number decides there.
TEST(BooleanOperation, RealSolidWithFacesThatNearlyCoincide)
{
  const DataSetPointer mesh = ReadSolid("anchor_dense.vtp");
  if (!mesh)
  {
    GTEST_SKIP() << "no anchor_dense.vtp in " << ExtraDataFolder();
  }
  auto output = Combine(mesh, Moved(mesh, { 0.125, 0, 0 }), Filter::UNION);
  EXPECT_EQ(ReportOf(output, "BadEdges"), 0.0);
}
}
