// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeSpatialQuery as a filter: outputs, composite and ghost cells, kept trees, bad input.

#include "Support/BoxReference.h"
#include "Support/BruteForce.h"
#include "Support/EventCounter.h"
#include "Support/NamedMeshes.h"
#include "Support/SpatialQueryRun.h"

#include "vtkExtractGeometry.h"
#include "vtkExtractSelection.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkSMPTools.h"
#include "vtkSphere.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace skdtest;

namespace
{

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

vtkUnstructuredGrid* CellsOf(SpatialQuery* query)
{
  query->Update();
  return vtkUnstructuredGrid::SafeDownCast(query->GetOutputDataObject(0));
}

Ids IdsIn(vtkDataSet* cells)
{
  Ids ids;
  auto* array = cells->GetCellData()->GetArray("SkdCellId");
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.push_back(static_cast<vtkIdType>(array->GetTuple1(i)));
  }
  return ids;
}

//------------------------------------------------------------------------------
class SpatialQueryOnMesh : public testing::TestWithParam<NamedMesh>
{
protected:
  void SetUp() override
  {
    this->Input = WithData(GetParam().Make());
    this->Input->GetBounds(this->Box.data());
  }

  Bounds RandomBox(Random& random) const
  {
    Bounds box = EmptyBounds();
    Extend(box, random.InBox(this->Box));
    Extend(box, random.InBox(this->Box));
    return box;
  }

  DataSetPointer Input;
  Bounds Box{};
};

INSTANTIATE_TEST_SUITE_P(All, SpatialQueryOnMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(SpatialQueryOnMesh, CellsThatOverlapABoxAreThoseOfClipping)
{
  const std::vector<CellShape> shapes = ShapesOf(this->Input);
  QueryPointer query = MakeQuery(this->Input);
  Random random(6);
  for (int i = 0; i < 10; ++i)
  {
    const Bounds box = this->RandomBox(random);
    SetBox(query, box);
    const Ids found = CellsFound(query);
    for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
    {
      if (shapes[cell].IsKnown)
      {
        ASSERT_EQ(std::binary_search(found.begin(), found.end(), cell), MeetsBox(shapes[cell], box))
          << cell;
      }
    }
  }
}

TEST_P(SpatialQueryOnMesh, CellsThatOverlapASphereAreThoseOfDistance)
{
  BruteForce reference(this->Input);
  QueryPointer query = MakeQuery(this->Input);
  Random random(7);
  for (int i = 0; i < 10; ++i)
  {
    const Point center = random.InBox(this->Box);
    const double radius = random.Between(0.0, 0.4) * Diagonal(this->Box);
    SetSphere(query, center, radius);
    const std::vector<PairRow> rows = RunQuery(query);
    Ids found;
    for (const PairRow& row : rows)
    {
      found.push_back(row.Cell);
      ASSERT_LE(row.Min, 0.0);
    }
    for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
    {
      if (!this->Input->GetCell(cell)->IsLinear())
      {
        continue;
      }
      const double distance =
        reference.IsInside(cell, center) ? 0.0 : reference.DistanceTo(cell, center);
      ASSERT_EQ(std::binary_search(found.begin(), found.end(), cell), distance <= radius) << cell;
    }
  }
}

TEST_P(SpatialQueryOnMesh, CellsAlongALineHoldAPointOfIt)
{
  QueryPointer query = MakeQuery(this->Input);
  BruteForce reference(this->Input);
  Random random(8);
  for (int i = 0; i < 10; ++i)
  {
    const Point a = random.InBox(this->Box);
    const Point b = random.InBox(this->Box);
    SetLine(query, a, b);
    const Ids found = CellsFound(query);
    for (const auto& hit : reference.Intersect(a, b))
    {
      ASSERT_TRUE(std::binary_search(found.begin(), found.end(), hit.Cell)) << hit.Cell;
    }
    for (const vtkIdType cell : reference.FindContaining(a))
    {
      ASSERT_TRUE(std::binary_search(found.begin(), found.end(), cell)) << cell;
    }
  }
}

TEST_P(SpatialQueryOnMesh, OutputsAgreeAndKeepTheData)
{
  QueryPointer query = MakeQuery(this->Input);
  SetSphere(query, Center(this->Box), 0.3 * Diagonal(this->Box));
  const Ids found = CellsFound(query);
  vtkUnstructuredGrid* cells = CellsOf(query);
  EXPECT_EQ(IdsIn(cells), found);
  EXPECT_EQ(Reported(query, "CellsFound"), found.size());
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(cells->GetCellType(i), this->Input->GetCellType(found[i]));
    ASSERT_EQ(cells->GetCellData()->GetArray("Number")->GetTuple1(i), 10.0 * found[i]);
    Bounds ours, theirs;
    cells->GetCellBounds(i, ours.data());
    this->Input->GetCellBounds(found[i], theirs.data());
    ASSERT_EQ(ours, theirs);
  }
  for (vtkIdType i = 0; i < cells->GetNumberOfPoints(); ++i)
  {
    Point x;
    cells->GetPoint(i, x.data());
    ASSERT_NEAR(cells->GetPointData()->GetArray("Linear")->GetTuple1(i), Linear(x), 1e-9);
  }
  vtkNew<vtkExtractSelection> extract;
  extract->SetInputData(0, this->Input);
  extract->SetInputData(1, query->GetOutputDataObject(1));
  extract->Update();
  auto* selected = vtkDataSet::SafeDownCast(extract->GetOutputDataObject(0));
  EXPECT_EQ(selected->GetNumberOfCells(), cells->GetNumberOfCells());
}

TEST_P(SpatialQueryOnMesh, ContainmentInASphereIsWhatExtractGeometryGives)
{
  vtkNew<vtkSphere> sphere;
  const Point center = Center(this->Box);
  const double radius = 0.35 * Diagonal(this->Box);
  sphere->SetCenter(center.data());
  sphere->SetRadius(radius);
  vtkNew<vtkExtractGeometry> extract;
  extract->SetImplicitFunction(sphere);
  extract->SetInputData(this->Input);
  extract->Update();
  QueryPointer query = MakeQuery(this->Input, SpatialQuery::CONTAINMENT);
  SetSphere(query, center, radius);
  EXPECT_EQ(CellsOf(query)->GetNumberOfCells(), extract->GetOutput()->GetNumberOfCells());
}

TEST_P(SpatialQueryOnMesh, AnswersAreTheSameAtAnyNumberOfThreads)
{
  for (int relation = SpatialQuery::EXACT_MATCH; relation <= SpatialQuery::NEAREST; ++relation)
  {
    QueryPointer query = MakeQuery(this->Input, relation);
    query->SetShape(SpatialQuery::SOURCE_CELLS);
    query->SetSourceData(this->Input);
    std::vector<std::vector<PairRow>> runs;
    for (const int threads : { 1, 4 })
    {
      vtkSMPTools::Initialize(threads);
      query->Modified();
      runs.push_back(RunQuery(query));
    }
    vtkSMPTools::Initialize();
    ASSERT_EQ(runs[0].size(), runs[1].size());
    for (std::size_t i = 0; i < runs[0].size(); ++i)
    {
      ASSERT_EQ(std::memcmp(&runs[0][i], &runs[1][i], sizeof(PairRow)), 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SpatialQuery, ArraysTellHowManyQueriesACellAnswersAndHowFarItIs)
{
  QueryPointer query = MakeQuery(MakeBricks(), SpatialQuery::NEAREST);
  query->SetShape(SpatialQuery::SOURCE_POINTS);
  query->SetSourceData(MakeQueries({ { -1, 0.5, 0.5 }, { -0.25, 0.5, 0.5 }, { 2.5, 2.5, 5 } }));
  vtkCellData* data = CellsOf(query)->GetCellData();
  EXPECT_EQ(IdsIn(CellsOf(query)), (Ids{ 0, 26 }));
  EXPECT_EQ(data->GetArray("SkdQueryCount")->GetTuple1(0), 2);
  EXPECT_EQ(data->GetArray("SkdQueryCount")->GetTuple1(1), 1);
  EXPECT_DOUBLE_EQ(data->GetArray("SkdDistance")->GetTuple1(0), 0.25);
  EXPECT_DOUBLE_EQ(data->GetArray("SkdDistance")->GetTuple1(1), 2.0);
  EXPECT_EQ(Reported(query, "Queries"), 3);
  EXPECT_EQ(Reported(query, "Pairs"), 3);
}

TEST(SpatialQuery, ReferenceBoundsAreScaledTurnedAndMoved)
{
  QueryPointer query = MakeQuery(MakeBricks(), SpatialQuery::EXACT_MATCH);
  query->UseReferenceBoundsOn();
  query->SetReferenceBounds(1, 2, 0, 1, 2, 4);
  query->SetBoxLength(1, 1, 0.5);
  query->SetBoxPosition(0, 1, 1);
  EXPECT_EQ(CellsFound(query), Ids{ 1 + 3 * 1 + 9 * 2 });
  query->SetBoxRotation(0, 0, 90);
  query->SetTolerance(1e-12);
  query->SetBoxPosition(1, 1, 1);
  EXPECT_EQ(CellsFound(query), Ids{ 0 + 3 * 2 + 9 * 2 });
  query->UseReferenceBoundsOff();
  query->SetBoxLength(1, -1, 1);
  EXPECT_EQ(CellsFound(query), Ids{ 1 + 3 * 1 + 9 * 1 });
}

TEST(SpatialQuery, CompositeDataKeepTheirStructure)
{
  DataSetPointer first = MakeBricks();
  DataSetPointer second = MakeBricks(10.0);
  auto input = MakeBlocks({ first, nullptr, second });
  QueryPointer query = MakeQuery(input);
  SetBox(query, { 9, 11.5, 0.5, 0.6, 0.5, 0.6 });
  query->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(query->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(vtkDataSet::SafeDownCast(output->GetBlock(0))->GetNumberOfCells(), 0);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  EXPECT_EQ(IdsIn(vtkDataSet::SafeDownCast(output->GetBlock(2))), (Ids{ 0, 1 }));
  auto* table = vtkTable::SafeDownCast(query->GetOutputDataObject(2));
  EXPECT_EQ(TableColumn(table, "SkdBlockIndex"), (std::vector<double>{ 3, 3 }));
  auto* selection = vtkSelection::SafeDownCast(query->GetOutputDataObject(1));
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  EXPECT_EQ(selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX()), 3);
}

TEST(SpatialQuery, NearestAreOfAllBlocksAndQueriesOfAllBlocks)
{
  auto input = MakeBlocks({ MakeBricks(), MakeBricks(10.0) });
  auto source =
    MakeBlocks({ MakeQueries({ { 6, 0, 0 } }), MakeQueries({ { 8, 0, 0 }, { 3, 0, 0 } }) });
  QueryPointer query = MakeQuery(input, SpatialQuery::NEAREST);
  query->SetShape(SpatialQuery::SOURCE_POINTS);
  query->SetSourceData(source);
  query->Update();
  auto* table = vtkTable::SafeDownCast(query->GetOutputDataObject(2));
  EXPECT_EQ(TableColumn(table, "SkdQueryId"), (std::vector<double>{ 0, 0, 1 }));
  EXPECT_EQ(TableColumn(table, "SkdQueryBlockIndex"), (std::vector<double>{ 1, 2, 2 }));
  EXPECT_EQ(TableColumn(table, "SkdBlockIndex"), (std::vector<double>{ 1, 2, 1 }));
  EXPECT_EQ(TableColumn(table, "SkdCellId"), (std::vector<double>{ 2, 0, 2 }));
}

TEST(SpatialQuery, GhostCellsAreNoAnswers)
{
  DataSetPointer input = MakeBricks();
  MarkGhosts(input, { 13 }, vtkDataSetAttributes::DUPLICATECELL);
  QueryPointer query = MakeQuery(input);
  SetBox(query, { 1.25, 1.75, 1.25, 1.75, 1.25, 1.75 });
  EXPECT_TRUE(CellsFound(query).empty());
  EXPECT_EQ(Reported(query, "CellsLeftOut"), 1);
}

TEST_P(SpatialQueryOnMesh, AnswersAreTheSameWithoutATreeAndWithOne)
{
  for (int relation = SpatialQuery::EXACT_MATCH; relation <= SpatialQuery::ADJACENCY; ++relation)
  {
    Random random(9);
    for (int shape = SpatialQuery::BOX; shape <= SpatialQuery::LINE; ++shape)
    {
      QueryPointer query = MakeQuery(this->Input, relation);
      SetSphere(query, random.InBox(this->Box), random.Between(0.0, 0.5) * Diagonal(this->Box));
      SetPlane(query, random.InBox(this->Box), random.InBox(this->Box));
      SetLine(query, random.InBox(this->Box), random.InBox(this->Box));
      SetBox(query, this->RandomBox(random));
      query->SetShape(shape);
      const std::vector<PairRow> without = RunQuery(query);
      query->Modified();
      const std::vector<PairRow> with = RunQuery(query);
      EXPECT_EQ(Reported(query, "TreesBuilt"), 1);
      ASSERT_EQ(without.size(), with.size());
      for (std::size_t i = 0; i < with.size(); ++i)
      {
        ASSERT_EQ(std::memcmp(&without[i], &with[i], sizeof(PairRow)), 0);
      }
    }
  }
}

TEST(SpatialQuery, NoneOneAndFlatMeshes)
{
  vtkNew<vtkUnstructuredGrid> none;
  auto flat = vtkSmartPointer<vtkImageData>::New();
  flat->SetDimensions(4, 4, 1);
  Mesh one;
  one.Add(VTK_VERTEX, { one.Add({ 0.5, 0.5, 0 }) });
  for (int relation = SpatialQuery::EXACT_MATCH; relation <= SpatialQuery::NEAREST; ++relation)
  {
    for (int shape = SpatialQuery::BOX; shape <= SpatialQuery::SOURCE_CELLS; ++shape)
    {
      QueryPointer query = MakeQuery(none, relation);
      query->SetShape(shape);
      query->SetSourceData(flat);
      EXPECT_TRUE(RunQuery(query).empty());
      EXPECT_EQ(CellsOf(query)->GetNumberOfCells(), 0);
      query->SetSourceData(none);
      query->SetInputDataObject(0, flat);
      EXPECT_EQ(RunQuery(query).empty(),
        shape >= SpatialQuery::SOURCE_POINTS || CellsOf(query)->GetNumberOfCells() == 0);
      query->SetInputDataObject(0, MakeGrid(one));
      query->SetSourceData(MakeGrid(one));
      RunQuery(query);
    }
  }
  QueryPointer query = MakeQuery(MakeGrid(one), SpatialQuery::EXACT_MATCH);
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(MakeGrid(one));
  EXPECT_EQ(CellsFound(query), Ids{ 0 });
  query->SetShape(SpatialQuery::SOURCE_POINTS);
  EXPECT_EQ(CellsFound(query), Ids{ 0 });
}

TEST(SpatialQuery, FlatCellsAreEnclosedByPlanesAndFlatBoxes)
{
  auto flat = vtkSmartPointer<vtkImageData>::New();
  flat->SetDimensions(4, 4, 1);
  QueryPointer query = MakeQuery(flat, SpatialQuery::CONTAINMENT);
  SetPlane(query, { 0, 0, 0 }, { 0, 0, -3 });
  EXPECT_EQ(CellsFound(query).size(), 9u);
  SetPlane(query, { 0, 0, 0 }, { 0, 1, 1 });
  EXPECT_TRUE(CellsFound(query).empty());
  SetBox(query, { 1, 3, 1, 2, 0, 0 });
  EXPECT_EQ(CellsFound(query), (Ids{ 4, 5 }));
  query->SetRelation(SpatialQuery::EXACT_MATCH);
  SetBox(query, { 1, 2, 1, 2, 0, 0 });
  EXPECT_EQ(CellsFound(query), Ids{ 4 });
  query->SetRelation(SpatialQuery::ENCLOSURE);
  SetLine(query, { 1.5, 1.25, 0 }, { 1.75, 1.5, 0 });
  EXPECT_EQ(CellsFound(query), Ids{ 4 });
}

TEST(SpatialQuery, ConcaveCellsEncloseOnlyWhatIsInThem)
{
  // An L of a polygon; and the same as a prism of polyhedron.
  Mesh mesh;
  const std::vector<Point> corners = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 },
    { 1, 2, 0 }, { 0, 2, 0 } };
  Ids low, high;
  for (const Point& p : corners)
  {
    low.push_back(mesh.Add(p));
    high.push_back(mesh.Add(p + Point{ 0, 0, 1 }));
  }
  mesh.Add(VTK_POLYGON, low);
  Ids faces = { 8, 6 };
  faces.insert(faces.end(), low.begin(), low.end());
  faces.push_back(6);
  faces.insert(faces.end(), high.begin(), high.end());
  for (std::size_t i = 0; i < 6; ++i)
  {
    const std::size_t next = (i + 1) % 6;
    faces.insert(faces.end(), { 4, low[i], low[next], high[next], high[i] });
  }
  mesh.Add(VTK_POLYHEDRON, faces);
  QueryPointer query = MakeQuery(MakeGrid(mesh), SpatialQuery::ENCLOSURE);
  SetLine(query, { 1.75, 0.5, 0 }, { 0.5, 1.75, 0 }); // across the notch
  EXPECT_EQ(CellsFound(query), Ids{});
  SetLine(query, { 1.75, 0.25, 0 }, { 0.25, 0.5, 0 });
  EXPECT_EQ(CellsFound(query), (Ids{ 0, 1 }));
  SetLine(query, { 1.5, 0.5, 0 }, { 0.5, 1.5, 0 }); // through the corner of the notch
  EXPECT_EQ(CellsFound(query), (Ids{ 0, 1 }));
  SetBox(query, { 0.25, 1.75, 0.25, 0.75, 0.25, 0.75 });
  EXPECT_EQ(CellsFound(query), Ids{ 1 });
  SetBox(query, { 0.25, 1.75, 0.25, 1.75, 0.25, 0.75 }); // all corners but one are in
  EXPECT_EQ(CellsFound(query), Ids{});
  SetSphere(query, { 0.5, 0.5, 0.5 }, 0.5);
  EXPECT_EQ(CellsFound(query), Ids{ 1 });
  SetSphere(query, { 0.75, 0.75, 0.5 }, 0.4);
  EXPECT_EQ(CellsFound(query), Ids{});
  query->SetRelation(SpatialQuery::CONTAINMENT);
  SetBox(query, { 0, 2, 0, 2, 0, 1 });
  EXPECT_EQ(CellsFound(query), (Ids{ 0, 1 }));
}

TEST(SpatialQuery, ABoxAcrossANotchIsNotEnclosedThoughItsCornersAre)
{
  // A U: the box spans its arms.
  Mesh mesh;
  const std::vector<Point> corners = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 }, { 2, 2, 0 },
    { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } };
  Ids ids;
  for (const Point& p : corners)
  {
    ids.push_back(mesh.Add(p));
  }
  mesh.Add(VTK_POLYGON, ids);
  QueryPointer query = MakeQuery(MakeGrid(mesh), SpatialQuery::ENCLOSURE);
  SetBox(query, { 0.5, 2.5, 0.25, 1.75, 0, 0 });
  EXPECT_TRUE(CellsFound(query).empty());
  SetBox(query, { 0.5, 2.5, 0.25, 1.0, 0, 0 });
  EXPECT_EQ(CellsFound(query), Ids{ 0 });
  SetLine(query, { 0.5, 1.5, 0 }, { 2.5, 1.5, 0 });
  EXPECT_TRUE(CellsFound(query).empty());
}

//------------------------------------------------------------------------------
struct Scale
{
  double Size;
  Point Offset;
};

TEST(SpatialQuery, TinyHugeAndFarMeshesAreAnsweredAlike)
{
  for (const Scale& scale : { Scale{ 1e-8, { 0, 0, 0 } }, Scale{ 1e9, { 0, 0, 0 } },
         Scale{ 1, { 1e6, -1e6, 1e6 } }, Scale{ 1e-3, { 4096, 4096, 4096 } } })
  {
    const auto position = [&](const Point& p) { return scale.Size * p + scale.Offset; };
    GridPointer input = MakeGrid(Transformed(Tetrahedra(3), scale.Size, scale.Offset));
    GridPointer plain = MakeGrid(Tetrahedra(3));
    for (int relation = SpatialQuery::OVERLAP; relation <= SpatialQuery::ADJACENCY; ++relation)
    {
      QueryPointer query = MakeQuery(input, relation);
      QueryPointer reference = MakeQuery(plain, relation);
      const Point low = { 0.625, 0.375, 0.75 }, high = { 2.125, 1.875, 2.25 };
      const Point a = position(low), b = position(high);
      SetBox(query, { a[0], b[0], a[1], b[1], a[2], b[2] });
      SetBox(reference, { low[0], high[0], low[1], high[1], low[2], high[2] });
      EXPECT_EQ(CellsFound(query), CellsFound(reference)) << scale.Size << " " << relation;
      SetSphere(query, a, 1.125 * scale.Size);
      SetSphere(reference, low, 1.125);
      EXPECT_EQ(CellsFound(query), CellsFound(reference)) << scale.Size << " " << relation;
      SetLine(query, a, b);
      SetLine(reference, low, high);
      EXPECT_EQ(CellsFound(query), CellsFound(reference)) << scale.Size << " " << relation;
    }
  }
}

//------------------------------------------------------------------------------
TEST(SpatialQueryBadInput, WithoutASourceIsOneErrorAndFindsNothing)
{
  for (const int shape : { SpatialQuery::SOURCE_POINTS, SpatialQuery::SOURCE_CELLS })
  {
    QueryPointer query = MakeQuery(MakeBricks());
    query->SetShape(shape);
    EventCounter events(query);
    EXPECT_TRUE(RunQuery(query).empty());
    EXPECT_EQ(events.Errors, 1);
    EXPECT_NE(events.Error.find("Source"), std::string::npos);
    EXPECT_EQ(CellsOf(query)->GetNumberOfCells(), 0);
  }
}

TEST(SpatialQueryBadInput, UnusableShapesAreOneWarningAndFindNothing)
{
  const std::vector<std::function<void(SpatialQuery*)>> makers = { [](SpatialQuery* query)
    {
      query->SetShape(SpatialQuery::BOX);
      query->SetBoxPosition(1e308, 0, 0);
      query->SetBoxLength(1e308, 1, 1);
      query->SetUseReferenceBounds(true);
      query->SetReferenceBounds(0, 10, 0, 1, 0, 1);
    },
    [](SpatialQuery* query) {
      SetSphere(query, { 1e308, 0, 0 }, 1e308);
    },
    [](SpatialQuery* query) {
      SetPlane(query, { 0, 0, 0 }, { 0, 0, 0 });
    } };
  for (const auto& make : makers)
  {
    for (int relation = SpatialQuery::EXACT_MATCH; relation <= SpatialQuery::NEAREST; ++relation)
    {
      for (const bool isExact : { true, false })
      {
        QueryPointer query = MakeQuery(MakeBricks(), relation);
        make(query);
        query->SetExact(isExact);
        EventCounter events(query);
        EXPECT_TRUE(RunQuery(query).empty());
        EXPECT_EQ(events.Warnings, 1);
        EXPECT_EQ(events.Errors, 0);
      }
    }
  }
}

TEST(SpatialQueryBadInput, PointsAndCellsThatAreNotFiniteFindNothing)
{
  QueryPointer query = MakeQuery(MakeBricks(), SpatialQuery::NEAREST);
  query->SetShape(SpatialQuery::SOURCE_POINTS);
  query->SetSourceData(MakeQueries({ { Nan, 0, 0 }, { 0.5, 0.5, 0.5 }, { 0, Infinity, 0 } }));
  const std::vector<PairRow> rows = RunQuery(query);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].Query, 1);
  Mesh mesh = Hexahedra(1);
  mesh.Points[0][1] = Nan;
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(MakeGrid(mesh));
  EXPECT_TRUE(RunQuery(query).empty());
  query->SetSourceData(MakeBricks());
  query->SetInputDataObject(0, MakeGrid(mesh));
  EXPECT_TRUE(RunQuery(query).empty());
}

TEST(SpatialQueryBadInput, NumbersOutOfRangeAreTakenForTheNearest)
{
  QueryPointer query = MakeQuery(MakeBricks(), SpatialQuery::NEAREST);
  query->SetNumberOfNearestCells(-3);
  {
    EventCounter events(query);
    EXPECT_TRUE(RunQuery(query).empty());
    EXPECT_EQ(events.Errors, 1);
    EXPECT_NE(events.Error.find("NumberOfNearestCells"), std::string::npos);
  }
  query->SetNumberOfNearestCells(VTK_INT_MAX);
  EXPECT_EQ(RunQuery(query).size(), 27u);
}

TEST(SpatialQuery, AbortedExecutionsEndAndProgressIsReported)
{
  QueryPointer query = MakeQuery(MakeGrid(Tetrahedra(12)));
  query->SetShape(SpatialQuery::SOURCE_POINTS);
  query->SetSourceData(MakeGrid(Tetrahedra(12)));
  ProgressWatch watch(query, 0.5);
  query->Update();
  EXPECT_GT(watch.Seen.size(), 1u);
  EXPECT_TRUE(std::is_sorted(watch.Seen.begin(), watch.Seen.end()));
}

}
