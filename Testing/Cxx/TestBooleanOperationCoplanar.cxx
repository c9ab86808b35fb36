// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeBooleanOperation: faces of several bodies that overlap in one plane, but for rounding,
// become as few as those that are exactly in one plane, and no fewer.

#include "Support/ClosedRun.h"
#include "Support/GridBoxes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/TestAmount.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

using namespace skdtest;

namespace
{
using Filter = vtkSkdTreeBooleanOperation;
using Surface = vtkSmartPointer<vtkPolyData>;

Surface Unite(const std::vector<Mesh>& solids, int pointType)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < solids.size(); ++i)
  {
    blocks->SetBlock(i, MakePolyData(solids[i], pointType));
  }
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, blocks);
  return RunClosed(filter);
}

std::vector<Mesh> Map(std::vector<Mesh> solids, const std::function<Point(const Point&)>& map)
{
  for (Mesh& solid : solids)
  {
    solid.Map(map);
  }
  return solids;
}

/// Back from Turned.
Point TurnedBack(const Point& p)
{
  return { (2 * p[0] + p[1] - 2 * p[2]) / 3, (-2 * p[0] + 2 * p[1] - p[2]) / 3,
    (p[0] + 2 * p[1] + 2 * p[2]) / 3 };
}

/// Each face is in one of the box that it is said to be of.
void ExpectFacesOfBoxes(vtkPolyData* output, const std::vector<GridBox>& boxes, double error)
{
  const Mesh surface = MeshOf(output);
  vtkDataArray* solids = output->GetCellData()->GetArray("SkdSolidId");
  ASSERT_TRUE(solids);
  for (std::size_t face = 0; face < surface.Cells.size(); ++face)
  {
    const Ids& ids = surface.Cells[face].Points;
    const GridBox& box =
      boxes[static_cast<std::size_t>(solids->GetTuple1(static_cast<vtkIdType>(face)))];
    const Point middle = TurnedBack(
      (1.0 / 3.0) * (surface.Points[ids[0]] + surface.Points[ids[1]] + surface.Points[ids[2]]));
    double nearest = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_GE(middle[axis], box.Low[axis] - error);
      EXPECT_LE(middle[axis], box.High[axis] + error);
      nearest = std::min({ nearest, std::abs(middle[axis] - box.Low[axis]),
        std::abs(middle[axis] - box.High[axis]) });
    }
    EXPECT_LE(nearest, error);
  }
}

class BooleanOperationCoplanar : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Points, BooleanOperationCoplanar, testing::Values(VTK_DOUBLE, VTK_FLOAT),
  [](const auto& info) { return info.param == VTK_FLOAT ? "Floats" : "Doubles"; });

TEST_P(BooleanOperationCoplanar, CrowdsOfTurnedBoxesHaveFewFaces)
{
  const double error = this->GetParam() == VTK_FLOAT ? 3e-5 : 1e-11;
  for (const int count : { 3, 10, 30, 100 })
  {
    SCOPED_TRACE(count);
    Random random(6000u + static_cast<std::uint64_t>(count));
    std::vector<GridBox> boxes;
    std::vector<Mesh> solids;
    GridCells cells;
    for (int i = 0; i < count; ++i)
    {
      boxes.emplace_back(random);
      solids.push_back(BoxTriangles(boxes.back().Low, boxes.back().High));
      cells |= boxes.back().Cells;
    }
    const Surface straight = Unite(solids, VTK_DOUBLE);
    const Surface turned = Unite(Map(solids, Turned), this->GetParam());
    EXPECT_NEAR(Reported(turned, "Volume"), static_cast<double>(cells.count()), error);
    EXPECT_NEAR(Reported(turned, "Area"), AreaOf(cells), error);
    EXPECT_LE(turned->GetNumberOfCells(), 1.25 * static_cast<double>(straight->GetNumberOfCells()));
    ExpectFacesOfBoxes(turned, boxes, error);
  }
}

/// A prism along z.
Mesh Prism(int sides, const Point& center, double radius, double height)
{
  Mesh prism;
  for (const double z : { 0.0, height })
  {
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / sides;
      prism.Add(center + Point{ radius * std::cos(angle), radius * std::sin(angle), z });
    }
  }
  for (int i = 0; i < sides; ++i)
  {
    const vtkIdType a = i;
    const vtkIdType b = (i + 1) % sides;
    prism.Add(VTK_TRIANGLE, { a, b, b + sides });
    prism.Add(VTK_TRIANGLE, { a, b + sides, a + sides });
    if (i > 0 && i + 1 < sides)
    {
      prism.Add(VTK_TRIANGLE, { 0, b, a });
      prism.Add(VTK_TRIANGLE, { sides, a + sides, b + sides });
    }
  }
  return prism;
}

TEST_P(BooleanOperationCoplanar, TurnedBodiesHaveTheFacesOfStraightOnes)
{
  const std::vector<std::vector<Mesh>> all = {
    // Corners that overlap, in two planes.
    { BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 }), BoxTriangles({ 1, 1, 0 }, { 3, 3, 2 }) },
    // One that is within the face of the other, and one that sticks out.
    { BoxTriangles({ 0, 0, 0 }, { 4, 4, 2 }), BoxTriangles({ 1, 1, 1 }, { 2, 2, 2 }),
      BoxTriangles({ 3, 1, 1 }, { 5, 2, 2 }) },
    // The border between the two is within the rim of what stands on it, and crosses it.
    { BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 }), BoxTriangles({ 1, 0.5, 0 }, { 3, 1.5, 2 }),
      BoxTriangles({ 1.5, 0.75, 1 }, { 2.5, 1.25, 3.5 }) },
    // Three that overlap in one place.
    { BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 }), BoxTriangles({ 1, 1, 0 }, { 3, 3, 2 }),
      BoxTriangles({ 0.5, -0.5, 0 }, { 1.5, 2.5, 2 }) },
    { Prism(12, { 0, 0, 0 }, 1.0, 1.0), Prism(17, { 0.8, 0.1, 0 }, 1.0, 1.0),
      Prism(9, { 0.3, 0.9, 0 }, 1.0, 1.0) },
  };
  // Sides of floats are bent along their diagonals, which are then seen where bodies cross.
  const bool areFloats = this->GetParam() == VTK_FLOAT;
  const double error = areFloats ? 1e-5 : 1e-12;
  const double more = areFloats ? 1.4 : 1.15;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Surface straight = Unite(all[i], VTK_DOUBLE);
    Random random(6100u + i);
    for (int turn = 0; turn < Amount(20); ++turn)
    {
      SCOPED_TRACE(std::to_string(i) + ", turn " + std::to_string(turn));
      const Surface turned = Unite(Map(all[i], RandomRotation(random, false)), this->GetParam());
      EXPECT_NEAR(Reported(turned, "Volume"), Reported(straight, "Volume"), error);
      EXPECT_NEAR(Reported(turned, "Area"), Reported(straight, "Area"), error);
      EXPECT_LE(
        turned->GetNumberOfCells(), more * static_cast<double>(straight->GetNumberOfCells()));
    }
  }
}

double FieldAt(const Point& x)
{
  return 3.0 * x[0] - 2.0 * x[1] + 0.5 * x[2] + 7.0;
}

/// Each cell has another value, so that none may be joined with another.
Surface WithData(const Mesh& solid)
{
  Surface mesh = MakePolyData(solid, VTK_DOUBLE);
  vtkNew<vtkDoubleArray> ofPoints, ofCells;
  ofPoints->SetName("field");
  ofCells->SetName("number");
  for (const Point& x : solid.Points)
  {
    ofPoints->InsertNextValue(FieldAt(x));
  }
  for (std::size_t cell = 0; cell < solid.Cells.size(); ++cell)
  {
    ofCells->InsertNextValue(static_cast<double>(cell));
  }
  mesh->GetPointData()->AddArray(ofPoints);
  mesh->GetCellData()->AddArray(ofCells);
  return mesh;
}

Point NormalOf(const Mesh& mesh, const CellSpec& cell)
{
  const Point& a = mesh.Points[cell.Points[0]];
  return Cross(mesh.Points[cell.Points[1]] - a, mesh.Points[cell.Points[2]] - a);
}

/// Whether a point in the plane of a triangle is beside it by more than rounding.
bool IsBeside(const Mesh& mesh, const CellSpec& cell, const Point& x)
{
  const Point normal = NormalOf(mesh, cell);
  for (int i = 0; i < 3; ++i)
  {
    const Point& from = mesh.Points[cell.Points[i]];
    const Point edge = mesh.Points[cell.Points[(i + 1) % 3]] - from;
    if (Dot(normal, Cross(edge, x - from)) < -1e-12 * Dot(normal, normal))
    {
      return true;
    }
  }
  return false;
}

/// The middle of each face is in the cell that it is said to be of, which faces as it does where
/// nothing is taken away; data of points are linear as those of the inputs.
void ExpectDataOfCells(vtkPolyData* output, const std::vector<Mesh>& solids, int operation)
{
  const Mesh surface = MeshOf(output);
  vtkDataArray* field = output->GetPointData()->GetArray("field");
  vtkCellData* data = output->GetCellData();
  ASSERT_TRUE(field && data->GetArray("SkdInputId") && data->GetArray("SkdCellId"));
  for (std::size_t point = 0; point < surface.Points.size(); ++point)
  {
    EXPECT_NEAR(
      field->GetTuple1(static_cast<vtkIdType>(point)), FieldAt(surface.Points[point]), 1e-11);
  }
  for (std::size_t face = 0; face < surface.Cells.size(); ++face)
  {
    const auto i = static_cast<vtkIdType>(face);
    const Mesh& of = solids[static_cast<std::size_t>(data->GetArray("SkdInputId")->GetTuple1(i))];
    const CellSpec& cell =
      of.Cells[static_cast<std::size_t>(data->GetArray("SkdCellId")->GetTuple1(i))];
    const Ids& ids = surface.Cells[face].Points;
    const Point middle =
      (1.0 / 3.0) * (surface.Points[ids[0]] + surface.Points[ids[1]] + surface.Points[ids[2]]);
    const Point normal = NormalOf(surface, surface.Cells[face]);
    EXPECT_FALSE(Length(normal) > 1e-12 && IsBeside(of, cell, middle)) << face;
    EXPECT_TRUE(operation != Filter::UNION || Dot(normal, NormalOf(of, cell)) > 0.0) << face;
  }
}

/// Parts of several cells are merged with those of the other body that lie on them.
TEST(BooleanOperationCoplanarData, FacesHaveTheDataOfCellsThatTheyAreIn)
{
  const std::vector<std::vector<Mesh>> pairs = {
    { BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 }), BoxTriangles({ 0.5, 0.5, 2 }, { 3, 1.25, 3 }) },
    { BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 }), BoxTriangles({ 1, 1, 0 }, { 3, 3, 2 }) },
    { BoxTriangles({ 0, 0, 0 }, { 2, 2, 2 }), BoxTriangles({ 0.25, 0.5, 1 }, { 1.25, 1.5, 2 }) },
    { Prism(7, { 0, 0, 0 }, 1.0, 1.0), Prism(5, { 0.4, 0.3, 1 }, 1.25, 1.0) },
    { Prism(7, { 0, 0, 0 }, 1.0, 1.0), Prism(11, { 0.4, 0.3, 0 }, 1.25, 1.0) },
  };
  Random random(6200);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    for (int turn = 0; turn < Amount(20); ++turn)
    {
      const std::vector<Mesh> solids = Map(pairs[i], RandomRotation(random, false));
      for (const int operation :
        { Filter::UNION, Filter::DIFFERENCE, Filter::SYMMETRIC_DIFFERENCE })
      {
        SCOPED_TRACE(std::to_string(i) + ", turn " + std::to_string(turn) + ", operation " +
          std::to_string(operation));
        vtkNew<Filter> filter;
        filter->SetInputData(WithData(solids[0]));
        filter->SetSourceData(WithData(solids[1]));
        filter->SetOperation(operation);
        filter->Update();
        ExpectDataOfCells(
          vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)), solids, operation);
      }
    }
  }
}
}
