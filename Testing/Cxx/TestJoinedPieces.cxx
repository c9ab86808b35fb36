// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Pieces of a mesh from several processes, sent as lists of arrays and joined: the mesh again.

#include "Support/FilterRun.h"
#include "Support/MeshPieces.h"
#include "Support/NamedMeshes.h"
#include "Support/StructuredMeshes.h"
#include "Support/SurfaceMeshes.h"
#include "Support/VolumeMeshes.h"

#include "Exchange/SkdJoinedPieces.h"
#include "Exchange/SkdPackedMesh.h"
#include "Exchange/SkdPieceArrays.h"

#include "vtkCharArray.h"
#include "vtkCommunicator.h"
#include "vtkIdTypeArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace skdtest;
using namespace skdtree;

namespace
{
using Row = std::vector<double>;

void Append(vtkDataSetAttributes* data, vtkIdType tuple, Row& row)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
    {
      row.push_back(array->GetComponent(tuple, c));
    }
  }
}

/// Each cell by value: type, coordinates and data of its points, its own data.
std::multiset<Row> CellsOf(vtkDataSet* mesh)
{
  std::multiset<Row> rows;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    Row row{ double(mesh->GetCellType(cell)) };
    mesh->GetCellPoints(cell, ids);
    std::vector<Row> points;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const double* x = mesh->GetPoint(ids->GetId(i));
      points.emplace_back(x, x + 3);
      Append(mesh->GetPointData(), ids->GetId(i), points.back());
    }
    if (mesh->GetCellType(cell) == VTK_POLYHEDRON) // in the order of their ids
    {
      std::sort(points.begin(), points.end());
    }
    for (const Row& point : points)
    {
      row.insert(row.end(), point.begin(), point.end());
    }
    row.push_back(mesh->GetCell(cell)->GetNumberOfFaces());
    Append(mesh->GetCellData(), cell, row);
    rows.insert(row);
  }
  return rows;
}

vtkSmartPointer<vtkDataSet> Sent(vtkDataSet* mesh)
{
  vtkNew<vtkCharArray> message;
  vtkCommunicator::MarshalDataObject(SkdPack(mesh), message);
  vtkNew<vtkTable> received;
  vtkCommunicator::UnMarshalDataObject(message, received);
  return SkdUnpack(received);
}

//------------------------------------------------------------------------------
class Packed : public testing::TestWithParam<NamedMesh>
{
};

TEST_P(Packed, IsTheSameMesh)
{
  const auto mesh = WithData(GetParam().Make());
  mesh->GetCellData()->SetActiveScalars("Number");
  const auto sent = Sent(mesh);
  EXPECT_EQ(sent->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  EXPECT_EQ(CellsOf(sent), CellsOf(mesh));
  EXPECT_EQ(sent->GetCellData()->GetScalars()->GetName(), std::string("Number"));
}

INSTANTIATE_TEST_SUITE_P(
  Meshes, Packed, testing::ValuesIn(AllMeshes()), [](const auto& info) { return info.param.Name; });

TEST(PackedMesh, KeepsWhatLegacyFilesRound)
{
  const auto image = MakeRotatedImage(3);
  image->SetOrigin(1.0 / 3.0, 1e10 / 7.0, -2.0 / 3.0);
  image->SetSpacing(0.1, 1.0 / 7.0, 1.0 / 3.0);
  auto* sent = vtkImageData::SafeDownCast(Sent(image));
  ASSERT_NE(sent, nullptr);
  const auto kept = Sent(image);
  EXPECT_EQ(CellsOf(kept), CellsOf(image));

  const auto grid = MakeGrid(Hexahedra(1));
  const auto weights = MakeArray("Weights", 8, [](vtkIdType i) { return 1.0 / (3.0 + i); });
  grid->GetPointData()->SetRationalWeights(weights);
  const auto curved = Sent(grid);
  ASSERT_NE(curved->GetPointData()->GetRationalWeights(), nullptr);
  EXPECT_EQ(curved->GetPointData()->GetRationalWeights()->GetTuple1(7), 0.1);
}

//------------------------------------------------------------------------------
class Join : public testing::TestWithParam<PieceCase>
{
protected:
  vtkSmartPointer<vtkDataSet> Make(const Mesh& mesh) const { return GetParam().Make(mesh); }

  const Mesh Whole = Compact(GetParam().Whole);

  void ExpectWhole(const Pieces& pieces) const
  {
    const SkdJoinedPieces joined = SkdJoinPieces(pieces);
    const auto whole = this->Make(this->Whole);
    EXPECT_EQ(joined.Mesh->GetDataObjectType(), whole->GetDataObjectType());
    EXPECT_EQ(joined.Mesh->GetNumberOfPoints(), whole->GetNumberOfPoints());
    EXPECT_EQ(CellsOf(joined.Mesh), CellsOf(whole));
    ASSERT_EQ(static_cast<vtkIdType>(joined.Origins.size()), whole->GetNumberOfCells());
    for (std::size_t cell = 0; cell < joined.Origins.size(); ++cell)
    {
      const SkdPieceCell& origin = joined.Origins[cell];
      double a[6];
      double b[6];
      joined.Mesh->GetCellBounds(static_cast<vtkIdType>(cell), a);
      pieces[static_cast<std::size_t>(origin.Piece)]->GetCellBounds(origin.CellId, b);
      EXPECT_TRUE(std::equal(a, a + 6, b)) << cell;
    }
  }
};

TEST_P(Join, OwnedByOneEach)
{
  for (int processes : { 1, 2, 3, 5 })
  {
    const std::vector<int> owners = RandomOwners(this->Whole, processes, processes);
    Pieces pieces;
    for (int process = 0; process < processes; ++process)
    {
      pieces.push_back(this->Make(
        Compact(Part(this->Whole, [&](std::size_t cell) { return owners[cell] == process; }))));
    }
    this->ExpectWhole(pieces);
  }
}

TEST_P(Join, EverywhereAndNowhere)
{
  this->ExpectWhole({ this->Make(this->Whole), this->Make(this->Whole) });
  this->ExpectWhole({ this->Make(Mesh()), this->Make(this->Whole), this->Make(Mesh()) });
  const vtkSmartPointer<vtkDataSet> none = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->ExpectWhole({ none, this->Make(this->Whole) });
}

// Every process also has cells of others, marked as ghosts or not.
TEST_P(Join, CellsOfOthers)
{
  for (const bool areMarked : { false, true })
  {
    const std::vector<int> owners = RandomOwners(this->Whole, 3, 11);
    Pieces pieces;
    for (int process = 0; process < 3; ++process)
    {
      Random random(process);
      std::vector<std::size_t> chosen;
      const Mesh part = Compact(Part(this->Whole,
        [&](std::size_t cell)
        {
          const bool isChosen = owners[cell] == process || random.Between(0.0, 1.0) < 0.4;
          if (isChosen)
          {
            chosen.push_back(cell);
          }
          return isChosen;
        }));
      const auto piece = this->Make(part);
      if (areMarked && !GetParam().IsSurface) // cells of surfaces are ordered by kind
      {
        vtkNew<vtkUnsignedCharArray> ghosts;
        ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
        for (const std::size_t cell : chosen)
        {
          ghosts->InsertNextValue(
            owners[cell] == process ? 0 : vtkDataSetAttributes::DUPLICATECELL);
        }
        piece->GetCellData()->AddArray(ghosts);
      }
      pieces.push_back(piece);
    }
    if (!areMarked)
    {
      this->ExpectWhole(pieces);
    }
    else if (!GetParam().IsSurface)
    {
      const SkdJoinedPieces joined = SkdJoinPieces(pieces);
      joined.Mesh->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      EXPECT_EQ(CellsOf(joined.Mesh), CellsOf(this->Make(this->Whole)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Meshes, Join, testing::ValuesIn(PieceCases()), [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
// By global ids: cells in their order, points that coincide stay apart.
TEST(JoinedPieces, GlobalIdsDecide)
{
  const Mesh whole = Together({ Hexahedra(1), Transformed(Hexahedra(1), 1.0, { 1.0, 0.0, 0.0 }) });
  Pieces pieces;
  for (const vtkIdType cell : { 1, 0 })
  {
    const auto piece = MakeGrid(
      Compact(Part(whole, [cell](std::size_t id) { return static_cast<vtkIdType>(id) == cell; })));
    const auto pointIds =
      MakeArray<vtkIdTypeArray>("PointIds", 8, [cell](vtkIdType i) { return 8.0 * cell + i; });
    const auto cellIds =
      MakeArray<vtkIdTypeArray>("CellIds", 1, [cell](vtkIdType) { return double(cell); });
    piece->GetPointData()->SetGlobalIds(pointIds);
    piece->GetCellData()->SetGlobalIds(cellIds);
    pieces.push_back(piece);
  }
  const SkdJoinedPieces joined = SkdJoinPieces(pieces);
  EXPECT_EQ(joined.Mesh->GetNumberOfPoints(), 16);
  ASSERT_EQ(joined.Mesh->GetNumberOfCells(), 2);
  EXPECT_EQ(joined.Origins[0].Piece, 1);
  for (vtkDataSet* piece : pieces)
  {
    piece->GetPointData()->SetGlobalIds(nullptr);
  }
  EXPECT_EQ(SkdJoinPieces(pieces).Mesh->GetNumberOfPoints(), 12);
}

// Points of one piece are not merged: both sides of a crack keep their own.
TEST(JoinedPieces, PointsOfOnePieceStayApart)
{
  const Mesh crack = Together({ Hexahedra(1), Transformed(Hexahedra(1), 1.0, { 1.0, 0.0, 0.0 }) });
  const Mesh beside = Transformed(Hexahedra(1), 1.0, { 0.0, 5.0, 0.0 });
  EXPECT_EQ(SkdJoinPieces({ MakeGrid(crack), MakeGrid(beside) }).Mesh->GetNumberOfPoints(), 24);
  EXPECT_EQ(SkdJoinPieces({ MakeGrid(crack), MakeGrid(crack) }).Mesh->GetNumberOfPoints(), 16);
}

TEST(JoinedPieces, PointsThatDifferByRounding)
{
  const Mesh left = Transformed(Hexahedra(1), 0.1, { 0.7, 0.3, 0.1 });
  Mesh right = Transformed(Hexahedra(1), 0.1, { 0.8, 0.3, 0.1 });
  right.Map(
    [](const Point& p) {
      return Point{ { std::nextafter(p[0], 0.0), std::nextafter(p[1], 1.0), p[2] } };
    });
  const SkdJoinedPieces joined = SkdJoinPieces({ MakeGrid(left), MakeGrid(right) });
  EXPECT_EQ(joined.Mesh->GetNumberOfPoints(), 12);
}

// What a piece knows of a point of ghost cells alone is not complete, whether it is marked or not.
TEST(JoinedPieces, DataOfPointsOfGhostCells)
{
  const Mesh whole =
    Compact(Together({ Hexahedra(1), Transformed(Hexahedra(1), 1.0, { 1.0, 0.0, 0.0 }) }));
  Pieces pieces;
  for (const vtkIdType own : { 1, 0 })
  {
    const auto piece = MakeGrid(whole);
    piece->GetPointData()->AddArray(MakeArray("Owner", piece->GetNumberOfPoints(),
      [&](vtkIdType point) { return point / 8 == own ? double(own) : -1.0; }));
    piece->AllocateCellGhostArray()->SetValue(1 - own, vtkDataSetAttributes::DUPLICATECELL);
    pieces.push_back(piece);
  }
  const auto mesh = SkdJoinPieces(pieces).Mesh;
  ASSERT_EQ(mesh->GetNumberOfPoints(), 16);
  for (vtkIdType point = 0; point < 16; ++point)
  {
    const double owner = mesh->GetPointData()->GetArray("Owner")->GetTuple1(point);
    EXPECT_EQ(owner, point < 8 ? 0.0 : 1.0) << point;
  }
}

// What is near is relative to usual coordinates.
TEST(JoinedPieces, PointsFarAwayMergeNoOthers)
{
  const Mesh left = Transformed(Hexahedra(1), 0.1, { 0.7, 0.3, 0.1 });
  const Mesh right = Transformed(Hexahedra(1), 0.1, { 0.8, 0.3, 0.1 });
  const std::size_t far = right.Points.size() - 1; // left has the first of each pair
  for (const double x : { std::numeric_limits<double>::infinity(), 1e60, std::nan(""), 1e20 })
  {
    Mesh moved = right;
    moved.Points[far] = { { x, 0.0, 0.0 } };
    const Pieces pieces{ MakeGrid(left), MakeGrid(moved) };
    EXPECT_EQ(SkdJoinPieces(pieces).Mesh->GetNumberOfPoints(), 12) << x;
  }
}

// Far away it is relative to their own coordinates, near the origin to those of most points.
TEST(JoinedPieces, PointsThatDifferByTheirOwnRounding)
{
  const Mesh cells = Hexahedra(4);
  const auto numberWith = [&](const Point& a, const Point& b)
  {
    Pieces pieces;
    for (const Point& x : { a, b })
    {
      pieces.push_back(MakeGrid(cells));
      vtkUnstructuredGrid::SafeDownCast(pieces.back())->GetPoints()->SetPoint(0, x.data());
    }
    return SkdJoinPieces(pieces).Mesh->GetNumberOfPoints();
  };
  const auto number = static_cast<vtkIdType>(cells.Points.size());
  EXPECT_EQ(
    numberWith({ { 1e20, 3.0, 0.0 } }, { { std::nextafter(1e20, 0.0), 3.0, 0.0 } }), number);
  EXPECT_EQ(numberWith({ { 1e20, 3.0, 0.0 } }, { { 1.0001e20, 3.0, 0.0 } }), number + 1);
  EXPECT_EQ(numberWith({ { 0.0, 0.0, 0.0 } }, { { 0.0, 1e-16, -2e-16 } }), number);
  EXPECT_EQ(numberWith({ { 0.0, 0.0, 0.0 } }, { { 0.0, 1e-9, 0.0 } }), number + 1);
}

//------------------------------------------------------------------------------
template <class Grid>
void ExpectWholeGrid(vtkSmartPointer<Grid> grid)
{
  WithData(grid);
  for (int ghosts : { 0, 1 })
  {
    Pieces pieces = PiecesOfGrid(grid, ghosts);
    const SkdJoinedPieces joined = SkdJoinPieces(pieces);
    EXPECT_EQ(joined.Mesh->GetDataObjectType(), grid->GetDataObjectType());
    EXPECT_EQ(CellsOf(joined.Mesh), CellsOf(grid));
    EXPECT_EQ(joined.Mesh->GetNumberOfPoints(), grid->GetNumberOfPoints());
    pieces.pop_back(); // a grid with a hole is none
    EXPECT_EQ(SkdJoinPieces(pieces).Mesh->GetDataObjectType(), VTK_UNSTRUCTURED_GRID);
  }
}

TEST(JoinedPieces, Grids)
{
  ExpectWholeGrid(MakeRotatedImage(5));
  ExpectWholeGrid(MakeRectilinear(5));
  ExpectWholeGrid(MakeStructured(5));
}

}
