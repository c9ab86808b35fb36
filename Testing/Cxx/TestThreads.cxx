// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// Many threads query one locator: each gets what it would get alone, of lazy trees too.

#include "Support/LocatorCalls.h"
#include "Support/NamedMeshes.h"

#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

using namespace skdtest;

namespace
{

constexpr int NumberOfThreads = 8;

/// Of so many threads at once and all i below n each, how often isRight(thread, i) is false.
template <class IsRight>
int CountWrong(std::size_t n, const IsRight& isRight)
{
  std::atomic<int> wrong(0);
  std::vector<std::thread> threads;
  for (int thread = 0; thread < NumberOfThreads; ++thread)
  {
    threads.emplace_back(
      [&, thread]
      {
        for (std::size_t i = 0; i < n; ++i)
        {
          wrong += !isRight(thread, i);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  return wrong;
}

/// The results of one point, of all queries that the header calls thread-safe.
struct Answers
{
  Closest Nearest;
  Closest WithinRadius;
  LineHit First;
  LineHits All;
  LineHits Entries;
  Found InCell;
  vtkIdType ShortCell = -2;
  vtkIdType HintedCell = -2;
  Ids Within;
  Ids AlongLine;
  Ids AlongPlane;
  Ids NearestCells;
  Ids CellsInRadius;
  vtkIdType CrossingCount = -2;
  std::vector<Ids> CrossingCells;
  Ids Candidates;
  bool IsInside = false;

  bool operator==(const Answers& o) const
  {
    return this->Nearest == o.Nearest && this->WithinRadius == o.WithinRadius &&
      this->First == o.First && this->All == o.All && this->Entries == o.Entries &&
      this->InCell == o.InCell && this->ShortCell == o.ShortCell &&
      this->HintedCell == o.HintedCell && this->Within == o.Within &&
      this->AlongLine == o.AlongLine && this->AlongPlane == o.AlongPlane &&
      this->NearestCells == o.NearestCells && this->CellsInRadius == o.CellsInRadius &&
      this->CrossingCount == o.CrossingCount && this->CrossingCells == o.CrossingCells &&
      this->Candidates == o.Candidates && this->IsInside == o.IsInside;
  }
};

void AskForPoints(vtkSkdTreeCellLocator* locator, Point x, Answers& answers)
{
  answers.Nearest = FindClosest(locator, x);
  locator->FindClosestPointWithinRadius(x.data(), 0.4, answers.WithinRadius.X.data(),
    answers.WithinRadius.Cell, answers.WithinRadius.SubId, answers.WithinRadius.Dist2);
  answers.InCell = FindCell(locator, x, 0.01);
  answers.ShortCell = locator->FindCell(x.data());
  Found f;
  answers.HintedCell = locator->FindCellWithHint(
    x.data(), 0.0, answers.InCell.Cell, nullptr, f.SubId, f.Pcoords.data(), nullptr);
  answers.NearestCells = FindClosestCells(locator, x, 4).Cells;
  answers.CellsInRadius = FindWithinRadius(locator, x, 0.3).Cells;
  answers.IsInside = locator->InsideCellBounds(x.data(), 1);
  vtkNew<vtkIdList> ids;
  locator->FindClosestCandidates(x.data(), ids);
  answers.Candidates = ToVector(ids);
}

Answers Ask(vtkSkdTreeCellLocator* locator, const Point& x, const Point& y)
{
  Answers answers;
  AskForPoints(locator, x, answers);
  vtkNew<vtkGenericCell> cell;
  answers.First = FindFirstHit(locator, x, y, 0.01);
  answers.All = FindAllHits(locator, x, y, 0.01, cell);
  answers.Entries = FindAllHits(locator, x, y, 0.01, nullptr);
  answers.CrossingCount = locator->CountCrossings(x.data(), y.data());
  answers.CrossingCells = FindCrossings(locator, x, y).Cells;
  Bounds box = EmptyBounds();
  Extend(box, x);
  Extend(box, y);
  answers.Within = FindWithinBounds(locator, box);
  answers.AlongLine = FindAlongLine(locator, x, y, 0.01);
  answers.AlongPlane = FindAlongPlane(locator, x, y - x);
  return answers;
}

class Threads : public testing::TestWithParam<NamedMesh>
{
protected:
  Threads()
    : Data(GetParam().Make())
  {
    Bounds box;
    this->Data->GetBounds(box.data());
    Random random(160);
    for (int i = 0; i < 80; ++i)
    {
      this->Points.push_back(random.InBox(Grown(box, 0.1 * Diagonal(box))));
    }
    this->Expect(MakeLocator(this->Data));
  }

  void Expect(vtkSkdTreeCellLocator* locator)
  {
    this->Expected.clear();
    for (std::size_t i = 0; i + 1 < this->Points.size(); ++i)
    {
      this->Expected.push_back(Ask(locator, this->Points[i], this->Points[i + 1]));
    }
  }

  /// Each thread runs all queries, each from another start. Returns how many results were wrong.
  int AskFromThreads(vtkSkdTreeCellLocator* locator)
  {
    std::atomic<int> wrong(0);
    std::atomic<int> ready(0);
    const auto work = [&](int thread)
    {
      ++ready;
      while (ready < NumberOfThreads) // all at once
      {
        std::this_thread::yield();
      }
      const std::size_t n = this->Expected.size();
      for (std::size_t k = 0; k < n; ++k)
      {
        const std::size_t i = (k + thread * n / NumberOfThreads) % n;
        wrong += !(Ask(locator, this->Points[i], this->Points[i + 1]) == this->Expected[i]);
      }
    };
    std::vector<std::thread> threads;
    for (int thread = 0; thread < NumberOfThreads; ++thread)
    {
      threads.emplace_back(work, thread);
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    return wrong;
  }

  DataSetPointer Data;
  std::vector<Point> Points;
  std::vector<Answers> Expected;
};

INSTANTIATE_TEST_SUITE_P(All, Threads, testing::ValuesIn(AllMeshes()), NameOfMesh());

TEST_P(Threads, GetTheAnswersOfOne)
{
  EXPECT_EQ(this->AskFromThreads(MakeLocator(this->Data)), 0);
}

/// Lists that come in the order of the tree are those of a tree that is divided at the median, too.
TEST_P(Threads, GetTheAnswersOfOneFromALazyTree)
{
  const auto whole = LocatorPointer::New();
  whole->SetDataSet(this->Data);
  whole->SetSplitRuleToMedian();
  whole->BuildLocator();
  this->Expect(whole);
  for (int round = 0; round < 3; ++round)
  {
    const auto locator = LocatorPointer::New();
    locator->SetDataSet(this->Data);
    locator->LazyBuildOn();
    locator->BuildLocator();
    ASSERT_EQ(this->AskFromThreads(locator), 0) << "round " << round;
  }
}

TEST_P(Threads, GetTheAnswersOfOneWithCachedBounds)
{
  const auto locator = LocatorPointer::New();
  locator->SetDataSet(this->Data);
  locator->CacheCellBoundsOn();
  locator->BuildLocator();
  EXPECT_EQ(this->AskFromThreads(locator), 0);
}

TEST(LazyTree, SplitUnderManyThreadsIsTheSameTree)
{
  const auto data = MakePolyData(TriangleSoup(3000, 0.05));
  const auto plain = MakeLocator(data);
  Random random(161);
  std::vector<Point> points;
  std::vector<Closest> expected;
  for (int i = 0; i < 400; ++i)
  {
    points.push_back(random.InBox({ 0, 1, 0, 1, 0, 1 }));
    expected.push_back(FindClosest(plain, points.back()));
  }
  for (int round = 0; round < 20; ++round)
  {
    const auto lazy = LocatorPointer::New();
    lazy->SetDataSet(data);
    lazy->LazyBuildOn();
    lazy->BuildLocator();
    const auto isRight = [&](int thread, std::size_t k)
    {
      const std::size_t i = (k * 7 + thread * 53) % points.size();
      return FindClosest(lazy, points[i]) == expected[i];
    };
    ASSERT_EQ(CountWrong(points.size(), isRight), 0) << "round " << round;
  }
}

TEST(SharedTree, CopiesAskAtOnce)
{
  const auto data = MakePolyData(SphereTriangles(12));
  const auto locator = MakeLocator(data);
  Random random(162);
  std::vector<Point> points;
  std::vector<Closest> expected;
  for (int i = 0; i < 300; ++i)
  {
    points.push_back(2.0 * random.Direction());
    expected.push_back(FindClosest(locator, points.back()));
  }
  std::vector<LocatorPointer> copies;
  for (int thread = 0; thread < NumberOfThreads; ++thread)
  {
    copies.push_back(LocatorPointer::New());
    copies.back()->ShallowCopy(locator);
  }
  const auto isRight = [&](int thread, std::size_t i)
  { return FindClosest(copies[thread], points[i]) == expected[i]; };
  EXPECT_EQ(CountWrong(points.size(), isRight), 0);
}

/// Points whose time takes a while to read; counts those that end while it is read.
class SlowPoints : public vtkPoints
{
public:
  static SlowPoints* New();
  vtkTypeMacro(SlowPoints, vtkPoints);

  vtkMTimeType GetMTime() override
  {
    ++Readers;
    std::this_thread::sleep_for(std::chrono::milliseconds(IsSlow ? 20 : 0));
    --Readers;
    return this->vtkPoints::GetMTime();
  }

  static std::atomic<bool> IsSlow;
  static std::atomic<int> Readers;
  static std::atomic<int> Ended;
  static std::atomic<int> EndedInUse;

protected:
  ~SlowPoints() override
  {
    ++Ended;
    EndedInUse += Readers > 0;
  }
};
vtkStandardNewMacro(SlowPoints);
std::atomic<bool> SlowPoints::IsSlow{ false };
std::atomic<int> SlowPoints::Readers{ 0 };
std::atomic<int> SlowPoints::Ended{ 0 };
std::atomic<int> SlowPoints::EndedInUse{ 0 };

// The tree is all that holds the first mesh's points when its first query finds them modified.
TEST(ThreadsOfLocator, RebuildATreeWhosePointsOfAnotherMeshAreModified)
{
  auto first = MakePolyData(SphereTriangles(8));
  const vtkSmartPointer<vtkDataArray> array = first->GetPoints()->GetData();
  {
    vtkNew<SlowPoints> points;
    points->SetData(array);
    first->SetPoints(points);
  }
  auto locator = MakeLocator(first);
  const auto copy = LocatorPointer::New();
  copy->SetDataSet(MakePolyData(SphereTriangles(8)));
  copy->ShallowCopy(locator);
  const Closest expected = FindClosest(copy, { 3, 1, 2 });
  locator = nullptr;
  first = nullptr;
  ASSERT_EQ(SlowPoints::Ended, 0);
  array->SetComponent(0, 0, 100.0);
  array->Modified();
  SlowPoints::IsSlow = true;
  const auto isRight = [&](int thread, std::size_t)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5 * thread)); // some read, some build
    return FindClosest(copy, { 3, 1, 2 }) == expected;
  };
  EXPECT_EQ(CountWrong(2, isRight), 0);
  EXPECT_EQ(SlowPoints::Ended, 1);
  EXPECT_EQ(SlowPoints::EndedInUse, 0);
}

}
