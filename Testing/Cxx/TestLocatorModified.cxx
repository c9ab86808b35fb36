// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// What queries notice of a data set that is modified after the tree was built, without
// BuildLocator.

#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

using namespace skdtest;

namespace
{

constexpr Point Query{ 0.1, 0.15, 0.12 };

void MoveInPlace(vtkPoints* points)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Point p;
    points->GetPoint(i, p.data());
    points->SetPoint(i, p[0] + 0.5, p[1], p[2]);
  }
}

vtkUnsignedCharArray* GhostsOf(vtkPointSet* mesh)
{
  return vtkUnsignedCharArray::SafeDownCast(
    mesh->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
}

void AddGhosts(vtkPointSet* mesh, vtkIdType duplicate)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(mesh->GetNumberOfCells());
  ghosts->FillValue(0);
  ghosts->SetValue(duplicate, vtkDataSetAttributes::DUPLICATECELL);
  mesh->GetCellData()->AddArray(ghosts);
}

void AddArray(vtkPointSet* mesh)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Field");
  array->SetNumberOfValues(mesh->GetNumberOfPoints());
  array->FillValue(0.0);
  mesh->GetPointData()->AddArray(array);
}

/// One of the two kinds of meshes whose cells are asked for when they were modified.
struct Kind
{
  std::string Name;
  std::function<vtkSmartPointer<vtkPointSet>()> Make;
  std::function<vtkCellArray*(vtkPointSet*)> Cells;
};

class Modified : public testing::TestWithParam<Kind>
{
protected:
  vtkCellArray* Cells() const { return this->GetParam().Cells(this->Mesh); }

  Closest Ask() { return FindClosest(this->Locator, Query); }

  /// Whether a query now answers as a new locator of a copy of the mesh does, and otherwise than
  /// before.
  void ExpectNoticed()
  {
    vtkSmartPointer<vtkPointSet> copy;
    copy.TakeReference(this->Mesh->NewInstance());
    copy->DeepCopy(this->Mesh);
    const Closest now = this->Ask();
    EXPECT_EQ(now, FindClosest(MakeLocator(copy), Query));
    EXPECT_FALSE(now == this->Before);
  }

  vtkSmartPointer<vtkPointSet> Mesh = this->GetParam().Make();
  LocatorPointer Locator = MakeLocator(this->Mesh);
  const Closest Before = this->Ask();
};

INSTANTIATE_TEST_SUITE_P(Kinds, Modified,
  testing::Values(
    Kind{ "Grid", [] { return MakeGrid(Tetrahedra(2)); },
      [](vtkPointSet* mesh) { return vtkUnstructuredGrid::SafeDownCast(mesh)->GetCells(); } },
    Kind{ "Surface", [] { return MakePolyData(CubeTriangles(2)); },
      [](vtkPointSet* mesh) { return vtkPolyData::SafeDownCast(mesh)->GetPolys(); } }),
  [](const auto& kind) { return kind.param.Name; });

TEST_P(Modified, PointsInPlaceAreNoticed)
{
  MoveInPlace(this->Mesh->GetPoints());
  this->Mesh->GetPoints()->Modified();
  this->ExpectNoticed();
}

TEST_P(Modified, TheArrayOfPointsInPlaceIsNoticed)
{
  MoveInPlace(this->Mesh->GetPoints());
  this->Mesh->GetPoints()->GetData()->Modified();
  this->ExpectNoticed();
}

TEST_P(Modified, OlderPointsAreNoticed)
{
  vtkNew<vtkPoints> points;
  points->DeepCopy(this->Mesh->GetPoints());
  MoveInPlace(points);
  this->Locator->Modified();
  this->Ask(); // builds the tree when the points are there
  this->Mesh->SetPoints(points);
  this->ExpectNoticed();
}

TEST_P(Modified, CellsInPlaceAreNoticed)
{
  const vtkIdType first = this->Before.Cell;
  vtkNew<vtkIdList> another;
  this->Cells()->GetCellAtId(this->Cells()->GetNumberOfCells() - 1 - first, another);
  this->Cells()->ReplaceCellAtId(first, another);
  this->Cells()->Modified();
  this->ExpectNoticed();
}

TEST_P(Modified, NewGhostsAndTheirChangesAreNoticed)
{
  AddGhosts(this->Mesh, this->Before.Cell);
  this->ExpectNoticed();
  GhostsOf(this->Mesh)->FillValue(0);
  GhostsOf(this->Mesh)->Modified();
  EXPECT_EQ(this->Ask(), this->Before);
}

TEST_P(Modified, OtherArraysInPlaceLeaveTheTree)
{
  AddArray(this->Mesh);
  this->Ask();
  const vtkMTimeType built = this->Locator->GetBuildTime();
  this->Mesh->GetPointData()->GetArray("Field")->Modified();
  EXPECT_EQ(this->Ask(), this->Before);
  EXPECT_EQ(this->Locator->GetBuildTime(), built);
  this->Locator->BuildLocator();
  EXPECT_GT(this->Locator->GetBuildTime(), built) << "as of VTK's locators";
}

}
