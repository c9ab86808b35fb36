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
#include <map>

namespace skdtree
{
namespace
{
using Triangle = SkdFlushFaces::Triangle;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

double LargestOf(const Triangle& positions)
{
  double largest = 0.0;
  for (const skd::Vector3& x : positions)
  {
    largest = std::max({ largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  }
  return largest;
}

/// Twice the area, along the normal.
skd::Vector3 AreaOf(const Triangle& x)
{
  return Cross(x[1] - x[0], x[2] - x[0]);
}

/// Whether the plane of a triangle means something, to within a tolerance of its points.
bool IsWide(double width, double tolerance)
{
  constexpr double least = 256.0; // tolerances
  return width > least * tolerance;
}

/// Whether one is in the plane of the other, that of the wider one.
bool AreInOnePlaneWithin(const Triangle& first, const Triangle& second, double tolerance)
{
  const double widths[] = { SkdWidthOf(first), SkdWidthOf(second) };
  const bool isFirstWider = widths[0] >= widths[1];
  return IsWide(std::max(widths[0], widths[1]), tolerance) &&
    SkdRoundedPlane(isFirstWider ? first : second, tolerance)
      .Contains(isFirstWider ? second : first);
}

/// Numbers, few of which are in a group with others. Each group has a first one.
class Groups
{
public:
  std::uint32_t GetFirstOf(std::uint32_t i) const
  {
    const auto at = this->FirstOf.find(i);
    return at == this->FirstOf.end() ? i : at->second;
  }

  std::vector<std::uint32_t> ListGroup(std::uint32_t first) const
  {
    const auto at = this->Members.find(first);
    return at == this->Members.end() ? std::vector<std::uint32_t>{ first } : at->second;
  }

  /// Adds a group to that of its new first one.
  void Add(std::uint32_t first, const std::vector<std::uint32_t>& joining)
  {
    std::vector<std::uint32_t>& all =
      this->Members.emplace(first, std::vector<std::uint32_t>{ first }).first->second;
    for (const std::uint32_t member : joining)
    {
      this->Members.erase(member);
      this->FirstOf[member] = first;
      all.push_back(member);
    }
  }

private:
  std::map<std::uint32_t, std::uint32_t> FirstOf;
  std::map<std::uint32_t, std::vector<std::uint32_t>> Members; // of each first one
};
}

//------------------------------------------------------------------------------
SkdFlushFaces::SkdFlushFaces(
  const std::vector<int>& bits, const SkdTriangleSet& set, const std::vector<std::uint32_t>* among)
  : Bits(bits)
  , Set(set)
  , Among(among)
{
  this->Weld();
  this->FindTolerances();
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
      const Triangle first = this->PositionsOf(pair.first);
      const Triangle second = this->PositionsOf(pair.second);
      const double tolerance = std::max(SkdToleranceOf(first), SkdToleranceOf(second));
      return !AreInOnePlaneWithin(first, second, tolerance);
    });
}

void SkdFlushFaces::FindPlanes()
{
  this->FindFaces();
  this->Faces.resize(this->TrianglesOf.size());
  this->AreFitted.assign(this->Faces.size(), false);
  this->UniteFaces();
}

//------------------------------------------------------------------------------
void SkdFlushFaces::FindTolerances()
{
  constexpr double roundings = 16.0;
  this->Tolerances.resize(this->Triangles.size());
  SkdForEach(static_cast<vtkIdType>(this->Triangles.size()),
    [this](vtkIdType i)
    {
      const auto triangle = static_cast<std::uint32_t>(i);
      const Triangle x = this->PositionsOf(triangle);
      this->Tolerances[triangle] =
        this->IsExact(triangle) ? SkdToleranceOf(x) : roundings * Rounding * LargestOf(x);
    });
}

bool SkdFlushFaces::AreInOnePlane(std::uint32_t a, std::uint32_t b) const
{
  return AreInOnePlaneWithin(this->PositionsOf(a), this->PositionsOf(b),
    std::max(this->ToleranceOf(a), this->ToleranceOf(b)));
}

bool SkdFlushFaces::IsIn(std::uint32_t triangle, const SkdFacePlane& plane) const
{
  const double tolerance = this->ToleranceOf(triangle);
  const Triangle positions = this->PositionsOf(triangle);
  return std::all_of(positions.begin(), positions.end(),
    [&](const skd::Vector3& x) { return std::abs(plane.HeightOf(x)) <= tolerance; });
}

skd::Box3 SkdFlushFaces::BoxOf(std::uint32_t triangle) const
{
  skd::Box3 box;
  for (const skd::Vector3& x : this->PositionsOf(triangle))
  {
    box.Add(x);
  }
  return box.Inflated(this->ToleranceOf(triangle));
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

bool SkdFlushFaces::AreOfTwoBodies(std::uint32_t a, std::uint32_t b) const
{
  if (!this->Among)
  {
    return this->BodyOf[a] != this->BodyOf[b];
  }
  const Corners& first = this->Triangles[a];
  const Corners& second = this->Triangles[b];
  const auto isShared = [&](std::uint32_t point)
  { return std::find(second.begin(), second.end(), point) != second.end(); };
  const Triangle x = this->PositionsOf(a);
  return this->BlockOf(a) != this->BlockOf(b) ||
    (std::none_of(first.begin(), first.end(), isShared) &&
      SkdDoOverlap(x, this->PositionsOf(b), AreaOf(x), this->ToleranceOf(a)));
}

/// Pairs of wide triangles of two bodies, one of which at least may be moved.
void SkdFlushFaces::FindPairs()
{
  std::vector<std::uint32_t> near = this->Among ? *this->Among : this->ListNear();
  const auto isNarrow = [this](std::uint32_t triangle)
  { return !IsWide(SkdWidthOf(this->PositionsOf(triangle)), this->ToleranceOf(triangle)); };
  near.erase(std::remove_if(near.begin(), near.end(), isNarrow), near.end());
  std::vector<skd::Box3> boxes;
  boxes.reserve(near.size());
  for (const std::uint32_t triangle : near)
  {
    boxes.push_back(this->BoxOf(triangle));
  }
  const skd::PackedRTree tree(boxes);
  skd::PackedRTree::OverlapLists lists;
  const auto visit = [&](std::uint32_t i, const std::vector<std::uint32_t>& others)
  {
    for (const std::uint32_t k : others)
    {
      const auto [first, second] = std::minmax(near[i], near[k]);
      if ((this->Among || this->BodyOf[first] != this->BodyOf[second]) &&
        boxes[i].Overlaps(boxes[k]) && this->AreOfTwoBodies(first, second) &&
        !(this->IsExact(first) && this->IsExact(second)) && this->AreInOnePlane(first, second))
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
}

//------------------------------------------------------------------------------
void SkdFlushFaces::FindFaces()
{
  const auto n = static_cast<std::uint32_t>(this->Triangles.size());
  skd::DisjointSets<> sets(n);
  std::vector<double> widths(n);
  std::vector<std::uint32_t> widest(n);
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    widths[triangle] = SkdWidthOf(this->PositionsOf(triangle));
    widest[triangle] = triangle;
  }
  this->ForEachNeighbours(
    [&](std::uint32_t a, std::uint32_t b)
    {
      const std::uint32_t first = widest[sets.Find(a)];
      const std::uint32_t second = widest[sets.Find(b)];
      const std::uint32_t plane = widths[first] >= widths[second] ? first : second;
      const auto isIn = [&](std::uint32_t triangle)
      { return triangle == plane || this->AreInOnePlane(triangle, plane); };
      if (isIn(a) && isIn(b) && isIn(first) && isIn(second))
      {
        sets.Unite(a, b);
        widest[sets.Find(a)] = plane;
      }
    });
  this->FaceOf = sets.Number();
  const std::size_t count =
    static_cast<std::size_t>(*std::max_element(this->FaceOf.begin(), this->FaceOf.end())) + 1;
  this->TrianglesOf = skd::IndexRows(count,
    [this](const auto& add)
    {
      for (std::uint32_t triangle = 0; triangle < this->FaceOf.size(); ++triangle)
      {
        add(this->FaceOf[triangle], triangle);
      }
    });
}

/// Finds the plane of a face, unless that is done.
void SkdFlushFaces::Fit(std::uint32_t face)
{
  if (this->AreFitted[face])
  {
    return;
  }
  const skd::IndexRows::Row triangles = this->TrianglesOf[face];
  SkdFacePlane& plane = this->Faces[face];
  plane = this->FitPlane(triangles);
  plane.IsFlat = plane.Area > 0.0 &&
    std::all_of(triangles.begin(), triangles.end(),
      [&](std::uint32_t triangle) { return this->IsIn(triangle, plane); });
  this->AreFitted[face] = true;
}

SkdFacePlane SkdFlushFaces::FitPlane(const skd::IndexRows::Row& triangles) const
{
  SkdFacePlane plane;
  auto& [first, second, third] = plane.Corners;
  // The point with the largest value of all, of equal ones the least by coordinates.
  const auto findLargest = [&](const auto& valueOf)
  {
    skd::Vector3 largest{};
    double value = -1.0;
    for (const std::uint32_t triangle : triangles)
    {
      for (const skd::Vector3& x : this->PositionsOf(triangle))
      {
        const double its = valueOf(x);
        const bool isLarger = its > value || (its == value && x < largest);
        largest = isLarger ? x : largest;
        value = isLarger ? its : value;
      }
    }
    return largest;
  };
  first = findLargest([](const skd::Vector3&) { return 0.0; });
  second = findLargest([&](const skd::Vector3& x) { return Distance2(x, first); });
  third =
    findLargest([&](const skd::Vector3& x) { return Norm2(Cross(second - first, x - first)); });
  const skd::Vector3 normal = AreaOf(plane.Corners);
  plane.Area = Norm(normal);
  plane.Normal = plane.Area > 0.0 ? (1.0 / plane.Area) * normal : normal;
  plane.IsSingle = triangles.size() == 1;
  for (const std::uint32_t triangle : triangles)
  {
    plane.Largest = std::max(plane.Largest, LargestOf(this->PositionsOf(triangle)));
    plane.IsExact = plane.IsExact && this->IsExact(triangle);
  }
  return plane;
}

//------------------------------------------------------------------------------
/// Adds pairs of faces that have a point in common and are parallel, or nearly, beginning at those
/// of the pairs that are there: those of what an operation before has made may be on two sides of
/// an edge at which more faces meet. All faces at these points are fitted.
void SkdFlushFaces::AddTouching(std::set<Pair>& pairs)
{
  constexpr double least = 1.0 - 1e-5;
  constexpr std::size_t most = 64; // faces, which are compared with each other
  const skd::IndexRows facesAt = this->ListFacesAtPoints();
  std::vector<bool> isReached(this->Points.size(), false);
  std::vector<bool> isListed(this->Faces.size(), false);
  std::vector<std::uint32_t> open;
  const auto list = [&](std::uint32_t face)
  {
    if (!isListed[face])
    {
      isListed[face] = true;
      open.push_back(face);
    }
  };
  for (const auto& [a, b] : pairs)
  {
    list(a);
    list(b);
  }
  const auto addAt = [&](std::uint32_t point)
  {
    std::vector<std::uint32_t> faces(facesAt[point].begin(), facesAt[point].end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      this->Fit(faces[i]);
      for (std::size_t k = 0; k < i && faces.size() <= most; ++k)
      {
        const double cosine = Dot(this->Faces[faces[k]].Normal, this->Faces[faces[i]].Normal);
        if (std::abs(cosine) > least)
        {
          pairs.emplace(faces[k], faces[i]);
          list(faces[k]);
          list(faces[i]);
        }
      }
    }
  };
  while (!open.empty())
  {
    const std::uint32_t face = open.back();
    open.pop_back();
    for (const std::uint32_t triangle : this->TrianglesOf[face])
    {
      for (const std::uint32_t corner : this->Triangles[triangle])
      {
        if (!isReached[corner])
        {
          isReached[corner] = true;
          addAt(corner);
        }
      }
    }
  }
}

skd::IndexRows SkdFlushFaces::ListFacesAtPoints() const
{
  return skd::IndexRows(this->Points.size(),
    [this](const auto& add)
    {
      for (std::uint32_t triangle = 0; triangle < this->Triangles.size(); ++triangle)
      {
        for (const std::uint32_t corner : this->Triangles[triangle])
        {
          add(corner, this->FaceOf[triangle]);
        }
      }
    });
}

/// In one group are faces that are all in the plane of the first of them.
void SkdFlushFaces::UniteFaces()
{
  const auto isIn = [&](std::uint32_t face, std::uint32_t plane)
  {
    return this->Faces[face].IsFlat &&
      std::all_of(this->TrianglesOf[face].begin(), this->TrianglesOf[face].end(),
        [&](std::uint32_t triangle) { return this->IsIn(triangle, this->Faces[plane]); });
  };
  std::set<Pair> pairs;
  for (const auto& [a, b] : this->Pairs)
  {
    pairs.insert(std::minmax(this->FaceOf[a], this->FaceOf[b]));
  }
  const std::set<Pair> flush = pairs;
  this->AddTouching(pairs);
  Groups groups;
  for (const auto& [a, b] : pairs)
  {
    std::uint32_t first = groups.GetFirstOf(a);
    std::uint32_t second = groups.GetFirstOf(b);
    if (this->Faces[second].ComesBefore(this->Faces[first]))
    {
      std::swap(first, second);
    }
    const std::vector<std::uint32_t> joining = groups.ListGroup(second);
    const auto joins = [&](std::uint32_t face) { return isIn(face, first); };
    if (first != second && this->Faces[first].IsFlat &&
      std::all_of(joining.begin(), joining.end(), joins))
    {
      groups.Add(first, joining);
    }
  }
  std::set<std::uint32_t> ofFlush; // the first ones of groups
  for (const auto& [a, b] : flush)
  {
    if (groups.GetFirstOf(a) == groups.GetFirstOf(b))
    {
      ofFlush.insert(groups.GetFirstOf(a));
    }
  }
  for (std::uint32_t face = 0; face < this->Faces.size(); ++face)
  {
    this->PlaneOf.push_back(groups.GetFirstOf(face));
    this->AreFlush.push_back(ofFlush.count(this->PlaneOf.back()) > 0);
  }
}
}
