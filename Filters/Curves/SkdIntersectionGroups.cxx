// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdIntersectionGroups.h"

#include <algorithm>
#include <tuple>

namespace skdtree
{
namespace
{
unsigned BitOf(int side)
{
  return side > 0 ? 1u : (side < 0 ? 2u : 0u);
}

/// 0 where there is none, or where there are both.
int OnlySideOf(unsigned bits)
{
  return bits == 1u ? 1 : (bits == 2u ? -1 : 0);
}
}

//------------------------------------------------------------------------------
void SkdIntersectionGroups::Group::Add(
  const SkdSurfaceHit& hit, const std::vector<SkdSurfaceElement>& elements)
{
  const auto idOf = [&](const SkdSurfaceHit& one)
  { return std::tie(elements[one.Element].CellId, one.Element); };
  if (idOf(hit) < idOf(this->Lowest))
  {
    this->Lowest = hit;
  }
  if (hit.Kind == skd::IntersectionKind::OverlapEnd)
  {
    ++(hit.Begins ? this->OverlapsBegun : this->OverlapsEnded);
    return;
  }
  this->IsExact &= hit.IsExact;
  this->ExactPasses += hit.Passes != 0;
  this->ExactSum += hit.Passes;
  this->GoesAlong |= hit.Direction > 0;
  this->GoesAgainst |= hit.Direction < 0;
  this->SidesBefore |= BitOf(hit.Before);
  this->SidesAfter |= BitOf(hit.After);
}

//------------------------------------------------------------------------------
int SkdIntersectionGroups::Group::Before() const
{
  return this->IsExact ? 0 : OnlySideOf(this->SidesBefore);
}

//------------------------------------------------------------------------------
int SkdIntersectionGroups::Group::After() const
{
  return this->IsExact ? 0 : OnlySideOf(this->SidesAfter);
}

//------------------------------------------------------------------------------
// Where all is exact, the parity decides. Elsewhere the sides on which the curve comes and goes do;
// or every element that meets there reports its own direction: they differ where the curve comes
// and goes on one side.
int SkdIntersectionGroups::Group::Sense() const
{
  if (this->IsExact)
  {
    return this->ExactPasses % 2 == 0 ? 0 : (this->ExactSum > 0 ? -1 : 1);
  }
  if (this->Before() != 0 && this->After() != 0)
  {
    return this->Before() == this->After() ? 0 : this->Before();
  }
  if (this->GoesAlong == this->GoesAgainst)
  {
    return 0;
  }
  return this->GoesAlong ? -1 : 1;
}

//------------------------------------------------------------------------------
// Where one element's common interval ends and another's begins, it goes on.
bool SkdIntersectionGroups::Group::IsWithinOverlap() const
{
  return this->OverlapsBegun > 0 && this->OverlapsEnded > 0;
}

//------------------------------------------------------------------------------
skd::IntersectionKind SkdIntersectionGroups::Group::Kind() const
{
  if (this->OverlapsBegun + this->OverlapsEnded > 0 && !this->IsWithinOverlap())
  {
    return skd::IntersectionKind::OverlapEnd;
  }
  return this->Sense() != 0 ? skd::IntersectionKind::Crossing : skd::IntersectionKind::Touching;
}

//------------------------------------------------------------------------------
bool SkdIntersectionGroups::BelongsTo(const Group& group, const SkdSurfaceHit& hit) const
{
  const SkdSurfaceHit& first = group.First;
  const double slack = std::max(hit.Slack, first.Slack);
  const double maxDistance = hit.Error + first.Error;
  return hit.Curve == first.Curve && hit.OnBoundary && first.OnBoundary &&
    this->Elements[hit.Element].Part == this->Elements[first.Element].Part &&
    hit.U - first.U <= slack && skd::Distance2(hit.X, first.X) <= 4.0 * maxDistance * maxDistance;
}

//------------------------------------------------------------------------------
void SkdIntersectionGroups::Add(const SkdSurfaceHit& hit)
{
  constexpr std::size_t window = 16; // as many parts may be met in one point
  const std::size_t count = this->Groups.size();
  for (std::size_t back = 1; back <= std::min(count, window); ++back)
  {
    Group& group = this->Groups[count - back];
    if (this->BelongsTo(group, hit))
    {
      group.Add(hit, this->Elements);
      return;
    }
  }
  Group group;
  group.First = group.Lowest = hit;
  group.Add(hit, this->Elements);
  this->Groups.push_back(group);
}

//------------------------------------------------------------------------------
std::vector<SkdSurfaceIntersection> SkdIntersectionGroups::GetIntersections() const
{
  std::vector<SkdSurfaceIntersection> intersections;
  for (const Group& group : this->Groups)
  {
    if (group.IsWithinOverlap() && group.Sense() == 0)
    {
      continue;
    }
    SkdSurfaceIntersection intersection{ group.Lowest, group.Sense(), group.Before(),
      group.After() };
    intersection.Hit.Kind = group.Kind();
    intersection.Hit.U = group.First.U;
    intersections.push_back(intersection);
  }
  return intersections;
}

//------------------------------------------------------------------------------
std::vector<int> SkdIntersectionGroups::GetPartsLeft() const
{
  std::vector<int> parts;
  for (const Group& group : this->Groups)
  {
    if (group.Sense() == 0)
    {
      continue;
    }
    const int part = this->Elements[group.First.Element].Part;
    const auto known = std::find(parts.begin(), parts.end(), part);
    if (known == parts.end())
    {
      parts.push_back(part);
    }
    else
    {
      parts.erase(known);
    }
  }
  return parts;
}
}
