// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The results of vtkStaticCellLocator where it is right; where it is not, how often is recorded as
// a property of the test.

#include "Support/BruteForce.h"
#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include "vtkStaticCellLocator.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

class AgainstStatic : public testing::Test
{
protected:
  void Build(vtkDataSet* data)
  {
    this->Data = data;
    this->Ours = MakeLocator(data);
    this->Theirs->SetDataSet(data);
    this->Theirs->BuildLocator();
    data->GetBounds(this->Box.data());
  }

  LineHit TheirHit(const Point& p1, const Point& p2, double tol)
  {
    LineHit h;
    h.Cell = -1;
    h.Found = this->Theirs->IntersectWithLine(
      p1.data(), p2.data(), tol, h.T, h.X.data(), h.Pcoords.data(), h.SubId, h.Cell, this->Cell);
    return h;
  }

  DataSetPointer Data;
  LocatorPointer Ours;
  vtkNew<vtkStaticCellLocator> Theirs;
  vtkNew<vtkGenericCell> Cell;
  Bounds Box;
};

TEST_F(AgainstStatic, ClosestPointsOnTrianglesAreTheSame)
{
  this->Build(MakePolyData(SphereTriangles(16)));
  Random random(200);
  for (int i = 0; i < 1000; ++i)
  {
    const Point x = random.InBox(Grown(this->Box, 0.5));
    Closest theirs;
    this->Theirs->FindClosestPoint(
      x.data(), theirs.X.data(), this->Cell, theirs.Cell, theirs.SubId, theirs.Dist2);
    const Closest ours = FindClosest(this->Ours, x);
    ASSERT_NEAR(std::sqrt(ours.Dist2), std::sqrt(theirs.Dist2), 1e-12);
    ASSERT_LE(Distance(ours.X, theirs.X), 1e-6);
  }
}

TEST_F(AgainstStatic, HitsOnTrianglesAreTheSame)
{
  this->Build(MakePolyData(TorusTriangles(40, 20)));
  Random random(201);
  for (int i = 0; i < 1000; ++i)
  {
    const Point through = random.InBox(this->Box);
    const Point along = 3.0 * random.Direction();
    const LineHit ours = FindFirstHit(this->Ours, through - along, through + along);
    const LineHit theirs = this->TheirHit(through - along, through + along, 1e-10);
    ASSERT_EQ(ours.Found, theirs.Found);
    if (ours.Found)
    {
      ASSERT_EQ(ours.Cell, theirs.Cell);
      ASSERT_NEAR(ours.T, theirs.T, 1e-9);
    }
  }
}

TEST_F(AgainstStatic, CellsOfTetrahedraAreTheSame)
{
  this->Build(MakeGrid(Tetrahedra(6)));
  BruteForce reference(this->Data);
  Random random(202);
  int differences = 0;
  double pcoords[3], weights[8];
  for (int i = 0; i < 2000; ++i)
  {
    Point x = random.InBox(Grown(this->Box, 0.2));
    const vtkIdType ours = FindCell(this->Ours, x).Cell;
    const vtkIdType theirs = this->Theirs->FindCell(x.data(), 0.0, this->Cell, pcoords, weights);
    if (ours != theirs)
    {
      ++differences; // VTK's tetrahedra reach a thousandth beyond their faces
      ASSERT_TRUE(ours >= 0 ? reference.IsInside(ours, x) || reference.DistanceTo(ours, x) < 1e-14
                            : reference.DistanceTo(theirs, x) > 0.0);
    }
  }
  RecordProperty("CellsThatVtkAssignsToANeighbour", differences);
  EXPECT_LT(differences, 100);
}

TEST_F(AgainstStatic, FindsNoMoreCellsWithinBounds)
{
  this->Build(MakePolyData(SphereTriangles(24)));
  BruteForce reference(this->Data);
  Random random(203);
  std::size_t ours = 0;
  std::size_t theirs = 0;
  vtkNew<vtkIdList> ids;
  for (int i = 0; i < 200; ++i)
  {
    Bounds box = EmptyBounds();
    const Point x = random.Direction();
    Extend(box, x);
    Extend(box, x + 0.2 * random.Direction());
    const Ids cells = FindWithinBounds(this->Ours, box);
    ASSERT_EQ(cells, reference.FindWithinBounds(box));
    this->Theirs->FindCellsWithinBounds(box.data(), ids);
    const Ids more = Sorted(ToVector(ids));
    ASSERT_TRUE(std::includes(more.begin(), more.end(), cells.begin(), cells.end()));
    ours += cells.size();
    theirs += more.size();
  }
  RecordProperty("CellsWithinBounds", int(ours));
  RecordProperty("CellsWithinBoundsOfVtk", int(theirs));
}

TEST_F(AgainstStatic, LosesNoLineAtEdgesAndVertices)
{
  const Mesh mesh = SphereTriangles(12);
  this->Build(MakePolyData(mesh));
  Random random(204);
  int lostByUs = 0;
  int lostByThem = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const CellSpec& cell = mesh.Cells[random.Index(int(mesh.Cells.size()))];
    const Point target =
      Lerp(mesh.Points[cell.Points[0]], mesh.Points[cell.Points[1]], (i % 3) * 0.5);
    const Point inside = 0.5 * random.Direction();
    const Point beyond = target + 2.0 * (target - inside);
    lostByUs += FindFirstHit(this->Ours, inside, beyond).Found == 0;
    lostByThem += this->TheirHit(inside, beyond, 0.0).Found == 0;
  }
  EXPECT_EQ(lostByUs, 0);
  RecordProperty("LinesLostByVtk", lostByThem);
}

TEST_F(AgainstStatic, WithAToleranceFindsTheNearest)
{
  this->Build(MakeGrid(Tetrahedra(5)));
  BruteForce reference(this->Data);
  Random random(205);
  int missedByThem = 0;
  double pcoords[3], weights[8];
  for (int i = 0; i < 500; ++i)
  {
    Point x = random.InBox(Grown(this->Box, 0.1));
    const vtkIdType ours = FindCell(this->Ours, x, 0.09).Cell;
    ASSERT_GE(ours, 0);
    ASSERT_NEAR(reference.DistanceTo(ours, x), reference.FindNearest(x).Distance, 1e-12);
    missedByThem += this->Theirs->FindCell(x.data(), 0.09, this->Cell, pcoords, weights) < 0;
  }
  RecordProperty("CellsWithinTheToleranceMissedByVtk", missedByThem);
}

}
