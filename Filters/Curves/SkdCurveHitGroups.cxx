// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCurveHitGroups.h"

#include "Curves/SkdCurveJoints.h"

#include <algorithm>
#include <tuple>

namespace skdtree
{
namespace
{
auto PairOf(const SkdCurveHit& hit)
{
  return std::tuple(hit.First.Curve, hit.Second.Curve);
}

auto LocationOf(const SkdCurveHit& hit)
{
  return std::tuple(hit.First.Curve, hit.Second.Curve, hit.First.U, hit.Second.U,
    static_cast<int>(hit.Kind), hit.Begins, hit.First.Piece, hit.Second.Piece);
}

/// Along the curve, of a closed one the shorter way around.
double Apart(const SkdCurveLocation& a, const SkdCurveLocation& b)
{
  const double apart = std::abs(a.U - b.U);
  return a.Period > 0.0 ? std::min(apart, a.Period - apart) : apart;
}

/// Exact intersections are equal only to within a few units in the last place.
bool IsSameLocation(const SkdCurveHit& a, const SkdCurveHit& b)
{
  const double SkdCurveLocation::*slack =
    a.IsExact && b.IsExact ? &SkdCurveLocation::Rounding : &SkdCurveLocation::Slack;
  const auto areNear = [&](const SkdCurveLocation& one, const SkdCurveLocation& other)
  { return Apart(one, other) <= std::max(one.*slack, other.*slack); };
  return PairOf(a) == PairOf(b) && areNear(a.First, b.First) && areNear(a.Second, b.Second);
}

bool IsKnown(const skd::Vector3& direction)
{
  return skd::Norm2(direction) > 0.0;
}

/// What meets in a point.
struct Group
{
  SkdCurveHit Hit;
  bool Crosses = false;
  bool CrossesSimply = false;
  bool Begins = false;
  bool Ends = false;

  skd::Vector3 Before{};
  skd::Vector3 After{};

  explicit Group(const SkdCurveHit& hit)
    : Hit(hit)
  {
    this->Add(hit);
  }

  void Add(const SkdCurveHit& hit)
  {
    const bool isEnd = hit.Kind == skd::IntersectionKind::OverlapEnd;
    this->Begins |= isEnd && hit.Begins;
    this->Ends |= isEnd && !hit.Begins;
    const bool crosses = hit.Kind == skd::IntersectionKind::Crossing;
    this->Crosses |= crosses;
    this->CrossesSimply |= crosses && !hit.IsResolved;
    this->Before = IsKnown(hit.Before) ? hit.Before : this->Before;
    this->After = IsKnown(hit.After) ? hit.After : this->After;
    const auto rank = [](const SkdCurveHit& one) { return std::tuple(!one.IsExact, one.Gap); };
    if (rank(hit) < rank(this->Hit))
    {
      this->Hit = hit;
    }
  }

  void Add(const Group& other)
  {
    const bool begins = this->Begins || other.Begins;
    const bool ends = this->Ends || other.Ends;
    const bool crosses = this->Crosses || other.Crosses;
    const bool crossesSimply = this->CrossesSimply || other.CrossesSimply;
    const skd::Vector3 before = IsKnown(this->Before) ? this->Before : other.Before;
    const skd::Vector3 after = IsKnown(this->After) ? this->After : other.After;
    this->Add(other.Hit);
    this->Begins = begins;
    this->Ends = ends;
    this->Crosses = crosses;
    this->CrossesSimply = crossesSimply;
    this->Before = before;
    this->After = after;
  }

  bool IsWithinInterval() const { return this->Begins && this->Ends; }

  skd::IntersectionKind Kind() const
  {
    if (this->Begins || this->Ends)
    {
      return skd::IntersectionKind::OverlapEnd;
    }
    const bool areSidesKnown = IsKnown(this->Before) && IsKnown(this->After);
    const bool crosses = this->CrossesSimply ||
      (areSidesKnown ? skd::Dot(this->Before, this->After) < 0.0 : this->Crosses);
    return crosses ? skd::IntersectionKind::Crossing : skd::IntersectionKind::Touching;
  }
};

/// Whether a location is where a closed curve ends and begins, seen from before.
bool IsBeforeStart(const SkdCurveLocation& location)
{
  return location.Period > 0.0 && location.Period - location.U <= location.Slack;
}

/// Merges the intersections at both ends of a closed curve, which are not adjacent in order. In
/// self-intersections the first parameter is the lower, which may be either.
void UniteAround(std::vector<Group>& groups, bool isSelf)
{
  const auto reversed = [](SkdCurveHit hit)
  {
    std::swap(hit.First, hit.Second);
    return hit;
  };
  std::vector<char> isLeftOut(groups.size(), 0);
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    const SkdCurveHit hit = groups[i].Hit;
    if (!IsBeforeStart(hit.First) && !IsBeforeStart(hit.Second))
    {
      continue;
    }
    const auto range = std::equal_range(groups.begin(), groups.end(), groups[i],
      [](const Group& a, const Group& b) { return PairOf(a.Hit) < PairOf(b.Hit); });
    const bool mayReverse = isSelf && hit.First.Curve == hit.Second.Curve;
    for (auto other = range.first; other != range.second && !isLeftOut[i]; ++other)
    {
      const auto number = static_cast<std::size_t>(other - groups.begin());
      const bool isSame = IsSameLocation(other->Hit, hit) ||
        (mayReverse && IsSameLocation(other->Hit, reversed(hit)));
      if (number != i && !isLeftOut[number] && isSame)
      {
        other->Add(groups[i]);
        isLeftOut[i] = 1;
      }
    }
  }
  std::size_t retained = 0;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    if (!isLeftOut[i])
    {
      groups[retained++] = groups[i];
    }
  }
  groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(retained), groups.end());
}

/// Whether two locations are one of curves that go on as each other there.
bool IsSameAlong(const SkdCurveLocation& a, const SkdCurveLocation& b, bool areExact)
{
  const bool isJoint = a.Joint != SkdCurveJoints::None && a.Joint == b.Joint;
  if (isJoint && (!areExact || (a.IsExactlyAtEnd && b.IsExactlyAtEnd)))
  {
    return true;
  }
  const double slack = areExact ? std::max(a.Rounding, b.Rounding) : std::max(a.Slack, b.Slack);
  return a.Curve == b.Curve && Apart(a, b) <= slack;
}

/// Makes one of the hits at a joint: all that follow one and are the same go, but that it may be
/// ends of intervals that stay. `order` has the numbers of these hits.
class JointUnion
{
public:
  JointUnion(std::vector<SkdCurveHit>& hits, bool isSelf)
    : Hits(hits)
    , IsSelf(isSelf)
    , IsLeftOut(hits.size(), 0)
  {
  }

  void Unite(const std::vector<std::size_t>& order)
  {
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      SkdCurveHit& retained = this->Hits[order[i]];
      for (std::size_t j = i + 1; j < order.size() && !this->IsLeftOut[order[i]]; ++j)
      {
        if (!this->IsLeftOut[order[j]] && this->IsSame(retained, this->Hits[order[j]]))
        {
          this->Merge(order[i], order[j]);
        }
      }
    }
  }

  void LeaveOut()
  {
    std::size_t retained = 0;
    for (std::size_t i = 0; i < this->Hits.size(); ++i)
    {
      if (!this->IsLeftOut[i])
      {
        this->Hits[retained++] = this->Hits[i];
      }
    }
    this->Hits.erase(this->Hits.begin() + static_cast<std::ptrdiff_t>(retained), this->Hits.end());
  }

private:
  bool IsSame(const SkdCurveHit& a, const SkdCurveHit& b) const
  {
    const bool areExact = a.IsExact && b.IsExact;
    const auto isSame = [&](const SkdCurveLocation& one, const SkdCurveLocation& other)
    { return IsSameAlong(one, other, areExact); };
    return (isSame(a.First, b.First) && isSame(a.Second, b.Second)) ||
      (this->IsSelf && isSame(a.First, b.Second) && isSame(a.Second, b.First));
  }

  void Merge(std::size_t retained, std::size_t other)
  {
    SkdCurveHit& one = this->Hits[retained];
    const SkdCurveHit& two = this->Hits[other];
    const bool endsInterval[2] = { one.Kind == skd::IntersectionKind::OverlapEnd,
      two.Kind == skd::IntersectionKind::OverlapEnd };
    if (endsInterval[0] || endsInterval[1])
    {
      this->IsLeftOut[retained] |= !endsInterval[0];
      this->IsLeftOut[other] |= !endsInterval[1];
      return;
    }
    const auto side = [](const SkdCurveHit& hit)
    { return IsKnown(hit.Before) ? hit.Before : hit.After; };
    const bool areSidesKnown =
      one.IsResolved && two.IsResolved && IsKnown(side(one)) && IsKnown(side(two));
    const bool crosses = areSidesKnown
      ? skd::Dot(side(one), side(two)) < 0.0
      : one.Kind == skd::IntersectionKind::Crossing || two.Kind == skd::IntersectionKind::Crossing;
    one.Kind = crosses ? skd::IntersectionKind::Crossing : skd::IntersectionKind::Touching;
    this->IsLeftOut[other] = 1;
  }

  std::vector<SkdCurveHit>& Hits;
  bool IsSelf;
  std::vector<char> IsLeftOut;
};

bool Follows(const SkdCurveInterval& next, const SkdCurveInterval& last)
{
  return IsSameLocation(last.End, next.Begin);
}
}

//------------------------------------------------------------------------------
std::vector<SkdCurveHit> SkdUniteCurveHits(std::vector<SkdCurveHit>& hits, bool isSelf)
{
  std::sort(hits.begin(), hits.end(),
    [](const SkdCurveHit& a, const SkdCurveHit& b) { return LocationOf(a) < LocationOf(b); });
  constexpr std::size_t window = 16;
  std::vector<Group> groups;
  for (const SkdCurveHit& hit : hits)
  {
    const auto first = groups.end() - static_cast<std::ptrdiff_t>(std::min(groups.size(), window));
    const auto same = std::find_if(
      first, groups.end(), [&](const Group& group) { return IsSameLocation(group.Hit, hit); });
    if (same == groups.end())
    {
      groups.emplace_back(hit);
    }
    else
    {
      same->Add(hit);
    }
  }
  UniteAround(groups, isSelf);
  std::vector<SkdCurveHit> united;
  for (const Group& group : groups)
  {
    if (!group.IsWithinInterval())
    {
      united.push_back(group.Hit);
      united.back().Kind = group.Kind();
      united.back().Before = group.Before;
      united.back().After = group.After;
    }
  }
  return united;
}

//------------------------------------------------------------------------------
void SkdUniteAtJoints(std::vector<SkdCurveHit>& hits, bool isSelf)
{
  std::vector<std::pair<std::size_t, std::size_t>> atJoints; // joint, hit
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    const std::size_t joints[2] = { hits[i].First.Joint, hits[i].Second.Joint };
    for (int side = 0; side < 2; ++side)
    {
      if (joints[side] != SkdCurveJoints::None)
      {
        // joints of two sets have numbers of their own
        atJoints.emplace_back(2 * joints[side] + (isSelf ? 0 : side), i);
      }
    }
  }
  std::sort(atJoints.begin(), atJoints.end());
  JointUnion joined(hits, isSelf);
  for (std::size_t first = 0; first < atJoints.size();)
  {
    std::vector<std::size_t> order;
    std::size_t last = first;
    for (; last < atJoints.size() && atJoints[last].first == atJoints[first].first; ++last)
    {
      order.push_back(atJoints[last].second);
    }
    joined.Unite(order);
    first = last;
  }
  joined.LeaveOut();
}

//------------------------------------------------------------------------------
std::vector<SkdCurveInterval> SkdJoinIntervals(std::vector<SkdCurveInterval>& intervals)
{
  std::sort(intervals.begin(), intervals.end(),
    [](const SkdCurveInterval& a, const SkdCurveInterval& b)
    { return LocationOf(a.Begin) < LocationOf(b.Begin); });
  std::vector<SkdCurveInterval> joined;
  for (const SkdCurveInterval& interval : intervals)
  {
    const auto last = std::find_if(joined.rbegin(), joined.rend(),
      [&](const SkdCurveInterval& one)
      { return PairOf(one.Begin) != PairOf(interval.Begin) || Follows(interval, one); });
    if (last != joined.rend() && Follows(interval, *last))
    {
      last->End = interval.End;
    }
    else
    {
      joined.push_back(interval);
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
}
