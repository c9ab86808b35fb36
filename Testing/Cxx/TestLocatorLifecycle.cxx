// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// When the tree is built, shared and freed; settings, statistics and PrintSelf.

#include "Support/EventCounter.h"
#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"
#include "Support/SameAnswers.h"
#include "Support/VolumeMeshes.h"

#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"
#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

using namespace skdtest;

namespace
{

class Lifecycle : public testing::Test
{
protected:
  PolyDataPointer Data = MakePolyData(SphereTriangles(8));
  LocatorPointer Locator = MakeLocator(Data);

  /// Moves all points by (100, 0, 0).
  void MoveData()
  {
    for (vtkIdType i = 0; i < this->Data->GetNumberOfPoints(); ++i)
    {
      Point p;
      this->Data->GetPoint(i, p.data());
      p[0] += 100;
      this->Data->GetPoints()->SetPoint(i, p.data());
    }
    this->Data->GetPoints()->Modified();
    this->Data->Modified();
  }
};

TEST_F(Lifecycle, BuildsOnceWhileNothingChanges)
{
  const vtkMTimeType built = this->Locator->GetBuildTime();
  this->Locator->BuildLocator();
  this->Locator->Update();
  FindClosest(this->Locator, { 1, 2, 3 });
  EXPECT_EQ(this->Locator->GetBuildTime(), built);
}

TEST_F(Lifecycle, RebuildsWhenTheDataChanges)
{
  this->MoveData();
  this->Locator->BuildLocator();
  EXPECT_NEAR(FindClosest(this->Locator, { 105, 0, 0 }).Dist2, 16, 0.1);
}

TEST_F(Lifecycle, RebuildsWhenTheDataSetIsAnother)
{
  const auto other = MakePolyData(CubeTriangles(2));
  this->Locator->SetDataSet(other);
  this->Locator->BuildLocator();
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), other->GetNumberOfCells());
  EXPECT_EQ(FindClosest(this->Locator, { 1, 1, 5 }).Dist2, 9.0);
}

TEST_F(Lifecycle, RebuildsWhenASettingChanges)
{
  const double before = this->Locator->GetAbsoluteEpsilon();
  this->Locator->SetEpsilon(1e-3);
  this->Locator->BuildLocator();
  EXPECT_GT(this->Locator->GetAbsoluteEpsilon(), 1000 * before);
}

TEST_F(Lifecycle, QueriesBeforeTheBuildBuild)
{
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(this->Data);
  EXPECT_EQ(FindClosest(locator, { 3, 1, 2 }), FindClosest(this->Locator, { 3, 1, 2 }));
}

TEST_F(Lifecycle, UseExistingSearchStructureKeepsTheTree)
{
  this->Locator->UseExistingSearchStructureOn();
  this->Locator->BuildLocator();
  const vtkMTimeType built = this->Locator->GetBuildTime();
  this->Data->Modified();
  this->Locator->BuildLocator();
  EXPECT_EQ(this->Locator->GetBuildTime(), built);
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), this->Data->GetNumberOfCells());
}

/// A sphere whose points are of single precision, which the tree copies, or of double, which it
/// shares.
PolyDataPointer SphereOf(int pointType, double shift = 0.0)
{
  const auto sphere = MakePolyData(Transformed(SphereTriangles(8), 1.0, { shift, 0, 0 }));
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  points->DeepCopy(sphere->GetPoints());
  sphere->SetPoints(points);
  return sphere;
}

// VTK's own read cells from the data set, so that an old structure costs them few answers.
TEST(UseExistingSearchStructure, DoesNotKeepTheTreeOfPointsThatMove)
{
  enum Change
  {
    IN_PLACE,
    NEW_POINTS,
    ANOTHER_MESH
  };
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (Change change : { IN_PLACE, NEW_POINTS, ANOTHER_MESH })
    {
      for (bool asksToBuild : { true, false })
      {
        auto mesh = SphereOf(type);
        const auto locator = MakeLocator(mesh);
        locator->UseExistingSearchStructureOn();
        locator->BuildLocator();
        const auto moved = SphereOf(type, 100.0);
        if (change == IN_PLACE)
        {
          mesh->GetPoints()->GetData()->DeepCopy(moved->GetPoints()->GetData());
          mesh->GetPoints()->Modified();
        }
        else if (change == NEW_POINTS)
        {
          mesh->SetPoints(moved->GetPoints());
        }
        else
        {
          locator->SetDataSet(moved);
        }
        if (asksToBuild)
        {
          locator->BuildLocator();
        }
        EXPECT_EQ(
          FindClosest(locator, { 103, 1, 2 }), FindClosest(MakeLocator(moved), { 103, 1, 2 }))
          << type << " " << change << " " << asksToBuild;
      }
    }
  }
}

TEST(UseExistingSearchStructure, NoticesCellsThatChangeInPlace)
{
  const GridPointer grid = MakeGrid(Tetrahedra(2));
  const auto locator = MakeLocator(grid);
  for (bool existing : { true, false })
  {
    locator->SetUseExistingSearchStructure(existing);
    locator->BuildLocator();
    auto* ids = vtkDataArray::SafeDownCast(grid->GetCells()->GetConnectivityArray());
    const double first = ids->GetTuple1(0);
    ids->SetTuple1(0, ids->GetTuple1(1)); // the first cell is flat now
    ids->Modified();
    locator->BuildLocator();
    Bounds box;
    MakeGrid(Tetrahedra(2))->GetCellBounds(0, box.data());
    Point inFirst = Center(box);
    EXPECT_EQ(locator->FindCell(inFirst.data()), MakeLocator(grid)->FindCell(inFirst.data()));
    ids->SetTuple1(0, first);
    ids->Modified();
  }
}

TEST(UseExistingSearchStructure, KeepsTheTreeWhileDataChange)
{
  auto mesh = SphereOf(VTK_FLOAT);
  const auto locator = MakeLocator(mesh);
  locator->UseExistingSearchStructureOn();
  const vtkMTimeType built = locator->GetBuildTime();
  for (int step = 0; step < 3; ++step)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Step");
    mesh->GetPointData()->AddArray(array);
    mesh->Modified();
    FindClosest(locator, { 3, 1, 2 });
    locator->SetDataSet(SphereOf(VTK_FLOAT)); // equal points and cells
    locator->BuildLocator();
    EXPECT_EQ(locator->GetBuildTime(), built);
  }
}

TEST_F(Lifecycle, UseExistingSearchStructureBuildsAFirstTree)
{
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(this->Data);
  locator->UseExistingSearchStructureOn();
  locator->BuildLocator();
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), this->Data->GetNumberOfCells());
}

TEST_F(Lifecycle, ForceBuildLocatorAlwaysBuilds)
{
  this->Locator->UseExistingSearchStructureOn();
  this->MoveData();
  const vtkMTimeType built = this->Locator->GetBuildTime();
  this->Locator->ForceBuildLocator();
  EXPECT_GT(this->Locator->GetBuildTime(), built);
  EXPECT_NEAR(FindClosest(this->Locator, { 105, 0, 0 }).Dist2, 16, 0.1);
}

TEST_F(Lifecycle, FreeSearchStructureFreesAndTheNextBuildBuilds)
{
  const Closest before = FindClosest(this->Locator, { 3, 1, 2 });
  this->Locator->FreeSearchStructure();
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), 0);
  EXPECT_EQ(this->Locator->GetMemorySize(), 0);
  this->Locator->BuildLocator();
  EXPECT_EQ(FindClosest(this->Locator, { 3, 1, 2 }), before);
}

TEST_F(Lifecycle, InitializeFreesToo)
{
  this->Locator->Initialize();
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), 0);
}

TEST_F(Lifecycle, ShallowCopySharesTheTreeAndTheSettings)
{
  this->Locator->SetEpsilon(1e-5);
  this->Locator->SkipGhostCellsOff();
  this->Locator->SetNumberOfCellsPerNode(4);
  this->Locator->BuildLocator();
  const auto copy = LocatorPointer::New();
  copy->ShallowCopy(this->Locator);
  EXPECT_EQ(copy->GetDataSet(), this->Data);
  EXPECT_EQ(copy->GetEpsilon(), 1e-5);
  EXPECT_FALSE(copy->GetSkipGhostCells());
  EXPECT_EQ(copy->GetNumberOfCellsPerNode(), 4);
  EXPECT_EQ(copy->GetNumberOfCellsInTree(), this->Locator->GetNumberOfCellsInTree());
  const vtkMTimeType built = copy->GetBuildTime();
  copy->BuildLocator();
  EXPECT_EQ(copy->GetBuildTime(), built) << "nothing is left to build";
  EXPECT_EQ(FindClosest(copy, { 3, 1, 2 }), FindClosest(this->Locator, { 3, 1, 2 }));
}

TEST_F(Lifecycle, ShallowCopyOutlivesItsSource)
{
  const Closest expected = FindClosest(this->Locator, { 3, 1, 2 });
  const auto copy = LocatorPointer::New();
  copy->ShallowCopy(this->Locator);
  this->Locator->FreeSearchStructure();
  this->Locator = nullptr;
  EXPECT_EQ(FindClosest(copy, { 3, 1, 2 }), expected);
}

TEST_F(Lifecycle, ShallowCopyKeepsADataSetThatIsThere)
{
  const auto same = PolyDataPointer::New();
  same->ShallowCopy(this->Data);
  const auto copy = LocatorPointer::New();
  copy->SetDataSet(same);
  copy->ShallowCopy(this->Locator);
  EXPECT_EQ(copy->GetDataSet(), same);
  EXPECT_EQ(FindClosest(copy, { 3, 1, 2 }), FindClosest(this->Locator, { 3, 1, 2 }));
}

/// What VTK's filters of time series do: a copy for the mesh of the next step.
LocatorPointer CopyFor(vtkDataSet* data, vtkSkdTreeCellLocator* locator)
{
  auto copy = LocatorPointer::New();
  copy->SetDataSet(data);
  copy->ShallowCopy(locator);
  return copy;
}

TEST_F(Lifecycle, ShallowCopyDoesNotPassAnOutdatedTreeOn)
{
  this->MoveData();
  const auto copy = CopyFor(this->Data, this->Locator);
  EXPECT_EQ(copy->GetNumberOfCellsInTree(), 0);
  EXPECT_NEAR(FindClosest(copy, { 105, 0, 0 }).Dist2, 16, 0.1);
}

TEST_F(Lifecycle, ShallowCopyDoesNotPassATreeOnToWhatChangedLater)
{
  const auto moved = MakePolyData(Transformed(SphereTriangles(8), 1.0, { 100, 0, 0 }));
  EXPECT_NEAR(FindClosest(CopyFor(moved, this->Locator), { 105, 0, 0 }).Dist2, 16, 0.1);
}

TEST_F(Lifecycle, ShallowCopyDoesNotPassATreeOnToAnotherMeshThatIsOlder)
{
  const auto older = MakePolyData(Transformed(SphereTriangles(8), 1.0, { 100, 0, 0 }));
  this->Data->Modified();
  this->Locator->BuildLocator();
  EXPECT_NEAR(FindClosest(CopyFor(older, this->Locator), { 105, 0, 0 }).Dist2, 16, 0.1);
}

// VTK's own, since 9.4, share their bins or boxes, but read cells from the data set of the copy.
TEST_F(Lifecycle, ShallowCopyAnswersForItsOwnDataSetEvenIfAnExistingStructureIsWanted)
{
  this->Locator->UseExistingSearchStructureOn();
  const auto moved = MakePolyData(Transformed(SphereTriangles(8), 1.0, { 0.02, 0, 0 }));
  const auto copy = CopyFor(moved, this->Locator);
  EXPECT_TRUE(copy->GetUseExistingSearchStructure());
  EXPECT_EQ(FindClosest(copy, { 3, 1, 2 }), FindClosest(MakeLocator(moved), { 3, 1, 2 }));
}

TEST_F(Lifecycle, AnExistingStructureServesADataSetThatIsTheSame)
{
  const auto copy = LocatorPointer::New();
  this->Locator->UseExistingSearchStructureOn();
  copy->ShallowCopy(this->Locator);
  copy->SetDataSet(MakePolyData(SphereTriangles(8)));
  const double built = copy->GetBuildSeconds();
  copy->BuildLocator();
  EXPECT_EQ(copy->GetBuildSeconds(), built) << "nothing was built";
  EXPECT_EQ(FindClosest(copy, { 3, 1, 2 }), FindClosest(this->Locator, { 3, 1, 2 }));
}

// A tree that was shared reads the points where they are stored, so in the first mesh.
TEST_F(Lifecycle, ATreeOfEqualPointsOutlivesTheirMotionInTheFirstMesh)
{
  for (const bool usesExisting : { false, true })
  {
    const auto first = MakePolyData(SphereTriangles(8));
    const auto second = MakePolyData(SphereTriangles(8));
    ASSERT_EQ(first->GetPoints()->GetDataType(), VTK_DOUBLE);
    const auto locator = MakeLocator(first);
    locator->SetUseExistingSearchStructure(usesExisting);
    const Closest expected = FindClosest(locator, { 3, 1, 2 });
    const auto copy = CopyFor(second, locator);
    locator->SetDataSet(second); // which has its tree kept if that is wanted
    locator->BuildLocator();
    EXPECT_GT(copy->GetNumberOfCellsInTree(), 0) << "it is shared";
    for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
    {
      first->GetPoints()->SetPoint(i, 100, 0, i);
    }
    first->GetPoints()->Modified();
    EXPECT_EQ(FindClosest(copy, { 3, 1, 2 }), expected);
    EXPECT_EQ(FindClosest(locator, { 3, 1, 2 }), expected);
    const double built = copy->GetBuildSeconds();
    copy->BuildLocator();
    EXPECT_EQ(copy->GetBuildSeconds(), built) << "nothing is left to build";
  }
}

TEST_F(Lifecycle, ShallowCopyLeavesNoTreeOfBeforeBehind)
{
  const auto copy = MakeLocator(MakePolyData(CubeTriangles(2)));
  this->Locator->FreeSearchStructure();
  copy->ShallowCopy(this->Locator);
  EXPECT_EQ(copy->GetNumberOfCellsInTree(), 0);
}

TEST_F(Lifecycle, ShallowCopyTakesTheMotionAndIsMovedByItself)
{
  vtkNew<vtkMatrix4x4> motion;
  motion->SetElement(0, 3, 7);
  this->Locator->SetTransform(motion);
  const auto copy = LocatorPointer::New();
  copy->ShallowCopy(this->Locator);
  EXPECT_EQ(FindClosest(copy, { 9, 1, 2 }), FindClosest(this->Locator, { 9, 1, 2 }));
  copy->SetTransform(nullptr);
  EXPECT_NE(FindClosest(copy, { 9, 1, 2 }).Dist2, FindClosest(this->Locator, { 9, 1, 2 }).Dist2);
}

TEST_F(Lifecycle, ShallowCopyOfAnotherKindOrOfNothingIsHarmless)
{
  vtkNew<vtkStaticCellLocator> other;
  other->SetDataSet(this->Data);
  other->BuildLocator();
  const Closest expected = FindClosest(this->Locator, { 3, 1, 2 });
  EventCounter events(this->Locator);
  this->Locator->ShallowCopy(other);
  this->Locator->ShallowCopy(nullptr);
  this->Locator->ShallowCopy(this->Locator);
  EXPECT_EQ(FindClosest(this->Locator, { 3, 1, 2 }), expected);
}

TEST_F(Lifecycle, LazyBuildGivesTheSameAnswers)
{
  for (const NamedMesh& mesh : AllMeshes())
  {
    const auto data = mesh.Make();
    const auto plain = MakeLocator(data);
    const auto lazy = LocatorPointer::New();
    lazy->SetDataSet(data);
    lazy->LazyBuildOn();
    lazy->BuildLocator();
    ExpectSameAnswers(lazy, plain, data, mesh.Name);
  }
}

TEST_F(Lifecycle, AnyNumberOfCellsPerNodeGivesTheSameAnswers)
{
  Random random(121);
  for (int cellsPerNode : { 1, 2, 3, 8, 32, 1000000 })
  {
    const auto locator = LocatorPointer::New();
    locator->SetDataSet(this->Data);
    locator->SetNumberOfCellsPerNode(cellsPerNode);
    locator->BuildLocator();
    for (int i = 0; i < 50; ++i)
    {
      const Point x = 2.0 * random.Direction();
      const Point y = 2.0 * random.Direction();
      ASSERT_EQ(FindClosest(locator, x), FindClosest(this->Locator, x));
      ASSERT_EQ(FindFirstHit(locator, x, y), FindFirstHit(this->Locator, x, y));
    }
  }
}

TEST_F(Lifecycle, StatisticsAreZeroBeforeTheBuild)
{
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(this->Data);
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), 0);
  EXPECT_EQ(locator->GetNumberOfCellsLeftOut(), 0);
  EXPECT_EQ(locator->GetNumberOfNodes(), 0);
  EXPECT_EQ(locator->GetDepth(), 0);
  EXPECT_EQ(locator->GetMemorySize(), 0);
  EXPECT_EQ(locator->GetBuildSeconds(), 0.0);
}

TEST_F(Lifecycle, StatisticsDescribeTheTree)
{
  const vtkIdType cells = this->Data->GetNumberOfCells();
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), cells);
  EXPECT_EQ(this->Locator->GetNumberOfCellsLeftOut(), 0);
  EXPECT_GT(this->Locator->GetNumberOfNodes(), 0);
  EXPECT_LE(this->Locator->GetNumberOfNodes(), 2 * cells - 1);
  EXPECT_GT(this->Locator->GetDepth(), 1);
  EXPECT_LE(this->Locator->GetDepth(), 11); // ceil(log2 768) and the root
  EXPECT_GT(this->Locator->GetMemorySize(), 8 * cells);
  EXPECT_LT(this->Locator->GetMemorySize(), 1000 * cells);
  EXPECT_GT(this->Locator->GetBuildSeconds(), 0.0);
}

/// What the header says of the corners that trees of triangles keep for lines: 30 bytes each, and a
/// few more where leaves share less.
constexpr int BytesOfCorners = 32;

TEST_F(Lifecycle, TreesOfManyTrianglesKeepAtMost85BytesForEach)
{
  const auto locator = MakeLocator(MakePolyData(SphereTriangles(60)));
  const double cells = static_cast<double>(locator->GetNumberOfCellsInTree());
  EXPECT_GT(cells, 40000.0);
  EXPECT_LE(locator->GetBytesPerCell(), 85.0);
  EXPECT_EQ(locator->GetBytesPerCell(), static_cast<double>(locator->GetMemorySize()) / cells);
  locator->FreeSearchStructure();
  EXPECT_EQ(locator->GetBytesPerCell(), 0.0);
}

/// The same triangles, of which each two share points, and none with others.
Mesh InPairs(const Mesh& mesh)
{
  Mesh pairs;
  std::map<vtkIdType, vtkIdType> copies;
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    if (i % 2 == 0)
    {
      copies.clear();
    }
    Ids ids;
    for (const vtkIdType id : mesh.Cells[i].Points)
    {
      const auto [copy, isNew] = copies.try_emplace(id, vtkIdType(pairs.Points.size()));
      if (isNew)
      {
        pairs.Add(mesh.Points[static_cast<std::size_t>(id)]);
      }
      ids.push_back(copy->second);
    }
    pairs.Add(VTK_TRIANGLE, ids);
  }
  return pairs;
}

TEST_F(Lifecycle, CornersAtOnePlaceAreKeptOnceWhereTrianglesShareFewPoints)
{
  const Mesh pairs = InPairs(SphereTriangles(60));
  EXPECT_LE(pairs.Points.size(), 2 * pairs.Cells.size());
  EXPECT_LE(MakeLocator(MakePolyData(pairs))->GetBytesPerCell(), 85.0);
}

TEST_F(Lifecycle, TreesOfManyTetrahedraKeepAtMost75BytesForEach)
{
  const auto locator = MakeLocator(MakeGrid(Tetrahedra(20)));
  EXPECT_EQ(locator->GetNumberOfCellsInTree(), 48000);
  EXPECT_LE(locator->GetBytesPerCell(), 75.0);
}

TEST_F(Lifecycle, StatisticsCountTheCellsLeftOut)
{
  MarkGhosts(this->Data, { 1, 2, 3 }, vtkDataSetAttributes::DUPLICATECELL);
  this->Data->Modified();
  this->Locator->BuildLocator();
  EXPECT_EQ(this->Locator->GetNumberOfCellsLeftOut(), 3);
  EXPECT_EQ(this->Locator->GetNumberOfCellsInTree(), this->Data->GetNumberOfCells() - 3);
}

TEST_F(Lifecycle, MemoryGrowsWithTheMeshNotFasterThanSaid)
{
  const auto data = MakePolyData(SphereTriangles(40));
  const auto locator = MakeLocator(data);
  const vtkIdType cells = data->GetNumberOfCells();
  const vtkIdType said = cells * (32 + 3 * 4 + BytesOfCorners) + data->GetNumberOfPoints() * 24;
  EXPECT_LE(locator->GetMemorySize(), said + said / 4 + 4096);
}

TEST_F(Lifecycle, DefaultsAreThoseOfTheHeader)
{
  const auto locator = LocatorPointer::New();
  EXPECT_EQ(locator->GetEpsilon(), 1e-9);
  EXPECT_FALSE(locator->GetLazyBuild());
  EXPECT_EQ(locator->GetSplitRule(), vtkSkdTreeCellLocator::SPLIT_AUTOMATICALLY);
  EXPECT_TRUE(locator->GetSkipGhostCells());
  EXPECT_EQ(locator->GetNumberOfCellsPerNode(), 8);
  EXPECT_FALSE(locator->GetUseExistingSearchStructure());
}

TEST_F(Lifecycle, PrintSelfNamesEverySetting)
{
  std::ostringstream text;
  this->Locator->Print(text);
  for (const char* name : { "Epsilon", "LazyBuild", "SplitRule", "SkipGhostCells", "Transform" })
  {
    std::string squeezed;
    for (char c : text.str())
    {
      squeezed += c == ' ' ? "" : std::string(1, c);
    }
    EXPECT_NE(squeezed.find(name), std::string::npos) << name;
  }
}

TEST_F(Lifecycle, PrintSelfWorksWithoutATree)
{
  std::ostringstream text;
  LocatorPointer::New()->Print(text);
  EXPECT_FALSE(text.str().empty());
}

TEST_F(Lifecycle, NewInstanceIsOfTheSameClass)
{
  vtkSmartPointer<vtkAbstractCellLocator> made;
  made.TakeReference(this->Locator->NewInstance());
  EXPECT_TRUE(made->IsA("vtkSkdTreeCellLocator"));
}

TEST_F(Lifecycle, LetsGoOfTheDataSet)
{
  vtkWeakPointer<vtkPolyData> data = this->Data.Get();
  this->Data = nullptr;
  EXPECT_NE(data, nullptr);
  this->Locator = nullptr;
  EXPECT_EQ(data, nullptr);
}

TEST_F(Lifecycle, ADataSetThatHoldsItsLocatorIsFreed)
{
  vtkWeakPointer<vtkPolyData> data = this->Data.Get();
  vtkWeakPointer<vtkSkdTreeCellLocator> locator = this->Locator.Get();
  this->Data->SetCellLocator(this->Locator);
  this->Locator = nullptr;
  EXPECT_NE(locator, nullptr);
  this->Data = nullptr;
  EXPECT_EQ(data, nullptr);
  EXPECT_EQ(locator, nullptr);
}

}
