// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFlushFaces.h"

#include "Bodies/SkdEdgeTable.h"
#include "Bodies/SkdWeld.h"
#include "Core/Geometry/DisjointSets.h"
#include "Core/Search/Tree/PackedRTree.h"
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

/// Whether one is in the plane of the other, that of the wider one.
bool AreInOnePlaneWithin(const Triangle& first, const Triangle& second, double tolerance)
{
  constexpr double least = 16.0; // tolerances: the plane of a narrower one means little
  const double widths[] = { SkdWidthOf(first), SkdWidthOf(second) };
  const bool isFirstWider = widths[0] >= widths[1];
  return std::max(widths[0], widths[1]) > least * tolerance &&
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
SkdFlushFaces::SkdFlushFaces(const std::vector<int>& bits, const SkdTriangleSet& set)
  : Bits(bits)
  , Set(set)
{
  this->Weld();
  this->Edges = SkdMakeEdgeTable(this->Triangles, this->Points.size());
  this->FindBodies();
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
  this->FitPlanes(this->FindFaces());
  this->UniteFaces();
}

//------------------------------------------------------------------------------
double SkdFlushFaces::ToleranceOf(std::uint32_t triangle) const
{
  constexpr double roundings = 16.0;
  const Triangle x = this->PositionsOf(triangle);
  return this->IsExact(triangle) ? SkdToleranceOf(x) : roundings * Rounding * LargestOf(x);
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
}

/// The triangles whose boxes overlap those of other bodies, with these boxes.
std::vector<std::uint32_t> SkdFlushFaces::ListNear(std::vector<skd::Box3>& boxes) const
{
  const auto n = static_cast<std::uint32_t>(this->Triangles.size());
  std::vector<skd::Box3> ofBodies;
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    ofBodies.resize(std::max<std::size_t>(ofBodies.size(), this->BodyOf[triangle] + 1));
    ofBodies[this->BodyOf[triangle]].Add(this->BoxOf(triangle));
  }
  std::vector<std::uint32_t> near;
  const skd::PackedRTree tree(ofBodies);
  for (std::uint32_t triangle = 0; ofBodies.size() > 1 && triangle < n; ++triangle)
  {
    const skd::Box3 box = this->BoxOf(triangle);
    bool isNear = false;
    tree.ForEachOverlapping(box,
      [&](std::uint32_t body)
      { isNear = isNear || (body != this->BodyOf[triangle] && ofBodies[body].Overlaps(box)); });
    if (isNear)
    {
      near.push_back(triangle);
      boxes.push_back(box);
    }
  }
  return near;
}

/// Pairs of triangles of two bodies, one of which at least may be moved.
void SkdFlushFaces::FindPairs()
{
  std::vector<skd::Box3> boxes;
  const std::vector<std::uint32_t> near = this->ListNear(boxes);
  const skd::PackedRTree tree(boxes);
  for (std::uint32_t i = 0; i < near.size(); ++i)
  {
    tree.ForEachOverlapping(boxes[i],
      [&](std::uint32_t k)
      {
        const bool isPair = i < k && this->BodyOf[near[i]] != this->BodyOf[near[k]] &&
          boxes[i].Overlaps(boxes[k]) && !(this->IsExact(near[i]) && this->IsExact(near[k]));
        if (isPair && this->AreInOnePlane(near[i], near[k]))
        {
          this->Pairs.emplace_back(near[i], near[k]);
        }
      });
  }
}

//------------------------------------------------------------------------------
/// Returns the widest triangle of the face of each one.
std::vector<std::uint32_t> SkdFlushFaces::FindFaces()
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
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    widest[triangle] = widest[sets.Find(triangle)]; // that of the lowest of a set does not change
  }
  this->FaceOf = sets.Number();
  return widest;
}

void SkdFlushFaces::FitPlanes(const std::vector<std::uint32_t>& widest)
{
  const auto n = static_cast<std::uint32_t>(this->Triangles.size());
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    this->Faces.resize(std::max<std::size_t>(this->Faces.size(), this->FaceOf[triangle] + 1));
    SkdFacePlane& face = this->Faces[this->FaceOf[triangle]];
    const Triangle x = this->PositionsOf(triangle);
    const Triangle first = this->PositionsOf(widest[triangle]);
    const double sign = Dot(AreaOf(x), AreaOf(first)) < 0.0 ? -1.0 : 1.0;
    face.Normal = face.Normal + sign * AreaOf(x);
    face.Origin = first[0];
    face.Largest = std::max(face.Largest, LargestOf(x));
    face.IsExact = face.IsExact && this->IsExact(triangle);
    ++face.Size;
  }
  for (SkdFacePlane& face : this->Faces)
  {
    face.Area = Norm(face.Normal);
    face.IsFlat = face.Area > 0.0;
    face.Normal = face.IsFlat ? (1.0 / face.Area) * face.Normal : face.Normal;
  }
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    SkdFacePlane& face = this->Faces[this->FaceOf[triangle]];
    const Triangle x = this->PositionsOf(triangle);
    const skd::Vector3& o = face.Origin;
    const double height = Dot(face.Normal, (x[0] - o) + (x[1] - o) + (x[2] - o)) / 3.0;
    face.Distance += face.IsFlat ? Norm(AreaOf(x)) / face.Area * height : 0.0;
  }
  for (std::uint32_t triangle = 0; triangle < n; ++triangle)
  {
    SkdFacePlane& face = this->Faces[this->FaceOf[triangle]];
    face.IsFlat = face.IsFlat && this->IsIn(triangle, face);
  }
}

//------------------------------------------------------------------------------
/// Faces that have a point in common and are parallel, or nearly: those of what an operation before
/// has made may be on two sides of an edge at which more faces meet.
void SkdFlushFaces::AddTouching(std::set<Pair>& pairs) const
{
  constexpr double least = 1.0 - 1e-5;
  constexpr std::size_t most = 64; // faces, which are compared with each other
  const skd::IndexRows facesAt(this->Points.size(),
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
  for (std::uint32_t point = 0; point < this->Points.size(); ++point)
  {
    std::vector<std::uint32_t> faces(facesAt[point].begin(), facesAt[point].end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (std::size_t i = 0; i < faces.size() && faces.size() <= most; ++i)
    {
      for (std::size_t k = 0; k < i; ++k)
      {
        if (std::abs(Dot(this->Faces[faces[k]].Normal, this->Faces[faces[i]].Normal)) > least)
        {
          pairs.emplace(faces[k], faces[i]);
        }
      }
    }
  }
}

/// In one group are faces that are all in the plane of the first of them.
void SkdFlushFaces::UniteFaces()
{
  const skd::IndexRows triangles(this->Faces.size(),
    [this](const auto& add)
    {
      for (std::uint32_t triangle = 0; triangle < this->FaceOf.size(); ++triangle)
      {
        add(this->FaceOf[triangle], triangle);
      }
    });
  const auto isIn = [&](std::uint32_t face, std::uint32_t plane)
  {
    return this->Faces[face].IsFlat &&
      std::all_of(triangles[face].begin(), triangles[face].end(),
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
