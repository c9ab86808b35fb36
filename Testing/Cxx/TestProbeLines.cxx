// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeProbe along lines: where they pass from cell to cell, and integrals.

#include "Support/CellZoo.h"
#include "Support/EventCounter.h"
#include "Support/NamedMeshes.h"
#include "Support/ProbeRun.h"

#include "vtkSMPTools.h"
#include "vtkSkdTreeCellLocator.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using LocatorPointer = vtkSmartPointer<vtkSkdTreeCellLocator>;

LocatorPointer LocatorOf(vtkDataSet* mesh)
{
  auto locator = LocatorPointer::New();
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  return locator;
}

/// What many points along the line say: the length within each cell, to within a step.
double SampledLength(vtkSkdTreeCellLocator* locator, const Point& from, const Point& to, int steps)
{
  int inside = 0;
  for (int i = 0; i < steps; ++i)
  {
    Point x = Lerp(from, to, (i + 0.5) / steps);
    inside += locator->FindCell(x.data()) >= 0;
  }
  return Distance(from, to) * inside / steps;
}

class LinesInVolume : public testing::TestWithParam<NamedMesh>
{
protected:
  void SetUp() override
  {
    this->Source = WithData(GetParam().Make());
    this->Source->GetBounds(this->Box.data());
  }

  std::vector<std::pair<Point, Point>> Lines(int count)
  {
    Random random(31);
    std::vector<std::pair<Point, Point>> lines;
    for (int i = 0; i < count; ++i)
    {
      const Bounds around = Grown(this->Box, (i % 2) * 0.3 * Diagonal(this->Box));
      lines.emplace_back(random.InBox(around), random.InBox(around));
    }
    return lines;
  }

  DataSetPointer Source;
  Bounds Box;
};

INSTANTIATE_TEST_SUITE_P(All, LinesInVolume, testing::ValuesIn(VolumeMeshes()), NameOfMesh());

TEST_P(LinesInVolume, EachPointIsInTheCellThatFindCellNames)
{
  LocatorPointer locator = LocatorOf(this->Source);
  Random random(32);
  const double rounding = 1e-10 * Diagonal(this->Box);
  for (const auto& [from, to] : this->Lines(40))
  {
    ProbePointer probe = MakeProbe(MakeLine({ from, to }), this->Source);
    const Intervals found(probe);
    const double length = Distance(from, to);
    for (int i = 0; i < 300; ++i)
    {
      const double s = length * (i + random.InBox({ 0, 1, 0, 1, 0, 1 })[0]) / 300;
      Point x = Lerp(from, to, s / length);
      vtkIdType expected = locator->FindCell(x.data());
      double named = -1;
      bool isClose = false;
      for (std::size_t k = 0; k < found.Cells.size(); ++k)
      {
        named = s >= found.Entries[k] && s <= found.Exits[k] ? found.Cells[k] : named;
        isClose |=
          std::abs(s - found.Entries[k]) < rounding || std::abs(s - found.Exits[k]) < rounding;
      }
      if (expected >= 0 && this->Source->GetCell(expected)->GetCellDimension() < 3)
      {
        continue; // of surfaces only what runs along them counts
      }
      ASSERT_TRUE(isClose || named == expected) << named << " for " << expected << " at " << s;
    }
  }
}

TEST_P(LinesInVolume, IntervalsAreInOrderAndFollowEachOther)
{
  LocatorPointer locator = LocatorOf(this->Source);
  for (const auto& [from, to] : this->Lines(30))
  {
    ProbePointer probe = MakeProbe(MakeLine({ from, to }), this->Source);
    const Intervals found(probe);
    double sum = 0.0;
    for (std::size_t k = 0; k < found.Cells.size(); ++k)
    {
      ASSERT_GT(found.Lengths[k], 0.0);
      ASSERT_NEAR(
        found.Lengths[k], Distance(found.From[k], found.To[k]), 1e-12 * Diagonal(this->Box));
      ASSERT_NEAR(Distance(from, found.From[k]), found.Entries[k], 1e-12 * Diagonal(this->Box));
      ASSERT_TRUE(k == 0 || found.Entries[k] >= found.Exits[k - 1]);
      sum += found.Lengths[k];
    }
    ASSERT_NEAR(sum, SampledLength(locator, from, to, 5000), 6e-4 * Distance(from, to));
    ASSERT_NEAR(IntegralsOf(probe, "SkdLength")[0], sum, 1e-12 * Diagonal(this->Box));
  }
}

TEST_P(LinesInVolume, IntegralsOfLinearFieldsAreExact)
{
  for (const auto& [from, to] : this->Lines(30))
  {
    ProbePointer probe = MakeProbe(MakeLine({ from, to }), this->Source);
    const Intervals found(probe);
    double expected = 0.0;
    double numbers = 0.0;
    for (std::size_t k = 0; k < found.Cells.size(); ++k)
    {
      expected += found.Lengths[k] * Linear(Lerp(found.From[k], found.To[k], 0.5));
      numbers += found.Lengths[k] * 10.0 * found.Cells[k];
    }
    const double scale = 1.0 + Diagonal(this->Box);
    ASSERT_NEAR(IntegralsOf(probe, "Linear_Integral")[0], expected, 1e-10 * scale * scale);
    ASSERT_NEAR(IntegralsOf(probe, "Number_Integral")[0], numbers, 1e-9 * (1.0 + numbers));
    const std::vector<double> atEnds = PointArray(probe->GetOutputDataObject(1), "Linear");
    for (std::size_t k = 0; k < found.Cells.size(); ++k)
    {
      ASSERT_NEAR(atEnds[2 * k], Linear(found.From[k]), 1e-10 * scale);
      ASSERT_NEAR(atEnds[2 * k + 1], Linear(found.To[k]), 1e-10 * scale);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ProbeLines, OfALatticeEachCellIsCrossedExactly)
{
  const int n = 5;
  auto source = WithData(MakeGrid(Hexahedra(n)));
  ProbePointer probe = MakeProbe(MakeLine({ { -1, 2.5, 2.5 }, { n + 1, 2.5, 2.5 } }), source);
  const Intervals found(probe);
  ASSERT_EQ(found.Cells.size(), static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
  {
    EXPECT_EQ(found.Cells[i], 2 * n * n + 2 * n + i);
    EXPECT_EQ(found.Entries[i], i + 1.0);
    EXPECT_EQ(found.Exits[i], i + 2.0);
  }
}

TEST(ProbeLines, AlongFacesEdgesAndDiagonalsEachPartCountsOnce)
{
  const int n = 4;
  for (const Mesh& mesh : { Hexahedra(n), Tetrahedra(n), Wedges(n), Polyhedra(n), Pyramids(n) })
  {
    auto source = WithData(MakeGrid(mesh));
    for (const auto& [from, to] : { std::pair(Point{ 0, 2, 2.5 }, Point{ 4, 2, 2.5 }),
           std::pair(Point{ 0, 2, 2 }, Point{ 4, 2, 2 }),
           std::pair(Point{ 0, 0, 0 }, Point{ 4, 4, 4 }),
           std::pair(Point{ -1, -1, 2 }, Point{ 5, 5, 2 }),
           std::pair(Point{ 0, 0, 0 }, Point{ 4, 0, 0 }) })
    {
      ProbePointer probe = MakeProbe(MakeLine({ from, to }), source);
      const Intervals found(probe);
      double sum = 0.0;
      for (double length : found.Lengths)
      {
        sum += length;
      }
      const double inside = from[0] < 0 ? Distance(from, to) * 4 / 6 : Distance(from, to);
      EXPECT_NEAR(sum, inside, 1e-12) << mesh.Cells[0].Type;
      EXPECT_LE(found.Cells.size(), static_cast<std::size_t>(2 * n)) << mesh.Cells[0].Type;
    }
  }
}

TEST(ProbeLines, AConcavePolyhedronMayBeCrossedTwice)
{
  // A U of height 1: a floor 3 wide, and two walls.
  Mesh mesh;
  const double u[8][2] = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 },
    { 0, 3 } };
  for (double z : { 0.0, 1.0 })
  {
    for (const auto& p : u)
    {
      mesh.Add({ p[0], p[1], z });
    }
  }
  Ids stream = { 10 };
  for (vtkIdType z : { 0, 8 })
  {
    stream.push_back(8);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      stream.push_back(z == 0 ? 7 - i : 8 + i);
    }
  }
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const vtkIdType next = (i + 1) % 8;
    stream.insert(stream.end(), { 4, i, next, next + 8, i + 8 });
  }
  mesh.Add(VTK_POLYHEDRON, stream);
  ProbePointer probe = MakeProbe(MakeLine({ { -1, 2, 0.4 }, { 4, 2, 0.4 } }), MakeGrid(mesh));
  const Intervals found(probe);
  ASSERT_EQ(found.Cells.size(), 2u);
  EXPECT_NEAR(found.Entries[0], 1.0, 1e-12);
  EXPECT_NEAR(found.Exits[0], 2.0, 1e-12);
  EXPECT_NEAR(found.Entries[1], 3.0, 1e-12);
  EXPECT_NEAR(found.Exits[1], 4.0, 1e-12);
}

TEST(ProbeLines, OverlappingCellsShareTheLineByLowestId)
{
  Mesh mesh = Hexahedra(1); // [0, 1]^3, and one from 0.5 to 1.5
  for (const Point& p : Hexahedra(1).Points)
  {
    mesh.Add(p + Point{ 0.5, 0, 0 });
  }
  mesh.Add(VTK_HEXAHEDRON, { 8, 9, 11, 10, 12, 13, 15, 14 });
  const Ids cube = Hexahedra(1).Cells[0].Points;
  mesh.Cells[1].Points = cube;
  for (vtkIdType& id : mesh.Cells[1].Points)
  {
    id += 8;
  }
  ProbePointer probe = MakeProbe(MakeLine({ { -1, 0.3, 0.3 }, { 2, 0.3, 0.3 } }), MakeGrid(mesh));
  const Intervals found(probe);
  EXPECT_EQ(found.Cells, (std::vector<double>{ 0, 1 }));
  EXPECT_NEAR(found.Exits[0], 2.0, 1e-13);
  EXPECT_NEAR(found.Exits[1], 2.5, 1e-13);
}

TEST(ProbeLines, OfASheetWhatRunsWithinIt)
{
  for (int type : { VTK_QUAD, VTK_TRIANGLE, VTK_PIXEL })
  {
    auto source = WithData(MakeGrid(Sheet(4, type)));
    Bounds box;
    source->GetBounds(box.data());
    const double y = box[2] + 0.37 * (box[3] - box[2]);
    const Point from = { box[0] - 1, y, box[4] };
    const Point to = { box[1] + 1, y + 0.01, box[4] };
    ProbePointer probe = MakeProbe(MakeLine({ from, to }), source);
    const Intervals found(probe);
    double sum = 0.0;
    for (double length : found.Lengths)
    {
      sum += length;
    }
    EXPECT_NEAR(sum, Distance(from, to) * (box[1] - box[0]) / (box[1] - box[0] + 2), 1e-12) << type;
    EXPECT_GE(found.Cells.size(), 4u);
    ProbePointer across = MakeProbe(MakeLine({ { 0.3, 0.3, -1 }, { 0.3, 0.3, 1 } }), source);
    EXPECT_LE(Intervals(across).Cells.size(), 1u);
  }
}

TEST(ProbeLines, CurvedCellsToo)
{
  for (int type : { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_LAGRANGE_HEXAHEDRON })
  {
    auto source = MakeGrid(Block(ReferenceCell(type, 2), Bent));
    LocatorPointer locator = LocatorOf(source);
    Bounds box;
    source->GetBounds(box.data());
    Random random(33);
    for (int i = 0; i < 10; ++i)
    {
      const Point from = random.InBox(Grown(box, 0.5));
      const Point to = random.InBox(Grown(box, 0.5));
      ProbePointer probe = MakeProbe(MakeLine({ from, to }), source);
      double sum = 0.0;
      for (double length : Intervals(probe).Lengths)
      {
        sum += length;
      }
      ASSERT_NEAR(sum, SampledLength(locator, from, to, 2000), 3e-3 * Distance(from, to))
        << NameOfType(type);
    }
  }
}

TEST(ProbeLines, PolylinesGoOnAndBlocksAreNamed)
{
  auto source = WithData(MakeGrid(Hexahedra(3)));
  auto bent =
    MakeLine({ { 0.5, 0.5, 0.5 }, { 2.5, 0.5, 0.5 }, { 2.5, 0.5, 0.5 }, { 2.5, 2.5, 0.5 } });
  ProbePointer probe = MakeProbe(bent, source);
  const Intervals found(probe);
  EXPECT_EQ(found.Cells, (std::vector<double>{ 0, 1, 2, 2, 5, 8 }));
  EXPECT_EQ(found.Exits, (std::vector<double>{ 0.5, 1.5, 2, 2.5, 3.5, 4 }));
  EXPECT_EQ(IntegralsOf(probe, "SkdLineLength"), (std::vector<double>{ 4 }));

  ProbePointer blocks = MakeProbe(MakeBlocks({ nullptr, bent, bent }), MakeBlocks({ source }));
  blocks->ProbeLinesOn();
  blocks->Update();
  auto* lines = vtkPolyData::SafeDownCast(blocks->GetOutputDataObject(1));
  EXPECT_EQ(lines->GetNumberOfCells(), 12);
  EXPECT_EQ(lines->GetCellData()->GetArray("SkdInputBlockIndex")->GetTuple1(0), 2);
  EXPECT_EQ(lines->GetCellData()->GetArray("SkdInputBlockIndex")->GetTuple1(11), 3);
  EXPECT_EQ(lines->GetCellData()->GetArray("SkdSourceBlockIndex")->GetTuple1(0), 1);
  EXPECT_EQ(IntegralsOf(blocks, "SkdInputBlockIndex"), (std::vector<double>{ 2, 3 }));
}

TEST(ProbeLines, WithoutLinesThereIsAWarning)
{
  auto source = WithData(MakeGrid(Hexahedra(2)));
  const Point one = { 1, 1, 1 };
  for (const PolyDataPointer& input :
    { MakeQueries({ one }), MakeLine({ one, one }), MakeLine({ one, { NAN, 0, 0 } }) })
  {
    ProbePointer probe = MakeProbe(input, source);
    EventCounter events(probe);
    EXPECT_TRUE(Intervals(probe).Cells.empty());
    const bool isFinite = std::isfinite(input->GetPoint(input->GetNumberOfPoints() - 1)[0]);
    EXPECT_EQ(events.Warnings, isFinite ? 1 : 2);
  }
}

TEST(ProbeLines, BitsAreTheSameForAnyNumberOfThreads)
{
  auto source = WithData(MakeGrid(Tetrahedra(4).Map(Bent)));
  Random random(34);
  std::vector<Point> walk;
  for (int i = 0; i < 200; ++i)
  {
    walk.push_back(random.InBox({ -1, 5, -1, 5, -1, 5 }));
  }
  std::vector<std::vector<double>> exits;
  for (int threads : { 1, 2, 4 })
  {
    vtkSMPTools::Initialize(threads);
    ProbePointer probe = MakeProbe(MakeLine(walk), source);
    exits.push_back(Intervals(probe).Exits);
    exits.back().push_back(IntegralsOf(probe, "Linear_Integral")[0]);
  }
  vtkSMPTools::Initialize();
  EXPECT_GT(exits[0].size(), 1000u);
  EXPECT_EQ(exits[0], exits[1]);
  EXPECT_EQ(exits[0], exits[2]);
}

}
