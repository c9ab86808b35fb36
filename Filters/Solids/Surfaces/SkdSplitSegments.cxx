// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitSegments.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>

namespace skdtree
{
/// A segment of one pair: its ends with their indices in the pair's contact.
struct SkdSplitSegments::PairSegment
{
  std::uint32_t A;
  std::uint32_t B;
  std::size_t Pair;
  std::int8_t SlotOfA;
  std::int8_t SlotOfB;

  bool operator<(const PairSegment& o) const
  {
    return std::tie(this->A, this->B, this->Pair) < std::tie(o.A, o.B, o.Pair);
  }
  bool HasEndsOf(const PairSegment& o) const { return this->A == o.A && this->B == o.B; }
};

SkdSplitSegments::SkdSplitSegments(const SkdPlacement& placement,
  const std::vector<SkdTrianglePair>& pairs, const SkdContactPoints& contacts,
  std::size_t mostEvents)
  : Pairs(pairs)
  , Contacts(contacts)
  , Points(contacts, placement)
  , IsOfOne(placement.IsOfOne())
  , MostEvents(mostEvents)
{
  this->Sides[0].Set = &placement.First;
  this->Sides[1].Set = &placement.GetSecond();
  this->AddElements(this->ListSegments());
  while (this->FindAll())
  {
  }
  this->UniteCorners();
}

// Returns whether points were added along edges, which others of the triangles there do not know
// of: then the segments that have them are compared again. All else that segments have in common is
// found when they are first compared; points that are one are united when those along a segment are
// sorted.
bool SkdSplitSegments::FindAll()
{
  const std::vector<SkdSplitEvent> events[2] = { this->FindEvents(0), this->FindEvents(1) };
  this->HasTooMany = this->HasTooMany || events[0].size() + events[1].size() > this->MostEvents;
  if (this->HasTooMany)
  {
    return false;
  }
  this->MarkAsOld();
  this->Apply(events[0]);
  this->Apply(events[1]);
  this->MarkAsOld();
  const bool isChanged = this->MeetAtEdges(this->Sides[0]);
  return this->MeetAtEdges(this->Sides[1]) || isChanged;
}

void SkdSplitSegments::MarkAsOld()
{
  for (SkdSplitSegment& segment : this->Segments)
  {
    segment.IsNew = false;
  }
}

//------------------------------------------------------------------------------
std::vector<SkdSplitSegments::PairSegment> SkdSplitSegments::ListSegments() const
{
  std::vector<PairSegment> list;
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    const int count = this->Pairs[pair].Contact.Count;
    for (int i = 0; i < (count == 2 ? 1 : count); ++i)
    {
      const int k = i + 1 < count ? i + 1 : 0;
      PairSegment segment{ this->Contacts.GetPoint(pair, i), this->Contacts.GetPoint(pair, k), pair,
        static_cast<std::int8_t>(i), static_cast<std::int8_t>(k) };
      if (segment.B < segment.A)
      {
        std::swap(segment.A, segment.B);
        std::swap(segment.SlotOfA, segment.SlotOfB);
      }
      list.push_back(segment);
    }
  }
  std::sort(list.begin(), list.end());
  return list;
}

void SkdSplitSegments::AddElements(const std::vector<PairSegment>& list)
{
  for (Side& side : this->Sides)
  {
    side.CornerOf.assign(this->Points.GetNumberOfPoints(), None);
  }
  for (auto first = list.begin(); first != list.end();)
  {
    const auto number = static_cast<std::uint32_t>(this->Segments.size());
    int sides = 0; // of areas
    int lines = 0;
    auto last = first;
    for (; last != list.end() && last->HasEndsOf(*first); ++last)
    {
      const int count = this->Pairs[last->Pair].Contact.Count;
      sides += count > 2;
      lines += count == 2;
      this->AddElementsOf(*last, number);
    }
    const bool isCurve = sides == 1 || (lines > 0 && sides == 0);
    const bool isOfOnePair = lines == 1 && last - first == 1;
    this->Segments.push_back({ first->A, first->B, isCurve,
      isOfOnePair ? static_cast<std::uint32_t>(first->Pair) : None, {} });
    first = last;
  }
  for (Side& side : this->Sides)
  {
    std::sort(side.Elements.begin(), side.Elements.end());
    side.Elements.erase(
      std::unique(side.Elements.begin(), side.Elements.end()), side.Elements.end());
  }
}

void SkdSplitSegments::AddElementsOf(const PairSegment& of, std::uint32_t segment)
{
  const SkdTrianglePair& pair = this->Pairs[of.Pair];
  const skd::ContactPoint& a = pair.Contact.Points[of.SlotOfA];
  const skd::ContactPoint& b = pair.Contact.Points[of.SlotOfB];
  const auto add = [&](int side, std::uint32_t triangle, skd::TriangleFeature featureOfA,
                     skd::TriangleFeature featureOfB)
  {
    Side& to = this->Sides[side];
    to.Elements.push_back({ triangle, segment, featureOfA, featureOfB });
    const SkdTriangleSet::Corners& corners = to.Set->GetCorners(triangle);
    for (const auto& [point, feature] :
      { std::pair(of.A, featureOfA), std::pair(of.B, featureOfB) })
    {
      if (skd::IsCorner(feature))
      {
        to.CornerOf[point] = corners[feature];
      }
    }
  };
  add(0, pair.First, a.First, b.First);
  add(this->IsOfOne ? 0 : 1, pair.Second, a.Second, b.Second);
}

//------------------------------------------------------------------------------
void SkdSplitSegments::Apply(const std::vector<SkdSplitEvent>& events)
{
  std::vector<std::uint32_t> crossings = this->FindFirstCrossings(events); // and then their points
  const SkdSplitEvent* last = nullptr;
  for (const SkdSplitEvent& event : events)
  {
    const bool isNext =
      !last || last->Kind != event.Kind || last->A != event.A || last->B != event.B;
    last = &event;
    if (isNext && event.Kind == SkdSplitEvent::Same)
    {
      this->Points.Unite(event.A, event.B);
    }
    else if (isNext && event.Kind == SkdSplitEvent::On)
    {
      this->AddBetween(event.A, event.B);
    }
    else if (isNext)
    {
      const auto number = static_cast<std::uint32_t>(&event - events.data());
      std::uint32_t& point = crossings[number];
      point = point == number ? this->AddCrossing(event) : crossings[point];
      this->AddBetween(event.A, point);
      this->AddBetween(event.B, point);
    }
  }
  for (SkdSplitSegment& segment : this->Segments)
  {
    if (segment.IsNew)
    {
      this->SortBetween(segment);
    }
  }
}

std::uint32_t SkdSplitSegments::AddCrossing(const SkdSplitEvent& event)
{
  const SkdSplitSegment& a = this->Segments[event.A];
  const SkdSplitSegment& b = this->Segments[event.B];
  return this->Points.AddCrossing({ a.A, a.B, b.A, b.B }, event.Axis);
}

namespace
{
/// The crossing of segments between three triangles, of which two are in each.
struct CrossingOfThree
{
  std::array<std::uint32_t, 3> Triangles; // ascending
  std::uint32_t Event;

  bool operator<(const CrossingOfThree& o) const
  {
    return std::tie(this->Triangles, this->Event) < std::tie(o.Triangles, o.Event);
  }
};
}

// Three triangles meet in one point at most if two of the segments between them cross: what is in
// all three is convex, and in both segments. Each of the triangles finds it.
std::vector<std::uint32_t> SkdSplitSegments::FindFirstCrossings(
  const std::vector<SkdSplitEvent>& events) const
{
  std::vector<CrossingOfThree> ofThree;
  for (const SkdSplitEvent& event : events)
  {
    if (const auto triangles = this->FindThree(event))
    {
      ofThree.push_back({ *triangles, static_cast<std::uint32_t>(&event - events.data()) });
    }
  }
  vtkSMPTools::Sort(ofThree.begin(), ofThree.end());
  std::vector<std::uint32_t> firsts(events.size());
  std::iota(firsts.begin(), firsts.end(), 0u);
  for (std::size_t i = 1; i < ofThree.size(); ++i)
  {
    const bool isSame = ofThree[i].Triangles == ofThree[i - 1].Triangles;
    firsts[ofThree[i].Event] = isSame ? firsts[ofThree[i - 1].Event] : ofThree[i].Event;
  }
  return firsts;
}

/// The triangles of a crossing of two segments that are each the contact of a pair, with one
/// triangle in common.
std::optional<std::array<std::uint32_t, 3>> SkdSplitSegments::FindThree(
  const SkdSplitEvent& event) const
{
  if (!this->IsOfOne || event.Kind != SkdSplitEvent::Cross ||
    this->Segments[event.A].Pair == None || this->Segments[event.B].Pair == None)
  {
    return std::nullopt;
  }
  const SkdTrianglePair& a = this->Pairs[this->Segments[event.A].Pair];
  const SkdTrianglePair& b = this->Pairs[this->Segments[event.B].Pair];
  std::array<std::uint32_t, 4> all = { a.First, a.Second, b.First, b.Second };
  std::sort(all.begin(), all.end());
  const auto end = std::unique(all.begin(), all.end());
  return end - all.begin() == 3 ? std::make_optional(std::array{ all[0], all[1], all[2] })
                                : std::nullopt;
}

void SkdSplitSegments::AddBetween(std::uint32_t segment, std::uint32_t point)
{
  this->Segments[segment].Between.push_back(point);
  this->Segments[segment].IsNew = true;
}

void SkdSplitSegments::SortBetween(SkdSplitSegment& segment)
{
  std::vector<std::uint32_t>& points = segment.Between;
  const int axis = this->Points.FindAxis(segment.A, segment.B);
  if (axis < 0)
  {
    points.clear();
    return;
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const int sign = this->Points.Compare(segment.B, segment.A, axis);
  std::sort(points.begin(), points.end(),
    [&](std::uint32_t a, std::uint32_t b) { return sign * this->Points.Compare(a, b, axis) < 0; });
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    if (this->Points.Compare(points[i - 1], points[i], axis) == 0)
    {
      this->Points.Unite(points[i - 1], points[i]);
    }
  }
}

void SkdSplitSegments::GetChain(std::uint32_t number, std::vector<std::uint32_t>& chain) const
{
  const SkdSplitSegment& segment = this->Segments[number];
  chain.assign(1, this->Points.Find(segment.A));
  const auto add = [&](std::uint32_t point)
  {
    point = this->Points.Find(point);
    if (point != chain.back())
    {
      chain.push_back(point);
    }
  };
  std::for_each(segment.Between.begin(), segment.Between.end(), add);
  add(segment.B);
}

//------------------------------------------------------------------------------
// What lies on an edge is on all segments along it, and the other way round.
bool SkdSplitSegments::MeetAtEdges(Side& side)
{
  this->CollectEdgePoints(side);
  this->SortEdgePoints(side);
  bool isChanged = false;
  for (const SkdSplitElement& element : side.Elements)
  {
    const SkdSplitSegment& segment = this->Segments[element.Segment];
    if (segment.A != segment.B && element.GetEdges() != 0)
    {
      isChanged = this->TakeFromEdge(side, element) || isChanged;
    }
  }
  return isChanged;
}

namespace
{
SkdSplitEdgePoint OnEdge(const SkdTriangleSet::Corners& corners, int edge, std::uint32_t point)
{
  const std::uint32_t a = corners[edge];
  const std::uint32_t b = corners[edge == 2 ? 0 : edge + 1];
  return { std::min(a, b), std::max(a, b), point };
}

/// The edge of a segment that lies along one.
int EdgeOf(unsigned edges)
{
  return edges & 1u ? 0 : (edges & 2u ? 1 : 2);
}

/// Both ends of the edge as one number.
std::uint64_t EndsOf(const SkdSplitEdgePoint& point)
{
  return static_cast<std::uint64_t>(point.From) << 32 | point.To;
}

bool IsOfLowerEdge(const SkdSplitEdgePoint& a, const SkdSplitEdgePoint& b)
{
  return EndsOf(a) < EndsOf(b);
}
}

void SkdSplitSegments::CollectEdgePoints(Side& side) const
{
  for (const SkdSplitElement& element : side.Elements)
  {
    const SkdTriangleSet::Corners& corners = side.Set->GetCorners(element.Triangle);
    const SkdSplitSegment& segment = this->Segments[element.Segment];
    const auto addEnd = [&](std::uint32_t point, skd::TriangleFeature feature)
    {
      if (skd::IsEdge(feature))
      {
        side.EdgePoints.push_back(OnEdge(corners, feature - 3, this->Points.Find(point)));
      }
    };
    addEnd(segment.A, element.FeatureOfA);
    addEnd(segment.B, element.FeatureOfB);
    if (element.GetEdges() != 0 && segment.A != segment.B)
    {
      for (const std::uint32_t point : segment.Between)
      {
        side.EdgePoints.push_back(
          OnEdge(corners, EdgeOf(element.GetEdges()), this->Points.Find(point)));
      }
    }
  }
}

void SkdSplitSegments::SortEdgePoints(Side& side)
{
  const auto compare = [&](const SkdSplitEdgePoint& a, const SkdSplitEdgePoint& b)
  {
    if (a.Point == b.Point)
    {
      return 0; // many triangles have the same edge
    }
    const skd::Vector3 direction = side.Set->GetPoints()[a.To] - side.Set->GetPoints()[a.From];
    const int axis = std::abs(direction[0]) >= std::abs(direction[1])
      ? (std::abs(direction[0]) >= std::abs(direction[2]) ? 0 : 2)
      : (std::abs(direction[1]) >= std::abs(direction[2]) ? 1 : 2);
    const int order = this->Points.Compare(a.Point, b.Point, axis);
    return direction[axis] < 0.0 ? -order : order;
  };
  auto& points = side.EdgePoints;
  std::sort(points.begin(), points.end(),
    [&](const SkdSplitEdgePoint& a, const SkdSplitEdgePoint& b)
    {
      const std::uint64_t first = EndsOf(a);
      const std::uint64_t second = EndsOf(b);
      return first != second ? first < second : compare(a, b) < 0;
    });
  const auto last = std::unique(points.begin(), points.end(),
    [&](const SkdSplitEdgePoint& a, const SkdSplitEdgePoint& b)
    {
      const bool isSame = EndsOf(a) == EndsOf(b) && compare(a, b) == 0;
      if (isSame)
      {
        this->Points.Unite(a.Point, b.Point);
      }
      return isSame;
    });
  points.erase(last, points.end());
}

bool SkdSplitSegments::TakeFromEdge(const Side& side, const SkdSplitElement& element)
{
  SkdSplitSegment& segment = this->Segments[element.Segment];
  const SkdTriangleSet::Corners& corners = side.Set->GetCorners(element.Triangle);
  const auto [first, last] = std::equal_range(side.EdgePoints.begin(), side.EdgePoints.end(),
    OnEdge(corners, EdgeOf(element.GetEdges()), 0), IsOfLowerEdge);
  const int axis = first == last ? -1 : this->Points.FindAxis(segment.A, segment.B);
  if (axis < 0)
  {
    return false;
  }
  std::vector<std::uint32_t> chain;
  this->GetChain(element.Segment, chain);
  const int sign = this->Points.Compare(segment.B, segment.A, axis);
  bool isChanged = false;
  for (auto at = first; at != last; ++at)
  {
    const std::uint32_t point = this->Points.Find(at->Point);
    if (std::find(chain.begin(), chain.end(), point) == chain.end() &&
      sign * this->Points.Compare(point, segment.A, axis) > 0 &&
      sign * this->Points.Compare(segment.B, point, axis) > 0)
    {
      this->AddBetween(element.Segment, point);
      isChanged = true;
    }
  }
  if (isChanged)
  {
    this->SortBetween(segment);
  }
  return isChanged;
}

void SkdSplitSegments::UniteCorners()
{
  for (Side& side : this->Sides)
  {
    side.CornerOf.resize(this->Points.GetNumberOfPoints(), None);
    for (std::uint32_t point = 0; point < this->Points.GetNumberOfPoints(); ++point)
    {
      if (side.CornerOf[point] != None)
      {
        side.CornerOf[this->Points.Find(point)] = side.CornerOf[point];
      }
    }
  }
}
}
