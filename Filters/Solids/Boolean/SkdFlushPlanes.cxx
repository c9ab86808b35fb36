// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The planes of SkdFlushFaces.
#include "Solids/Boolean/SkdFlushFaces.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace skdtree
{
/// Numbers, few of which are in a group with others. Each group has a first one.
class SkdGroups
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

//------------------------------------------------------------------------------
void SkdFlushFaces::FindPlanes()
{
  this->FindFaces();
  this->Faces.resize(this->TrianglesOf.size());
  this->AreFitted.assign(this->Faces.size(), false);
  this->UniteFaces();
}

/// Finds the plane of a face, unless that is done.
void SkdFlushFaces::Fit(std::uint32_t face)
{
  if (this->AreFitted[face])
  {
    return;
  }
  const std::vector<std::uint32_t> triangles = this->ListTriangles({ face });
  const bool isOfPlate = std::any_of(triangles.begin(), triangles.end(),
    [this](std::uint32_t triangle) { return this->IsOfPlate[triangle]; });
  this->Faces[face] = this->FitPlane(triangles);
  this->Faces[face].IsFlat = this->Faces[face].IsFlat && !isOfPlate;
  this->AreFitted[face] = true;
}

SkdFacePlane SkdFlushFaces::FitPlane(const std::vector<std::uint32_t>& triangles) const
{
  SkdFacePlane plane;
  skd::Vector3& first = plane.Corners[0];
  skd::Vector3& second = plane.Corners[1];
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
  plane.Corners[2] =
    findLargest([&](const skd::Vector3& x) { return Norm2(Cross(second - first, x - first)); });
  const skd::Vector3 normal = AreaOf(plane.Corners);
  plane.Area = Norm(normal);
  plane.Normal = plane.Area > 0.0 ? (1.0 / plane.Area) * normal : normal;
  plane.IsSingle = triangles.size() == 1;
  for (const std::uint32_t triangle : triangles)
  {
    plane.Largest = Greatest(plane.Largest, LargestOf(this->PositionsOf(triangle)));
    plane.Tolerance = std::max(plane.Tolerance, Along(plane.Normal, this->Errors[triangle]));
    plane.IsExact = plane.IsExact && this->IsExact(triangle);
  }
  plane.IsFlat = plane.Area > 0.0 && this->AreAllIn(triangles, plane);
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

std::vector<std::uint32_t> SkdFlushFaces::ListTriangles(
  const std::vector<std::uint32_t>& faces) const
{
  std::vector<std::uint32_t> triangles;
  for (const std::uint32_t face : faces)
  {
    triangles.insert(
      triangles.end(), this->TrianglesOf[face].begin(), this->TrianglesOf[face].end());
  }
  return triangles;
}

/// Of two groups, which lie in the planes of their first ones, one: all are in that plane, or, if
/// they may move, in one that is fitted to all of them.
void SkdFlushFaces::Join(std::uint32_t first, std::uint32_t second, SkdGroups& groups)
{
  const std::vector<std::uint32_t> joining = groups.ListGroup(second);
  SkdFacePlane plane = this->Planes[first];
  if (!this->AreAllIn(this->ListTriangles(joining), plane))
  {
    std::vector<std::uint32_t> all = groups.ListGroup(first);
    all.insert(all.end(), joining.begin(), joining.end());
    plane = plane.IsExact ? SkdFacePlane() : this->FitPlane(this->ListTriangles(all));
  }
  if (plane.IsFlat)
  {
    groups.Add(first, joining);
    this->Planes[first] = plane;
  }
}

/// Puts faces that are flush in one plane. It is not fitted to all of them where that of one will
/// do: planes that are right already would be off by a bit after each of several operations.
void SkdFlushFaces::UniteFaces()
{
  std::set<Pair> pairs;
  for (const auto& [a, b] : this->Pairs)
  {
    pairs.insert(std::minmax(this->FaceOf[a], this->FaceOf[b]));
  }
  const std::set<Pair> flush = pairs;
  this->AddTouching(pairs);
  this->Planes = this->Faces;
  SkdGroups groups;
  for (const auto& [a, b] : pairs)
  {
    std::uint32_t first = groups.GetFirstOf(a);
    std::uint32_t second = groups.GetFirstOf(b);
    if (this->Faces[second].ComesBefore(this->Faces[first]))
    {
      std::swap(first, second);
    }
    if (first != second && this->Faces[a].IsFlat && this->Faces[b].IsFlat)
    {
      this->Join(first, second, groups);
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
