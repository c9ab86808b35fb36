// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFlatFace.h"

#include "Core/Geometry/Box.h"
#include "Core/Geometry/Polygons/DelaunayEdge.h"
#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace skdtree
{
namespace
{
/// Of those that are equal to within rounding the first.
int LargestAxisOf(const skd::Vector3& normal)
{
  constexpr double more = 1.0 + 1e-9;
  int largest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    largest = std::abs(normal[axis]) > more * std::abs(normal[largest]) ? axis : largest;
  }
  return largest;
}
}

//------------------------------------------------------------------------------
// Returns whether as many edges leave each point as reach it, and no edge is there twice or in both
// directions.
bool SkdFlatFace::ListPoints()
{
  std::sort(this->Edges.begin(), this->Edges.end());
  this->Points.clear();
  this->Reached.clear();
  bool isSimple = this->Edges.size() > 2;
  for (const Edge& edge : this->Edges)
  {
    this->Points.push_back(edge.first);
    this->Reached.push_back(edge.second);
    isSimple = isSimple && edge.first != edge.second &&
      !std::binary_search(this->Edges.begin(), this->Edges.end(), Edge{ edge.second, edge.first });
  }
  std::sort(this->Reached.begin(), this->Reached.end());
  isSimple = isSimple && this->Points == this->Reached &&
    std::adjacent_find(this->Edges.begin(), this->Edges.end()) == this->Edges.end();
  if (!this->Within.empty())
  {
    for (const Edge& edge : this->Within)
    {
      this->Points.insert(this->Points.end(), { edge.first, edge.second });
    }
    std::sort(this->Points.begin(), this->Points.end());
  }
  this->Points.erase(std::unique(this->Points.begin(), this->Points.end()), this->Points.end());
  return isSimple;
}

// Numbers follow the coordinates: which of several Delaunay triangulations is found depends on the
// order in which points are added, and must not depend on how a mesh has numbered them.
void SkdFlatFace::SetPositions()
{
  const std::vector<skd::Vector3>& given = this->Given;
  this->Order.resize(given.size());
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  std::sort(this->Order.begin(), this->Order.end(),
    [&given](std::uint32_t a, std::uint32_t b) {
      return std::lexicographical_compare(given[a].X, given[a].X + 3, given[b].X, given[b].X + 3);
    });
  this->Numbers.resize(given.size());
  this->PointOf.assign(3, 0);
  this->Positions.resize(3); // around all, see Surround
  for (const std::uint32_t i : this->Order)
  {
    this->Numbers[i] = static_cast<int>(this->Positions.size());
    this->PointOf.push_back(this->Points[i]);
    this->Positions.push_back(given[i]);
  }
}

int SkdFlatFace::NumberOf(std::uint32_t point) const
{
  const auto at = std::lower_bound(this->Points.begin(), this->Points.end(), point);
  return this->Numbers[static_cast<std::size_t>(at - this->Points.begin())];
}

// The edges by the numbers of their ends.
void SkdFlatFace::ListEnds()
{
  this->ByNumber.clear();
  for (const Edge& edge : this->Edges)
  {
    this->ByNumber.emplace_back(this->NumberOf(edge.first), this->NumberOf(edge.second));
  }
  std::sort(this->ByNumber.begin(), this->ByNumber.end());
}

//------------------------------------------------------------------------------
// The first three positions are a triangle that has all others well inside, and turns left.
void SkdFlatFace::Surround(int axis, int sign)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  skd::Box3 box;
  std::for_each(this->Positions.begin() + 3, this->Positions.end(),
    [&box](const skd::Vector3& x) { box.Add(x); });
  const skd::Vector3 middle = 0.5 * (box.Min + box.Max);
  const double size = std::max(box.Max[u] - box.Min[u], box.Max[v] - box.Min[v]);
  const auto at = [&](double alongU, double alongV)
  {
    skd::Vector3 x = middle;
    x[u] += alongU * size;
    x[v] += alongV * size;
    return x;
  };
  this->Positions[0] = at(-4.0, -2.0);
  this->Positions[1] = at(4.0, -2.0);
  this->Positions[2] = at(0.0, 4.0);
  if (sign < 0)
  {
    std::swap(this->Positions[0], this->Positions[1]);
  }
}

//------------------------------------------------------------------------------
bool SkdFlatFace::Triangulate(const skd::Vector3& normal)
{
  const int axis = LargestAxisOf(normal);
  const int sign = normal[axis] < 0.0 ? -1 : 1;
  this->Surround(axis, sign);
  this->ListEnds();
  const auto& x = this->Positions;
  const auto orient = [&](int a, int b, int c)
  { return sign * skd::Orient2D(x[a], x[b], x[c], axis); };
  const auto isBetter = [&](int a, int b, int c, int d)
  { return skd::IsOtherEdgeDelaunay(x[a], x[b], x[c], x[d]); };
  const auto count = static_cast<int>(x.size());
  skd::ConstrainedTriangulation<decltype(orient), decltype(isBetter)> made(
    count, orient, isBetter, std::move(this->Memory));
  int next = 3;
  while (next < count && made.Add(next) == next)
  {
    ++next;
  }
  bool isMade = next == count;
  if (isMade)
  {
    for (const Ends& edge : this->ByNumber)
    {
      made.Constrain(edge.first, edge.second);
    }
    for (const Edge& edge : this->Within)
    {
      made.Constrain(this->NumberOf(edge.first), this->NumberOf(edge.second));
    }
    isMade = this->FindWindings(made.GetMesh()) && this->TakeInside(made.GetMesh());
  }
  this->Memory = made.TakeMemory();
  return isMade;
}

//------------------------------------------------------------------------------
namespace
{
constexpr int Unknown = std::numeric_limits<int>::max();

std::size_t NumberOfSide(const skd::FlipMesh::Side& side)
{
  return 3 * static_cast<std::size_t>(side.At) + static_cast<std::size_t>(side.Index);
}
}

// How often edges go around each triangle, to the left. False if an edge is missing. Triangles with
// one of the first three corners are outside of all.
bool SkdFlatFace::FindWindings(const skd::FlipMesh& mesh)
{
  const std::vector<skd::FlipMesh::Triangle>& all = mesh.GetAll();
  this->AreEdges.assign(3 * all.size(), 0);
  for (const Ends& edge : this->ByNumber)
  {
    const skd::FlipMesh::Side left = mesh.FindSide(edge.first, edge.second);
    if (left.At < 0)
    {
      return false;
    }
    this->AreEdges[NumberOfSide(left)] = 1;
  }
  this->Windings.assign(all.size(), Unknown);
  const auto outside = std::find_if(all.begin(), all.end(),
    [](const skd::FlipMesh::Triangle& triangle)
    { return *std::min_element(triangle.Corners.begin(), triangle.Corners.end()) < 3; });
  this->Open.clear();
  if (outside != all.end())
  {
    this->Open.push_back(static_cast<int>(outside - all.begin()));
    this->Windings[outside - all.begin()] = 0;
  }
  while (!this->Open.empty())
  {
    const int at = this->Open.back();
    this->Open.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const skd::FlipMesh::Side beyond = mesh.Across({ at, i });
      if (beyond.At >= 0 && this->Windings[beyond.At] == Unknown)
      {
        this->Windings[beyond.At] = this->Windings[at] + this->AreEdges[NumberOfSide(beyond)] -
          this->AreEdges[NumberOfSide({ at, i })];
        this->Open.push_back(beyond.At);
      }
    }
  }
  return true;
}

bool SkdFlatFace::TakeInside(const skd::FlipMesh& mesh)
{
  this->Taken.Left.clear();
  this->Taken.Right.clear();
  for (std::size_t triangle = 0; triangle < mesh.GetAll().size(); ++triangle)
  {
    const int winding = this->Windings[triangle];
    if (winding != 0 && std::abs(winding) != 1)
    {
      return false;
    }
    if (winding != 0)
    {
      const std::array<int, 3>& of = mesh.GetAll()[triangle].Corners;
      const Corners corners{ this->PointOf[of[0]], this->PointOf[of[1]], this->PointOf[of[2]] };
      winding > 0 ? this->Taken.Left.push_back(corners)
                  : this->Taken.Right.push_back({ corners[0], corners[2], corners[1] });
    }
  }
  return true;
}
}
