// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdContactPoints.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/Intersection/ContactPosition.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

namespace skdtree
{
SkdContactPoints::SkdContactPoints(
  const SkdPlacement& placement, const std::vector<SkdTrianglePair>& pairs, Directions directions)
  : First(placement.First)
  , Second(placement.IsOfOne() ? nullptr : &placement.GetSecond())
{
  const std::vector<Key> keys = this->MakeKeys(pairs);
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0u);
  vtkSMPTools::Sort(order.begin(), order.end(),
    [&keys](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  this->Points.resize(keys.size());
  for (const std::uint32_t i : order)
  {
    if (this->Keys.empty() || !(this->Keys.back() == keys[i]))
    {
      this->Keys.push_back(keys[i]);
    }
    this->Points[i] = static_cast<std::uint32_t>(this->Keys.size() - 1);
  }
  this->Positions.resize(this->Keys.size());
  const double unscaled = 1.0 / placement.Scale;
  SkdForEach(this->Keys.size(),
    [&](std::size_t i)
    { this->Positions[i] = unscaled * this->FindPosition(this->Keys[i], directions); });
}

std::vector<SkdContactPoints::Key> SkdContactPoints::MakeKeys(
  const std::vector<SkdTrianglePair>& pairs)
{
  this->Offsets.reserve(pairs.size() + 1);
  this->Offsets.push_back(0);
  for (const SkdTrianglePair& pair : pairs)
  {
    this->Offsets.push_back(this->Offsets.back() + static_cast<std::size_t>(pair.Contact.Count));
  }
  std::vector<Key> keys(this->Offsets.back());
  SkdForEach(pairs.size(),
    [&](std::size_t pair)
    {
      for (int i = 0; i < pairs[pair].Contact.Count; ++i)
      {
        keys[this->Offsets[pair] + static_cast<std::size_t>(i)] =
          this->MakeKey(pairs[pair], pairs[pair].Contact.Points[i]);
      }
    });
  if (this->Second)
  {
    this->MakeCornersOne(pairs, keys);
  }
  return keys;
}

SkdContactPoints::Feature SkdContactPoints::MakeFeature(
  bool isOfSecond, std::uint32_t triangle, skd::TriangleFeature feature) const
{
  const bool isCountedOn = isOfSecond && this->Second;
  const SkdMovedTriangles& set = isCountedOn ? *this->Second : this->First;
  if (feature == skd::TriangleInside)
  {
    const auto before = static_cast<std::uint32_t>(this->First.GetSet().GetTriangles().size());
    return { triangle + (isCountedOn ? before : 0), Inside };
  }
  const auto before = isCountedOn ? static_cast<std::uint32_t>(this->First.GetPoints().size()) : 0u;
  const SkdTriangleSet::Corners& corners = set.GetCorners(triangle);
  const std::uint32_t a = before + corners[feature % 3];
  const std::uint32_t b =
    before + (skd::IsCorner(feature) ? corners[feature] : corners[(feature + 1) % 3]);
  return { std::min(a, b), std::max(a, b) };
}

SkdContactPoints::Key SkdContactPoints::MakeKey(
  const SkdTrianglePair& pair, const skd::ContactPoint& point) const
{
  const Feature first = this->MakeFeature(false, pair.First, point.First);
  const Feature second = this->MakeFeature(true, pair.Second, point.Second);
  if (first.IsCorner())
  {
    return { first, first };
  }
  if (second.IsCorner())
  {
    return { second, second };
  }
  const bool isSwapped = first.IsInside() || (!second.IsInside() && second < first);
  return isSwapped ? Key{ second, first } : Key{ first, second }; // an edge comes first
}

// A corner of the second set that lies on one of the first is that one. Where it is met by itself
// (on an edge, say, that has no end there) it must be, too.
void SkdContactPoints::MakeCornersOne(
  const std::vector<SkdTrianglePair>& pairs, std::vector<Key>& keys) const
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> same; // (second's, first's)
  for (const SkdTrianglePair& pair : pairs)
  {
    for (int i = 0; i < pair.Contact.Count; ++i)
    {
      const skd::ContactPoint& point = pair.Contact.Points[i];
      if (skd::IsCorner(point.First) && skd::IsCorner(point.Second))
      {
        same.emplace_back(this->MakeFeature(true, pair.Second, point.Second).A,
          this->MakeFeature(false, pair.First, point.First).A);
      }
    }
  }
  vtkSMPTools::Sort(same.begin(), same.end());
  SkdForEach(keys.size(),
    [&](std::size_t i)
    {
      Key& key = keys[i];
      const std::pair<std::uint32_t, std::uint32_t> from(key.first.A, 0u);
      const auto at = std::lower_bound(same.begin(), same.end(), from);
      if (key.first.IsCorner() && at != same.end() && at->first == key.first.A)
      {
        const Feature corner{ at->second, at->second };
        key = { corner, corner };
      }
    });
}

bool SkdContactPoints::IsOn(const Feature& edge, const Key& key)
{
  const bool isEnd = key.first.IsCorner() && (key.first.A == edge.A || key.first.A == edge.B);
  return isEnd || key.first == edge || key.second == edge;
}

bool SkdContactPoints::AreOnOneEdge(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
{
  const Key* const keys[3] = { &this->Keys[a], &this->Keys[b], &this->Keys[c] };
  const auto areOn = [&keys](const Feature& edge)
  {
    return !edge.IsCorner() && !edge.IsInside() && IsOn(edge, *keys[0]) && IsOn(edge, *keys[1]) &&
      IsOn(edge, *keys[2]);
  };
  // Of three different points at most two are ends of the edge.
  return std::any_of(
    keys, keys + 3, [&areOn](const Key* key) { return areOn(key->first) || areOn(key->second); });
}

const skd::Vector3& SkdContactPoints::CornerAt(std::uint32_t corner) const
{
  const auto before = static_cast<std::uint32_t>(this->First.GetPoints().size());
  return corner < before ? this->First.GetPoints()[corner]
                         : this->Second->GetPoints()[corner - before];
}

skd::Segment<3> SkdContactPoints::EdgeAt(const Feature& edge) const
{
  return { this->CornerAt(edge.A), this->CornerAt(edge.B) };
}

std::array<skd::Vector3, 3> SkdContactPoints::TriangleAt(std::uint32_t triangle) const
{
  const auto before = static_cast<std::uint32_t>(this->First.GetSet().GetTriangles().size());
  return triangle < before ? this->First.GetCornerPoints(triangle)
                           : this->Second->GetCornerPoints(triangle - before);
}

skd::Segment<3> SkdContactPoints::AscendingEdgeAt(const Feature& edge) const
{
  const skd::Segment<3> ends = this->EdgeAt(edge);
  return ends.B < ends.A ? skd::Segment<3>{ ends.B, ends.A } : ends;
}

// Of two sets the first one's comes first; within one set the lower one.
void SkdContactPoints::OrderEdges(skd::Segment<3>& edge, skd::Segment<3>& other) const
{
  if (!this->Second && (other.A < edge.A || (other.A == edge.A && other.B < edge.B)))
  {
    std::swap(edge, other);
  }
}

skd::Vector3 SkdContactPoints::FindPosition(const Key& key, Directions directions) const
{
  if (key.first.IsCorner())
  {
    return this->CornerAt(key.first.A);
  }
  const auto edgeAt = [&](const Feature& edge)
  {
    return directions == Directions::ByCoordinates ? this->AscendingEdgeAt(edge)
                                                   : this->EdgeAt(edge);
  };
  if (!key.second.IsInside())
  {
    skd::Segment<3> edge = edgeAt(key.first);
    skd::Segment<3> other = edgeAt(key.second);
    if (directions == Directions::ByCoordinates)
    {
      this->OrderEdges(edge, other);
    }
    return skd::CrossingWithEdge(edge, other);
  }
  const auto [a, b, c] = this->TriangleAt(key.second.A);
  return skd::CrossingWithPlane(edgeAt(key.first), a, b, c);
}

SkdContactPoints::Location SkdContactPoints::Locate(std::uint32_t point) const
{
  const Key& key = this->Keys[point];
  Location location{};
  if (key.first.IsCorner())
  {
    location.Corners[0] = this->CornerAt(key.first.A);
    location.Number = 1;
    return location;
  }
  skd::Segment<3> edge = this->AscendingEdgeAt(key.first);
  if (!key.second.IsInside())
  {
    skd::Segment<3> other = this->AscendingEdgeAt(key.second);
    this->OrderEdges(edge, other);
    location.Corners = { edge.A, edge.B, other.A, other.B, {} };
    location.Number = 4;
    return location;
  }
  location.Corners[0] = edge.A;
  location.Corners[1] = edge.B;
  std::array<skd::Vector3, 3> corners = this->TriangleAt(key.second.A);
  std::sort(corners.begin(), corners.end());
  std::copy(corners.begin(), corners.end(), location.Corners.begin() + 2);
  location.Number = 5;
  const auto before = static_cast<std::uint32_t>(this->First.GetSet().GetTriangles().size());
  location.IsTriangleOfSecond = key.second.A >= before;
  location.Triangle = key.second.A - (location.IsTriangleOfSecond ? before : 0);
  return location;
}

unsigned SkdContactPoints::FindExactAxes(const Feature& feature, const skd::Vector3& position) const
{
  std::array<skd::Vector3, 3> corners;
  if (feature.IsInside())
  {
    corners = this->TriangleAt(feature.A);
  }
  else
  {
    corners = { this->CornerAt(feature.A), this->CornerAt(feature.B), this->CornerAt(feature.B) };
  }
  unsigned axes = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = position[axis];
    const bool areAll = corners[0][axis] == x && corners[1][axis] == x && corners[2][axis] == x;
    axes |= static_cast<unsigned>(areAll) << axis;
  }
  return axes;
}

unsigned SkdContactPoints::FindExactAxes(std::uint32_t point, const skd::Vector3& position) const
{
  const Key& key = this->Keys[point];
  return this->FindExactAxes(key.first, position) | this->FindExactAxes(key.second, position);
}

skd::ClosePoint SkdContactPoints::GetClose(std::uint32_t point) const
{
  const Key& key = this->Keys[point];
  if (key.first.IsCorner())
  {
    return skd::ClosePoint(this->CornerAt(key.first.A));
  }
  const skd::Segment<3> edge = this->EdgeAt(key.first);
  if (!key.second.IsInside())
  {
    skd::ClosePoint none(edge.A);
    none.Error = std::numeric_limits<double>::infinity();
    return none;
  }
  const auto [a, b, c] = this->TriangleAt(key.second.A);
  return skd::CloseCrossingWithPlane(edge.A, edge.B, a, b, c);
}

skd::ExactPoint SkdContactPoints::GetExact(std::uint32_t point) const
{
  const Key& key = this->Keys[point];
  if (key.first.IsCorner())
  {
    return skd::ExactPoint(this->CornerAt(key.first.A));
  }
  const skd::Segment<3> edge = this->EdgeAt(key.first);
  if (!key.second.IsInside())
  {
    const skd::Segment<3> other = this->EdgeAt(key.second);
    return skd::ExactCrossingOfEdges(edge.A, edge.B, other.A, other.B);
  }
  const auto [a, b, c] = this->TriangleAt(key.second.A);
  return skd::ExactCrossingWithPlane(edge.A, edge.B, a, b, c);
}
}
