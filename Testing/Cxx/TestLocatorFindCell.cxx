// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// FindCell and FindCellWithHint.

#include "Support/LocatorOnMesh.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// The lowest of several, -1 of none.
vtkIdType Lowest(const Ids& ids)
{
  return ids.empty() ? -1 : *std::min_element(ids.begin(), ids.end());
}

class FindCellOnMesh : public LocatorOnMesh
{
protected:
  std::vector<Point> Queries(int count, double grow)
  {
    Random random(60);
    std::vector<Point> queries;
    const double size = Diagonal(this->Reference.GetBounds());
    for (int i = 0; i < count; ++i)
    {
      queries.push_back(random.InBox(Grown(this->Reference.GetBounds(), grow * size)));
    }
    return queries;
  }

  /// Random points of random cells.
  std::vector<Point> PointsOnCells(int count)
  {
    Random random(61);
    vtkNew<vtkGenericCell> cell;
    std::vector<Point> points;
    for (int i = 0; i < count; ++i)
    {
      this->Data->GetCell(random.Index(int(this->Data->GetNumberOfCells())), cell);
      Point sum = { 0, 0, 0 };
      double total = 0;
      for (const Point& p : ToVector(cell->GetPoints()))
      {
        const double weight = random.Between(0.05, 1);
        sum = sum + weight * p;
        total += weight;
      }
      points.push_back((1 / total) * sum);
    }
    return points;
  }
};

class FindCellInVolume : public FindCellOnMesh
{
};

INSTANTIATE_TEST_SUITE_P(All, FindCellOnMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());
INSTANTIATE_TEST_SUITE_P(
  Volumes, FindCellInVolume, testing::ValuesIn(VolumeMeshes()), NameOfMesh());

TEST_P(FindCellInVolume, IsTheLowestOfTheCellsThatContainThePoint)
{
  int inside = 0;
  for (const Point& x : this->Queries(400, 0.05))
  {
    const vtkIdType expected = Lowest(this->Reference.FindContaining(x));
    inside += expected >= 0;
    ASSERT_EQ(FindCell(this->Locator, x).Cell, expected)
      << "at (" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  }
  EXPECT_GT(inside, 20);
}

TEST_P(FindCellInVolume, ParametricCoordinatesAndWeightsReproduceThePoint)
{
  vtkNew<vtkGenericCell> cell;
  const double tolerance = 1e-12 * Scale(this->Reference.GetBounds());
  std::vector<double> weights(this->Data->GetMaxCellSize() + 1);
  for (const Point& x : this->PointsOnCells(200))
  {
    Found f = FindCell(this->Locator, x);
    ASSERT_GE(f.Cell, 0);
    this->Data->GetCell(f.Cell, cell);
    Point byPcoords;
    cell->EvaluateLocation(f.SubId, f.Pcoords.data(), byPcoords.data(), weights.data());
    ASSERT_LE(Distance(byPcoords, x), tolerance) << "cell " << f.Cell;
    Point byWeights = { 0, 0, 0 };
    double sum = 0;
    const auto points = ToVector(cell->GetPoints());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      byWeights = byWeights + f.Weights[i] * points[i];
      sum += f.Weights[i];
    }
    ASSERT_NEAR(sum, 1.0, 1e-12);
    ASSERT_LE(Distance(byWeights, x), 10 * tolerance) << "cell " << f.Cell;
  }
}

TEST_P(FindCellInVolume, GenericCellHoldsTheReturnedCell)
{
  vtkNew<vtkGenericCell> cell, expected;
  std::vector<double> weights(this->Data->GetMaxCellSize() + 1);
  for (Point x : this->PointsOnCells(30))
  {
    Found f;
    f.Cell = this->Locator->FindCell(x.data(), 0.0, cell, f.Pcoords.data(), weights.data());
    ASSERT_GE(f.Cell, 0);
    this->Data->GetCell(f.Cell, expected);
    ASSERT_EQ(cell->GetCellType(), expected->GetCellType());
    ASSERT_EQ(ToVector(cell->GetPointIds()), ToVector(expected->GetPointIds()));
    ASSERT_EQ(ToVector(cell->GetPoints()), ToVector(expected->GetPoints()));
  }
}

TEST_P(FindCellInVolume, AnyHintGivesTheSameAnswer)
{
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(this->Data->GetMaxCellSize() + 1);
  const vtkIdType cells = this->Data->GetNumberOfCells();
  Random random(62);
  for (Point x : this->Queries(100, 0.05))
  {
    const Found expected = FindCell(this->Locator, x);
    for (vtkIdType hint : { vtkIdType(-1), vtkIdType(random.Index(int(cells))), expected.Cell,
           cells, cells + 1000000, vtkIdType(-77) })
    {
      Found f;
      f.Cell = this->Locator->FindCellWithHint(
        x.data(), 0.0, hint, cell, f.SubId, f.Pcoords.data(), weights.data());
      ASSERT_EQ(f.Cell, expected.Cell) << "hint " << hint;
      if (f.Cell >= 0)
      {
        ASSERT_EQ(f.Pcoords, expected.Pcoords) << "hint " << hint;
      }
    }
  }
}

TEST_P(FindCellOnMesh, WithAToleranceIsTheNearestWithinIt)
{
  int misses = 0;
  for (const Point& x : this->Queries(120, 0.2))
  {
    const double distance = this->Reference.FindNearest(x).Distance;
    const double wide = distance + 1e-9 * Scale(this->Reference.GetBounds());
    const Found f = FindCell(this->Locator, x, wide * wide);
    ASSERT_GE(f.Cell, 0);
    ASSERT_NEAR(this->Reference.DistanceTo(f.Cell, x), distance, 2 * this->Reference.Tolerance());
    const Found farther = FindCell(this->Locator, x, 100 * wide * wide);
    ASSERT_EQ(farther, f) << "a larger tolerance finds the same";
    const double narrow = distance - 1e-9 * Scale(this->Reference.GetBounds());
    if (narrow > 0)
    {
      ++misses;
      ASSERT_EQ(FindCell(this->Locator, x, narrow * narrow).Cell, -1);
    }
  }
  EXPECT_GT(misses, 10);
}

TEST_P(FindCellOnMesh, WithinTheToleranceTheWeightsAreThoseOfTheNearestPoint)
{
  vtkNew<vtkGenericCell> cell;
  const double tolerance = 1e-7 * Scale(this->Reference.GetBounds());
  for (const Point& x : this->Queries(60, 0.2))
  {
    const Closest c = FindClosest(this->Locator, x);
    const Found f = FindCell(this->Locator, x, std::numeric_limits<double>::infinity());
    ASSERT_GE(f.Cell, 0);
    this->Data->GetCell(f.Cell, cell);
    Point byWeights = { 0, 0, 0 };
    const auto points = ToVector(cell->GetPoints());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      byWeights = byWeights + f.Weights[i] * points[i];
    }
    ASSERT_NEAR(Distance(byWeights, x), std::sqrt(c.Dist2), tolerance) << "cell " << f.Cell;
  }
}

TEST_P(FindCellOnMesh, AllFormsAgree)
{
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(this->Data->GetMaxCellSize() + 1);
  for (Point x : this->PointsOnCells(40))
  {
    const vtkIdType expected = FindCell(this->Locator, x).Cell;
    Found f;
    EXPECT_EQ(this->Locator->FindCell(x.data()), expected);
    EXPECT_EQ(this->Locator->FindCell(x.data(), 0.0), expected);
    EXPECT_EQ(
      this->Locator->FindCell(x.data(), 0.0, cell, f.Pcoords.data(), weights.data()), expected);
    EXPECT_EQ(this->Locator->FindCell(x.data(), 0.0, nullptr, f.SubId, f.Pcoords.data(), nullptr),
      expected);
  }
}

// Lattice meshes have all their faces on exact coordinates: who owns a shared face is decided.
class FindCellOnLattice : public testing::TestWithParam<NamedMesh>
{
};

INSTANTIATE_TEST_SUITE_P(Meshes, FindCellOnLattice,
  testing::ValuesIn(std::vector<NamedMesh>{ { "Hexahedra", [] { return MakeGrid(Hexahedra(4)); } },
    { "Inverted", [] { return MakeGrid(InvertedHexahedra(4)); } },
    { "Voxels", [] { return MakeGrid(Voxels(4)); } },
    { "Image",
      []
      {
        auto image = MakeImage(4);
        image->SetOrigin(0, 0, 0);
        image->SetSpacing(1, 1, 1);
        return image;
      } } }),
  NameOfMesh());

TEST_P(FindCellOnLattice, APointOnASharedFaceBelongsToTheLowestId)
{
  const auto data = GetParam().Make();
  const auto locator = MakeLocator(data);
  BruteForce reference(data);
  for (int i = 0; i <= 8; ++i)
  {
    for (int j = 0; j <= 8; ++j)
    {
      for (int k = 0; k <= 8; ++k)
      {
        const Point x = { 0.5 * i, 0.5 * j, 0.5 * k };
        const vtkIdType expected =
          Lowest(reference.FindWithinBounds({ x[0], x[0], x[1], x[1], x[2], x[2] }));
        ASSERT_EQ(FindCell(locator, x).Cell, expected) << x[0] << " " << x[1] << " " << x[2];
      }
    }
  }
}

TEST(FindCell, OfTetrahedraSharedFacesBelongToTheLowestId)
{
  const Mesh mesh = Tetrahedra(3);
  const auto data = MakeGrid(mesh);
  const auto locator = MakeLocator(data);
  const auto contains = [&mesh](const CellSpec& cell, const Point& x)
  {
    for (int out = 0; out < 4; ++out)
    {
      Point p[4];
      for (int i = 0; i < 4; ++i)
      {
        p[i] = mesh.Points[cell.Points[(out + i) % 4]];
      }
      const Point normal = Cross(p[2] - p[1], p[3] - p[1]);
      if (Dot(normal, x - p[1]) * Dot(normal, p[0] - p[1]) < 0) // exact on the lattice
      {
        return false;
      }
    }
    return true;
  };
  for (int id = 0; id < 13 * 13 * 13; ++id)
  {
    const Point x = { 0.25 * (id % 13), 0.25 * (id / 13 % 13), 0.25 * (id / 169) };
    vtkIdType expected = 0;
    while (!contains(mesh.Cells[expected], x))
    {
      ++expected;
    }
    ASSERT_EQ(FindCell(locator, x).Cell, expected) << x[0] << " " << x[1] << " " << x[2];
  }
}

TEST(FindCell, OnASheetIsTheCellUnderThePoint)
{
  for (int type : { VTK_TRIANGLE, VTK_QUAD, VTK_PIXEL })
  {
    const auto data = MakeGrid(Sheet(6, type));
    const auto locator = MakeLocator(data);
    BruteForce reference(data);
    Random random(63);
    for (int i = 0; i < 200; ++i)
    {
      const Point x = random.InBox({ -1, 7, -1, 7, 0, 0 });
      const auto nearest = reference.FindNearest(x);
      ASSERT_EQ(FindCell(locator, x).Cell, nearest.Distance < 1e-15 ? nearest.Cell : -1)
        << x[0] << " " << x[1];
      ASSERT_EQ(FindCell(locator, x + Point{ 0, 0, 1e-9 }).Cell, -1);
    }
  }
}

TEST(FindCell, AMissByRoundingAloneIsContained)
{
  const auto data = MakeGrid(Hexahedra(2));
  const auto locator = MakeLocator(data);
  const double ulp = std::nextafter(2.0, 3.0) - 2.0;
  EXPECT_GE(FindCell(locator, { 2.0 + 2 * ulp, 1.5, 1.5 }).Cell, 0);
  EXPECT_EQ(FindCell(locator, { 2.0 + 1e-9, 1.5, 1.5 }).Cell, -1);
}

TEST(FindCell, ToleranceFindsTheNearestNotTheFirst)
{
  // Every cell of the row lies within the tolerance; the last is nearest.
  Mesh mesh;
  for (int i = 0; i < 50; ++i)
  {
    const double z = -0.01 * (50 - i);
    const vtkIdType a = mesh.Add(Point{ 0, 0, z });
    const vtkIdType b = mesh.Add(Point{ 1, 0, z });
    const vtkIdType c = mesh.Add(Point{ 0, 1, z });
    mesh.Add(VTK_TRIANGLE, { a, b, c });
  }
  const auto data = MakePolyData(mesh);
  EXPECT_EQ(FindCell(MakeLocator(data), { 0.2, 0.2, 0.001 }, 1.0).Cell, 49);
}

TEST(FindCell, NegativeToleranceCountsAsZero)
{
  const auto data = MakeGrid(Hexahedra(2));
  const auto locator = MakeLocator(data);
  EXPECT_EQ(FindCell(locator, { 0.5, 0.5, 1.5 }, -1.0).Cell, 4);
  EXPECT_EQ(FindCell(locator, { 0.5, 0.5, 2.5 }, -1.0).Cell, -1);
}

TEST(FindCell, InOverlappingMeshesTheHintWins)
{
  Mesh mesh = Hexahedra(2);
  const auto cells = mesh.Cells;
  mesh.Cells.insert(mesh.Cells.end(), cells.begin(), cells.end());
  const auto data = MakeGrid(mesh);
  const auto locator = MakeLocator(data);
  Point x = { 0.5, 0.5, 0.25 };
  EXPECT_EQ(FindCell(locator, x).Cell, 0);
  Found f;
  double weights[8];
  EXPECT_EQ(
    locator->FindCellWithHint(x.data(), 0.0, 8, nullptr, f.SubId, f.Pcoords.data(), weights), 8);
  EXPECT_EQ(f.Pcoords, (Point{ 0.5, 0.5, 0.25 }));
}

TEST(FindCell, ThroughTheAbstractClassAnswersTheSame)
{
  const auto data = MakeGrid(Tetrahedra(2));
  const auto locator = MakeLocator(data);
  vtkAbstractCellLocator* abstract = locator;
  Point x = { 0.3, 1.2, 0.9 };
  EXPECT_EQ(abstract->FindCell(x.data()), FindCell(locator, x).Cell);
}

}
