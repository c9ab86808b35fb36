// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Batches have the results of single queries, each in its slot, whatever the number of threads.

#include "Support/EventCounter.h"
#include "Support/LocatorOnMesh.h"
#include "Support/ValuesOf.h"

#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace skdtest;

namespace
{

const double NaN = std::nan("");
constexpr int NumberOfQueries = 700; // of more than one thread's piece

using Doubles = vtkSmartPointer<vtkDoubleArray>;

Doubles MakeArray(int components, const std::vector<double>& values)
{
  auto array = Doubles::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// Equal to the bit, of NaN too.
void ExpectSame(const std::vector<double>& a, const std::vector<double>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ASSERT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))
      << "value " << i << ": " << a[i] << " and " << b[i];
  }
}

/// Random points in and around a data set: some twice, some its own points, one not finite.
std::vector<Point> QueryPoints(vtkDataSet* data)
{
  Bounds box;
  data->GetBounds(box.data());
  Random random(170);
  std::vector<Point> points;
  for (int i = 0; i < NumberOfQueries; ++i)
  {
    Point x = random.InBox(Grown(box, (i % 3 == 0 ? 1.0 : 0.1) * Diagonal(box)));
    if (i % 7 == 0)
    {
      data->GetPoint(random.Index(static_cast<int>(data->GetNumberOfPoints())), x.data());
    }
    points.push_back(i % 50 == 49 ? points[i - 40] : x);
  }
  points[123][1] = NaN;
  points[124][0] = std::numeric_limits<double>::infinity();
  return points;
}

Doubles ToArray(const std::vector<Point>& points)
{
  std::vector<double> values;
  for (const Point& point : points)
  {
    values.insert(values.end(), point.begin(), point.end());
  }
  return MakeArray(3, values);
}

/// Each point, and the next.
Doubles ToLines(const std::vector<Point>& points)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point& next = points[(i + 1) % points.size()];
    values.insert(values.end(), points[i].begin(), points[i].end());
    values.insert(values.end(), next.begin(), next.end());
  }
  return MakeArray(6, values);
}

Doubles ToBoxes(const std::vector<Point>& points, double halfLength)
{
  std::vector<double> values;
  for (const Point& point : points)
  {
    for (const double x : point)
    {
      values.push_back(x - halfLength);
      values.push_back(x + halfLength);
    }
  }
  return MakeArray(6, values);
}

/// The results of all batches.
struct Answers
{
  vtkNew<vtkIdTypeArray> ClosestIds, CellIds, HitIds, HitOffsets, AllHitIds, BoxOffsets, BoxIds;
  vtkNew<vtkDoubleArray> ClosestPoints, Distances, PCoords, Ts, Xs, AllTs, AllXs;
  vtkIdType Numbers[5] = { -2, -2, -2, -2, -2 };

  std::vector<std::vector<double>> Values() const
  {
    std::vector<std::vector<double>> values(
      1, std::vector<double>(std::begin(this->Numbers), std::end(this->Numbers)));
    for (vtkDataArray* array :
      { static_cast<vtkDataArray*>(this->ClosestIds.Get()),
        static_cast<vtkDataArray*>(this->CellIds.Get()), static_cast<vtkDataArray*>(this->HitIds),
        static_cast<vtkDataArray*>(this->HitOffsets), static_cast<vtkDataArray*>(this->AllHitIds),
        static_cast<vtkDataArray*>(this->BoxOffsets), static_cast<vtkDataArray*>(this->BoxIds),
        static_cast<vtkDataArray*>(this->ClosestPoints),
        static_cast<vtkDataArray*>(this->Distances), static_cast<vtkDataArray*>(this->PCoords),
        static_cast<vtkDataArray*>(this->Ts), static_cast<vtkDataArray*>(this->Xs),
        static_cast<vtkDataArray*>(this->AllTs), static_cast<vtkDataArray*>(this->AllXs) })
    {
      values.push_back(ValuesOf(array));
    }
    return values;
  }
};

class Batches : public BuiltLocator
{
protected:
  Batches()
    : Points(QueryPoints(this->Data))
    , Queries(ToArray(this->Points))
    , Lines(ToLines(this->Points))
    , Boxes(ToBoxes(this->Points, 0.05 * Diagonal(this->Box)))
    , Radius(0.2 * Diagonal(this->Box))
  {
  }

  void AskAll(Answers& a)
  {
    a.Numbers[0] = this->Locator->FindClosestPoints(
      this->Queries, a.ClosestIds, a.ClosestPoints, a.Distances, this->Radius);
    a.Numbers[1] = this->Locator->FindCells(this->Queries, a.CellIds, a.PCoords, 0.01);
    a.Numbers[2] = this->Locator->IntersectWithLines(this->Lines, a.HitIds, a.Ts, a.Xs, 0.01);
    a.Numbers[3] =
      this->Locator->FindAllHits(this->Lines, a.HitOffsets, a.AllHitIds, a.AllTs, a.AllXs, 0.01);
    a.Numbers[4] = this->Locator->FindCellsWithinBoxes(this->Boxes, a.BoxOffsets, a.BoxIds);
  }

  std::vector<std::vector<double>> AskAll()
  {
    Answers answers;
    this->AskAll(answers);
    return answers.Values();
  }

  void ExpectClosest(double radius)
  {
    vtkNew<vtkIdTypeArray> ids;
    vtkNew<vtkDoubleArray> xs, distances;
    const vtkIdType number =
      this->Locator->FindClosestPoints(this->Queries, ids, xs, distances, radius);
    vtkIdType found = 0;
    for (vtkIdType i = 0; i < NumberOfQueries; ++i)
    {
      Closest c;
      found += this->Locator->FindClosestPointWithinRadius(
        this->Points[i].data(), radius, c.X.data(), c.Cell, c.SubId, c.Dist2);
      ASSERT_EQ(ids->GetValue(i), c.Cell) << i;
      const Point x = c.Cell < 0 ? Point{ NaN, NaN, NaN } : c.X;
      ExpectSame(std::vector<double>(xs->GetPointer(3 * i), xs->GetPointer(3 * i + 3)),
        std::vector<double>(x.begin(), x.end()));
      ExpectSame({ distances->GetValue(i) }, { c.Cell < 0 ? NaN : std::sqrt(c.Dist2) });
    }
    EXPECT_EQ(number, found);
  }

  void ExpectAllAsOfOne()
  {
    this->ExpectClosest(VTK_DOUBLE_MAX);
    this->ExpectClosest(this->Radius);
    this->ExpectClosest(0.0);
    Answers batch;
    this->AskAll(batch);
    for (vtkIdType i = 0; i < NumberOfQueries; ++i)
    {
      const Point& from = this->Points[i];
      const Point& to = this->Points[(i + 1) % NumberOfQueries];
      const Found cell = FindCell(this->Locator, from, 0.01);
      ASSERT_EQ(batch.CellIds->GetValue(i), cell.Cell) << i;
      ExpectSame(Three(batch.PCoords, i), ThreeOf(cell.Cell, cell.Pcoords));
      const LineHit hit = FindFirstHit(this->Locator, from, to, 0.01);
      ASSERT_EQ(batch.HitIds->GetValue(i), hit.Cell) << i;
      ExpectSame({ batch.Ts->GetValue(i) }, { hit.Found ? hit.T : NaN });
      ExpectSame(Three(batch.Xs, i), ThreeOf(hit.Cell, hit.X));
      this->ExpectHits(batch, i, from, to);
      this->ExpectInBox(batch, i);
    }
    EXPECT_EQ(batch.Numbers[3], batch.AllHitIds->GetNumberOfTuples());
    EXPECT_EQ(batch.Numbers[3], batch.HitOffsets->GetValue(NumberOfQueries));
    EXPECT_EQ(batch.Numbers[4], batch.BoxIds->GetNumberOfTuples());
    EXPECT_EQ(batch.HitOffsets->GetValue(0), 0);
  }

  static std::vector<double> Three(vtkDoubleArray* array, vtkIdType i)
  {
    return std::vector<double>(array->GetPointer(3 * i), array->GetPointer(3 * i) + 3);
  }

  static std::vector<double> ThreeOf(vtkIdType id, const Point& x)
  {
    return id < 0 ? std::vector<double>(3, NaN) : std::vector<double>(x.begin(), x.end());
  }

  void ExpectHits(const Answers& batch, vtkIdType i, const Point& from, const Point& to)
  {
    vtkNew<vtkGenericCell> cell;
    const LineHits hits = FindAllHits(this->Locator, from, to, 0.01, cell);
    const vtkIdType first = batch.HitOffsets->GetValue(i);
    const auto size = static_cast<vtkIdType>(hits.Cells.size());
    ASSERT_EQ(batch.HitOffsets->GetValue(i + 1) - first, size) << i;
    for (vtkIdType k = 0; k < size; ++k)
    {
      EXPECT_EQ(batch.AllHitIds->GetValue(first + k), hits.Cells[k]);
      const Point& x = hits.Points[k];
      ExpectSame(Three(batch.AllXs, first + k), std::vector<double>(x.begin(), x.end()));
      EXPECT_LE(
        batch.AllTs->GetValue(k == 0 ? first : first + k - 1), batch.AllTs->GetValue(first + k));
    }
  }

  void ExpectInBox(const Answers& batch, vtkIdType i)
  {
    vtkNew<vtkIdList> ids;
    this->Locator->FindCellsWithinBounds(this->Boxes->GetPointer(6 * i), ids);
    const vtkIdType* first = batch.BoxIds->GetPointer(batch.BoxOffsets->GetValue(i));
    EXPECT_EQ(Ids(first, first + batch.BoxOffsets->GetValue(i + 1) - batch.BoxOffsets->GetValue(i)),
      ToVector(ids));
  }

  std::vector<Point> Points;
  Doubles Queries, Lines, Boxes;
  double Radius;
};

INSTANTIATE_TEST_SUITE_P(All, Batches, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(Batches, AnswerAsQueriesForOne)
{
  this->ExpectAllAsOfOne();
}

TEST_P(Batches, AnswerAsQueriesForOneOfAMovedSet)
{
  vtkNew<vtkMatrix4x4> motion;
  const Point columns[3] = { Rotated({ 1, 0, 0 }), Rotated({ 0, 1, 0 }), Rotated({ 0, 0, 1 }) };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      motion->SetElement(row, column, columns[column][row]);
    }
    motion->SetElement(row, 3, 0.1 * row);
  }
  this->Locator->SetTransform(motion);
  this->ExpectAllAsOfOne();
}

TEST_P(Batches, AreTheSameForAnyNumberOfThreads)
{
  const std::string former = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(1);
  const auto one = this->AskAll();
  vtkSMPTools::Initialize(2);
  const auto two = this->AskAll();
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(former.c_str());
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    ASSERT_EQ(one[i].size(), two[i].size());
    EXPECT_EQ(std::memcmp(one[i].data(), two[i].data(), 8 * one[i].size()), 0);
  }
}

TEST_P(Batches, DoNotDependOnTheOrderOfQueries)
{
  Answers forward;
  this->AskAll(forward);
  std::reverse(this->Points.begin(), this->Points.end());
  this->Queries = ToArray(this->Points);
  Answers backward;
  this->AskAll(backward);
  EXPECT_EQ(forward.Numbers[0], backward.Numbers[0]);
  for (vtkIdType i = 0; i < NumberOfQueries; ++i)
  {
    ASSERT_EQ(
      forward.ClosestIds->GetValue(i), backward.ClosestIds->GetValue(NumberOfQueries - 1 - i));
    ASSERT_EQ(forward.CellIds->GetValue(i), backward.CellIds->GetValue(NumberOfQueries - 1 - i));
  }
}

TEST_P(Batches, NeedNoOutputs)
{
  Answers all;
  this->AskAll(all);
  vtkSkdTreeCellLocator* locator = this->Locator;
  EXPECT_EQ(all.Numbers[0],
    locator->FindClosestPoints(this->Queries, nullptr, nullptr, nullptr, this->Radius));
  EXPECT_EQ(all.Numbers[1], locator->FindCells(this->Queries, nullptr, nullptr, 0.01));
  EXPECT_EQ(
    all.Numbers[2], locator->IntersectWithLines(this->Lines, nullptr, nullptr, nullptr, 0.01));
  EXPECT_EQ(
    all.Numbers[3], locator->FindAllHits(this->Lines, nullptr, nullptr, nullptr, nullptr, 0.01));
  EXPECT_EQ(all.Numbers[4], locator->FindCellsWithinBoxes(this->Boxes, nullptr, nullptr));
}

/// Pairs as tuples are those of the lists.
void ExpectSamePairs(vtkSkdTreeCellLocator* locator, vtkSkdTreeCellLocator* other,
  vtkIdTypeArray* offsets, vtkIdTypeArray* ids)
{
  vtkNew<vtkIdTypeArray> pairs;
  ASSERT_EQ(locator->FindPairs(other, pairs), ids->GetNumberOfTuples());
  ASSERT_EQ(locator->FindPairs(other, nullptr), ids->GetNumberOfTuples());
  ASSERT_EQ(pairs->GetNumberOfComponents(), 2);
  std::vector<std::pair<vtkIdType, vtkIdType>> listed, found;
  for (vtkIdType i = 0; i < pairs->GetNumberOfTuples(); ++i)
  {
    found.emplace_back(pairs->GetValue(2 * i), pairs->GetValue(2 * i + 1));
  }
  for (vtkIdType cell = 0; cell + 1 < offsets->GetNumberOfTuples(); ++cell)
  {
    for (vtkIdType i = offsets->GetValue(cell); i < offsets->GetValue(cell + 1); ++i)
    {
      listed.emplace_back(cell, ids->GetValue(i));
    }
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, listed);
}

/// FindPairs against every cell with every cell.
void ExpectPairs(vtkSkdTreeCellLocator* locator, vtkSkdTreeCellLocator* otherLocator)
{
  vtkDataSet* data = locator->GetDataSet();
  vtkDataSet* other = otherLocator->GetDataSet();
  vtkNew<vtkIdTypeArray> offsets, ids;
  const vtkIdType number = locator->FindPairs(otherLocator, offsets, ids);
  EXPECT_EQ(number, ids->GetNumberOfTuples());
  ASSERT_EQ(offsets->GetNumberOfTuples(), data->GetNumberOfCells() + 1);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    Bounds box;
    data->GetCellBounds(i, box.data());
    Ids expected;
    for (vtkIdType k = 0; k < other->GetNumberOfCells(); ++k)
    {
      Bounds otherBox;
      other->GetCellBounds(k, otherBox.data());
      if (Overlap(box, otherBox))
      {
        expected.push_back(k);
      }
    }
    const vtkIdType* first = ids->GetPointer(offsets->GetValue(i));
    ASSERT_EQ(Ids(first, first + offsets->GetValue(i + 1) - offsets->GetValue(i)), expected) << i;
  }
  ExpectSamePairs(locator, otherLocator, offsets, ids);
}

TEST_P(Batches, FindPairsOfCellsWhoseBoundsOverlap)
{
  const auto other = MakePolyData(SphereTriangles(6).Map(Bent));
  ExpectPairs(this->Locator, MakeLocator(other));
}

/// Far less than the trees' boxes show.
TEST(BatchOfPairs, TellsCellsThatTouchFromThoseAHairApart)
{
  const auto cubes = MakeGrid(Hexahedra(4));
  for (const double x : { std::nextafter(4.0, 3.0), 4.0, std::nextafter(4.0, 5.0), 3.0 - 1e-9 })
  {
    SCOPED_TRACE(x);
    for (const double far : { 0.0, 1e6 })
    {
      Mesh beside = Transformed(Hexahedra(4), 1.0, { x, 0, 1 });
      const vtkIdType lonely = beside.Add(Point{ -far, 0, 0 }); // spoils the other's resolution
      beside.Add(VTK_VERTEX, { lonely });
      const auto others = MakeGrid(beside);
      const auto locator = MakeLocator(cubes);
      const auto otherLocator = MakeLocator(others);
      ExpectPairs(locator, otherLocator);
      ExpectPairs(otherLocator, locator);
      locator->LazyBuildOn();
      ExpectPairs(locator, otherLocator);
      ExpectPairs(otherLocator, locator);
    }
  }
}

TEST(BatchOfPairs, OfManySizes)
{
  for (const double size : { 0.01, 1.0, 100.0, 1e7 })
  {
    SCOPED_TRACE(size);
    const auto soup = MakePolyData(TriangleSoup(300, 0.2));
    const auto sized = MakePolyData(Transformed(TriangleSoup(200, 0.3), size, { 0.1, 0.2, 0.3 }));
    ExpectPairs(MakeLocator(soup), MakeLocator(sized));
    ExpectPairs(MakeLocator(sized), MakeLocator(soup));
  }
}

/// A locator of a small surface.
class SmallBatch : public testing::Test
{
protected:
  PolyDataPointer Data = MakePolyData(SphereTriangles(6));
  LocatorPointer Locator = MakeLocator(this->Data);
  vtkNew<vtkIdTypeArray> Ids1, Ids2;
  vtkNew<vtkDoubleArray> Numbers1, Numbers2;
};

TEST_F(SmallBatch, TakesFloatsAndIntegers)
{
  vtkNew<vtkFloatArray> floats;
  floats->SetNumberOfComponents(3);
  vtkNew<vtkIdTypeArray> integers;
  integers->SetNumberOfComponents(3);
  Random random(171);
  for (int i = 0; i < 1000; ++i)
  {
    const Point x = random.InBox({ -3, 3, -3, 3, -3, 3 });
    floats->InsertNextTuple(x.data());
    integers->InsertNextTuple(x.data());
  }
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(floats), static_cast<vtkDataArray*>(integers) })
  {
    EXPECT_EQ(this->Locator->FindClosestPoints(array, this->Ids1, nullptr, this->Numbers1), 1000);
    for (int i = 0; i < 1000; ++i)
    {
      Point x;
      array->GetTuple(i, x.data());
      const Closest c = FindClosest(this->Locator, x);
      ASSERT_EQ(this->Ids1->GetValue(i), c.Cell);
      ASSERT_EQ(this->Numbers1->GetValue(i), std::sqrt(c.Dist2));
    }
  }
}

TEST_F(SmallBatch, WithOneBadPointSpoilsOnlyItsOwnAnswer)
{
  std::vector<Point> points;
  Random random(172);
  for (int i = 0; i < 2000; ++i)
  {
    points.push_back(random.InBox({ -2, 2, -2, 2, -2, 2 }));
  }
  const auto good = ToArray(points);
  points[777] = { 0.1, NaN, 0.2 };
  const auto bad = ToArray(points);
  EXPECT_EQ(this->Locator->FindClosestPoints(good, this->Ids1, nullptr, this->Numbers1), 2000);
  EXPECT_EQ(this->Locator->FindClosestPoints(bad, this->Ids2, nullptr, this->Numbers2), 1999);
  for (int i = 0; i < 2000; ++i)
  {
    ASSERT_EQ(this->Ids2->GetValue(i), i == 777 ? -1 : this->Ids1->GetValue(i));
    ASSERT_EQ(std::isnan(this->Numbers2->GetValue(i)), i == 777);
    ASSERT_TRUE(i == 777 || this->Numbers2->GetValue(i) == this->Numbers1->GetValue(i));
  }
}

TEST_F(SmallBatch, OfQueriesThatAreAllBadFindsNothing)
{
  const auto bad = MakeArray(6, std::vector<double>(6 * 600, NaN));
  const auto badPoints = MakeArray(3, std::vector<double>(3 * 600, NaN));
  EXPECT_EQ(this->Locator->FindClosestPoints(badPoints, this->Ids1, nullptr, nullptr), 0);
  EXPECT_EQ(this->Ids1->GetValue(599), -1);
  EXPECT_EQ(this->Locator->IntersectWithLines(bad, this->Ids1, nullptr, nullptr), 0);
  EXPECT_EQ(this->Locator->FindAllHits(bad, this->Ids1, this->Ids2, nullptr, nullptr), 0);
  EXPECT_EQ(this->Ids1->GetNumberOfTuples(), 601);
  EXPECT_EQ(this->Locator->FindCellsWithinBoxes(bad, this->Ids1, this->Ids2), 0);
}

TEST_F(SmallBatch, OfHugeAndTinyNumbersAnswersAsQueriesForOne)
{
  for (const double scale : { 1e-300, 1e-160, 1e150, 1e300 })
  {
    const auto data =
      MakePolyData(SphereTriangles(6).Map([scale](const Point& p) { return scale * p; }));
    const auto locator = MakeLocator(data);
    std::vector<Point> points;
    Random random(173);
    for (int i = 0; i < 600; ++i)
    {
      points.push_back(scale * random.InBox({ -2, 2, -2, 2, -2, 2 }));
    }
    points.push_back({ 1e308, -1e308, 1e308 });
    points.push_back({ -1e308, 1e308, 1e308 });
    locator->FindClosestPoints(ToArray(points), this->Ids1, nullptr, this->Numbers1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Closest c = FindClosest(locator, points[i]);
      ASSERT_EQ(this->Ids1->GetValue(i), c.Cell) << i << " at " << scale;
    }
  }
}

TEST_F(SmallBatch, OfOnePositionIsAnsweredManyTimes)
{
  const auto same = ToArray(std::vector<Point>(1000, Point{ 0.3, 0.2, 2.0 }));
  EXPECT_EQ(this->Locator->FindClosestPoints(same, this->Ids1, nullptr, nullptr), 1000);
  const vtkIdType expected = FindClosest(this->Locator, { 0.3, 0.2, 2.0 }).Cell;
  for (int i = 0; i < 1000; ++i)
  {
    ASSERT_EQ(this->Ids1->GetValue(i), expected);
  }
}

TEST_F(SmallBatch, WithoutQueriesIsEmpty)
{
  EventCounter events(this->Locator);
  this->Ids1->SetNumberOfTuples(5);
  EXPECT_EQ(this->Locator->FindClosestPoints(MakeArray(3, {}), this->Ids1, nullptr, nullptr), 0);
  EXPECT_EQ(this->Ids1->GetNumberOfTuples(), 0);
  EXPECT_EQ(
    this->Locator->FindAllHits(MakeArray(6, {}), this->Ids1, this->Ids2, nullptr, nullptr), 0);
  ASSERT_EQ(this->Ids1->GetNumberOfTuples(), 1);
  EXPECT_EQ(this->Ids1->GetValue(0), 0);
  EXPECT_EQ(events.Errors, 0);
}

TEST_F(SmallBatch, OfALocatorWithoutCellsFindsNothing)
{
  const auto empty = LocatorPointer::New();
  const auto points = ToArray(std::vector<Point>(300, Point{ 0, 0, 0 }));
  EXPECT_EQ(empty->FindClosestPoints(points, this->Ids1, nullptr, this->Numbers1), 0);
  EXPECT_EQ(this->Ids1->GetValue(0), -1);
  EXPECT_TRUE(std::isnan(this->Numbers1->GetValue(299)));
  EXPECT_EQ(empty->FindCells(points, this->Ids1, nullptr, 1e300), 0);
  EXPECT_EQ(empty->FindPairs(this->Locator, this->Ids1, this->Ids2), 0);
  EXPECT_EQ(this->Ids1->GetNumberOfTuples(), 1);
  EXPECT_EQ(this->Locator->FindPairs(empty, this->Ids1, this->Ids2), 0);
  EXPECT_EQ(this->Locator->FindPairs(empty, this->Ids2), 0);
  EXPECT_EQ(this->Ids1->GetNumberOfTuples(), this->Data->GetNumberOfCells() + 1);
}

TEST_F(SmallBatch, NamesItsOutputs)
{
  const auto points = ToArray({ { 0, 0, 2 } });
  this->Locator->FindClosestPoints(points, this->Ids1, this->Numbers1, this->Numbers2);
  EXPECT_STREQ(this->Ids1->GetName(), "SkdClosestCellId");
  EXPECT_STREQ(this->Numbers1->GetName(), "SkdClosestPoint");
  EXPECT_STREQ(this->Numbers2->GetName(), "SkdDistance");
  EXPECT_EQ(this->Numbers1->GetNumberOfComponents(), 3);
}

TEST_F(SmallBatch, ThatIsRefusedSaysWhyOnceAndTouchesNothing)
{
  const auto points = ToArray({ { 0, 0, 2 } });
  const auto lines = MakeArray(6, { 0, 0, 2, 0, 0, -2 });
  const auto expectError = [&](const char* why, const std::function<vtkIdType()>& ask)
  {
    EventCounter events(this->Locator);
    this->Ids1->SetNumberOfTuples(3);
    EXPECT_EQ(ask(), -1) << why;
    EXPECT_EQ(events.Errors, 1) << why;
    EXPECT_NE(events.Error.find(why), std::string::npos) << events.Error;
    EXPECT_EQ(this->Ids1->GetNumberOfTuples(), 3);
  };
  vtkSkdTreeCellLocator* locator = this->Locator;
  vtkIdTypeArray* ids = this->Ids1;
  expectError("array of queries is missing",
    [&] { return locator->FindClosestPoints(nullptr, ids, nullptr, nullptr); });
  expectError("6 components instead of 3", [&] { return locator->FindCells(lines, ids, nullptr); });
  expectError("3 components instead of 6",
    [&] { return locator->IntersectWithLines(points, ids, nullptr, nullptr); });
  expectError("3 components instead of 6",
    [&] { return locator->FindAllHits(points, ids, nullptr, nullptr, nullptr); });
  expectError("3 components instead of 6",
    [&] { return locator->FindCellsWithinBoxes(points, ids, nullptr); });
  expectError("passed twice", [&] { return locator->FindCellsWithinBoxes(lines, ids, ids); });
  expectError(
    "passed twice", [&] { return locator->FindClosestPoints(points, ids, points, nullptr); });
  expectError("passed twice", [&] { return locator->FindPairs(locator, ids, ids); });
  expectError(
    "other locator is missing", [&] { return locator->FindPairs(nullptr, ids, nullptr); });
  expectError("other locator is missing", [&] { return locator->FindPairs(nullptr, ids); });
}

}
