// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdContactPoints.h"

#include "Core/Geometry/ContactPosition.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
template <class Body>
void ForEach(std::size_t n, const Body& body)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(n),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        body(static_cast<std::size_t>(i));
      }
    });
}
}

SkdContactPoints::SkdContactPoints(
  const SkdPlacement& placement, const std::vector<SkdTrianglePair>& pairs)
  : First(placement.First)
  , Second(placement.IsOfOne() ? nullptr : &placement.GetSecond())
{
  const std::vector<Key> keys = this->MakeKeys(pairs);
  this->Keys = keys;
  vtkSMPTools::Sort(this->Keys.begin(), this->Keys.end());
  this->Keys.erase(std::unique(this->Keys.begin(), this->Keys.end()), this->Keys.end());
  this->Points.resize(keys.size());
  ForEach(keys.size(),
    [&](std::size_t i)
    {
      const auto at = std::lower_bound(this->Keys.begin(), this->Keys.end(), keys[i]);
      this->Points[i] = static_cast<std::uint32_t>(at - this->Keys.begin());
    });
  this->Positions.resize(this->Keys.size());
  const double unscaled = 1.0 / placement.Scale;
  ForEach(this->Keys.size(),
    [&](std::size_t i) { this->Positions[i] = unscaled * this->FindPosition(this->Keys[i]); });
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
  ForEach(pairs.size(),
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

SkdContactPoints::Part SkdContactPoints::MakePart(
  bool isOfSecond, std::uint32_t triangle, skd::TrianglePart part) const
{
  const bool isCountedOn = isOfSecond && this->Second;
  const SkdPlacedTriangles& set = isCountedOn ? *this->Second : this->First;
  if (part == skd::TriangleInside)
  {
    const auto before = static_cast<std::uint32_t>(this->First.GetSet().GetTriangles().size());
    return { triangle + (isCountedOn ? before : 0), Inside };
  }
  const auto before = isCountedOn ? static_cast<std::uint32_t>(this->First.GetPoints().size()) : 0u;
  const SkdTriangleSet::Corners& corners = set.GetCorners(triangle);
  const std::uint32_t a = before + corners[part % 3];
  const std::uint32_t b = before + (skd::IsCorner(part) ? corners[part] : corners[(part + 1) % 3]);
  return { std::min(a, b), std::max(a, b) };
}

SkdContactPoints::Key SkdContactPoints::MakeKey(
  const SkdTrianglePair& pair, const skd::ContactPoint& point) const
{
  const Part first = this->MakePart(false, pair.First, point.First);
  const Part second = this->MakePart(true, pair.Second, point.Second);
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
        same.emplace_back(this->MakePart(true, pair.Second, point.Second).A,
          this->MakePart(false, pair.First, point.First).A);
      }
    }
  }
  vtkSMPTools::Sort(same.begin(), same.end());
  ForEach(keys.size(),
    [&](std::size_t i)
    {
      Key& key = keys[i];
      const std::pair<std::uint32_t, std::uint32_t> from(key.first.A, 0u);
      const auto at = std::lower_bound(same.begin(), same.end(), from);
      if (key.first.IsCorner() && at != same.end() && at->first == key.first.A)
      {
        const Part corner{ at->second, at->second };
        key = { corner, corner };
      }
    });
}

const skd::Vector3& SkdContactPoints::CornerAt(std::uint32_t corner) const
{
  const auto before = static_cast<std::uint32_t>(this->First.GetPoints().size());
  return corner < before ? this->First.GetPoints()[corner]
                         : this->Second->GetPoints()[corner - before];
}

skd::Segment<3> SkdContactPoints::EdgeAt(const Part& edge) const
{
  return { this->CornerAt(edge.A), this->CornerAt(edge.B) };
}

skd::SeenTriangle SkdContactPoints::TriangleAt(std::uint32_t triangle) const
{
  const auto before = static_cast<std::uint32_t>(this->First.GetSet().GetTriangles().size());
  return triangle < before ? this->First.Get(triangle) : this->Second->Get(triangle - before);
}

skd::Vector3 SkdContactPoints::FindPosition(const Key& key) const
{
  if (key.first.IsCorner())
  {
    return this->CornerAt(key.first.A);
  }
  if (!key.second.IsInside())
  {
    return skd::CrossingWithEdge(this->EdgeAt(key.first), this->EdgeAt(key.second));
  }
  const skd::SeenTriangle seen = this->TriangleAt(key.second.A);
  return skd::CrossingWithPlane(this->EdgeAt(key.first), seen[0], seen[1], seen[2]);
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
  const skd::SeenTriangle seen = this->TriangleAt(key.second.A);
  return skd::ExactCrossingWithPlane(edge.A, edge.B, seen[0], seen[1], seen[2]);
}
