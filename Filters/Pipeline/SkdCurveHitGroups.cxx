// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdCurveHitGroups.h"

#include <algorithm>
#include <tuple>

namespace
{
auto PairOf(const SkdCurveHit& hit)
{
  return std::tuple(hit.First.Curve, hit.Second.Curve);
}

auto PlaceOf(const SkdCurveHit& hit)
{
  return std::tuple(hit.First.Curve, hit.Second.Curve, hit.First.U, hit.Second.U,
    static_cast<int>(hit.Kind), hit.Begins, hit.First.Piece, hit.Second.Piece);
}

bool AreNear(const SkdCurvePlace& a, const SkdCurvePlace& b)
{
  return std::abs(a.U - b.U) <= std::max(a.Slack, b.Slack);
}

bool IsSamePlace(const SkdCurveHit& a, const SkdCurveHit& b)
{
  return PairOf(a) == PairOf(b) && AreNear(a.First, b.First) && AreNear(a.Second, b.Second);
}

/// What meets in a place.
struct Group
{
  SkdCurveHit Hit;
  bool Crosses = false;
  bool Begins = false;
  bool Ends = false;

  explicit Group(const SkdCurveHit& hit)
    : Hit(hit)
  {
    this->Add(hit);
  }

  void Add(const SkdCurveHit& hit)
  {
    const bool isEnd = hit.Kind == skd::MeetingKind::OverlapEnd;
    this->Begins |= isEnd && hit.Begins;
    this->Ends |= isEnd && !hit.Begins;
    this->Crosses |= hit.Kind == skd::MeetingKind::Crossing;
    if (hit.Gap < this->Hit.Gap)
    {
      this->Hit = hit;
    }
  }

  bool IsWithinStretch() const { return this->Begins && this->Ends; }

  skd::MeetingKind Kind() const
  {
    if (this->Begins || this->Ends)
    {
      return skd::MeetingKind::OverlapEnd;
    }
    return this->Crosses ? skd::MeetingKind::Crossing : skd::MeetingKind::Touching;
  }
};

bool Follows(const SkdCurveStretch& next, const SkdCurveStretch& last)
{
  return IsSamePlace(last.End, next.Begin);
}
}

//------------------------------------------------------------------------------
std::vector<SkdCurveHit> SkdUniteCurveHits(std::vector<SkdCurveHit>& hits)
{
  std::sort(hits.begin(), hits.end(),
    [](const SkdCurveHit& a, const SkdCurveHit& b) { return PlaceOf(a) < PlaceOf(b); });
  constexpr std::size_t window = 16;
  std::vector<Group> groups;
  for (const SkdCurveHit& hit : hits)
  {
    const auto first = groups.end() - static_cast<std::ptrdiff_t>(std::min(groups.size(), window));
    const auto same = std::find_if(
      first, groups.end(), [&](const Group& group) { return IsSamePlace(group.Hit, hit); });
    if (same == groups.end())
    {
      groups.emplace_back(hit);
    }
    else
    {
      same->Add(hit);
    }
  }
  std::vector<SkdCurveHit> united;
  for (const Group& group : groups)
  {
    if (!group.IsWithinStretch())
    {
      united.push_back(group.Hit);
      united.back().Kind = group.Kind();
    }
  }
  return united;
}

//------------------------------------------------------------------------------
std::vector<SkdCurveStretch> SkdJoinStretches(std::vector<SkdCurveStretch>& stretches)
{
  std::sort(stretches.begin(), stretches.end(),
    [](const SkdCurveStretch& a, const SkdCurveStretch& b)
    { return PlaceOf(a.Begin) < PlaceOf(b.Begin); });
  std::vector<SkdCurveStretch> joined;
  for (const SkdCurveStretch& stretch : stretches)
  {
    const auto last = std::find_if(joined.rbegin(), joined.rend(),
      [&](const SkdCurveStretch& one)
      { return PairOf(one.Begin) != PairOf(stretch.Begin) || Follows(stretch, one); });
    if (last != joined.rend() && Follows(stretch, *last))
    {
      last->End = stretch.End;
    }
    else
    {
      joined.push_back(stretch);
    }
  }
  return joined;
}

//------------------------------------------------------------------------------
std::vector<SkdCurveHit> SkdNearestApproaches(
  std::vector<SkdCurveHit>& near, const std::vector<SkdCurveHit>& hits)
{
  const auto rank = [](const SkdCurveHit& hit)
  { return std::tuple(hit.First.Curve, hit.Second.Curve, hit.Gap, hit.First.U, hit.Second.U); };
  std::sort(near.begin(), near.end(),
    [&](const SkdCurveHit& a, const SkdCurveHit& b) { return rank(a) < rank(b); });
  const auto isSamePair = [](const SkdCurveHit& a, const SkdCurveHit& b)
  { return PairOf(a) == PairOf(b); };
  near.erase(std::unique(near.begin(), near.end(), isSamePair), near.end());
  std::vector<SkdCurveHit> left;
  for (const SkdCurveHit& one : near)
  {
    const auto known = std::lower_bound(hits.begin(), hits.end(), one,
      [](const SkdCurveHit& a, const SkdCurveHit& b) { return PairOf(a) < PairOf(b); });
    const bool areJoined = one.Gap < 0.0;
    if (!areJoined && (known == hits.end() || PairOf(*known) != PairOf(one)))
    {
      left.push_back(one);
    }
  }
  return left;
}
