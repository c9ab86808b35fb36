// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Any vtkDataSet: kinds of grids, precision of points, storage of cells, ghosts and blanking.

#include "Support/BruteForce.h"
#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

/// The same results of a hundred queries of each kind.
void ExpectSameAnswers(vtkDataSet* a, vtkDataSet* b)
{
  const auto locatorA = MakeLocator(a);
  const auto locatorB = MakeLocator(b);
  Bounds box;
  a->GetBounds(box.data());
  Random random(140);
  for (int i = 0; i < 100; ++i)
  {
    const Point x = random.InBox(Grown(box, 0.2 * Diagonal(box)));
    const Point y = random.InBox(Grown(box, 0.2 * Diagonal(box)));
    ASSERT_EQ(FindClosest(locatorA, x), FindClosest(locatorB, x));
    ASSERT_EQ(FindFirstHit(locatorA, x, y), FindFirstHit(locatorB, x, y));
    ASSERT_EQ(FindCell(locatorA, x), FindCell(locatorB, x));
    ASSERT_EQ(FindAlongLine(locatorA, x, y), FindAlongLine(locatorB, x, y));
  }
}

/// Queries find the cells of `kept` and no others.
void ExpectOnly(
  vtkDataSet* data, const std::function<bool(vtkIdType)>& kept, vtkSkdTreeCellLocator* locator)
{
  BruteForce reference(data, kept);
  ASSERT_EQ(locator->GetNumberOfCellsInTree(), vtkIdType(reference.GetCells().size()));
  ASSERT_EQ(locator->GetNumberOfCellsLeftOut(),
    data->GetNumberOfCells() - vtkIdType(reference.GetCells().size()));
  Bounds box;
  data->GetBounds(box.data());
  ASSERT_EQ(FindWithinBounds(locator, box), reference.GetCells());
  Random random(141);
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < 100; ++i)
  {
    const Point x = random.InBox(Grown(box, 0.1 * Diagonal(box)));
    const Point y = random.InBox(Grown(box, 0.1 * Diagonal(box)));
    const Closest c = FindClosest(locator, x);
    ASSERT_TRUE(kept(c.Cell));
    ASSERT_NEAR(std::sqrt(c.Dist2), reference.FindNearest(x).Distance, reference.Tolerance());
    for (vtkIdType hit : FindAllHits(locator, x, y, 0.0, cell).Cells)
    {
      ASSERT_TRUE(kept(hit));
    }
    const vtkIdType found = FindCell(locator, x).Cell;
    ASSERT_TRUE(found < 0 || kept(found));
  }
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    Point x = Center(reference.Box(id));
    ASSERT_EQ(locator->InsideCellBounds(x.data(), id), kept(id));
  }
}

// Through memory: GCC 12 takes two neighbouring double(float(x)) for no conversion at all.
double ToFloat(double x)
{
  volatile float rounded = static_cast<float>(x);
  return rounded;
}

bool All(vtkIdType)
{
  return true;
}

TEST(DataSets, ImageAnswersAsItsVoxelsDo)
{
  const auto image = MakeImage(5);
  Mesh mesh = Voxels(5);
  mesh.Map([](const Point& p) { return Point{ p[0] - 1, 0.5 * p[1] + 0.5, 0.25 * p[2] + 2 }; });
  ExpectSameAnswers(image, MakeGrid(mesh));
}

TEST(DataSets, TurnedImageAnswersAsItsHexahedraDo)
{
  const auto image = MakeRotatedImage(4);
  Mesh mesh = Hexahedra(4);
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    image->GetPoint(vtkIdType(i), mesh.Points[i].data());
  }
  const auto grid = MakeGrid(mesh);
  const auto ofImage = MakeLocator(image);
  const auto ofGrid = MakeLocator(grid);
  Bounds box;
  grid->GetBounds(box.data());
  Random random(142);
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < 200; ++i)
  {
    const Point x = random.InBox(Grown(box, 1));
    const Point y = Center(box) + 9.0 * random.Direction();
    ASSERT_NEAR(
      std::sqrt(FindClosest(ofImage, x).Dist2), std::sqrt(FindClosest(ofGrid, x).Dist2), 1e-12);
    ASSERT_EQ(FindCell(ofImage, x).Cell, FindCell(ofGrid, x).Cell);
    const Point far = y + 20.0 * (Center(box) - y);
    ASSERT_EQ(FindAllHits(ofImage, y, far, 0.0, cell).Cells.size(),
      FindAllHits(ofGrid, y, far, 0.0, cell).Cells.size());
  }
}

TEST(DataSets, FlatImagesAcrossEachAxisAreSearched)
{
  for (int across = 0; across < 3; ++across)
  {
    const auto image = MakeFlatImage(5, across);
    ExpectOnly(image, All, MakeLocator(image));
  }
}

TEST(DataSets, RectilinearAndCurvilinearGridsAreSearched)
{
  for (const DataSetPointer& data : std::vector<DataSetPointer>{
         MakeRectilinear(5), MakeStructured(5), MakeExplicitStructured(4), MakeUniformGrid(5) })
  {
    ExpectOnly(data, All, MakeLocator(data));
  }
}

TEST(DataSets, FloatPointsAnswerAsTheSameDoublePoints)
{
  for (Mesh mesh : { SphereTriangles(6), SphereQuads(6), Tetrahedra(3).Map(Bent),
         Hexahedra(3).Map(Bent), Helix(60, VTK_LINE) })
  {
    mesh.Map([](const Point& p) { return Point{ ToFloat(p[0]), ToFloat(p[1]), ToFloat(p[2]) }; });
    ExpectSameAnswers(MakeGrid(mesh, VTK_FLOAT), MakeGrid(mesh, VTK_DOUBLE));
  }
}

TEST(DataSets, PointsOfIntegersAreSearched)
{
  ExpectSameAnswers(
    MakePolyData(CubeTriangles(4), VTK_INT), MakePolyData(CubeTriangles(4), VTK_DOUBLE));
  ExpectSameAnswers(MakePolyData(CubeQuads(4), VTK_SHORT), MakePolyData(CubeQuads(4)));
}

TEST(DataSets, CellArraysOf32And64BitsAnswerTheSame)
{
  for (const Mesh& mesh : { SphereTriangles(6), CubeQuads(5), Hexagons(5), Strips(6),
         Helix(40, VTK_POLY_LINE), Cloud(50, VTK_VERTEX) })
  {
    const auto narrow = MakePolyData(mesh, VTK_DOUBLE, true);
    const auto wide = MakePolyData(mesh, VTK_DOUBLE, false);
    ASSERT_FALSE(narrow->GetPolys()->IsStorage64Bit());
    ExpectSameAnswers(narrow, wide);
  }
}

TEST(DataSets, UnstructuredGridsOf32BitCellsAnswerTheSame)
{
  const Mesh mesh = Tetrahedra(3).Map(Bent);
  const auto wide = MakeGrid(mesh);
  vtkNew<vtkCellArray> cells;
  cells->Use32BitStorage();
  for (const CellSpec& cell : mesh.Cells)
  {
    cells->InsertNextCell(4, cell.Points.data());
  }
  vtkNew<vtkUnstructuredGrid> narrow;
  narrow->SetPoints(wide->GetPoints());
  narrow->SetCells(VTK_TETRA, cells);
  ExpectSameAnswers(narrow, wide);
}

TEST(DataSets, PolyDataOfAllFourKindsNumbersItsCellsAsVtkDoes)
{
  Mesh mesh = Cloud(9, VTK_VERTEX);
  for (const Mesh& more : { Helix(8, VTK_LINE), Hexagons(2), Strips(3) })
  {
    const vtkIdType first = vtkIdType(mesh.Points.size());
    mesh.Points.insert(mesh.Points.end(), more.Points.begin(), more.Points.end());
    for (CellSpec cell : more.Cells)
    {
      for (vtkIdType& id : cell.Points)
      {
        id += first;
      }
      mesh.Cells.push_back(cell);
    }
  }
  const auto data = MakePolyData(mesh);
  ExpectOnly(data, All, MakeLocator(data));
}

TEST(DataSets, BlankedCellsAreLeftOutWhateverTheSetting)
{
  const auto isVisible = [](vtkIdType cell) { return !IsBlanked(cell); };
  for (bool skipGhosts : { true, false })
  {
    const auto structured = Blanked(MakeStructured(4));
    const auto uniform = Blanked(MakeUniformGrid(4));
    const auto explicitGrid = Blanked(MakeExplicitStructured(3));
    for (vtkDataSet* data : { static_cast<vtkDataSet*>(structured),
           static_cast<vtkDataSet*>(uniform), static_cast<vtkDataSet*>(explicitGrid) })
    {
      const auto locator = LocatorPointer::New();
      locator->SetDataSet(data);
      locator->SetSkipGhostCells(skipGhosts);
      locator->BuildLocator();
      ExpectOnly(data, isVisible, locator);
    }
  }
}

TEST(DataSets, CellsOfBlankedPointsAreLeftOut)
{
  const auto grid = MakeStructured(4);
  grid->BlankPoint(0); // the corner of the first cell alone
  ExpectOnly(
    grid, [](vtkIdType cell) { return cell != 0; }, MakeLocator(grid));
}

class GhostCells : public testing::TestWithParam<unsigned char>
{
protected:
  static bool IsKept(vtkIdType cell) { return cell != 2 && cell != 7 && cell != 8; }
  const Ids Marked = { 2, 7, 8 };
};

INSTANTIATE_TEST_SUITE_P(Kinds, GhostCells,
  testing::Values(vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::REFINEDCELL,
    vtkDataSetAttributes::HIDDENCELL));

TEST_P(GhostCells, AreLeftOut)
{
  for (const NamedMesh& mesh : AllMeshes())
  {
    SCOPED_TRACE(mesh.Name);
    const auto data = mesh.Make();
    MarkGhosts(data, this->Marked, GetParam());
    ExpectOnly(data, &GhostCells::IsKept, MakeLocator(data));
  }
}

TEST_P(GhostCells, AreKeptIfSkippingIsOffUnlessHidden)
{
  const bool isHidden = GetParam() == vtkDataSetAttributes::HIDDENCELL;
  for (const Mesh& mesh : { SphereTriangles(4), Tetrahedra(2) })
  {
    const auto data = MakeGrid(mesh);
    MarkGhosts(data, this->Marked, GetParam());
    const auto locator = LocatorPointer::New();
    locator->SetDataSet(data);
    locator->SkipGhostCellsOff();
    locator->BuildLocator();
    ExpectOnly(data, isHidden ? &GhostCells::IsKept : &All, locator);
  }
}

TEST(DataSets, OtherGhostBitsDoNotMatter)
{
  const auto data = MakeGrid(SphereTriangles(4));
  MarkGhosts(data, { 1, 2 }, vtkDataSetAttributes::EXTERIORCELL);
  ExpectOnly(data, All, MakeLocator(data));
}

TEST(DataSets, SwitchingGhostsRebuilds)
{
  const auto data = MakeGrid(SphereTriangles(4));
  MarkGhosts(data, { 1, 2 }, vtkDataSetAttributes::DUPLICATECELL);
  const auto locator = MakeLocator(data);
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 2);
  locator->SkipGhostCellsOff();
  locator->BuildLocator();
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 0);
}

}
