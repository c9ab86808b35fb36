// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The nearest of what many processes have (threads in their place), compared with brute force, and
// how often they ask each other.

#include "Support/ThreadTransport.h"

#include "Core/Geometry/Box.h"
#include "Exchange/SkdNearestExchange.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <random>

using namespace skdtest;
using namespace skdtree;

namespace
{
using skd::Vector3;

constexpr double Infinite = std::numeric_limits<double>::infinity();

struct Site
{
  Vector3 Point;
  int Id;
};

struct Answer
{
  double Distance2;
  int Id;
};

bool IsLess(const Answer& a, const Answer& b)
{
  return a.Distance2 < b.Distance2 || (a.Distance2 == b.Distance2 && a.Id < b.Id);
}

bool FindNearest(const std::vector<Site>& sites, const Vector3& x, double radius, Answer& answer)
{
  answer = { Infinite, -1 };
  for (const Site& site : sites)
  {
    const Vector3 apart = site.Point - x;
    const Answer other{ Dot(apart, apart), site.Id };
    if (std::sqrt(other.Distance2) <= radius && IsLess(other, answer))
    {
      answer = other;
    }
  }
  return answer.Id >= 0;
}

double GapOf(const skd::Box3& box, const Vector3& x)
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double gap = std::max({ box.Min[axis] - x[axis], x[axis] - box.Max[axis], 0.0 });
    sum += gap * gap;
  }
  return sum;
}

/// The sites of one process, and boxes of those of all.
struct Searcher
{
  using Query = Vector3;
  using Answer = ::Answer;
  std::vector<std::vector<Site>> Sites;
  std::vector<skd::Box3> Boxes;
  int Own;

  static bool IsBetter(const Answer& a, const Answer& b) { return IsLess(a, b); }
  static double RadiusOf(const Answer& answer)
  {
    return std::nextafter(std::sqrt(answer.Distance2), Infinite);
  }
  template <class QuestionOf, class Set>
  void FindHere(std::size_t n, const QuestionOf& questionOf, const Set& set) const
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      Answer answer;
      if (FindNearest(this->Sites[static_cast<std::size_t>(this->Own)], questionOf(i).Request,
            questionOf(i).Radius, answer))
      {
        set(i, answer);
      }
    }
  }
  void ListNear(const Vector3& x, double radius, std::vector<SkdNearProcess>& near) const
  {
    for (std::size_t process = 0; process < this->Boxes.size(); ++process)
    {
      const double gap = GapOf(this->Boxes[process], x);
      if (static_cast<int>(process) != this->Own && !this->Boxes[process].IsEmpty() &&
        gap <= radius * radius)
      {
        near.push_back({ static_cast<int>(process), gap });
      }
    }
  }
};

/// On a coarse lattice, so that many are equally far, and some at the same place.
std::vector<Vector3> LatticePoints(std::size_t n, int steps, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> step(0, steps);
  std::vector<Vector3> points(n);
  for (Vector3& point : points)
  {
    point = { { 0.5 * step(random), 0.5 * step(random), 0.5 * step(random) } };
  }
  return points;
}

enum class Spread
{
  RoundRobin,
  Slabs,
  OnLast,
  OnEverySecond
};

int OwnerOf(Spread spread, const Vector3& x, std::size_t i, int processes, int steps)
{
  switch (spread)
  {
    case Spread::RoundRobin:
      return static_cast<int>(i) % processes;
    case Spread::Slabs:
      return std::min(static_cast<int>(x[0] * 2.0 * processes / (steps + 1)), processes - 1);
    case Spread::OnEverySecond:
      return static_cast<int>(i) % ((processes + 1) / 2) * 2;
    default:
      return processes - 1;
  }
}

Searcher Spreads(Spread spread, const std::vector<Vector3>& points, int processes, int steps)
{
  Searcher searcher;
  searcher.Sites.resize(static_cast<std::size_t>(processes));
  searcher.Boxes.resize(static_cast<std::size_t>(processes));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const int owner = OwnerOf(spread, points[i], i, processes, steps);
    searcher.Sites[static_cast<std::size_t>(owner)].push_back({ points[i], static_cast<int>(i) });
    searcher.Boxes[static_cast<std::size_t>(owner)].Add(points[i]);
  }
  return searcher;
}

/// Process p asks every n-th of the points from the p-th on; returns the answers by point, and how
/// often a process asked another.
std::vector<Answer> AskAll(const Searcher& searcher, const std::vector<Vector3>& points,
  double radius, std::uint64_t& mostAsked)
{
  const auto processes = static_cast<int>(searcher.Sites.size());
  std::vector<Answer> answers(points.size(), Answer{ Infinite, -1 });
  std::mutex mutex;
  mostAsked = 0;
  ThreadTransport::RunAll(processes,
    [&](SkdTransport& transport)
    {
      const auto rank = static_cast<std::size_t>(transport.GetRank());
      Searcher own = searcher;
      own.Own = transport.GetRank();
      const std::size_t count = (points.size() + processes - 1 - rank) / processes;
      vtkNew<vtkAlgorithm> algorithm;
      SkdLoop loop(algorithm, static_cast<vtkIdType>(count), 0.0, 1.0);
      SkdNearestExchange<Searcher> exchange(transport, own);
      const bool isWhole = exchange.Find(
        count, radius, [&](std::size_t i) { return points[rank + i * processes]; },
        [&](std::size_t i, const Answer& answer, int) { answers[rank + i * processes] = answer; },
        loop);
      EXPECT_TRUE(isWhole);
      const std::lock_guard<std::mutex> lock(mutex);
      mostAsked = std::max(mostAsked, exchange.CountRequests());
    });
  return answers;
}
}

TEST(NearestExchange, IsTheNearestOfAllWithTiesToTheLowestId)
{
  constexpr int steps = 9;
  const std::vector<Vector3> sites = LatticePoints(400, steps, 1);
  const std::vector<Vector3> points = LatticePoints(300, steps + 6, 2);
  std::vector<Site> all;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    all.push_back({ sites[i], static_cast<int>(i) });
  }
  for (const double radius : { Infinite, 1.0, 0.0 })
  {
    for (const Spread spread :
      { Spread::RoundRobin, Spread::Slabs, Spread::OnLast, Spread::OnEverySecond })
    {
      for (const int processes : { 1, 2, 3, 8 })
      {
        std::uint64_t requested;
        const std::vector<Answer> found =
          AskAll(Spreads(spread, sites, processes, steps), points, radius, requested);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          Answer expected;
          FindNearest(all, points[i], radius, expected);
          ASSERT_EQ(expected.Id, found[i].Id) << processes << " processes, point " << i;
          ASSERT_EQ(expected.Distance2, found[i].Distance2);
        }
      }
    }
  }
}

TEST(NearestExchange, WithoutSitesThereIsNoAnswer)
{
  std::uint64_t requested;
  const std::vector<Answer> found =
    AskAll(Spreads(Spread::Slabs, {}, 3, 1), LatticePoints(10, 4, 3), Infinite, requested);
  EXPECT_EQ(found.end(),
    std::find_if(found.begin(), found.end(), [](const Answer& answer) { return answer.Id >= 0; }));
  EXPECT_EQ(0u, requested);
}

// Processes that have a slab each, and points anywhere: each point is sent on about once.
TEST(NearestExchange, AsksAsOftenInManyProcessesAsInFew)
{
  constexpr std::size_t pointsOfEach = 100;
  for (const int processes : { 2, 4, 8, 16, 32 })
  {
    const auto many = static_cast<std::size_t>(processes);
    const int steps = 8 * processes;
    const std::vector<Vector3> sites = LatticePoints(100 * many, steps, 4);
    std::uint64_t requested;
    AskAll(Spreads(Spread::Slabs, sites, processes, steps),
      LatticePoints(pointsOfEach * many, steps, 5), Infinite, requested);
    EXPECT_GT(requested, 0u);
    EXPECT_LE(requested, 5 * pointsOfEach) << processes << " processes";
  }
}

TEST(NearestExchange, AnAbortOfOneEndsAllAfterTheSameRound)
{
  const std::vector<Vector3> points = LatticePoints(20, 4, 6);
  const Searcher searcher = Spreads(Spread::RoundRobin, points, 3, 4);
  ThreadTransport::RunAll(3,
    [&](SkdTransport& transport)
    {
      Searcher own = searcher;
      own.Own = transport.GetRank();
      vtkNew<vtkAlgorithm> algorithm;
      algorithm->SetAbortExecute(transport.GetRank() == 1 ? 1 : 0);
      SkdLoop loop(algorithm, 20, 0.0, 1.0);
      SkdNearestExchange<Searcher> exchange(transport, own);
      EXPECT_FALSE(exchange.Find(
        points.size(), Infinite, [&](std::size_t i) { return points[i]; },
        [](std::size_t, const Answer&, int) {}, loop));
    });
}
