// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The ids that cells and points of pieces have in the joined mesh, found by exchange: those of the
// mesh that one process joins. Threads take the part of processes.

#include "Support/MeshPieces.h"
#include "Support/ThreadTransport.h"

#include "Exchange/SkdJoinedPieces.h"
#include "Exchange/SkdPieceNumbers.h"

#include "vtkIdTypeArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

using namespace skdtest;
using namespace skdtree;

namespace
{
std::vector<SkdPieceNumbers> NumbersOf(const Pieces& pieces)
{
  std::vector<SkdPieceNumbers> numbers(pieces.size());
  ThreadTransport::RunAll(static_cast<int>(pieces.size()),
    [&](SkdTransport& transport)
    {
      const auto rank = static_cast<std::size_t>(transport.GetRank());
      const SkdAllFacts facts(transport, pieces[rank]);
      numbers[rank] = SkdNumberPiece(transport, pieces[rank], facts);
    });
  return numbers;
}

void ExpectSamePoint(vtkDataSet* a, vtkIdType inA, vtkDataSet* b, vtkIdType inB)
{
  double x[3];
  a->GetPoint(inA, x);
  double y[3];
  b->GetPoint(inB, y);
  EXPECT_TRUE(std::equal(x, x + 3, y)) << inA << " " << inB;
}

/// The cells of a piece with joined points: equal to those of the joined mesh.
void ExpectCells(vtkDataSet* piece, const SkdPieceNumbers& numbers, vtkDataSet* joined)
{
  vtkNew<vtkIdList> own;
  vtkNew<vtkIdList> whole;
  for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell)
  {
    const vtkIdType id = numbers.CellIds[static_cast<std::size_t>(cell)];
    if (id >= 0)
    {
      piece->GetCellPoints(cell, own);
      joined->GetCellPoints(id, whole);
      std::vector<vtkIdType> ids;
      for (const vtkIdType point : *own)
      {
        ids.push_back(numbers.PointIds[static_cast<std::size_t>(point)]);
      }
      std::vector<vtkIdType> expected(whole->begin(), whole->end());
      if (piece->GetCellType(cell) == VTK_POLYHEDRON)
      {
        std::sort(ids.begin(), ids.end());
        std::sort(expected.begin(), expected.end());
      }
      EXPECT_EQ(ids, expected) << cell;
    }
  }
}

constexpr double OfOnePiece = 1e6;

/// Numbers points so that the joined mesh tells where each has its data from.
void AddOrigins(const Pieces& pieces)
{
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    pieces[piece]->GetPointData()->AddArray(MakeArray("Origin", pieces[piece]->GetNumberOfPoints(),
      [piece](vtkIdType point) { return OfOnePiece * double(piece) + double(point); }));
  }
}

void ExpectNumbersOfJoined(const Pieces& pieces)
{
  AddOrigins(pieces);
  const SkdJoinedPieces joined = SkdJoinPieces(pieces);
  const std::vector<SkdPieceNumbers> numbers = NumbersOf(pieces);
  std::set<vtkIdType> found;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    const SkdPieceNumbers& own = numbers[piece];
    ASSERT_EQ(own.NumberOfCells, joined.Mesh->GetNumberOfCells());
    ASSERT_EQ(own.NumberOfPoints, joined.Mesh->GetNumberOfPoints());
    ASSERT_EQ(static_cast<vtkIdType>(own.CellIds.size()), pieces[piece]->GetNumberOfCells());
    for (std::size_t cell = 0; cell < own.CellIds.size(); ++cell)
    {
      if (own.CellIds[cell] >= 0)
      {
        EXPECT_TRUE(found.insert(own.CellIds[cell]).second);
        const SkdPieceCell& origin = joined.Origins[static_cast<std::size_t>(own.CellIds[cell])];
        EXPECT_EQ(origin.Piece, static_cast<int>(piece));
        EXPECT_EQ(origin.CellId, static_cast<vtkIdType>(cell));
      }
    }
    for (std::size_t point = 0; point < own.PointIds.size(); ++point)
    {
      const SkdPointOrigin& origin = own.PointOrigins[point];
      EXPECT_EQ(origin.Process < 0, own.PointIds[point] < 0);
      if (origin.Process >= 0)
      {
        ExpectSamePoint(joined.Mesh, own.PointIds[point],
          pieces[static_cast<std::size_t>(origin.Process)], origin.Point);
        EXPECT_EQ(joined.Mesh->GetPointData()->GetArray("Origin")->GetTuple1(own.PointIds[point]),
          OfOnePiece * origin.Process + double(origin.Point));
      }
    }
    ExpectCells(pieces[piece], own, joined.Mesh);
  }
  EXPECT_EQ(static_cast<vtkIdType>(found.size()), joined.Mesh->GetNumberOfCells());
}

//------------------------------------------------------------------------------
class PieceNumbers : public testing::TestWithParam<PieceCase>
{
protected:
  const Mesh Whole = Compact(GetParam().Whole);

  enum class Marks
  {
    None,
    Cells,
    CellsAndPoints
  };

  /// A process's cells, and some of others, marked or not.
  vtkSmartPointer<vtkDataSet> PieceOf(
    int process, const std::vector<int>& owners, double share, Marks marks) const
  {
    Random random(process);
    std::vector<bool> areOwn;
    const Mesh part = Compact(Part(this->Whole,
      [&](std::size_t cell)
      {
        const bool isOwn = owners[cell] == process;
        const bool isChosen = isOwn || random.Between(0.0, 1.0) < share;
        if (isChosen)
        {
          areOwn.push_back(isOwn);
        }
        return isChosen;
      }));
    auto piece = GetParam().Make(part);
    if (marks != Marks::None)
    {
      AddMarks(piece, areOwn, marks);
    }
    return piece;
  }

  static void AddMarks(vtkDataSet* piece, const std::vector<bool>& areOwn, Marks marks)
  {
    vtkNew<vtkUnsignedCharArray> cells;
    vtkNew<vtkUnsignedCharArray> points;
    for (vtkUnsignedCharArray* array : { cells.Get(), points.Get() })
    {
      array->SetName(vtkDataSetAttributes::GhostArrayName());
    }
    for (const bool isOwn : areOwn)
    {
      cells->InsertNextValue(isOwn ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
    Random random(5);
    for (vtkIdType point = 0; point < piece->GetNumberOfPoints(); ++point)
    {
      points->InsertNextValue(
        random.Between(0.0, 1.0) < 0.3 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
    }
    piece->GetCellData()->AddArray(cells);
    if (marks == Marks::CellsAndPoints)
    {
      piece->GetPointData()->AddArray(points);
    }
  }

  void ExpectRandom(int processes, double share, Marks marks) const
  {
    const std::vector<int> owners = RandomOwners(this->Whole, processes, processes);
    Pieces pieces;
    for (int process = 0; process < processes; ++process)
    {
      pieces.push_back(this->PieceOf(process, owners, share, marks));
    }
    ExpectNumbersOfJoined(pieces);
  }
};

TEST_P(PieceNumbers, OwnedByOneEach)
{
  for (int processes : { 1, 2, 3, 7 })
  {
    this->ExpectRandom(processes, 0.0, Marks::None);
  }
}

TEST_P(PieceNumbers, CellsOfOthers)
{
  this->ExpectRandom(3, 0.4, Marks::None);
  if (!GetParam().IsSurface) // cells of surfaces are ordered by kind
  {
    this->ExpectRandom(3, 0.4, Marks::Cells);
    this->ExpectRandom(4, 0.4, Marks::CellsAndPoints);
  }
}

TEST_P(PieceNumbers, EverywhereAndNowhere)
{
  const auto whole = [&]() { return GetParam().Make(this->Whole); };
  ExpectNumbersOfJoined({ whole(), whole() });
  const vtkSmartPointer<vtkDataSet> none = vtkSmartPointer<vtkUnstructuredGrid>::New();
  ExpectNumbersOfJoined({ none, whole(), GetParam().Make(Mesh()) });
  ExpectNumbersOfJoined({ none, GetParam().Make(Mesh()) });
}

TEST_P(PieceNumbers, ByGlobalIds)
{
  const std::vector<int> owners = RandomOwners(this->Whole, 3, 2);
  Pieces pieces;
  for (int process = 0; process < 3; ++process)
  {
    const auto piece = this->PieceOf(process, owners, 0.3, Marks::None);
    const auto ids = MakeArray<vtkIdTypeArray>("Ids", piece->GetNumberOfCells(),
      [&](vtkIdType cell)
      {
        double box[6];
        piece->GetCellBounds(cell, box); // the same in all pieces
        return std::floor(1000.0 * (box[0] + 3.0 * box[2] + 7.0 * box[4] + 0.7 * box[1]));
      });
    piece->GetCellData()->SetGlobalIds(ids);
    pieces.push_back(piece);
  }
  ExpectNumbersOfJoined(pieces);
  for (vtkDataSet* piece : pieces)
  {
    const auto ids = MakeArray<vtkIdTypeArray>("PointIds", piece->GetNumberOfPoints(),
      [&](vtkIdType point)
      {
        double x[3];
        piece->GetPoint(point, x);
        return std::floor(5.0 * (x[0] + 3.0 * x[1] - 7.0 * x[2]));
      });
    piece->GetPointData()->SetGlobalIds(ids);
  }
  ExpectNumbersOfJoined(pieces);
}

INSTANTIATE_TEST_SUITE_P(Meshes, PieceNumbers, testing::ValuesIn(PieceCases()),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
// Points of neighbours that were computed with different rounding.
TEST(PieceNumbersNear, PointsThatDifferByRounding)
{
  Random random(3);
  const Mesh whole = Compact(Transformed(Tetrahedra(4), 0.1, { 0.7, 0.3, 100.1 }));
  const std::vector<int> owners = RandomOwners(whole, 4, 9);
  Pieces pieces;
  for (int process = 0; process < 4; ++process)
  {
    Mesh part = Compact(Part(whole, [&](std::size_t cell) { return owners[cell] == process; }));
    part.Map(
      [&](const Point& p)
      {
        Point near = p;
        for (double& x : near)
        {
          x = std::nextafter(x, random.Between(-1e3, 1e3));
        }
        return near;
      });
    pieces.push_back(MakeGrid(part));
  }
  ExpectNumbersOfJoined(pieces);
  EXPECT_EQ(
    SkdJoinPieces(pieces).Mesh->GetNumberOfPoints(), static_cast<vtkIdType>(whole.Points.size()));
}

// One that does not count, or is far away, makes no others near each other.
TEST(PieceNumbersNear, PointsBesideOneFarAway)
{
  for (const double x : { 1e60, 1e20 })
  {
    Pieces pieces;
    for (const double shift : { 0.0, 1.0, 2.0 })
    {
      Mesh part = Transformed(Hexahedra(1), 1.0, { shift, 0.0, 0.0 });
      if (shift == 2.0)
      {
        part.Points.back() = { { x, 0.0, 0.0 } };
      }
      pieces.push_back(MakeGrid(part));
    }
    ExpectNumbersOfJoined(pieces);
    EXPECT_EQ(SkdJoinPieces(pieces).Mesh->GetNumberOfPoints(), 16) << x;
  }
}

// Some points are many powers of two farther than most.
TEST(PieceNumbersNear, PointsThatDifferByTheirOwnRounding)
{
  Random random(7);
  Mesh whole = Compact(Tetrahedra(4));
  for (std::size_t i = 0; i < whole.Points.size(); i += 7)
  {
    const double scale = std::ldexp(1.0, static_cast<int>(i));
    for (double& x : whole.Points[i])
    {
      x = scale * random.Between(-1.0, 1.0);
    }
  }
  const std::vector<int> owners = RandomOwners(whole, 4, 9);
  Pieces pieces;
  for (int process = 0; process < 4; ++process)
  {
    Mesh part = Compact(Part(whole, [&](std::size_t cell) { return owners[cell] == process; }));
    part.Map(
      [&](const Point& p)
      {
        Point near = p;
        for (double& x : near)
        {
          x = std::nextafter(x, random.Between(-1e50, 1e50));
        }
        return near;
      });
    pieces.push_back(MakeGrid(part));
  }
  ExpectNumbersOfJoined(pieces);
  EXPECT_EQ(
    SkdJoinPieces(pieces).Mesh->GetNumberOfPoints(), static_cast<vtkIdType>(whole.Points.size()));
}

//------------------------------------------------------------------------------
// Two columns of cells of one process each, with the global ids of the whole.
Pieces WithGlobalIds()
{
  const Mesh whole = Hexahedra(2);
  Pieces pieces;
  for (int process = 0; process < 2; ++process)
  {
    const auto ownerOf = [](vtkIdType cell) { return static_cast<int>(cell % 2); };
    const Mesh part = Part(
      whole, [&](std::size_t cell) { return ownerOf(static_cast<vtkIdType>(cell)) == process; });
    const auto piece = MakeGrid(Compact(part));
    const auto idOfPoint = [&](vtkIdType point)
    {
      double x[3];
      piece->GetPoint(point, x);
      return x[0] + 10.0 * x[1] + 100.0 * x[2];
    };
    piece->GetPointData()->SetGlobalIds(
      MakeArray<vtkIdTypeArray>("PointIds", piece->GetNumberOfPoints(), idOfPoint));
    piece->GetCellData()->SetGlobalIds(MakeArray<vtkIdTypeArray>(
      "CellIds", 4, [&](vtkIdType cell) { return 2.0 * cell + process; }));
    pieces.push_back(piece);
  }
  return pieces;
}

/// Joined in one process, and found by exchange in each.
void ExpectRepeated(const Pieces& pieces, const std::string& description)
{
  const auto describe = [](const SkdRepeatedId& repeated)
  { return repeated.IsThere ? repeated.Describe() : std::string(); };
  EXPECT_EQ(describe(SkdJoinPieces(pieces).Repeated), description);
  for (const SkdPieceNumbers& numbers : NumbersOf(pieces))
  {
    EXPECT_EQ(describe(numbers.Repeated), description);
  }
}

TEST(PieceNumbersRepeated, GlobalIdsOfTwoCellsOrPoints)
{
  ExpectRepeated(WithGlobalIds(), "");
  const Pieces ofCells = WithGlobalIds();
  ofCells[1]->GetCellData()->GetGlobalIds()->SetTuple1(3, 4.0);
  ExpectRepeated(ofCells, "cell 2 of process 0 and cell 3 of process 1 have the global id 4.");
  const Pieces ofBorder = WithGlobalIds(); // cells all of whose points are shared
  const Pieces doubled{ ofBorder[0], ofBorder[0], ofBorder[1] };
  ExpectRepeated(doubled, "");
  const Pieces ofPoints = WithGlobalIds();
  ofPoints[1]->GetPointData()->GetGlobalIds()->SetTuple1(
    0, ofPoints[0]->GetPointData()->GetGlobalIds()->GetTuple1(5));
  EXPECT_TRUE(SkdJoinPieces(ofPoints).Repeated.IsOfPoints);
  for (const SkdPieceNumbers& numbers : NumbersOf(ofPoints))
  {
    EXPECT_TRUE(numbers.Repeated.IsThere && numbers.Repeated.IsOfPoints);
  }
}

// Cells of several pieces with one id are the same only if their points are.
TEST(PieceNumbersRepeated, CellsOfSharedPoints)
{
  const Pieces pieces = WithGlobalIds();
  const Pieces doubled{ pieces[0], MakeGrid(Compact(Hexahedra(2))) };
  doubled[1]->GetPointData()->SetGlobalIds(nullptr);
  doubled[1]->GetCellData()->SetGlobalIds(
    MakeArray<vtkIdTypeArray>("CellIds", 8, [](vtkIdType cell) { return double(cell); }));
  ExpectRepeated(doubled, "");
  doubled[1]->GetCellData()->GetGlobalIds()->SetTuple1(6, 4.0);
  doubled[1]->GetCellData()->GetGlobalIds()->SetTuple1(4, 6.0);
  ExpectRepeated(doubled, "cell 2 of process 0 and cell 6 of process 1 have the global id 4.");
}

/// Triangles around a point, each with points of its own, as files of triangles have them.
Mesh TrianglesApart(int first, int last)
{
  Mesh mesh;
  const auto around = [](int i) { return Point{ std::cos(i), std::sin(i), 0.1 * i }; };
  for (int i = first; i < last; ++i)
  {
    const vtkIdType center = mesh.Add(Point{ 0.0, 0.0, 0.0 });
    const vtkIdType from = mesh.Add(around(i));
    mesh.Add(VTK_TRIANGLE, { center, from, mesh.Add(around(i + 1)) });
  }
  return mesh;
}

// Pieces that have only some of the cells at a place have as many points there.
TEST(PieceNumbersRepeated, CellsOfPointsOfTheirOwn)
{
  const Pieces pieces{ MakeGrid(TrianglesApart(0, 4)), MakeGrid(TrianglesApart(2, 6)),
    MakeGrid(TrianglesApart(3, 5)) };
  ExpectNumbersOfJoined(pieces);
  EXPECT_EQ(NumbersOf(pieces)[0].NumberOfCells, 6);
}

//------------------------------------------------------------------------------
template <class Grid>
void ExpectNumbersOfGrid(vtkSmartPointer<Grid> grid)
{
  for (int ghosts : { 0, 1 })
  {
    Pieces pieces = PiecesOfGrid(grid, ghosts);
    ExpectNumbersOfJoined(pieces);
    pieces[1]->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::DUPLICATECELL);
    pieces[2]->AllocatePointGhostArray()->SetValue(3, vtkDataSetAttributes::DUPLICATEPOINT);
    ExpectNumbersOfJoined(pieces);
    pieces.pop_back();
    ExpectNumbersOfJoined(pieces);
  }
}

TEST(PieceNumbersGrid, Grids)
{
  ExpectNumbersOfGrid(MakeRotatedImage(5));
  ExpectNumbersOfGrid(MakeRectilinear(5));
  ExpectNumbersOfGrid(MakeStructured(5));
}

/// The most bytes that one of four processes sends.
double MostSent(const Mesh& whole, const std::function<int(std::size_t cell)>& ownerOf)
{
  Pieces pieces;
  for (int process = 0; process < 4; ++process)
  {
    pieces.push_back(
      MakeGrid(Compact(Part(whole, [&](std::size_t cell) { return ownerOf(cell) == process; }))));
  }
  std::vector<std::uint64_t> sent(pieces.size());
  ThreadTransport::RunAll(4,
    [&](SkdTransport& transport)
    {
      const auto rank = static_cast<std::size_t>(transport.GetRank());
      SkdNumberPiece(transport, pieces[rank], SkdAllFacts(transport, pieces[rank]));
      sent[rank] = transport.GetTraffic().Bytes;
    });
  return static_cast<double>(*std::max_element(sent.begin(), sent.end()));
}

// Where pieces have their borders in common alone, processes tell of these alone.
TEST(PieceNumbersTraffic, IsOfBorders)
{
  const Mesh whole = Compact(Tetrahedra(20));
  const std::size_t share = whole.Cells.size() / 4;
  const double ofSlabs = MostSent(whole, [&](std::size_t cell) { return int(cell / share); });
  const double ofAll = MostSent(whole, [](std::size_t cell) { return int(cell % 4); });
  EXPECT_LT(ofSlabs, 0.25 * ofAll);
}

}
