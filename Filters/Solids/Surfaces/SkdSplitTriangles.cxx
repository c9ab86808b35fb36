// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitTriangles.h"

#include "Pipeline/SkdLoop.h"
#include "Solids/Surfaces/SkdTriangleSplitter.h"

#include <algorithm>
#include <array>
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
    , IsOnSplitEdge(this->Side.Set->GetPoints().size(), false)
  {
    for (const SkdSplitEdgePoint& point : this->Side.EdgePoints)
    {
      this->IsOnSplitEdge[point.From] = this->IsOnSplitEdge[point.To] = true;
    }
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
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->DoWork(works[i]);
        }
      });
    return isDone ? std::make_optional(this->Gather(works, n)) : std::nullopt;
  }

private:
  struct NewPoint
  {
    std::uint32_t Id;
    SkdSplitPoint Point;
  };
  struct Work
  {
    std::uint32_t Triangle;
    std::vector<Corners> Pieces;
    std::vector<NewPoint> Points;
    std::vector<SkdSplitEdge> Curves;
  };

  SkdSplitResult Gather(std::vector<Work>& works, std::size_t n) const
  {
    SkdSplitResult result;
    this->NumberPoints(works, result);
    result.NumberSplit = std::count_if( // neighbours may have points at corners only
      works.begin(), works.end(), [](const Work& work) { return work.Pieces.size() > 1; });
    std::size_t count = n - works.size();
    std::for_each(
      works.begin(), works.end(), [&](const Work& work) { count += work.Pieces.size(); });
    result.Triangles.reserve(count);
    result.Parents.reserve(count);
    std::uint32_t triangle = 0;
    for (const Work& work : works)
    {
      this->AddWhole(triangle, work.Triangle, result);
      result.Triangles.insert(result.Triangles.end(), work.Pieces.begin(), work.Pieces.end());
      result.Parents.insert(result.Parents.end(), work.Pieces.size(), work.Triangle);
      result.Curves.insert(result.Curves.end(), work.Curves.begin(), work.Curves.end());
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
    const Corners& corners = this->Side.Set->GetCorners(triangle);
    const std::array<bool, 3> isOn{ this->IsOnSplitEdge[corners[0]],
      this->IsOnSplitEdge[corners[1]], this->IsOnSplitEdge[corners[2]] };
    return (isOn[0] && isOn[1] && this->IsSplitEdge(corners[0], corners[1])) ||
      (isOn[1] && isOn[2] && this->IsSplitEdge(corners[1], corners[2])) ||
      (isOn[2] && isOn[0] && this->IsSplitEdge(corners[2], corners[0]));
  }

  bool IsSplitEdge(std::uint32_t a, std::uint32_t b) const
  {
    return std::binary_search(this->Side.EdgePoints.begin(), this->Side.EdgePoints.end(),
      SkdSplitEdgePoint{ std::min(a, b), std::max(a, b), 0 },
      [](const SkdSplitEdgePoint& first, const SkdSplitEdgePoint& second)
      { return first.From != second.From ? first.From < second.From : first.To < second.To; });
  }

  std::vector<Work> ListWorks(std::size_t n) const
  {
    std::vector<Work> works;
    auto element = this->Side.Elements.begin();
    for (std::uint32_t triangle = 0; triangle < n; ++triangle)
    {
      const auto first = element;
      while (element != this->Side.Elements.end() && element->Triangle == triangle)
      {
        ++element;
      }
      if ((first != element || this->HasEdgePoints(triangle)) &&
        this->Side.Set->HasArea(triangle) && this->Side.Set->GetSet().IsSearched(triangle))
      {
        works.push_back({ triangle, {}, {}, {} });
      }
    }
    return works;
  }

  void DoWork(Work& work) const
  {
    const SkdSplitElement least{ work.Triangle, 0, 0, 0 };
    const SkdSplitElement next{ work.Triangle + 1, 0, 0, 0 };
    const SkdSplitElement* elements = this->Side.Elements.data();
    const SkdSplitElement* end = elements + this->Side.Elements.size();
    SkdTriangleSplitter splitter(this->Segments, this->Side, work.Triangle);
    work.Pieces =
      splitter.Split(std::lower_bound(elements, end, least), std::lower_bound(elements, end, next));
    work.Curves = splitter.GetCurves();
    const SkdSplitCorners& points = splitter.GetCorners();
    for (int i = 3; i < points.Count(); ++i)
    {
      const std::uint32_t id = splitter.IdOf(i);
      if (id >= this->Side.Set->GetPoints().size())
      {
        work.Points.push_back({ id, this->MakePoint(points[i], work.Triangle) });
      }
    }
  }

  /// A point on an edge is a mean of its ends, the same for all triangles that have the edge.
  SkdSplitPoint MakePoint(const SkdSplitCorner& local, std::uint32_t triangle) const
  {
    const Corners& corners = this->Side.Set->GetCorners(triangle);
    const auto at = [&](int i) { return this->Side.Set->GetPoints()[corners[i]]; };
    if (local.Edges == 0)
    {
      const auto area = [&](int i)
      {
        const skd::Vector3 normal = Cross(at(1) - at(0), at(2) - at(0));
        return Dot(normal, Cross(at((i + 1) % 3) - local.X, at((i + 2) % 3) - local.X));
      };
      const double areas[3] = { area(0), area(1), area(2) };
      const double sum = areas[0] + areas[1] + areas[2];
      return { local.X, corners, { areas[0] / sum, areas[1] / sum, areas[2] / sum }, triangle };
    }
    const int edge = local.Edges == 1u ? 0 : (local.Edges == 2u ? 1 : 2);
    int a = edge;
    int b = (edge + 1) % 3;
    if (corners[b] < corners[a])
    {
      std::swap(a, b);
    }
    const skd::Vector3 along = at(b) - at(a);
    const double t = std::clamp(Dot(local.X - at(a), along) / Norm2(along), 0.0, 1.0);
    return { local.X, { corners[a], corners[b], corners[b] }, { 1.0 - t, t, 0.0 }, triangle };
  }

  /// Numbers the new points on from the set's, also in pieces and curves.
  void NumberPoints(std::vector<Work>& works, SkdSplitResult& result) const
  {
    std::vector<NewPoint> all;
    for (const Work& work : works)
    {
      all.insert(all.end(), work.Points.begin(), work.Points.end());
    }
    std::stable_sort(
      all.begin(), all.end(), [](const NewPoint& a, const NewPoint& b) { return a.Id < b.Id; });
    all.erase(std::unique(all.begin(), all.end(),
                [](const NewPoint& a, const NewPoint& b) { return a.Id == b.Id; }),
      all.end());
    const auto before = static_cast<std::uint32_t>(this->Side.Set->GetPoints().size());
    for (const NewPoint& point : all)
    {
      result.Points.push_back(point.Point);
      result.Ids.push_back(point.Id - before);
    }
    const auto renumber = [&](std::uint32_t& corner)
    {
      if (corner >= before)
      {
        const auto at = std::lower_bound(all.begin(), all.end(), corner,
          [](const NewPoint& a, std::uint32_t id) { return a.Id < id; });
        corner = before + static_cast<std::uint32_t>(at - all.begin());
      }
    };
    for (Work& work : works)
    {
      for (Corners& piece : work.Pieces)
      {
        std::for_each(piece.begin(), piece.end(), renumber);
      }
      for (SkdSplitEdge& edge : work.Curves)
      {
        renumber(edge.first);
        renumber(edge.second);
        edge = SkdMakeSplitEdge(edge.first, edge.second);
      }
    }
  }

  const SkdSplitSegments& Segments;
  const SkdSplitSegments::Side& Side;
  std::vector<bool> IsOnSplitEdge; // of corners
};
}

std::optional<SkdSplitResult> SkdSplitTriangles(
  const SkdSplitSegments& segments, int side, SkdLoop& loop)
{
  return SideSplitting(segments, side).Split(loop);
}
}
