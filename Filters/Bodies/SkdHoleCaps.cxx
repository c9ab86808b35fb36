// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdHoleCaps.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

SkdHoleCaps::SkdHoleCaps(
  const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles)
  : Points(points)
{
  this->CloseAll(FindOpen(triangles));
}

std::vector<SkdHoleCaps::Edge> SkdHoleCaps::FindOpen(const std::vector<SkdTriangleIds>& triangles)
{
  struct Side
  {
    vtkIdType Least;
    vtkIdType Most;
    bool IsForward;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const SkdTriangleIds& ids : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType from = ids[k], to = ids[(k + 1) % 3];
      sides.push_back({ std::min(from, to), std::max(from, to), from < to });
    }
  }
  vtkSMPTools::Sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.Least, a.Most, a.IsForward) < std::tie(b.Least, b.Most, b.IsForward); });
  std::vector<Edge> open;
  for (auto first = sides.begin(); first != sides.end();)
  {
    const auto end = std::find_if(first, sides.end(),
      [&](const Side& side) { return side.Least != first->Least || side.Most != first->Most; });
    const bool isForward = (first + (end - first) / 2)->IsForward;
    if ((end - first) % 2 != 0 && first->Least != first->Most)
    {
      open.push_back(
        isForward ? Edge{ first->Least, first->Most } : Edge{ first->Most, first->Least });
    }
    first = end;
  }
  return open;
}

// An even number of edges meets at each point, so that a path ends where it began.
void SkdHoleCaps::CloseAll(const std::vector<Edge>& edges)
{
  std::unordered_map<vtkIdType, std::vector<std::size_t>> edgesAt;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    edgesAt[edges[i].From].push_back(i);
    edgesAt[edges[i].To].push_back(i);
  }
  std::vector<char> isUsed(edges.size(), 0);
  std::vector<Edge> path;
  std::vector<vtkIdType> visited; // where each edge of the path begins
  std::unordered_map<vtkIdType, std::size_t> placeOf;
  const auto follow = [&](vtkIdType at)
  {
    std::vector<std::size_t>& those = edgesAt[at];
    while (!those.empty() && isUsed[those.back()])
    {
      those.pop_back();
    }
    if (those.empty())
    {
      return vtkIdType(-1);
    }
    const std::size_t edge = those.back();
    isUsed[edge] = 1;
    placeOf[at] = path.size();
    visited.push_back(at);
    path.push_back(edges[edge]);
    return edges[edge].From == at ? edges[edge].To : edges[edge].From;
  };
  for (const Edge& first : edges)
  {
    for (vtkIdType at = follow(first.From); at >= 0; at = follow(at))
    {
      const auto place = placeOf.find(at);
      if (place != placeOf.end())
      {
        const auto begin = static_cast<std::ptrdiff_t>(place->second);
        this->Close({ path.begin() + begin, path.end() });
        path.erase(path.begin() + begin, path.end());
        std::for_each(
          visited.begin() + begin, visited.end(), [&](vtkIdType id) { placeOf.erase(id); });
        visited.erase(visited.begin() + begin, visited.end());
      }
    }
  }
}

void SkdHoleCaps::Close(const std::vector<Edge>& loop)
{
  if (loop.size() == 3)
  {
    const Edge& first = loop.front();
    const vtkIdType other =
      loop[1].From == first.From || loop[1].From == first.To ? loop[1].To : loop[1].From;
    this->Triangles.push_back({ first.To, first.From, other });
    return;
  }
  const skd::Vector3 origin = this->Points[loop.front().From];
  skd::Vector3 sum{ { 0.0, 0.0, 0.0 } };
  double length = 0.0;
  for (const Edge& edge : loop)
  {
    const skd::Vector3& from = this->Points[edge.From];
    const skd::Vector3& to = this->Points[edge.To];
    const double weight = skd::Norm(to - from);
    sum = sum + 0.5 * weight * ((from - origin) + (to - origin));
    length += weight;
  }
  const auto centre = static_cast<vtkIdType>(this->Points.size());
  this->Points.push_back(length > 0.0 ? origin + (1.0 / length) * sum : origin);
  for (const Edge& edge : loop)
  {
    this->Triangles.push_back({ edge.To, edge.From, centre });
  }
}
