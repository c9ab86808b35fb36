// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that other people made: those of Data/, and of the folder SKDTREE_EXTRA_DATA_DIR if it is
// there.

#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"
#include "Support/OnFile.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

class RealMesh : public OnFile
{
protected:
  void SetUp() override
  {
    OnFile::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Data = ReadMesh(GetParam());
    ASSERT_NE(this->Data, nullptr);
    ASSERT_GT(this->Data->GetNumberOfCells(), 0);
    this->Locator = MakeLocator(this->Data);
    this->Data->GetBounds(this->Box.data());
  }

  /// Near the mesh and far from it, and at its points.
  std::vector<Point> Queries(int count)
  {
    Random random(190);
    std::vector<Point> queries;
    for (int i = 0; i < count; ++i)
    {
      queries.push_back(random.InBox(Grown(this->Box, (i % 3) * 0.2 * Diagonal(this->Box))));
      Point x;
      this->Data->GetPoint(random.Index(int(this->Data->GetNumberOfPoints())), x.data());
      queries.push_back(x + (1e-3 * Diagonal(this->Box)) * random.Direction());
    }
    return queries;
  }

  DataSetPointer Data;
  LocatorPointer Locator;
  Bounds Box;
};

class RealVolume : public RealMesh
{
};

class RealSurface : public RealMesh
{
};

const std::string Shipped = DataFolder();
const std::string Extra = ExtraDataFolder();

INSTANTIATE_TEST_SUITE_P(Shipped, RealMesh, testing::ValuesIn(MeshFiles(Shipped)), NameOfFile());
INSTANTIATE_TEST_SUITE_P(
  Shipped, RealVolume, testing::ValuesIn(VolumeFiles(Shipped)), NameOfFile());
INSTANTIATE_TEST_SUITE_P(
  Shipped, RealSurface, testing::ValuesIn(SurfaceFiles(Shipped)), NameOfFile());
INSTANTIATE_TEST_SUITE_P(Extra, RealMesh, testing::ValuesIn(MeshFiles(Extra)), NameOfFile());
INSTANTIATE_TEST_SUITE_P(Extra, RealVolume, testing::ValuesIn(VolumeFiles(Extra)), NameOfFile());
INSTANTIATE_TEST_SUITE_P(Extra, RealSurface, testing::ValuesIn(SurfaceFiles(Extra)), NameOfFile());

TEST_P(RealMesh, ClosestPointsAreNoFartherThanAnyCell)
{
  const auto queries = this->Queries(8);
  std::vector<double> distances;
  const double slack = 1e-9 * Scale(this->Box);
  for (const Point& x : queries)
  {
    const Closest c = FindClosest(this->Locator, x);
    ASSERT_GE(c.Cell, 0);
    ASSERT_NEAR(Distance(c.X, x), std::sqrt(c.Dist2), slack);
    vtkNew<vtkGenericCell> cell;
    this->Data->GetCell(c.Cell, cell);
    ASSERT_LE(DistanceToRealCell(cell, c.X), slack + Flatness(cell)) << "cell " << c.Cell;
    distances.push_back(std::sqrt(c.Dist2));
  }
  const auto nearer = FindNearerCell(this->Data, queries, distances, slack);
  EXPECT_EQ(nearer.Cell, -1) << "query " << nearer.Query << ": " << nearer.Distance
                             << " instead of " << distances[std::max(0, nearer.Query)];
}

TEST_P(RealVolume, EachCellIsFoundAtItsMiddle)
{
  const vtkIdType step = std::max<vtkIdType>(1, this->Data->GetNumberOfCells() / 3000);
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < this->Data->GetNumberOfCells(); id += step)
  {
    this->Data->GetCell(id, cell);
    if (cell->GetCellDimension() != 3)
    {
      continue;
    }
    Point x = { 0, 0, 0 };
    const auto points = ToVector(cell->GetPoints());
    for (const Point& p : points)
    {
      x = x + (1.0 / double(points.size())) * p;
    }
    const Found f = FindCell(this->Locator, x);
    ASSERT_GE(f.Cell, 0) << "middle of cell " << id;
    this->Data->GetCell(f.Cell, cell);
    Point byWeights = { 0, 0, 0 };
    for (std::size_t i = 0; i < f.Weights.size(); ++i)
    {
      Point p;
      cell->GetPoints()->GetPoint(vtkIdType(i), p.data());
      byWeights = byWeights + f.Weights[i] * p;
    }
    ASSERT_LE(Distance(byWeights, x), 1e-9 * Scale(this->Box)) << "cell " << f.Cell;
  }
}

TEST_P(RealMesh, FirstHitsAreTheFirstOfAllHits)
{
  Random random(191);
  vtkNew<vtkGenericCell> cell;
  const double size = Diagonal(this->Box);
  for (int i = 0; i < 300; ++i)
  {
    const Point through = random.InBox(this->Box);
    const Point along = size * random.Direction();
    const LineHit first = FindFirstHit(this->Locator, through - along, through + along);
    const LineHits all = FindAllHits(this->Locator, through - along, through + along, 0.0, cell);
    ASSERT_EQ(first.Found, all.Found);
    if (first.Found)
    {
      ASSERT_EQ(first.Cell, all.Cells[0]);
      ASSERT_EQ(first.X, all.Points[0]);
    }
  }
}

TEST_P(RealSurface, KeepsParityIfClosed)
{
  const Mesh surface = SurfaceOf(this->Data);
  if (!IsClosed(surface))
  {
    GTEST_SKIP() << "not a closed surface of triangles and quads";
  }
  Random random(192);
  const double far = 3 * Diagonal(this->Box);
  int wrong = 0;
  for (int i = 0; i < 1500; ++i)
  {
    const CellSpec& cell = surface.Cells[random.Index(int(surface.Cells.size()))];
    const std::size_t corner = random.Index(int(cell.Points.size()));
    const Point& a = surface.Points[cell.Points[corner]];
    const Point& b = surface.Points[cell.Points[(corner + 1) % cell.Points.size()]];
    const Point target = Lerp(a, b, (i % 3) * 0.5); // a vertex or the middle of an edge
    const Point along = far * random.Direction();
    const Point p1 = target - along;
    const Point p2 = target + along;
    wrong += this->Locator->CountCrossings(p1.data(), p2.data()) % 2 != 0;
  }
  EXPECT_EQ(wrong, 0);
}

TEST_P(RealMesh, CellsWithinBoundsAreExact)
{
  Random random(193);
  std::vector<Bounds> boxes;
  std::vector<std::size_t> counts(6, 0);
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    boxes.push_back(EmptyBounds());
    const Point x = random.InBox(this->Box);
    Extend(boxes.back(), x);
    Extend(boxes.back(), x + (0.1 * Diagonal(this->Box)) * random.Direction());
  }
  for (vtkIdType id = 0; id < this->Data->GetNumberOfCells(); ++id)
  {
    Bounds bounds;
    this->Data->GetCellBounds(id, bounds.data());
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      counts[i] += Overlap(boxes[i], bounds);
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    ASSERT_EQ(FindWithinBounds(this->Locator, boxes[i]).size(), counts[i]);
  }
}

}
