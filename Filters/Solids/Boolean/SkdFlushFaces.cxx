// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFlushFaces.h"

#include "Bodies/SkdEdgeTable.h"
#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/DisjointSets.h"
#include "Core/Search/Tree/PackedRTree.h"
#include "Solids/Boolean/SkdFacingFacets.h"
#include "Solids/Boolean/SkdRoundedPlane.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
using Triangle = SkdFlushFaces::Triangle;
using Pair = std::pair<std::uint32_t, std::uint32_t>;
constexpr std::uint32_t None = 0xffffffffu;

/// Whether the plane of a triangle means something, to within a tolerance of its points.
bool IsWide(double width, double tolerance)
{
  constexpr double least = 256.0; // tolerances
  return width > least * tolerance;
}

/// Whether one is in the plane of the other, that of the wider one, to the rounding of doubles.
bool AreInOnePlaneOfDoubles(const Triangle& first, const Triangle& second)
{
  const bool isFirstWider = SkdWidthOf(first) >= SkdWidthOf(second);
  return SkdRoundedPlane(
    isFirstWider ? first : second, std::max(SkdToleranceOf(first), SkdToleranceOf(second)))
    .Contains(isFirstWider ? second : first);
}
}

//------------------------------------------------------------------------------
SkdFlushFaces::SkdFlushFaces(
  const std::vector<int>& bits, const SkdTriangleSet& set, const std::vector<std::uint32_t>* among)
  : Bits(bits)
  , Set(set)
  , Among(among)
{
  this->Weld();
  this->FindErrors();
  if (!among)
  {
    this->Edges = SkdMakeEdgeTable(this->Triangles, this->Points.size());
    this->FindBodies();
  }
  this->FindPairs();
}

bool SkdFlushFaces::AreSomeOff() const
{
  return std::any_of(this->Pairs.begin(), this->Pairs.end(),
    [this](const Pair& pair)
    {
      return this->MayCross(pair.first, pair.second) &&
        !AreInOnePlaneOfDoubles(this->PositionsOf(pair.first), this->PositionsOf(pair.second));
    });
}

/// On each other, but for folds of one block, or side by side in two blocks: with a common point
/// they meet in it, or along an edge that both have.
bool SkdFlushFaces::MayCross(std::uint32_t a, std::uint32_t b) const
{
  const std::size_t common = this->CountCommonPoints(a, b);
  return this->BlockOf(a) == this->BlockOf(b)
    ? common < 2 && this->AreOverlapping(a, b, 1.0)
    : this->AreOverlapping(a, b, common == 0 ? -1.0 : 1.0);
}

//------------------------------------------------------------------------------
void SkdFlushFaces::FindErrors()
{
  constexpr double roundings = 16.0;
  constexpr double ofDoubles = 64.0 * std::numeric_limits<double>::epsilon();
  this->Errors.resize(this->Triangles.size());
  SkdForEach(static_cast<vtkIdType>(this->Triangles.size()),
    [this](vtkIdType i)
    {
      const auto triangle = static_cast<std::uint32_t>(i);
      this->Errors[triangle] = (this->IsExact(triangle) ? ofDoubles : roundings * Rounding) *
        LargestOf(this->PositionsOf(triangle));
    });
}

/// `width` is that of the wider one.
bool SkdFlushFaces::IsInPlaneOf(std::uint32_t triangle, std::uint32_t wider, double width) const
{
  const Triangle plane = this->PositionsOf(wider);
  const skd::Vector3 area = AreaOf(plane);
  const double size = Norm(area);
  const double tolerance = size > 0.0
    ? Along((1.0 / size) * area, Greatest(this->Errors[triangle], this->Errors[wider]))
    : 0.0;
  return size > 0.0 && IsWide(width, tolerance) &&
    SkdRoundedPlane(plane, tolerance).Contains(this->PositionsOf(triangle));
}

/// In that of the wider one.
bool SkdFlushFaces::AreInOnePlane(std::uint32_t a, std::uint32_t b) const
{
  const double first = SkdWidthOf(this->PositionsOf(a));
  const double second = SkdWidthOf(this->PositionsOf(b));
  return first >= second ? this->IsInPlaneOf(b, a, first) : this->IsInPlaneOf(a, b, second);
}

bool SkdFlushFaces::AreAllIn(
  const std::vector<std::uint32_t>& triangles, const SkdFacePlane& plane) const
{
  return std::all_of(triangles.begin(), triangles.end(),
    [&](std::uint32_t triangle)
    {
      const double tolerance =
        std::max(plane.Tolerance, Along(plane.Normal, this->Errors[triangle]));
      const Triangle positions = this->PositionsOf(triangle);
      return std::all_of(positions.begin(), positions.end(),
        [&](const skd::Vector3& x) { return std::abs(plane.HeightOf(x)) <= tolerance; });
    });
}

std::size_t SkdFlushFaces::CountCommonPoints(std::uint32_t a, std::uint32_t b) const
{
  const Corners& first = this->Triangles[a];
  const Corners& second = this->Triangles[b];
  return static_cast<std::size_t>(std::count_if(first.begin(), first.end(),
    [&second](std::uint32_t point)
    { return std::find(second.begin(), second.end(), point) != second.end(); }));
}

skd::Box3 SkdFlushFaces::BoxOf(std::uint32_t triangle) const
{
  skd::Box3 box;
  for (const skd::Vector3& x : this->PositionsOf(triangle))
  {
    box.Add(x);
  }
  box.Min = box.Min - this->Errors[triangle];
  box.Max = box.Max + this->Errors[triangle];
  return box;
}

skd::Vector3 SkdFlushFaces::LargestOf(const Triangle& positions)
{
  skd::Vector3 largest{};
  for (const skd::Vector3& x : positions)
  {
    largest = Greatest(largest, { { std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) } });
  }
  return largest;
}

double SkdFlushFaces::Along(const skd::Vector3& normal, const skd::Vector3& errors)
{
  return std::abs(normal[0]) * errors[0] + std::abs(normal[1]) * errors[1] +
    std::abs(normal[2]) * errors[2];
}

/// Calls visit(a, b) for triangles of a block that have an edge which no others of it have.
template <class Visit>
void SkdFlushFaces::ForEachNeighbours(const Visit& visit) const
{
  this->Edges.ForEach(
    [&](std::uint32_t, const skd::EdgeUse<>* first, const skd::EdgeUse<>* last)
    {
      for (const skd::EdgeUse<>* use = first; use + 1 < last; ++use)
      {
        const auto isOfBlock = [this, block = this->BlockOf(use->Triangle)](
                                 const skd::EdgeUse<>& other)
        { return this->BlockOf(other.Triangle) == block; };
        if (isOfBlock(use[1]) && std::count_if(first, last, isOfBlock) == 2)
        {
          visit(use[0].Triangle, use[1].Triangle);
        }
      }
    });
}

void SkdFlushFaces::Weld()
{
  const SkdTriangleSet::PointList& points = this->Set.GetPoints();
  SkdWeld weld(points.size());
  this->PointOf.reserve(points.size());
  for (const skd::Vector3& x : points)
  {
    this->PointOf.push_back(static_cast<std::uint32_t>(weld.GetId(x.X)));
  }
  this->Points = weld.GetPoints();
  this->Triangles.reserve(this->Set.GetTriangles().size());
  for (const auto& [a, b, c] : this->Set.GetTriangles())
  {
    this->Triangles.push_back({ this->PointOf[a], this->PointOf[b], this->PointOf[c] });
  }
}

void SkdFlushFaces::FindBodies()
{
  skd::DisjointSets<> sets(this->Triangles.size());
  this->ForEachNeighbours([&sets](std::uint32_t a, std::uint32_t b) { sets.Unite(a, b); });
  this->BodyOf = sets.Number();
  this->NumberOfBodies =
    this->BodyOf.empty() ? 0 : *std::max_element(this->BodyOf.begin(), this->BodyOf.end()) + 1;
}

/// The triangles whose boxes overlap the boxes of bodies that are near theirs.
std::vector<std::uint32_t> SkdFlushFaces::ListNear() const
{
  const auto n = static_cast<std::uint32_t>(this->Triangles.size());
  std::vector<skd::Box3> bodies(this->NumberOfBodies);
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    bodies[this->BodyOf[triangle]].Add(this->BoxOf(triangle));
  }
  const skd::PackedRTree tree(bodies);
  std::vector<skd::Box3> others(bodies.size()); // around those near each body
  for (std::uint32_t body = 0; body < bodies.size(); ++body)
  {
    tree.ForEachOverlapping(bodies[body],
      [&](std::uint32_t other)
      {
        if (other != body && bodies[body].Overlaps(bodies[other]))
        {
          others[body].Add(bodies[other]);
        }
      });
  }
  std::vector<std::uint32_t> near;
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    if (this->BoxOf(triangle).Overlaps(others[this->BodyOf[triangle]]))
    {
      near.push_back(triangle);
    }
  }
  return near;
}

/// As seen along their normal, by more than so many tolerances.
bool SkdFlushFaces::AreOverlapping(std::uint32_t a, std::uint32_t b, double tolerances) const
{
  const Triangle x = this->PositionsOf(a);
  const skd::Vector3 area = AreaOf(x);
  const double size = Norm(area);
  return size > 0.0 &&
    SkdDoOverlap(
      x, this->PositionsOf(b), area, tolerances * Along((1.0 / size) * area, this->Errors[a]));
}

bool SkdFlushFaces::AreOfTwoBodies(std::uint32_t a, std::uint32_t b) const
{
  return this->Among ? this->BlockOf(a) != this->BlockOf(b) ||
      (this->CountCommonPoints(a, b) == 0 && this->AreOverlapping(a, b, 1.0))
                     : this->BodyOf[a] != this->BodyOf[b];
}

/// Of one body, on each other and facing away from each other, or towards each other, in one plane.
bool SkdFlushFaces::AreSidesOfAPlate(std::uint32_t a, std::uint32_t b) const
{
  return !this->Among && this->CountCommonPoints(a, b) == 0 &&
    Dot(AreaOf(this->PositionsOf(a)), AreaOf(this->PositionsOf(b))) < 0.0 &&
    this->AreInOnePlane(a, b) && this->AreOverlapping(a, b, 1.0);
}

/// Pairs of wide triangles of two bodies, one of which at least may be moved.
void SkdFlushFaces::FindPairs()
{
  std::vector<std::uint32_t> near = this->Among ? *this->Among : this->ListNear();
  const auto isNarrow = [this](std::uint32_t triangle)
  {
    const Triangle x = this->PositionsOf(triangle);
    const skd::Vector3 area = AreaOf(x);
    return !IsWide(SkdWidthOf(x), Along(area, this->Errors[triangle]) / Norm(area));
  };
  near.erase(std::remove_if(near.begin(), near.end(), isNarrow), near.end());
  std::vector<skd::Box3> boxes;
  boxes.reserve(near.size());
  for (const std::uint32_t triangle : near)
  {
    boxes.push_back(this->BoxOf(triangle));
  }
  this->IsOfPlate.assign(this->Triangles.size(), false);
  const skd::PackedRTree tree(boxes);
  skd::PackedRTree::OverlapLists lists;
  const auto visit = [&](std::uint32_t i, const std::vector<std::uint32_t>& others)
  {
    for (const std::uint32_t k : others)
    {
      const auto [first, second] = std::minmax(near[i], near[k]);
      const bool areOfOne = !this->Among && this->BodyOf[first] == this->BodyOf[second];
      if ((this->IsExact(first) && this->IsExact(second)) || !boxes[i].Overlaps(boxes[k]))
      {
        continue;
      }
      if (areOfOne && this->AreSidesOfAPlate(first, second))
      {
        this->IsOfPlate[first] = this->IsOfPlate[second] = true;
      }
      if (!areOfOne && this->AreOfTwoBodies(first, second) && this->AreInOnePlane(first, second))
      {
        this->Pairs.emplace_back(first, second);
      }
    }
    return true;
  };
  for (std::size_t packet = 0; packet < tree.GetNumberOfPackets(); ++packet)
  {
    tree.ForEachOverlapWithin(packet, lists, visit);
  }
  const auto isOfPlate = [this](const Pair& pair)
  { return this->IsOfPlate[pair.first] || this->IsOfPlate[pair.second]; };
  this->Pairs.erase(
    std::remove_if(this->Pairs.begin(), this->Pairs.end(), isOfPlate), this->Pairs.end());
}

//------------------------------------------------------------------------------
/// Faces grow from their widest triangles on.
void SkdFlushFaces::FindFaces()
{
  const auto n = static_cast<std::uint32_t>(this->Triangles.size());
  std::vector<std::array<std::uint32_t, 3>> neighbours(n, { None, None, None });
  this->ForEachNeighbours(
    [&](std::uint32_t a, std::uint32_t b)
    {
      *std::find(neighbours[a].begin(), neighbours[a].end() - 1, None) = b;
      *std::find(neighbours[b].begin(), neighbours[b].end() - 1, None) = a;
    });
  std::vector<double> widths(n);
  std::vector<std::uint32_t> seeds(n);
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    widths[triangle] = SkdWidthOf(this->PositionsOf(triangle));
    seeds[triangle] = triangle;
  }
  const auto leastOf = [this](std::uint32_t triangle)
  {
    const Triangle x = this->PositionsOf(triangle);
    return *std::min_element(x.begin(), x.end());
  };
  std::stable_sort(seeds.begin(), seeds.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return widths[a] != widths[b] ? widths[a] > widths[b] : leastOf(a) < leastOf(b); });
  this->FaceOf.assign(n, None);
  std::uint32_t count = 0;
  for (const std::uint32_t seed : seeds)
  {
    if (this->FaceOf[seed] == None)
    {
      this->FaceOf[seed] = count++;
      this->GrowFace(seed, neighbours);
    }
  }
  this->TrianglesOf = skd::IndexRows(count,
    [this](const auto& add)
    {
      for (std::uint32_t triangle = 0; triangle < this->FaceOf.size(); ++triangle)
      {
        add(this->FaceOf[triangle], triangle);
      }
    });
}

/// Adds what is in the plane of the seed and connected to it.
void SkdFlushFaces::GrowFace(
  std::uint32_t seed, const std::vector<std::array<std::uint32_t, 3>>& neighbours)
{
  const double width = SkdWidthOf(this->PositionsOf(seed));
  std::vector<std::uint32_t> open{ seed };
  while (!open.empty())
  {
    const std::uint32_t triangle = open.back();
    open.pop_back();
    for (const std::uint32_t next : neighbours[triangle])
    {
      if (next != None && this->FaceOf[next] == None && this->IsInPlaneOf(next, seed, width))
      {
        this->FaceOf[next] = this->FaceOf[seed];
        open.push_back(next);
      }
    }
  }
}
}
