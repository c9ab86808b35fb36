// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAttach: what comes out has the input's data and our locator, for the next filter.

#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/NamedMeshes.h"
#include "Support/VolumeMeshes.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSkdTreeAttach.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkStaticCellLocator.h"

#include <gtest/gtest.h>

#include <cmath>

#if __has_include("vtkCellLocatorStrategy.h")
#include "vtkCellLocatorStrategy.h" // deprecated in VTK 9.7
#define HAS_STRATEGY
#endif

using namespace skdtest;

namespace
{

using AttachPointer = vtkSmartPointer<vtkSkdTreeAttach>;

AttachPointer MakeAttach(vtkDataObject* input)
{
  auto made = AttachPointer::New();
  made->SetInputDataObject(input);
  return made;
}

vtkPointSet* OutputOf(vtkSkdTreeAttach* attach)
{
  attach->Update();
  return vtkPointSet::SafeDownCast(attach->GetOutputDataObject(0));
}

/// Ours, or nullptr.
vtkSkdTreeCellLocator* LocatorOf(vtkDataObject* mesh)
{
  auto* points = vtkPointSet::SafeDownCast(mesh);
  return vtkSkdTreeCellLocator::SafeDownCast(points ? points->GetCellLocator() : nullptr);
}

/// A copy of everything, in new arrays.
template <class Pointer>
Pointer DeepCopyOf(const Pointer& mesh)
{
  Pointer copy = Pointer::New();
  copy->DeepCopy(mesh);
  return copy;
}

class AttachToMesh : public testing::TestWithParam<NamedMesh>
{
};

INSTANTIATE_TEST_SUITE_P(All, AttachToMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(AttachToMesh, PassesTheDataAndAnswersAsALocatorOfItsOwn)
{
  const DataSetPointer input = WithData(GetParam().Make());
  AttachPointer attach = MakeAttach(input);
  attach->Update();
  auto* output = vtkDataSet::SafeDownCast(attach->GetOutputDataObject(0));
  ASSERT_EQ(output->GetDataObjectType(), input->GetDataObjectType());
  EXPECT_EQ(output->GetPointData()->GetArray("Linear"), input->GetPointData()->GetArray("Linear"));
  EXPECT_EQ(output->GetCellData()->GetArray("Number"), input->GetCellData()->GetArray("Number"));
  EXPECT_EQ(LocatorOf(input), nullptr);
  if (!vtkPointSet::SafeDownCast(input))
  {
    EXPECT_EQ(attach->GetTreesBuilt(), 0);
    return;
  }
  vtkSkdTreeCellLocator* attached = LocatorOf(output);
  ASSERT_NE(attached, nullptr);
  EXPECT_EQ(attached->GetDataSet(), output);
  vtkNew<vtkSkdTreeCellLocator> own;
  own->SetDataSet(input);
  own->BuildLocator();
  for (Point x : RandomQueries(input, 200))
  {
    ASSERT_EQ(attached->FindCell(x.data()), own->FindCell(x.data()));
  }
}

#ifdef HAS_STRATEGY
TEST(Attach, TheStrategyOfStreamTracersAsksIt)
{
  const GridPointer grid = MakeGrid(Polyhedra(3).Map(Bent));
  AttachPointer attach = MakeAttach(grid);
  vtkPointSet* output = OutputOf(attach);
  vtkNew<vtkCellLocatorStrategy> strategy;
  ASSERT_EQ(strategy->Initialize(output), 1);
  vtkNew<vtkGenericCell> cell;
  int subId;
  double pcoords[3], weights[32];
  int found = 0;
  for (Point x : RandomQueries(grid, 300))
  {
    const vtkIdType id =
      strategy->FindCell(x.data(), nullptr, cell, -1, 0.0, subId, pcoords, weights);
    ASSERT_EQ(id, LocatorOf(output)->FindCell(x.data()));
    found += id >= 0 ? 1 : 0;
  }
  EXPECT_GT(found, 50);
}
#endif

TEST(Attach, ImagesHaveNoLocatorAndPass)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 4, 5);
  AttachPointer attach = MakeAttach(image);
  EventCounter events(attach);
  attach->Update();
  EXPECT_EQ(vtkDataSet::SafeDownCast(attach->GetOutputDataObject(0))->GetNumberOfCells(), 24);
  EXPECT_EQ(attach->GetTreesBuilt(), 0);
  EXPECT_EQ(events.Errors + events.Warnings, 0);
}

TEST(Attach, OfBlocksEachHasALocatorOfItsOwn)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  const GridPointer left = MakeGrid(Hexahedra(2));
  const PolyDataPointer right = MakePolyData(Octahedron(1));
  AttachPointer attach = MakeAttach(MakeBlocks({ left, nullptr, image, right }));
  attach->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(attach->GetOutputDataObject(0));
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 4u);
  EXPECT_EQ(LocatorOf(blocks->GetBlock(0))->GetDataSet(), blocks->GetBlock(0));
  EXPECT_EQ(blocks->GetBlock(1), nullptr);
  EXPECT_NE(blocks->GetBlock(2), nullptr);
  EXPECT_EQ(LocatorOf(blocks->GetBlock(3))->GetDataSet(), blocks->GetBlock(3));
  EXPECT_EQ(attach->GetTreesBuilt(), 2);
}

TEST(Attach, InATimeSeriesTheTreeIsKeptUntilPointsMove)
{
  const GridPointer first = WithData(MakeGrid(Hexahedra(4).Map(Bent)));
  AttachPointer attach = MakeAttach(first);
  attach->Update();
  EXPECT_EQ(attach->GetTreesBuilt(), 1);

  const GridPointer sameValues = DeepCopyOf(first);
  sameValues->GetPointData()->GetArray("Linear")->Fill(1.0);
  attach->SetInputDataObject(sameValues);
  vtkPointSet* second = OutputOf(attach);
  EXPECT_EQ(attach->GetTreesBuilt(), 0);
  EXPECT_EQ(second->GetPointData()->GetArray("Linear")->GetTuple1(0), 1.0);
  EXPECT_EQ(LocatorOf(second)->GetDataSet(), second);

  const GridPointer moved = MakeGrid(Transformed(Hexahedra(4).Map(Bent), 1.0, { 100, 0, 0 }));
  attach->SetInputDataObject(moved);
  Point there = { 102.1, 2.1, 2.1 };
  EXPECT_GE(LocatorOf(OutputOf(attach))->FindCell(there.data()), 0);
  EXPECT_EQ(attach->GetTreesBuilt(), 1);
  Point here = { 2.1, 2.1, 2.1 };
  EXPECT_LT(LocatorOf(OutputOf(attach))->FindCell(here.data()), 0);
}

// What sources that reuse their output do. Points of single precision are copied by the tree, those
// of double precision shared.
TEST(Attach, PointsThatMoveInPlaceAreSearchedWhereTheyAre)
{
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const GridPointer grid = MakeGrid(Hexahedra(4).Map(Bent));
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->DeepCopy(grid->GetPoints());
    grid->SetPoints(points);
    AttachPointer attach = MakeAttach(grid);
    vtkPointSet* output = OutputOf(attach);
    Point here = { 2.1, 2.1, 2.1 };
    Point there = { 102.1, 2.1, 2.1 };
    EXPECT_GE(LocatorOf(output)->FindCell(here.data()), 0);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      Point p;
      points->GetPoint(i, p.data());
      p[0] += 100.0;
      points->SetPoint(i, p.data());
    }
    points->Modified();
    EXPECT_GE(LocatorOf(output)->FindCell(there.data()), 0) << "without an update";
    EXPECT_LT(LocatorOf(output)->FindCell(here.data()), 0);

    attach->SetInputDataObject(DeepCopyOf(grid)); // equal to what was kept, which has changed
    EXPECT_GE(LocatorOf(OutputOf(attach))->FindCell(there.data()), 0);
    EXPECT_EQ(attach->GetTreesBuilt(), 1);
  }
}

TEST(Attach, WhatChangesTheDataAloneDoesNotBuildATree)
{
  const GridPointer grid = WithData(MakeGrid(Hexahedra(4).Map(Bent)));
  AttachPointer attach = MakeAttach(grid);
  vtkPointSet* output = OutputOf(attach);
  const vtkMTimeType built = LocatorOf(output)->GetBuildTime();
  output->GetPointData()->SetActiveScalars("Linear");
  output->GetPointData()->RemoveArray("Linear");
  output->Modified();
  Point x = { 2.1, 2.1, 2.1 };
  EXPECT_GE(LocatorOf(output)->FindCell(x.data()), 0);
  LocatorOf(output)->BuildLocator();
  EXPECT_EQ(LocatorOf(output)->GetBuildTime(), built);
}

/// Tetrahedra that rotate about an axis, and the velocity of their points, in one data set for all
/// times, as of a source that reuses its output.
struct RotatingMesh
{
  static constexpr double Omega = 0.05;
  GridPointer Grid = MakeGrid(Tetrahedra(6));
  vtkNew<vtkPoints> Start;

  RotatingMesh() { this->Start->DeepCopy(this->Grid->GetPoints()); }

  static Point Rotated(const Point& p, double time)
  {
    const Point centre = { 3, 3, 0 };
    const double angle = Omega * time;
    const Point d = p - centre;
    return centre +
      Point{ std::cos(angle) * d[0] - std::sin(angle) * d[1],
        std::sin(angle) * d[0] + std::cos(angle) * d[1], d[2] };
  }

  void MoveTo(double time, vtkPointSet* mesh) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> vectors;
    vectors->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < this->Start->GetNumberOfPoints(); ++i)
    {
      Point p;
      this->Start->GetPoint(i, p.data());
      p = Rotated(p, time);
      points->InsertNextPoint(p.data());
      vectors->InsertNextTuple3(-Omega * (p[1] - 3.0), Omega * (p[0] - 3.0), 0.0);
    }
    mesh->SetPoints(points);
    mesh->GetPointData()->SetVectors(vectors);
  }
};

/// NaN outside.
Point VelocityAt(vtkPointSet* mesh, Point x)
{
  int subId;
  double pcoords[3], weights[8];
  vtkNew<vtkGenericCell> cell;
  const vtkIdType id = LocatorOf(mesh)->FindCell(x.data(), 0.0, cell, subId, pcoords, weights);
  Point sum = { id < 0 ? NAN : 0.0, 0, 0 };
  for (vtkIdType i = 0; id >= 0 && i < cell->GetNumberOfPoints(); ++i)
  {
    Point v;
    mesh->GetPointData()->GetVectors()->GetTuple(cell->GetPointId(i), v.data());
    sum = sum + weights[i] * v;
  }
  return sum;
}

// What vtkParticleTracer does with meshes of the same topology.
TEST(Attach, ParticlesInARotatingMeshStayInIt)
{
  const RotatingMesh rotating;
  rotating.MoveTo(0.0, rotating.Grid);
  AttachPointer attach = MakeAttach(rotating.Grid);
  vtkPointSet* mesh = OutputOf(attach);
  LocatorOf(mesh)->UseExistingSearchStructureOn();
  const Point seed = { 4.1, 3.2, 2.9 };
  Point x = seed;
  for (int step = 1; step <= 40; ++step)
  {
    const Point half = x + 0.5 * VelocityAt(mesh, x);
    x = x + VelocityAt(mesh, half);
    rotating.MoveTo(step, mesh);
    LocatorOf(mesh)->BuildLocator();
  }
  EXPECT_LT(Distance(x, RotatingMesh::Rotated(seed, 40)), 1e-3);
}

// VTK 9.6 stores the types of such a grid otherwise than one by one.
TEST(Attach, OfCellsOfOneTypeTheTreeIsKept)
{
  const auto make = []
  {
    const GridPointer mixed = MakeGrid(Tetrahedra(3));
    GridPointer grid = GridPointer::New();
    grid->SetPoints(mixed->GetPoints());
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy(mixed->GetCells());
    grid->SetCells(VTK_TETRA, cells);
    return grid;
  };
  AttachPointer attach = MakeAttach(make());
  vtkSkdTreeCellLocator* locator = LocatorOf(OutputOf(attach));
  Point x = { 1.2, 1.3, 1.4 };
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), make()->GetNumberOfCells());
  EXPECT_GE(locator->FindCell(x.data()), 0);
  attach->SetInputDataObject(make());
  attach->Update();
  EXPECT_EQ(attach->GetTreesBuilt(), 0);
}

TEST(Attach, SettingsReachTheTreeAndBuildItAnew)
{
  const GridPointer grid = MakeGrid(Tetrahedra(2));
  MarkGhosts(grid, { 0, 1, 2 }, vtkDataSetAttributes::DUPLICATECELL);
  AttachPointer attach = MakeAttach(grid);
  EXPECT_EQ(LocatorOf(OutputOf(attach))->GetNumberOfCellsInTree(), 45);
  attach->SkipGhostCellsOff();
  EXPECT_EQ(LocatorOf(OutputOf(attach))->GetNumberOfCellsInTree(), 48);
  EXPECT_EQ(attach->GetTreesBuilt(), 1);
  attach->LazyBuildOn();
  EXPECT_TRUE(LocatorOf(OutputOf(attach))->GetLazyBuild());
  EXPECT_EQ(attach->GetTreesBuilt(), 1);
  attach->SetEpsilon(1e-3);
  EXPECT_EQ(LocatorOf(OutputOf(attach))->GetEpsilon(), 1e-3);
  EXPECT_EQ(attach->GetTreesBuilt(), 1);
  attach->Modified();
  attach->Update();
  EXPECT_EQ(attach->GetTreesBuilt(), 0);
}

TEST(Attach, TheInputsOwnLocatorStaysItsOwn)
{
  const GridPointer grid = MakeGrid(Hexahedra(2));
  vtkNew<vtkStaticCellLocator> theirs;
  theirs->SetDataSet(grid);
  grid->SetCellLocator(theirs);
  EXPECT_NE(LocatorOf(OutputOf(MakeAttach(grid))), nullptr);
  EXPECT_EQ(grid->GetCellLocator(), theirs.Get());
}

TEST(Attach, WithoutCellsTheLocatorFindsNothing)
{
  vtkNew<vtkPolyData> empty;
  AttachPointer attach = MakeAttach(empty);
  EventCounter events(attach);
  Point x = { 0, 0, 0 };
  EXPECT_EQ(LocatorOf(OutputOf(attach))->FindCell(x.data()), -1);
  EXPECT_EQ(events.Errors + events.Warnings, 0);
}

TEST(Attach, AnAbortLeavesTheRestWithoutLocators)
{
  AttachPointer attach = MakeAttach(MakeBlocks(Hexahedra(2), 6));
  const std::vector<double> visited = AbortAt(attach, 0.4);
  EXPECT_TRUE(std::is_sorted(visited.begin(), visited.end()));
  EXPECT_LT(attach->GetTreesBuilt(), 6);
  attach->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(attach->GetOutputDataObject(0));
  for (unsigned int i = 0; i < 6; ++i)
  {
    EXPECT_NE(LocatorOf(output->GetBlock(i)), nullptr);
  }
}

}
