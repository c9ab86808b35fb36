// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/ClosedVersion.h"

#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <set>

namespace skdtest
{
namespace
{

using Neighbours = std::map<vtkIdType, std::set<vtkIdType>>;

/// The edges that an odd number of triangles use, both ways.
Neighbours OddEdges(const Mesh& mesh)
{
  Neighbours odd;
  const auto flip = [&odd](vtkIdType a, vtkIdType b)
  {
    if (!odd[a].insert(b).second)
    {
      odd[a].erase(b);
    }
  };
  for (const CellSpec& cell : mesh.Cells)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      flip(cell.Points[i], cell.Points[(i + 1) % 3]);
      flip(cell.Points[(i + 1) % 3], cell.Points[i]);
    }
  }
  return odd;
}

/// Takes a loop out of edges of which every point has an even number; none are left: empty.
Ids TakeLoop(Neighbours& edges)
{
  while (!edges.empty() && edges.begin()->second.empty())
  {
    edges.erase(edges.begin());
  }
  if (edges.empty())
  {
    return {};
  }
  Ids path{ edges.begin()->first };
  for (;;)
  {
    const vtkIdType here = path.back();
    const vtkIdType next = *edges[here].begin();
    edges[here].erase(next);
    edges[next].erase(here);
    const auto before = std::find(path.begin(), path.end(), next);
    if (before == path.end())
    {
      path.push_back(next);
      continue;
    }
    // What leads to the loop is put back.
    for (auto at = path.begin(); at != before; ++at)
    {
      edges[*at].insert(*(at + 1));
      edges[*(at + 1)].insert(*at);
    }
    return { before, path.end() };
  }
}

Mesh EachTriangleOnce(const Mesh& mesh)
{
  Mesh once;
  once.Points = mesh.Points;
  std::set<Ids> known;
  for (const CellSpec& cell : mesh.Cells)
  {
    Ids ids = cell.Points;
    std::sort(ids.begin(), ids.end());
    const bool hasArea = std::adjacent_find(ids.begin(), ids.end()) == ids.end();
    if (hasArea && known.insert(ids).second)
    {
      once.Cells.push_back(cell);
    }
  }
  return once;
}

struct Lattice3
{
  Bounds Box;
  double Step;
  int Size[3];

  Point At(int id) const
  {
    return { this->Box[0] + this->Step * (id % this->Size[0]),
      this->Box[2] + this->Step * (id / this->Size[0] % this->Size[1]),
      this->Box[4] + this->Step * (id / this->Size[0] / this->Size[1]) };
  }

  template <class Visit>
  void ForEachNeighbour(int id, const Visit& visit) const
  {
    const int strides[3] = { 1, this->Size[0], this->Size[0] * this->Size[1] };
    for (int axis = 0; axis < 3; ++axis)
    {
      const int index = id / strides[axis] % this->Size[axis];
      if (index > 0)
      {
        visit(id - strides[axis]);
      }
      if (index + 1 < this->Size[axis])
      {
        visit(id + strides[axis]);
      }
    }
  }
};

/// Whether points of the lattice are farther from the surface than the radius.
std::vector<char> FindFree(const Lattice3& lattice, vtkPolyData* surface, double radius)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  std::vector<char> isFree(
    static_cast<std::size_t>(lattice.Size[0]) * lattice.Size[1] * lattice.Size[2]);
  for (std::size_t id = 0; id < isFree.size(); ++id)
  {
    Point x = lattice.At(static_cast<int>(id));
    double nearest[3], dist2;
    vtkIdType cell;
    int subId;
    isFree[id] =
      locator->FindClosestPointWithinRadius(x.data(), radius, nearest, cell, subId, dist2) == 0;
  }
  return isFree;
}

}

ClosedVersion::ClosedVersion(const Mesh& triangles)
  : Whole(EachTriangleOnce(triangles))
{
  Neighbours edges = OddEdges(this->Whole);
  this->Fans.Points = this->Whole.Points;
  for (Ids loop = TakeLoop(edges); !loop.empty(); loop = TakeLoop(edges))
  {
    Point middle = { 0, 0, 0 };
    for (const vtkIdType id : loop)
    {
      middle = middle + (1.0 / static_cast<double>(loop.size())) * this->Fans.Points[id];
    }
    const vtkIdType top = this->Fans.Add(middle);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      this->Fans.Add(VTK_TRIANGLE, { loop[i], loop[(i + 1) % loop.size()], top });
    }
  }
  this->Whole.Points = this->Fans.Points;
  this->Whole.Cells.insert(
    this->Whole.Cells.end(), this->Fans.Cells.begin(), this->Fans.Cells.end());
}

BallRadius::BallRadius(vtkPolyData* surface, double radius)
{
  Lattice3 lattice{ {}, radius, {} }; // halfway between free points it still is half as far
  surface->GetBounds(lattice.Box.data());
  lattice.Box = Grown(lattice.Box, 3.0 * radius);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = lattice.Box[2 * axis + 1] - lattice.Box[2 * axis];
    lattice.Size[axis] = static_cast<int>(length / lattice.Step) + 1;
  }
  const std::vector<char> isFree = FindFree(lattice, surface, radius);
  std::vector<bool> isCovered(isFree.size(), false);
  std::vector<int> queue{ 0 }; // a corner, which is outside
  isCovered[0] = true;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    lattice.ForEachNeighbour(queue[i],
      [&](int next)
      {
        if (isFree[static_cast<std::size_t>(next)] && !isCovered[static_cast<std::size_t>(next)])
        {
          isCovered[static_cast<std::size_t>(next)] = true;
          queue.push_back(next);
        }
      });
  }
  for (std::size_t id = 0; id < isFree.size(); ++id)
  {
    if (isFree[id])
    {
      this->Points.push_back(lattice.At(static_cast<int>(id)));
      this->IsCovered.push_back(isCovered[id]);
    }
  }
}

}
