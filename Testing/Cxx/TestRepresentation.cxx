// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeRepresentation: the boxes of a level, and the table about the tree, against the arrays
// S and L of the tree itself.

#include "Support/EventCounter.h"
#include "Support/FilterRun.h"
#include "Support/NamedMeshes.h"
#include "Support/PaperArrays.h"
#include "Support/VolumeMeshes.h"

#include "vtkSkdTreeRepresentation.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

using RepresentationPointer = vtkSmartPointer<vtkSkdTreeRepresentation>;

RepresentationPointer MakeRepresentation(vtkDataObject* input, int level)
{
  auto made = RepresentationPointer::New();
  made->SetInputDataObject(input);
  made->SetLevel(level);
  return made;
}

vtkPolyData* BoxesOf(vtkSkdTreeRepresentation* representation)
{
  representation->Update();
  return vtkPolyData::SafeDownCast(representation->GetOutputDataObject(0));
}

double Reported(vtkSkdTreeRepresentation* representation, const char* column, vtkIdType row = 0)
{
  auto* table = vtkTable::SafeDownCast(representation->GetOutputDataObject(1));
  return table->GetValueByName(row, column).ToDouble();
}

/// Six quads each, by their bounds.
std::vector<Bounds> DrawnBoxes(vtkPolyData* drawn)
{
  std::vector<Bounds> boxes(static_cast<std::size_t>(drawn->GetNumberOfCells()) / 6, EmptyBounds());
  for (vtkIdType cell = 0; cell < drawn->GetNumberOfCells(); ++cell)
  {
    Bounds quad;
    drawn->GetCellBounds(cell, quad.data());
    Extend(boxes[static_cast<std::size_t>(cell / 6)], { quad[0], quad[2], quad[4] });
    Extend(boxes[static_cast<std::size_t>(cell / 6)], { quad[1], quad[3], quad[5] });
  }
  return boxes;
}

class RepresentationOfMesh : public testing::TestWithParam<NamedMesh>
{
};

INSTANTIATE_TEST_SUITE_P(All, RepresentationOfMesh, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(RepresentationOfMesh, DrawsTheSafetyBoxesOfEachLevel)
{
  const DataSetPointer mesh = GetParam().Make();
  const LocatorPointer locator = MakeLocator(mesh);
  const PaperArrays arrays(locator);
  for (const int level : { 0, 1, 3, -1, 64 })
  {
    std::vector<Bounds> expected;
    const bool isOfLeaves = level < 0 || level == 64;
    arrays.Visit(
      [&](vtkIdType node, int depth)
      {
        if (isOfLeaves ? arrays.IsLeaf(node) : depth == level)
        {
          expected.push_back(arrays.S[node]);
        }
      });
    std::vector<Bounds> drawn = DrawnBoxes(BoxesOf(MakeRepresentation(mesh, level)));
    std::sort(expected.begin(), expected.end());
    std::sort(drawn.begin(), drawn.end());
    ASSERT_EQ(drawn, expected) << "level " << level;
  }
}

double Area(const Bounds& b)
{
  const Point size = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  return 2.0 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
}

double SharedArea(const Bounds& a, const Bounds& b)
{
  Bounds both;
  for (int axis = 0; axis < 3; ++axis)
  {
    both[2 * axis] = std::max(a[2 * axis], b[2 * axis]);
    both[2 * axis + 1] = std::min(a[2 * axis + 1], b[2 * axis + 1]);
    if (both[2 * axis] > both[2 * axis + 1])
    {
      return 0.0;
    }
  }
  return Area(both);
}

TEST_P(RepresentationOfMesh, TellsWhatTheTreeIs)
{
  const DataSetPointer mesh = GetParam().Make();
  const LocatorPointer locator = MakeLocator(mesh);
  const PaperArrays arrays(locator);
  double cost = 0.0, overlap = 0.0;
  int deepest = 0, inner = 0;
  arrays.Visit(
    [&](vtkIdType node, int depth)
    {
      deepest = std::max(deepest, depth);
      cost += Area(arrays.S[node]) / Area(arrays.S[0]);
      if (!arrays.IsLeaf(node))
      {
        ++inner;
        overlap +=
          SharedArea(arrays.S[arrays.L[node]], arrays.S[arrays.L[node] + 1]) / Area(arrays.S[node]);
      }
    });
  RepresentationPointer reported = MakeRepresentation(mesh, 0);
  reported->Update();
  EXPECT_EQ(Reported(reported, "Cells"), static_cast<double>(mesh->GetNumberOfCells()));
  EXPECT_EQ(Reported(reported, "CellsLeftOut"), 0.0);
  EXPECT_EQ(Reported(reported, "PaperNodes"), static_cast<double>(arrays.L.size()));
  EXPECT_EQ(Reported(reported, "PaperDepth"), deepest);
  EXPECT_NEAR(Reported(reported, "Cost"), cost, 1e-9 * cost);
  EXPECT_NEAR(Reported(reported, "Overlap"), overlap / inner, 1e-9);
  EXPECT_EQ(Reported(reported, "Nodes"), static_cast<double>(locator->GetNumberOfNodes()));
  EXPECT_EQ(Reported(reported, "Depth"), locator->GetDepth());
  EXPECT_EQ(Reported(reported, "Bytes"), static_cast<double>(locator->GetMemorySize()));
  EXPECT_GE(Reported(reported, "BuildSeconds"), 0.0);
}

TEST(Representation, OfBlocksEachHasItsTreeAndItsRow)
{
  const GridPointer grid = MakeGrid(Hexahedra(2));
  const PolyDataPointer surface = MakePolyData(Octahedron(1));
  RepresentationPointer drawn = MakeRepresentation(MakeBlocks({ grid, nullptr, surface }), -1);
  vtkPolyData* boxes = BoxesOf(drawn);
  ASSERT_EQ(boxes->GetNumberOfCells(), 6 * 16);
  vtkDataArray* blocks = boxes->GetCellData()->GetArray("BlockIndex");
  vtkDataArray* cells = boxes->GetCellData()->GetArray("CellId");
  EXPECT_EQ(blocks->GetTuple1(0), 1);
  EXPECT_EQ(blocks->GetTuple1(6 * 8), 3);
  EXPECT_EQ(cells->GetRange()[1], 7);
  EXPECT_EQ(Reported(drawn, "BlockIndex", 0), 1);
  EXPECT_EQ(Reported(drawn, "BlockIndex", 1), 3);
  EXPECT_EQ(Reported(drawn, "Cells", 1), 8);
}

TEST(Representation, GhostsAndCellsThatAreNotFiniteAreLeftOutAndCounted)
{
  Mesh mesh = Hexahedra(2);
  const GridPointer grid = MakeGrid(mesh);
  MarkGhosts(grid, { 0, 3 }, vtkDataSetAttributes::DUPLICATECELL);
  RepresentationPointer drawn = MakeRepresentation(grid, -1);
  EXPECT_EQ(BoxesOf(drawn)->GetNumberOfCells(), 6 * 6);
  EXPECT_EQ(Reported(drawn, "CellsLeftOut"), 2);
  mesh.Points[0] = { NAN, 0, 0 };
  drawn = MakeRepresentation(MakeGrid(mesh), -1);
  EXPECT_EQ(BoxesOf(drawn)->GetNumberOfCells(), 6 * 7);
  EXPECT_EQ(Reported(drawn, "CellsLeftOut"), 1);
}

TEST(Representation, WithoutCellsThereIsARowOfZerosAndNoBox)
{
  vtkNew<vtkPolyData> empty;
  RepresentationPointer drawn = MakeRepresentation(empty, 4);
  EventCounter events(drawn);
  EXPECT_EQ(BoxesOf(drawn)->GetNumberOfCells(), 0);
  for (const char* column : { "Cells", "Nodes", "PaperNodes", "PaperDepth", "Overlap", "Cost" })
  {
    EXPECT_EQ(Reported(drawn, column), 0.0) << column;
  }
  EXPECT_EQ(events.Errors + events.Warnings, 0);
}

TEST(Representation, AnAbortLeavesBlocksOut)
{
  RepresentationPointer drawn = MakeRepresentation(MakeBlocks(Hexahedra(1), 6), 0);
  AbortAt(drawn, 0.4);
  auto* table = vtkTable::SafeDownCast(drawn->GetOutputDataObject(1));
  EXPECT_LT(table->GetNumberOfRows(), 6);
  EXPECT_EQ(BoxesOf(drawn)->GetNumberOfCells(), 36);
}

}
