// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitTriangles.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdLoop.h"
#include "Solids/Surfaces/SkdTriangleSplitter.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;

/// The splitting of a whole side.
class SideSplitting
{
public:
  SideSplitting(const SkdSplitSegments& segments, int side)
    : Segments(segments)
    , Side(segments.GetSide(side))
    , Edges(this->Side)
  {
  }

  std::optional<SkdSplitResult> Split(SkdLoop& loop)
  {
    const std::size_t n = this->Side.Set->GetSet().GetTriangles().size();
    std::vector<Work> works = this->ListWorks(n);
    const auto count = static_cast<vtkIdType>(works.size());
    loop.SetTotal(count);
    const bool isDone = loop.For(count,
      [&](vtkIdType begin, vtkIdType end)
      {
        Thread& thread = this->Threads.Local();
        if (!thread.Splitter)
        {
          thread.Splitter =
            std::make_shared<SkdTriangleSplitter>(this->Segments, this->Side, this->Edges);
        }
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->DoWork(works[i], thread);
        }
      });
    for (Thread& thread : this->Threads)
    {
      thread.Splitter.reset();
    }
    this->Segments.GetPoints().ForgetExact(); // few are needed later
    return isDone ? std::make_optional(this->Gather(works, n)) : std::nullopt;
  }

private:
  /// A point in a triangle, of its corners or edges as a bit each of these says.
  struct NewPoint
  {
    std::uint32_t Point; // in SkdSplitPoints
    unsigned Edges;
  };

  /// One that a triangle has made.
  struct MadePoint
  {
    NewPoint At;
    std::uint32_t Triangle;
  };

  /// What a thread makes, and works in.
  struct Thread
  {
    std::shared_ptr<SkdTriangleSplitter> Splitter; // nullptr: not used yet
    std::vector<Corners> Pieces;
    std::vector<NewPoint> Points;
    std::vector<SkdSplitEdge> Curves;
  };

  struct Range
  {
    std::uint32_t Begin;
    std::uint32_t End;

    std::size_t GetSize() const { return this->End - this->Begin; }

    template <class T>
    static std::uint32_t EndOf(const std::vector<T>& items)
    {
      return static_cast<std::uint32_t>(items.size());
    }
  };

  /// A triangle, and what it becomes in what its thread made.
  struct Work
  {
    std::uint32_t Triangle;
    std::uint32_t FirstElement;
    std::uint32_t EndOfElements;
    const Thread* By;
    Range Pieces;
    Range Points;
    Range Curves;
  };

  SkdSplitResult Gather(const std::vector<Work>& works, std::size_t n)
  {
    SkdSplitResult result;
    const std::vector<std::uint32_t> numbers = this->NumberPoints(works, result);
    for (Thread& thread : this->Threads)
    {
      thread.Points = std::vector<NewPoint>();
    }
    const auto before = static_cast<std::uint32_t>(this->Side.Set->GetPoints().size());
    const auto number = [&](std::uint32_t corner)
    { return corner < before ? corner : before + numbers[corner - before]; };
    result.NumberSplit = std::count_if( // neighbours may have points at corners only
      works.begin(), works.end(), [](const Work& work) { return work.Pieces.GetSize() > 1; });
    std::size_t count = n - works.size();
    std::for_each(
      works.begin(), works.end(), [&](const Work& work) { count += work.Pieces.GetSize(); });
    result.Triangles.reserve(count);
    result.Parents.reserve(count);
    std::uint32_t triangle = 0;
    for (const Work& work : works)
    {
      this->AddWhole(triangle, work.Triangle, result);
      for (std::size_t i = work.Pieces.Begin; i < work.Pieces.End; ++i)
      {
        const Corners& piece = work.By->Pieces[i];
        result.Triangles.push_back({ number(piece[0]), number(piece[1]), number(piece[2]) });
        result.Parents.push_back(work.Triangle);
      }
      for (std::size_t i = work.Curves.Begin; i < work.Curves.End; ++i)
      {
        const SkdSplitEdge& edge = work.By->Curves[i];
        result.Curves.push_back(SkdMakeSplitEdge(number(edge.first), number(edge.second)));
      }
      triangle = work.Triangle + 1;
    }
    this->AddWhole(triangle, static_cast<std::uint32_t>(n), result);
    return result;
  }

  /// Adds consecutive triangles that are not split.
  void AddWhole(std::uint32_t first, std::uint32_t end, SkdSplitResult& result) const
  {
    const SkdTriangleSet& set = this->Side.Set->GetSet();
    if (set.GetSearched().empty())
    {
      const auto all = set.GetTriangles().begin();
      result.Triangles.insert(result.Triangles.end(), all + first, all + end);
      result.Parents.resize(result.Triangles.size());
      std::iota(result.Parents.end() - (end - first), result.Parents.end(), first);
      return;
    }
    for (std::uint32_t triangle = first; triangle < end; ++triangle)
    {
      if (set.IsSearched(triangle))
      {
        result.Triangles.push_back(set.GetTriangles()[triangle]);
        result.Parents.push_back(triangle);
      }
    }
  }

  bool HasEdgePoints(std::uint32_t triangle) const
  {
    const auto isSplit = [this](std::uint32_t a, std::uint32_t b)
    {
      const SkdSplitEdges::Row row = this->Edges.Find(a, b);
      return row.First != row.Last;
    };
    const auto [a, b, c] = this->Side.Set->GetCorners(triangle);
    const bool areAny =
      this->Edges.AreAtLower(a) || this->Edges.AreAtLower(b) || this->Edges.AreAtLower(c);
    return areAny && (isSplit(a, b) || isSplit(b, c) || isSplit(c, a));
  }

  std::vector<Work> ListWorks(std::size_t n) const
  {
    std::vector<Work> works;
    const std::vector<SkdSplitElement>& elements = this->Side.Elements;
    std::uint32_t element = 0;
    for (std::uint32_t triangle = 0; triangle < n; ++triangle)
    {
      const std::uint32_t first = element;
      while (element < elements.size() && elements[element].Triangle == triangle)
      {
        ++element;
      }
      if ((first != element || this->HasEdgePoints(triangle)) &&
        this->Side.Set->HasArea(triangle) && this->Side.Set->GetSet().IsSearched(triangle))
      {
        works.push_back({ triangle, first, element, nullptr, {}, {}, {} });
      }
    }
    return works;
  }

  void DoWork(Work& work, Thread& thread) const
  {
    work.By = &thread;
    work.Pieces.Begin = Range::EndOf(thread.Pieces);
    work.Points.Begin = Range::EndOf(thread.Points);
    work.Curves.Begin = Range::EndOf(thread.Curves);
    const SkdSplitElement* const elements = this->Side.Elements.data();
    thread.Splitter->Split(
      work.Triangle, elements + work.FirstElement, elements + work.EndOfElements, thread.Pieces);
    const std::vector<SkdSplitEdge>& curves = thread.Splitter->GetCurves();
    thread.Curves.insert(thread.Curves.end(), curves.begin(), curves.end());
    const SkdSplitCorners& corners = thread.Splitter->GetCorners();
    for (int i = 3; i < corners.Count(); ++i)
    {
      if (this->Side.CornerOf[corners[i].Point] == SkdSplitSegments::None)
      {
        thread.Points.push_back({ corners[i].Point, corners[i].Edges });
      }
    }
    work.Pieces.End = Range::EndOf(thread.Pieces);
    work.Points.End = Range::EndOf(thread.Points);
    work.Curves.End = Range::EndOf(thread.Curves);
  }

  /// The new points, as the first triangle that has each makes it. Returns their numbers.
  std::vector<std::uint32_t> NumberPoints(
    const std::vector<Work>& works, SkdSplitResult& result) const
  {
    std::vector<std::uint32_t> numbers(
      this->Segments.GetPoints().GetNumberOfPoints(), SkdSplitSegments::None);
    std::vector<MadePoint> all;
    for (const Work& work : works)
    {
      for (std::size_t i = work.Points.Begin; i < work.Points.End; ++i)
      {
        const NewPoint& point = work.By->Points[i];
        if (numbers[point.Point] == SkdSplitSegments::None)
        {
          numbers[point.Point] = static_cast<std::uint32_t>(all.size());
          all.push_back({ point, work.Triangle });
        }
      }
    }
    result.Ids.reserve(all.size());
    result.Points.resize(all.size());
    std::vector<std::uint32_t> found;
    found.reserve(all.size());
    for (std::uint32_t point = 0; point < numbers.size(); ++point)
    {
      if (numbers[point] != SkdSplitSegments::None)
      {
        found.push_back(numbers[point]);
        numbers[point] = static_cast<std::uint32_t>(result.Ids.size());
        result.Ids.push_back(point);
      }
    }
    SkdForEach(found.size(), [&](std::size_t i) { result.Points[i] = this->Make(all[found[i]]); });
    return numbers;
  }

  SkdSplitPoint Make(const MadePoint& made) const
  {
    return this->MakePoint(
      this->Segments.GetPoints().GetPosition(made.At.Point), made.At.Edges, made.Triangle);
  }

  /// A point on an edge is a mean of its ends, the same for all triangles that have the edge.
  SkdSplitPoint MakePoint(const skd::Vector3& x, unsigned edges, std::uint32_t triangle) const
  {
    const Corners& corners = this->Side.Set->GetCorners(triangle);
    const auto at = [&](int i) { return this->Side.Set->GetPoints()[corners[i]]; };
    if (edges == 0)
    {
      const auto area = [&](int i)
      {
        const skd::Vector3 normal = Cross(at(1) - at(0), at(2) - at(0));
        return Dot(normal, Cross(at((i + 1) % 3) - x, at((i + 2) % 3) - x));
      };
      const double areas[3] = { area(0), area(1), area(2) };
      const double sum = areas[0] + areas[1] + areas[2];
      return { x, corners, { areas[0] / sum, areas[1] / sum, areas[2] / sum }, triangle };
    }
    const int edge = edges == 1u ? 0 : (edges == 2u ? 1 : 2);
    int a = edge;
    int b = (edge + 1) % 3;
    if (corners[b] < corners[a])
    {
      std::swap(a, b);
    }
    const skd::Vector3 along = at(b) - at(a);
    const double t = std::clamp(Dot(x - at(a), along) / Norm2(along), 0.0, 1.0);
    return { x, { corners[a], corners[b], corners[b] }, { 1.0 - t, t, 0.0 }, triangle };
  }

  const SkdSplitSegments& Segments;
  const SkdSplitSegments::Side& Side;
  const SkdSplitEdges Edges;
  vtkSMPThreadLocal<Thread> Threads;
};
}

std::optional<SkdSplitResult> SkdSplitTriangles(
  const SkdSplitSegments& segments, int side, SkdLoop& loop)
{
  return SideSplitting(segments, side).Split(loop);
}
}
