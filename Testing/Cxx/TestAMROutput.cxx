// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeAMR: its base grids and what its output is made of.

#include "Support/AMRRun.h"
#include "Support/NamedMeshes.h"

#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridNonOrientedGeometryCursor.h"
#include "vtkImageData.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSkdTreeVersion.h"

#include <gtest/gtest.h>

#include <map>

using namespace skdtest;

namespace
{

using Values = std::vector<double>;

/// What all arrays of a hyper tree grid's leaves hold, by the middle of the leaf.
class LeafReader
{
public:
  explicit LeafReader(vtkHyperTreeGrid* grid)
    : Data(grid->GetAttributes(vtkDataObject::CELL))
  {
    vtkNew<vtkHyperTreeGridNonOrientedGeometryCursor> cursor;
    for (vtkIdType tree = 0; tree < grid->GetMaxNumberOfTrees(); ++tree)
    {
      grid->InitializeNonOrientedGeometryCursor(cursor, tree);
      this->Read(cursor);
    }
  }

  std::map<Point, Values> Leaves;
  vtkIdType Nodes = 0;

private:
  void Read(vtkHyperTreeGridNonOrientedGeometryCursor* cursor)
  {
    ++this->Nodes;
    if (cursor->IsLeaf())
    {
      Bounds box;
      cursor->GetBounds(box.data());
      const vtkIdType id = cursor->GetGlobalNodeIndex();
      Values& values = this->Leaves[this->Rounded(Center(box))];
      for (int i = 0; i < this->Data->GetNumberOfArrays(); ++i)
      {
        values.push_back(this->Data->GetArray(i)->GetTuple1(id));
      }
      EXPECT_EQ(this->Data->GetArray("SkdLevel")->GetTuple1(id), cursor->GetLevel());
      return;
    }
    for (int child = 0; child < cursor->GetNumberOfChildren(); ++child)
    {
      cursor->ToChild(static_cast<unsigned char>(child));
      this->Read(cursor);
      cursor->ToParent();
    }
  }

public:
  /// VTK's own halving rounds otherwise.
  static Point Rounded(const Point& p)
  {
    return { std::round(1e9 * p[0]), std::round(1e9 * p[1]), std::round(1e9 * p[2]) };
  }

private:
  vtkDataSetAttributes* Data;
};

/// The values of a row of a data set's cell arrays, but for marks of VTK's own.
void AppendRow(vtkDataSetAttributes* data, vtkIdType row, Values& values)
{
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    if (std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
    {
      values.push_back(array->GetTuple1(row));
    }
  }
}

using LeafValues = std::map<Point, Values>;

void AppendGridLeaves(vtkSkdTreeAMR* filter, LeafValues& read)
{
  const std::vector<Leaf> leaves = LeavesOf(filter);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    AppendRow(filter->GetOutputDataObject(0)->GetAttributes(vtkDataObject::CELL),
      static_cast<vtkIdType>(i), read[LeafReader::Rounded(Center(leaves[i].Box))]);
  }
}

LeafValues UnstructuredLeaves(vtkSkdTreeAMR* filter)
{
  filter->SetOutputType(vtkSkdTreeAMR::UNSTRUCTURED_GRID);
  filter->Update();
  LeafValues read;
  AppendGridLeaves(filter, read);
  return read;
}

template <class Output>
Output* OutputAs(vtkSkdTreeAMR* filter, int type)
{
  filter->SetOutputType(type);
  filter->Update();
  return Output::SafeDownCast(filter->GetOutputDataObject(0));
}

void ExpectTreesToHave(const LeafValues& expected, vtkSkdTreeAMR* filter)
{
  const double all = Reported(filter, "AllCells");
  auto trees = OutputAs<vtkHyperTreeGrid>(filter, vtkSkdTreeAMR::HYPER_TREE_GRID);
  ASSERT_NE(trees, nullptr);
  const LeafReader read(trees);
  EXPECT_EQ(trees->GetNumberOfElements(vtkDataObject::CELL), all);
  EXPECT_EQ(read.Nodes, all);
  EXPECT_EQ(read.Leaves, expected);
}

/// The cells of a block that are not marked as refined; all of them are of the block's level.
void AppendLeaves(vtkImageData* block, unsigned int level, LeafValues& read)
{
  for (vtkIdType i = 0; i < block->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(block->GetCellData()->GetArray("SkdLevel")->GetTuple1(i), level);
    if (block->GetCellGhostArray()->GetValue(i) != vtkDataSetAttributes::REFINEDCELL)
    {
      Bounds box;
      block->GetCellBounds(i, box.data());
      AppendRow(block->GetCellData(), i, read[LeafReader::Rounded(Center(box))]);
    }
  }
}

void ExpectBlocksToHave(const LeafValues& expected, vtkSkdTreeAMR* filter)
{
  const double all = Reported(filter, "AllCells");
  auto blocks = OutputAs<vtkOverlappingAMR>(filter, vtkSkdTreeAMR::OVERLAPPING_AMR);
  ASSERT_NE(blocks, nullptr);
  LeafValues read;
  vtkIdType cells = 0;
  for (unsigned int level = 0; level < blocks->GetNumberOfLevels(); ++level)
  {
    for (unsigned int i = 0; i < blocks->VTK_SKD_AMR_GET_NUMBER_OF_BLOCKS(level); ++i)
    {
      vtkImageData* block = blocks->VTK_SKD_AMR_GET_BLOCK(level, i);
      Bounds told;
      Bounds is;
      blocks->GetBounds(level, i, told.data());
      block->GetBounds(is.data());
      EXPECT_LT(Distance(Center(told), Center(is)), 1e-12);
      cells += block->GetNumberOfCells();
      AppendLeaves(block, level, read);
    }
  }
  EXPECT_EQ(cells, all);
  EXPECT_EQ(read, expected);
}

void ExpectSameLeaves(vtkSkdTreeAMR* filter)
{
  filter->ComputeInsideOn();
  filter->ComputeDistanceOn();
  const LeafValues expected = UnstructuredLeaves(filter);
  ExpectTreesToHave(expected, filter);
  ExpectBlocksToHave(expected, filter);
}

TEST(AMROutput, AllTypesHaveTheSameLeaves)
{
  for (int branch = 2; branch <= 3; ++branch)
  {
    AMRPointer filter = MakeAMR(MakeTorus(), branch == 2 ? 4 : 3);
    filter->SetBranchFactor(branch);
    filter->SetBaseDimensions(3, 2, 1);
    filter->SetBalance(vtkSkdTreeAMR::EDGE);
    ExpectSameLeaves(filter);
  }
}

/// The leaves of all pieces: none is of two.
LeafValues LeavesOfPieces(vtkSkdTreeAMR* filter, int pieces)
{
  LeafValues together;
  std::size_t sum = 0;
  for (int piece = 0; piece < pieces; ++piece)
  {
    filter->UpdatePiece(piece, pieces, 0);
    LeafValues own;
    AppendGridLeaves(filter, own);
    sum += own.size();
    EXPECT_EQ(Reported(filter, "Cells"), static_cast<double>(own.size()));
    together.insert(own.begin(), own.end());
  }
  EXPECT_EQ(together.size(), sum);
  return together;
}

TEST(AMROutput, PiecesTogetherAreTheWhole)
{
  for (const int balance : { vtkSkdTreeAMR::NONE, vtkSkdTreeAMR::CORNER })
  {
    AMRPointer filter = MakeAMR(MakeTorus(), 4);
    filter->SetBaseDimensions(3, 2, 1);
    filter->SetBalance(balance);
    filter->ComputeInsideOn();
    const LeafValues whole = UnstructuredLeaves(filter);
    for (const int pieces : { 2, 3, 7 })
    {
      EXPECT_EQ(LeavesOfPieces(filter, pieces), whole) << pieces;
    }
  }
}

TEST(AMROutput, BlocksAndTreesOfPiecesTogetherAreTheWhole)
{
  AMRPointer filter = MakeAMR(MakeTorus(), 4);
  filter->SetBaseDimensions(3, 2, 1);
  filter->Update();
  const double all = Reported(filter, "AllCells");
  for (const int type : { vtkSkdTreeAMR::HYPER_TREE_GRID, vtkSkdTreeAMR::OVERLAPPING_AMR })
  {
    filter->SetOutputType(type);
    double cells = 0;
    for (int piece = 0; piece < 4; ++piece)
    {
      filter->UpdatePiece(piece, 4, 0);
      const auto own = static_cast<double>(
        filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL));
      EXPECT_GT(own, 0);
      EXPECT_LT(own, 0.7 * all);
      cells += own;
    }
    EXPECT_EQ(cells, all);
  }
}

TEST(AMROutput, FlatBasesInAnyPlaneAndAlongALine)
{
  auto torus = MakeTorus();
  for (int flat = 0; flat < 3; ++flat)
  {
    Bounds box = { -1.6, 1.5, -1.7, 1.4, -0.6, 0.5 };
    const double across[3] = { 0.9, 0.5, 0.1 };
    box[2 * flat] = box[2 * flat + 1] = across[flat];
    AMRPointer filter = MakeAMRIn(torus, 4, box);
    filter->SetBaseDimensions(3, 2, 2);
    filter->SetBranchFactor(2 + flat % 2);
    ExpectSameLeaves(filter);
    EXPECT_GT(Reported(filter, "CutCells"), 10);
    const int other = (flat + 1) % 3;
    box[2 * other] = box[2 * other + 1] = across[other];
    AMRPointer line = MakeAMRIn(torus, 6, box);
    line->ComputeInsideOn();
    ExpectTreesToHave(UnstructuredLeaves(line), line);
    EXPECT_GE(Reported(line, "CutCells"), 1);
  }
}

TEST(AMROutput, AnImageOrARectilinearGridIsTheBase)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 6, -1, 2, 0, 3);
  image->SetOrigin(-3, -1, -1.5);
  image->SetSpacing(0.75, 0.8, 0.9);
  AMRPointer filter = MakeAMR(MakeTorus(), 3);
  filter->SetBaseMeshData(image);
  const std::vector<Leaf> ofImage = RunLeaves(filter);
  Bounds box;
  filter->GetOutputDataObject(0);
  vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0))->GetBounds(box.data());
  Bounds expected;
  image->GetBounds(expected.data());
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(box[i], expected[i], 1e-12);
  }

  auto rectilinear = MakeRectilinear(5);
  rectilinear->GetBounds(expected.data());
  filter->SetBaseMeshData(rectilinear);
  filter->SetMaximumLevel(0);
  const std::vector<Leaf> base = RunLeaves(filter);
  ASSERT_EQ(static_cast<vtkIdType>(base.size()), rectilinear->GetNumberOfCells());
  for (std::size_t i = 0; i < base.size(); ++i)
  {
    Bounds cell;
    rectilinear->GetCellBounds(static_cast<vtkIdType>(i), cell.data());
    EXPECT_EQ(base[i].Box, cell);
  }
}

TEST(AMROutput, BaseCellsBySizeAndByNumber)
{
  auto torus = MakeTorus(); // 2.7 x 2.7 x 0.7
  AMRPointer filter = MakeAMR(torus, 0);
  filter->SetBoundsMargin(0.0);
  EXPECT_EQ(RunLeaves(filter).size(), 4u * 4u * 1u);
  filter->SetBaseDimensions(5, 0, 2);
  EXPECT_EQ(RunLeaves(filter).size(), 5u * 4u * 2u);
  filter->SetBaseCellSize(0.5);
  const std::vector<Leaf> cubes = RunLeaves(filter);
  EXPECT_EQ(cubes.size(), 6u * 6u * 2u);
  for (const Leaf& cube : cubes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(cube.Box[2 * axis + 1] - cube.Box[2 * axis], 0.5, 1e-12);
    }
  }
  EXPECT_NE(FindLeaf(cubes, { 1.35, 0.0, 0.0 }), nullptr);
}

}
