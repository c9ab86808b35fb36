// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdHoleCaps.h"

#include "Bodies/SkdEdgeTable.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace skdtree
{
SkdHoleCaps::SkdHoleCaps(
  const std::vector<skd::Vector3>& points, const std::vector<SkdTriangleIds>& triangles)
  : Points(points)
{
  this->CloseAll(this->FindOpen(triangles));
}

std::vector<SkdHoleCaps::Edge> SkdHoleCaps::FindOpen(
  const std::vector<SkdTriangleIds>& triangles) const
{
  using Use = skd::EdgeUse<vtkIdType>;
  std::vector<Edge> open;
  SkdMakeEdgeTable(triangles, this->Points.size())
    .ForEach(
      [&open](vtkIdType low, const Use* first, const Use* last)
      {
        const auto forward =
          std::count_if(first, last, [](const Use& use) { return use.IsForward; });
        if ((last - first) % 2 != 0 && low != first->High)
        {
          open.push_back(
            2 * forward > last - first ? Edge{ low, first->High } : Edge{ first->High, low });
        }
      });
  // Where loops begin, and which they are where several meet, does not depend on ids.
  const auto isBefore = [](const skd::Vector3& a, const skd::Vector3& b)
  { return std::lexicographical_compare(a.X, a.X + 3, b.X, b.X + 3); };
  std::sort(open.begin(), open.end(),
    [&](const Edge& a, const Edge& b)
    {
      const skd::Vector3& from = this->Points[a.From];
      const skd::Vector3& other = this->Points[b.From];
      return isBefore(from, other) ||
        (!isBefore(other, from) && isBefore(this->Points[a.To], this->Points[b.To]));
    });
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
  std::unordered_map<vtkIdType, std::size_t> positionOf;
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
    positionOf[at] = path.size();
    visited.push_back(at);
    path.push_back(edges[edge]);
    return edges[edge].From == at ? edges[edge].To : edges[edge].From;
  };
  for (const Edge& first : edges)
  {
    for (vtkIdType at = follow(first.From); at >= 0; at = follow(at))
    {
      const auto position = positionOf.find(at);
      if (position != positionOf.end())
      {
        const auto begin = static_cast<std::ptrdiff_t>(position->second);
        this->Close({ path.begin() + begin, path.end() });
        path.erase(path.begin() + begin, path.end());
        std::for_each(
          visited.begin() + begin, visited.end(), [&](vtkIdType id) { positionOf.erase(id); });
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
}
