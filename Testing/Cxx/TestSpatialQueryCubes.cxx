// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeSpatialQuery on unit cubes, of whatever type of cell: there every relation to every
// shape is known by intervals. Shapes have coordinates of halves, so many only touch.

#include "Support/CubeReference.h"
#include "Support/StructuredMeshes.h"
#include "Support/TestAmount.h"

#include "vtkTransform.h"

#include <gtest/gtest.h>

using namespace skdtest;

namespace
{

constexpr int N = 4;

Bounds CubeAt(vtkIdType cell)
{
  const double i = static_cast<double>(cell % N);
  const double j = static_cast<double>(cell / N % N);
  const double k = static_cast<double>(cell / N / N);
  return { i, i + 1, j, j + 1, k, k + 1 };
}

//------------------------------------------------------------------------------
/// How the cubes are stored, and whether all is turned and moved.
struct Setting
{
  const char* Name;
  std::function<DataSetPointer()> Make;
  bool IsReversed;
  int Queries; ///< less of what takes long

  friend void PrintTo(const Setting& setting, std::ostream* os) { *os << setting.Name; }
};

constexpr double Angles[3] = { 20.0, 35.0, 50.0 };

vtkSmartPointer<vtkTransform> Motion()
{
  auto motion = vtkSmartPointer<vtkTransform>::New();
  motion->Translate(3.0, -7.0, 11.0);
  motion->RotateZ(Angles[2]);
  motion->RotateX(Angles[0]);
  motion->RotateY(Angles[1]);
  return motion;
}

DataSetPointer MakeCubes(const Mesh& mesh, bool isTurned)
{
  GridPointer grid = MakeGrid(mesh);
  if (isTurned)
  {
    vtkNew<vtkPoints> moved;
    moved->SetDataTypeToDouble();
    Motion()->TransformPoints(grid->GetPoints(), moved);
    grid->SetPoints(moved);
  }
  return grid;
}

/// Each cube with 27 or 8 points as a curved cell that is straight, or a set of points.
Mesh CubesOfType(int type)
{
  Mesh cubes = Hexahedra(N);
  for (CellSpec& cell : cubes.Cells)
  {
    cell.Type = type;
  }
  return cubes;
}

Mesh TriquadraticCubes()
{
  Mesh mesh;
  for (vtkIdType cell = 0; cell < N * N * N; ++cell)
  {
    const Bounds box = CubeAt(cell);
    Ids ids;
    static constexpr int positions[27][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
      { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 },
      { 0, 1, 0 }, { 1, 0, 2 }, { 2, 1, 2 }, { 1, 2, 2 }, { 0, 1, 2 }, { 0, 0, 1 }, { 2, 0, 1 },
      { 2, 2, 1 }, { 0, 2, 1 }, { 0, 1, 1 }, { 2, 1, 1 }, { 1, 0, 1 }, { 1, 2, 1 }, { 1, 1, 0 },
      { 1, 1, 2 }, { 1, 1, 1 } };
    for (const auto& position : positions)
    {
      ids.push_back(mesh.Add(
        { box[0] + 0.5 * position[0], box[2] + 0.5 * position[1], box[4] + 0.5 * position[2] }));
    }
    mesh.Add(VTK_TRIQUADRATIC_HEXAHEDRON, ids);
  }
  return Welded(mesh);
}

DataSetPointer CubesAsImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(N + 1, N + 1, N + 1);
  return image;
}

std::vector<Setting> Settings()
{
  std::vector<Setting> settings = { { "Image", CubesAsImage, false, 12 } };
  const auto add = [&](const char* name, const char* rotated, const Mesh& mesh, int queries)
  {
    settings.push_back({ name, [mesh]() { return MakeCubes(mesh, false); }, false, queries });
    settings.push_back({ rotated, [mesh]() { return MakeCubes(mesh, true); }, true, queries });
  };
  add("Voxels", "TurnedVoxels", Voxels(N), 12);
  add("Hexahedra", "TurnedHexahedra", Hexahedra(N), 12);
  add("Inverted", "TurnedInverted", InvertedHexahedra(N), 12);
  add("Polyhedra", "TurnedPolyhedra", Polyhedra(N), 12);
  add("ConvexPointSets", "TurnedConvexPointSets", CubesOfType(VTK_CONVEX_POINT_SET), 3);
  add("Triquadratic", "TurnedTriquadratic", TriquadraticCubes(), 2);
  return settings;
}

//------------------------------------------------------------------------------
double HalfIn(Random& random, int low, int high)
{
  return 0.5 * (2 * low + random.Index(2 * (high - low) + 1));
}

Point HalfPoint(Random& random)
{
  return { HalfIn(random, -1, N + 1), HalfIn(random, -1, N + 1), HalfIn(random, -1, N + 1) };
}

CubeQuery RandomQuery(int shape, Random& random)
{
  CubeQuery query;
  query.Shape = shape;
  query.Center = HalfPoint(random);
  query.A = HalfPoint(random);
  query.B = random.Index(6) == 0 ? query.A : HalfPoint(random);
  query.Radius = 0.5 * random.Index(6);
  do
  {
    query.Normal = { double(random.Index(5) - 2), double(random.Index(5) - 2),
      double(random.Index(5) - 2) };
  } while (Length(query.Normal) == 0.0);
  query.Box = EmptyBounds();
  Extend(query.Box, HalfPoint(random));
  const Point other = HalfPoint(random);
  for (int axis = 0; axis < 3 && shape == SpatialQuery::BOX; ++axis)
  {
    if (random.Index(4) > 0) // else flat
    {
      query.Box[2 * axis + 1] = std::max(other[axis], query.Box[2 * axis]);
      query.Box[2 * axis] = std::min(other[axis], query.Box[2 * axis]);
    }
  }
  return query;
}

class Cubes : public testing::TestWithParam<Setting>
{
protected:
  void SetUp() override
  {
    this->Input = GetParam().Make();
    this->IsReversed = GetParam().IsReversed;
  }

  Point Position(Point x, bool isDirection = false) const
  {
    if (this->IsReversed)
    {
      isDirection ? Motion()->TransformVector(x.data(), x.data())
                  : Motion()->TransformPoint(x.data(), x.data());
    }
    return x;
  }

  QueryPointer Make(const CubeQuery& requested, int relation) const
  {
    QueryPointer query = MakeQuery(this->Input, relation);
    query->SetTolerance(this->IsReversed ? 1e-9 : 0.0); // where they touch rounding is not known
    switch (requested.Shape)
    {
      case SpatialQuery::BOX:
        SetBox(query, requested.Box);
        query->SetBoxPosition(this->Position(CornerOf(requested.Box, 0)).data());
        query->SetBoxRotation(this->IsReversed ? Angles[0] : 0.0,
          this->IsReversed ? Angles[1] : 0.0, this->IsReversed ? Angles[2] : 0.0);
        break;
      case SpatialQuery::SPHERE:
        SetSphere(query, this->Position(requested.Center), requested.Radius);
        break;
      case SpatialQuery::PLANE:
        SetPlane(query, this->Position(requested.Center), this->Position(requested.Normal, true));
        break;
      case SpatialQuery::LINE:
        SetLine(query, this->Position(requested.A), this->Position(requested.B));
        break;
      default:
        query->SetShape(SpatialQuery::SOURCE_POINTS);
        query->SetSourceData(MakeQueries({ this->Position(CornerOf(requested.Box, 0)) }));
    }
    return query;
  }

  void CheckRelated(const CubeQuery& requested, int relation) const
  {
    QueryPointer query = this->Make(requested, relation);
    const std::vector<PairRow> rows = RunQuery(query);
    Ids found, expected;
    for (const PairRow& row : rows)
    {
      found.push_back(row.Cell);
      this->CheckDistances(requested, row);
    }
    for (vtkIdType cell = 0; cell < N * N * N; ++cell)
    {
      if (CubeReference(CubeAt(cell), requested).Is(relation))
      {
        expected.push_back(cell);
      }
    }
    ASSERT_EQ(found, expected);
    query->ExactOff();
    const Ids candidates = CellsFound(query);
    ASSERT_TRUE(
      std::includes(candidates.begin(), candidates.end(), expected.begin(), expected.end()));
  }

  void CheckDistances(const CubeQuery& requested, const PairRow& row) const
  {
    const CubeReference reference(CubeAt(row.Cell), requested);
    ASSERT_NEAR(row.Min, reference.Min(), 1e-7);
    ASSERT_NEAR(row.Max, reference.Max(), 1e-7);
    ASSERT_LE(row.Optimistic, row.Min + 1e-12);
    ASSERT_GE(row.Pessimistic, row.Max - 1e-12);
  }

  void CheckNearest(const CubeQuery& requested, int number) const
  {
    QueryPointer query = this->Make(requested, SpatialQuery::NEAREST);
    query->SetNumberOfNearestCells(number);
    std::vector<std::pair<double, vtkIdType>> expected;
    for (vtkIdType cell = 0; cell < N * N * N; ++cell)
    {
      const double distance = CubeReference(CubeAt(cell), requested).Min();
      expected.push_back({ distance < 1e-9 ? 0.0 : distance, cell });
    }
    std::sort(expected.begin(), expected.end());
    const double limit = expected[std::min<std::size_t>(expected.size(), number) - 1].first + 1e-9;
    Ids asNear;
    for (const auto& [distance, cell] : expected)
    {
      if (distance <= limit)
      {
        asNear.push_back(cell);
      }
    }
    std::sort(asNear.begin(), asNear.end());
    query->AllTiesOn();
    Ids told = CellsFound(query);
    std::sort(told.begin(), told.end());
    ASSERT_EQ(told, asNear);
    query->AllTiesOff();
    expected.resize(std::min<std::size_t>(expected.size(), number));
    const std::vector<PairRow> rows = RunQuery(query);
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      ASSERT_NEAR(rows[i].Min, expected[i].first, 1e-7);
      this->CheckDistances(requested, rows[i]);
      // Where distances are exact so are ties.
      const bool areTiesKnown = rows[i].Min == 0.0 ||
        (!this->IsReversed && requested.Shape != SpatialQuery::LINE &&
          requested.Shape != SpatialQuery::PLANE);
      if (areTiesKnown)
      {
        ASSERT_EQ(rows[i].Cell, expected[i].second);
      }
    }
    query->ExactOff();
    Ids candidates = CellsFound(query);
    std::sort(candidates.begin(), candidates.end());
    for (const PairRow& row : rows)
    {
      ASSERT_TRUE(std::binary_search(candidates.begin(), candidates.end(), row.Cell));
    }
  }

  DataSetPointer Input;
  bool IsReversed = false;
};

INSTANTIATE_TEST_SUITE_P(All, Cubes, testing::ValuesIn(Settings()),
  [](const auto& info) { return std::string(info.param.Name); });

TEST_P(Cubes, RelationsToShapesAreThoseOfIntervals)
{
  Random random(17);
  for (int shape = SpatialQuery::BOX; shape <= SpatialQuery::SOURCE_POINTS; ++shape)
  {
    for (int i = 0; i < Amount(GetParam().Queries); ++i)
    {
      const CubeQuery requested = RandomQuery(shape, random);
      for (int relation = SpatialQuery::EXACT_MATCH; relation <= SpatialQuery::ADJACENCY;
           ++relation)
      {
        SCOPED_TRACE(
          std::string(RelationNames[relation]) + " " + ShapeNames[shape] + " " + std::to_string(i));
        ASSERT_NO_FATAL_FAILURE(this->CheckRelated(requested, relation));
      }
    }
  }
}

TEST_P(Cubes, NearestAreThoseOfIntervalsTiesToTheLowest)
{
  Random random(18);
  for (int shape = SpatialQuery::BOX; shape <= SpatialQuery::SOURCE_POINTS; ++shape)
  {
    for (int i = 0; i < Amount(GetParam().Queries); ++i)
    {
      const CubeQuery requested = RandomQuery(shape, random);
      for (int number : { 1, 3, 20, N * N * N, 1000 })
      {
        SCOPED_TRACE(
          std::string(ShapeNames[shape]) + " " + std::to_string(i) + " " + std::to_string(number));
        ASSERT_NO_FATAL_FAILURE(this->CheckNearest(requested, number));
      }
    }
  }
}

TEST_P(Cubes, TheBoxOfACellMatchesThatCellAlone)
{
  for (vtkIdType cell = 0; cell < N * N * N; cell += 7)
  {
    CubeQuery requested;
    requested.Box = CubeAt(cell);
    EXPECT_EQ(CellsFound(this->Make(requested, SpatialQuery::EXACT_MATCH)), Ids{ cell });
  }
}

//------------------------------------------------------------------------------
/// Cubes of another size and place, as hexahedra.
Mesh OtherCubes(double size, const Point& offset)
{
  return Transformed(Hexahedra(N), size, offset);
}

Bounds OtherCubeAt(vtkIdType cell, double size, const Point& offset)
{
  Bounds box = CubeAt(cell);
  for (int side = 0; side < 6; ++side)
  {
    box[side] = size * box[side] + offset[side / 2];
  }
  return box;
}

TEST_P(Cubes, RelationsToCellsAreThoseOfIntervals)
{
  const struct
  {
    double Size;
    Point Offset;
  } others[] = { { 1, { 0, 0, 0 } }, { 0.5, { 1, 1, 1 } }, { 2, { -1, 0, 1 } },
    { 1, { 0.5, 0, 0.25 } } };
  for (const auto& other : others)
  {
    if (GetParam().Queries < 12 && other.Size != 2)
    {
      continue;
    }
    for (const int relation : { SpatialQuery::EXACT_MATCH, SpatialQuery::OVERLAP,
           SpatialQuery::ENCLOSURE, SpatialQuery::CONTAINMENT })
    {
      SCOPED_TRACE(std::string(RelationNames[relation]) + " " + std::to_string(other.Size));
      QueryPointer query = MakeQuery(this->Input, relation);
      query->SetTolerance(this->IsReversed ? 1e-9 : 0.0);
      query->SetShape(SpatialQuery::SOURCE_CELLS);
      query->SetSourceData(MakeCubes(OtherCubes(other.Size, other.Offset), this->IsReversed));
      std::vector<std::pair<vtkIdType, vtkIdType>> expected, found;
      for (vtkIdType i = 0; i < N * N * N; ++i)
      {
        CubeQuery requested;
        requested.Box = OtherCubeAt(i, other.Size, other.Offset);
        for (vtkIdType cell = 0; cell < N * N * N; ++cell)
        {
          if (CubeReference(CubeAt(cell), requested).Is(relation))
          {
            expected.push_back({ i, cell });
          }
        }
      }
      for (const PairRow& row : RunQuery(query))
      {
        found.push_back({ row.Query, row.Cell });
        CubeQuery requested;
        requested.Box = OtherCubeAt(row.Query, other.Size, other.Offset);
        ASSERT_NO_FATAL_FAILURE(this->CheckDistances(requested, row));
      }
      ASSERT_EQ(found, expected);
    }
  }
}

TEST_P(Cubes, NeighboursOfCellsShareAPointAnEdgeOrAFace)
{
  for (const int part : { SpatialQuery::POINT, SpatialQuery::EDGE, SpatialQuery::FACE })
  {
    QueryPointer query = MakeQuery(this->Input, SpatialQuery::ADJACENCY);
    query->SetTolerance(1e-9);
    query->SetShape(SpatialQuery::SOURCE_CELLS);
    query->SetSourceData(this->Input);
    query->SetSharedPart(part);
    std::vector<std::pair<vtkIdType, vtkIdType>> expected, found;
    for (vtkIdType i = 0; i < N * N * N; ++i)
    {
      for (vtkIdType k = 0; k < N * N * N; ++k)
      {
        int steps = 0, farthest = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
          const int step = static_cast<int>(std::abs(CubeAt(i)[2 * axis] - CubeAt(k)[2 * axis]));
          steps += step;
          farthest = std::max(farthest, step);
        }
        if (farthest == 1 && steps <= 3 - part)
        {
          expected.push_back({ i, k });
        }
      }
    }
    for (const PairRow& row : RunQuery(query))
    {
      found.push_back({ row.Query, row.Cell });
      EXPECT_EQ(row.Min, 0.0);
    }
    ASSERT_EQ(found, expected) << part;
  }
}

TEST_P(Cubes, NearestCellsOfCells)
{
  QueryPointer query = MakeQuery(this->Input, SpatialQuery::NEAREST);
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(MakeCubes(OtherCubes(0.25, { 6, 1.125, 1.125 }), this->IsReversed));
  query->SetNumberOfNearestCells(2);
  const std::vector<PairRow> rows = RunQuery(query);
  ASSERT_EQ(rows.size(), 2u * N * N * N);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i].Query, static_cast<vtkIdType>(i / 2));
    CubeQuery requested;
    requested.Box = OtherCubeAt(rows[i].Query, 0.25, { 6, 1.125, 1.125 });
    ASSERT_NO_FATAL_FAILURE(this->CheckDistances(requested, rows[i]));
    EXPECT_LE(rows[i].Min, 2.0 + requested.Box[0] - 6.0 + 1.0);
  }
}

}
