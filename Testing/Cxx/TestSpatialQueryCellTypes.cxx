// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkSkdTreeSpatialQuery on every type of cell that VTK has: points of cells, found by their own
// interpolation functions, and points of shapes must not contradict any answer.

#include "Support/BruteForce.h"
#include "Support/CellZoo.h"
#include "Support/FetchCell.h"
#include "Support/SpatialQueryRun.h"

#include <gtest/gtest.h>

#include <set>

using namespace skdtest;

namespace
{

/// The facets that stand for curved cells are this near to them, for the sizes here.
constexpr double Chord = 0.03;

struct TypeAndOrder
{
  int Type;
  int Order;

  friend void PrintTo(const TypeAndOrder& type, std::ostream* os)
  {
    *os << NameOfType(type.Type) << type.Order;
  }
};

bool IsLinear(int type)
{
  vtkSmartPointer<vtkCell> cell;
  cell.TakeReference(vtkGenericCell::InstantiateCell(type));
  return cell->IsLinear();
}

/// Curved solids are hundreds of facets each: one kind of them can stand for the others.
bool IsStoodFor(int type)
{
  vtkSmartPointer<vtkCell> cell;
  cell.TakeReference(vtkGenericCell::InstantiateCell(type));
  return cell->GetCellDimension() == 3 && !IsLinear(type) && type != VTK_QUADRATIC_TETRA;
}

std::vector<TypeAndOrder> AllTypes()
{
  std::vector<TypeAndOrder> types;
  for (const int type : AllCellTypes())
  {
    if (type != VTK_EMPTY_CELL && !ReferenceCell(type, 2).Cells.empty() &&
      !(FewerTests() && IsStoodFor(type)))
    {
      types.push_back({ type, 2 });
    }
  }
  return types;
}

Point Bulged(const Point& p)
{
  return { p[0] + 0.05 * std::sin(1.3 * p[1]), p[1] + 0.04 * std::cos(1.1 * p[2]), p[2] };
}

class SpatialQueryOnType : public testing::TestWithParam<TypeAndOrder>
{
protected:
  void SetUp() override
  {
    const Mesh one = ReferenceCell(GetParam().Type, GetParam().Order);
    this->Input = MakeGrid(Block(one, Bulged));
    this->Input->GetBounds(this->Box.data());
    this->SamplePoints();
  }

  /// Points of each cell, from parametric coordinates of its own points drawn together.
  void SamplePoints()
  {
    Random random(3);
    vtkNew<vtkGenericCell> cell;
    std::vector<double> weights(this->Input->GetMaxCellSize() + 1);
    for (vtkIdType id = 0; id < this->Input->GetNumberOfCells(); ++id)
    {
      FetchCell(this->Input, id, cell);
      std::vector<Point>& points = this->Points.emplace_back();
      for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
      {
        cell->GetPoints()->GetPoint(i, points.emplace_back().data());
      }
      const double* reference = cell->GetParametricCoords();
      for (int i = 0; reference && !cell->IsLinear() && i < 40; ++i)
      {
        Point p = { 0, 0, 0 };
        const int a = random.Index(static_cast<int>(cell->GetNumberOfPoints()));
        const int b = random.Index(static_cast<int>(cell->GetNumberOfPoints()));
        const double t = random.Between(0, 1);
        for (int axis = 0; axis < 3; ++axis)
        {
          p[axis] = (1 - t) * reference[3 * a + axis] + t * reference[3 * b + axis];
        }
        int subId = 0;
        cell->EvaluateLocation(subId, p.data(), points.emplace_back().data(), weights.data());
      }
    }
    // Points of Bezier cells need not be in them.
    this->HasBezier = GetParam().Type >= VTK_BEZIER_CURVE;
  }

  std::set<vtkIdType> Found(SpatialQuery* query) const
  {
    std::set<vtkIdType> cells;
    for (const PairRow& row : RunQuery(query))
    {
      EXPECT_LE(row.Optimistic, row.Pessimistic);
      cells.insert(row.Cell);
      if (query->GetExact())
      {
        EXPECT_LE(row.Optimistic, row.Min + 1e-9);
        EXPECT_LE(row.Min, row.Max);
        EXPECT_LE(row.Max, row.Pessimistic + 1e-9);
      }
    }
    return cells;
  }

  /// All relations of a shape that is set, and what they imply for each other.
  void CheckRelations(SpatialQuery* query, const std::function<double(const Point&)>& distance)
  {
    std::set<vtkIdType> found[5];
    for (int relation = 0; relation < 5; ++relation)
    {
      query->SetRelation(relation);
      query->ExactOn();
      found[relation] = this->Found(query);
      query->ExactOff();
      const std::set<vtkIdType> candidates = this->Found(query);
      EXPECT_TRUE(std::includes(
        candidates.begin(), candidates.end(), found[relation].begin(), found[relation].end()))
        << RelationNames[relation];
    }
    for (int relation = 0; relation < 5; ++relation)
    {
      for (const vtkIdType cell : found[relation])
      {
        EXPECT_TRUE(found[SpatialQuery::OVERLAP].count(cell)) << RelationNames[relation];
      }
    }
    for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
    {
      this->CheckCell(cell, found, distance);
    }
  }

  void CheckCell(vtkIdType cell, const std::set<vtkIdType>* found,
    const std::function<double(const Point&)>& distance)
  {
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0.0;
    const std::vector<Point>& points = this->Points[cell];
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const bool isSure = !this->HasBezier ||
        i >= static_cast<std::size_t>(this->Input->GetCells()->GetCellSize(cell));
      nearest = isSure ? std::min(nearest, distance(points[i])) : nearest;
      farthest = isSure ? std::max(farthest, distance(points[i])) : farthest;
    }
    const auto is = [&](int relation) { return found[relation].count(cell) > 0; };
    if (nearest <= 0.0 && IsLinear(GetParam().Type))
    {
      EXPECT_TRUE(is(SpatialQuery::OVERLAP)) << cell;
    }
    if (farthest > Chord)
    {
      EXPECT_FALSE(is(SpatialQuery::CONTAINMENT)) << cell;
    }
    EXPECT_EQ(
      is(SpatialQuery::EXACT_MATCH), is(SpatialQuery::ENCLOSURE) && is(SpatialQuery::CONTAINMENT));
  }

  GridPointer Input;
  Bounds Box{};
  std::vector<std::vector<Point>> Points;
  bool HasBezier = false;
};

INSTANTIATE_TEST_SUITE_P(All, SpatialQueryOnType, testing::ValuesIn(AllTypes()),
  [](const auto& info) { return NameOfType(info.param.Type); });

TEST_P(SpatialQueryOnType, PointsOfCellsDoNotContradictShapes)
{
  Random random(4);
  for (int i = 0; i < 4; ++i)
  {
    QueryPointer query = MakeQuery(this->Input);
    Bounds box = EmptyBounds();
    Extend(box, random.InBox(this->Box));
    Extend(box, random.InBox(this->Box));
    SetBox(query, box);
    this->CheckRelations(query, [&](const Point& x) { return Distance(box, x); });

    const Point center = random.InBox(this->Box);
    const double radius = random.Between(0.0, 1.0);
    SetSphere(query, center, radius);
    this->CheckRelations(
      query, [&](const Point& x) { return std::max(0.0, Distance(x, center) - radius); });

    SetPlane(query, center, random.Direction());
    this->CheckRelations(query,
      [&](const Point& x)
      {
        return std::abs(Dot(x - center,
          Point{
            query->GetPlaneNormal()[0], query->GetPlaneNormal()[1], query->GetPlaneNormal()[2] }));
      });
  }
}

TEST_P(SpatialQueryOnType, PointsOfCellsAreInThem)
{
  std::vector<Point> points;
  Ids cells;
  for (std::size_t cell = 0; cell < this->Points.size(); ++cell)
  {
    const std::size_t first =
      this->HasBezier ? static_cast<std::size_t>(this->Input->GetCells()->GetCellSize(cell)) : 0;
    for (std::size_t i = first; i < this->Points[cell].size(); i += 3)
    {
      points.push_back(this->Points[cell][i]);
      cells.push_back(static_cast<vtkIdType>(cell));
    }
  }
  QueryPointer query = MakeQuery(this->Input, SpatialQuery::ENCLOSURE);
  query->SetTolerance(1e-7);
  query->SetShape(SpatialQuery::SOURCE_POINTS);
  query->SetSourceData(MakeQueries(points));
  std::set<std::pair<vtkIdType, vtkIdType>> found;
  for (const PairRow& row : RunQuery(query))
  {
    found.insert({ row.Query, row.Cell });
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_TRUE(found.count({ static_cast<vtkIdType>(i), cells[i] })) << i;
  }
}

TEST_P(SpatialQueryOnType, EachCellMatchesItselfAndNoOther)
{
  QueryPointer query = MakeQuery(this->Input, SpatialQuery::EXACT_MATCH);
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(this->Input);
  const std::vector<PairRow> rows = RunQuery(query);
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(this->Input->GetNumberOfCells()));
  for (const PairRow& row : rows)
  {
    EXPECT_EQ(row.Query, row.Cell);
    EXPECT_EQ(row.Min, 0.0);
  }
  query->SetRelation(SpatialQuery::ADJACENCY); // they stand apart, and are not their own neighbours
  EXPECT_TRUE(RunQuery(query).empty());
}

TEST_P(SpatialQueryOnType, NearestToPointsAreThoseOfTheLocator)
{
  const std::vector<Point> points = RandomQueries(this->Input, 30);
  QueryPointer query = MakeQuery(this->Input, SpatialQuery::NEAREST);
  query->SetNumberOfNearestCells(2);
  query->SetShape(SpatialQuery::SOURCE_POINTS);
  query->SetSourceData(MakeQueries(points));
  const std::vector<PairRow> rows = RunQuery(query);
  ASSERT_EQ(rows.size(), 2 * points.size());
  BruteForce reference(this->Input);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(rows[2 * i].Query, static_cast<vtkIdType>(i));
    EXPECT_LE(rows[2 * i].Min, rows[2 * i + 1].Min);
    if (IsLinear(GetParam().Type))
    {
      // VTK finds the nearest point of a convex point set to less than its own tolerance.
      EXPECT_NEAR(rows[2 * i].Min, reference.FindNearest(points[i]).Distance, 1e-6);
    }
  }
}

TEST_P(SpatialQueryOnType, DistancesToCellsAreSymmetric)
{
  QueryPointer query = MakeQuery(this->Input, SpatialQuery::NEAREST);
  query->SetNumberOfNearestCells(8);
  query->SetShape(SpatialQuery::SOURCE_CELLS);
  query->SetSourceData(this->Input);
  std::map<std::pair<vtkIdType, vtkIdType>, PairRow> rows;
  for (const PairRow& row : RunQuery(query))
  {
    rows.insert({ { row.Query, row.Cell }, row });
  }
  ASSERT_EQ(rows.size(), 64u);
  for (const auto& [pair, row] : rows)
  {
    const PairRow& other = rows.at({ pair.second, pair.first });
    EXPECT_NEAR(row.Min, other.Min, 1e-9);
    EXPECT_NEAR(row.Max, other.Max, 1e-9);
    if (pair.first == pair.second)
    {
      EXPECT_EQ(row.Min, 0.0);
    }
    EXPECT_EQ(row.Optimistic, other.Optimistic);
  }
}

}
