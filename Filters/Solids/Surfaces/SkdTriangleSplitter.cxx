// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdTriangleSplitter.h"

#include "Core/Geometry/Polygons/DelaunayEdge.h"

#include <algorithm>
#include <numeric>

namespace skdtree
{
namespace
{
constexpr std::uint32_t None = SkdSplitSegments::None;
}

void SkdSplitCorners::Begin(const skd::ProjectedTriangle& triangle)
{
  this->Axis = triangle.Axis;
  this->Sign = skd::Orient2D(triangle[0], triangle[1], triangle[2], triangle.Axis);
  this->ExactCorners = {};
  this->All.clear();
  for (int i = 0; i < 3; ++i)
  {
    this->All.push_back({ triangle[i], None, skd::EdgesAt(static_cast<std::int8_t>(i)) });
  }
}

int SkdSplitCorners::Add(std::uint32_t point, unsigned edges)
{
  this->All.push_back({ this->Points.GetPosition(point), point, edges });
  return this->Count() - 1;
}

void SkdSplitCorners::PutOnLine(int corner, int line)
{
  std::array<int, 2>& lines = this->All[static_cast<std::size_t>(corner)].Lines;
  int& next = lines[0] < 0 ? lines[0] : lines[1];
  next = next < 0 && lines[0] != line ? line : next;
}

bool SkdSplitCorners::AreOnOneLine(int a, int b, int c) const
{
  const std::array<int, 2>& lines = (*this)[a].Lines;
  return std::any_of(lines.begin(), lines.end(),
    [&](int line) { return line >= 0 && (*this)[b].IsOn(line) && (*this)[c].IsOn(line); });
}

int SkdSplitCorners::Orient(int a, int b, int c)
{
  const SkdSplitCorner& first = (*this)[a];
  const SkdSplitCorner& second = (*this)[b];
  const SkdSplitCorner& third = (*this)[c];
  if ((first.Edges & second.Edges & third.Edges) != 0)
  {
    return 0; // on one edge of the triangle
  }
  const int sign =
    skd::FilteredOrient2D(first.X, second.X, third.X, this->Axis, this->Points.GetError());
  if (sign != 0)
  {
    return this->Sign * sign;
  }
  if (this->AreOnOneLine(a, b, c))
  {
    return 0; // as exact signs would tell, slowly
  }
  if (std::min({ a, b, c }) >= 3) // all are points
  {
    return this->Sign *
      this->Points.OrientExactly(first.Point, second.Point, third.Point, this->Axis);
  }
  const std::optional<int> known = SkdOrientByCoordinates(
    this->GetSplitPosition(a), this->GetSplitPosition(b), this->GetSplitPosition(c), this->Axis);
  return this->Sign *
    (known ? *known
           : skd::ExactArea(this->GetExact(a), this->GetExact(b), this->GetExact(c), this->Axis)
               .Sign());
}

bool SkdSplitCorners::IsBetter(int a, int b, int c, int d) const
{
  return skd::IsOtherEdgeDelaunay((*this)[a].X, (*this)[b].X, (*this)[c].X, (*this)[d].X);
}

SkdSplitPosition SkdSplitCorners::GetSplitPosition(int i) const
{
  constexpr unsigned all = 7; // of a given corner
  const SkdSplitCorner& local = (*this)[i];
  return { local.X, local.Point == None ? all : this->Points.GetExactAxes(local.Point) };
}

const skd::ExactPoint& SkdSplitCorners::GetExact(int i)
{
  const SkdSplitCorner& local = (*this)[i];
  if (local.Point != None)
  {
    return this->Points.GetExact(local.Point);
  }
  std::optional<skd::ExactPoint>& corner = this->ExactCorners[static_cast<std::size_t>(i)];
  if (!corner)
  {
    corner.emplace(local.X);
  }
  return *corner;
}

//------------------------------------------------------------------------------
SkdTriangleSplitter::SkdTriangleSplitter(
  const SkdSplitSegments& segments, const SkdSplitSegments::Side& side, const SkdSplitEdges& edges)
  : Segments(segments)
  , Side(side)
  , Edges(edges)
  , Corners(segments.GetPoints())
{
}

void SkdTriangleSplitter::Split(std::uint32_t triangle, const SkdSplitElement* first,
  const SkdSplitElement* last, std::vector<SkdTriangleSet::Corners>& pieces)
{
  this->TriangleCorners = this->Side.Set->GetCorners(triangle);
  this->Corners.Begin(this->Side.Set->Get(triangle));
  this->CollectCorners(first, last);
  this->CollectEdges();
  const int onBorder = this->Corners.Count();
  this->CollectInside(first, last);
  const auto orient = [this](int a, int b, int c) { return this->Corners.Orient(a, b, c); };
  const auto isBetter = [this](int a, int b, int c, int d)
  { return this->Corners.IsBetter(a, b, c, d); };
  skd::ConstrainedTriangulation<decltype(orient), decltype(isBetter)> made(
    this->Corners.Count(), orient, isBetter, std::move(this->Memory));
  for (const std::array<int, 3>& added : this->Border)
  {
    made.AddOnBorder(added[0], added[1], added[2]);
  }
  this->Slots.resize(static_cast<std::size_t>(this->Corners.Count()));
  std::iota(this->Slots.begin(), this->Slots.end(), 0);
  this->AddInside(onBorder, this->Corners.Count(), made);
  for (const std::pair<int, int>& edge : this->Inner)
  {
    made.Constrain(this->Slots[edge.first], this->Slots[edge.second]);
  }
  for (const skd::FlipMesh::Triangle& piece : made.GetTriangles())
  {
    const std::array<int, 3>& corners = piece.Corners;
    pieces.push_back({ this->IdOf(corners[0]), this->IdOf(corners[1]), this->IdOf(corners[2]) });
  }
  this->Memory = made.TakeMemory();
}

// The middle one first, as in AddToBorder: as a rule points that follow each other are near.
template <class Triangulation>
void SkdTriangleSplitter::AddInside(int begin, int end, Triangulation& made)
{
  if (begin < end)
  {
    const int middle = begin + (end - begin) / 2;
    this->Slots[middle] = made.Add(middle);
    this->AddInside(begin, middle, made);
    this->AddInside(middle + 1, end, made);
  }
}

std::uint32_t SkdTriangleSplitter::IdOf(int i) const
{
  const SkdSplitCorner& local = this->Corners[i];
  if (local.Point == None)
  {
    return this->TriangleCorners[i];
  }
  const std::uint32_t corner = this->Side.CornerOf[local.Point];
  return corner != None
    ? corner
    : static_cast<std::uint32_t>(this->Side.Set->GetPoints().size()) + local.Point;
}

void SkdTriangleSplitter::CollectCorners(const SkdSplitElement* first, const SkdSplitElement* last)
{
  this->Known.Clear();
  for (; first != last; ++first)
  {
    const SkdSplitSegment& segment = this->Segments.GetSegment(first->Segment);
    for (const auto& [point, part] :
      { std::pair(segment.A, first->FeatureOfA), std::pair(segment.B, first->FeatureOfB) })
    {
      if (skd::IsCorner(part))
      {
        this->Known.Add(this->Find(point), part);
      }
    }
  }
}

void SkdTriangleSplitter::CollectEdges()
{
  this->Border.clear();
  for (int edge = 0; edge < 3; ++edge)
  {
    const int next = edge == 2 ? 0 : edge + 1;
    const std::uint32_t from = this->TriangleCorners[edge];
    const std::uint32_t to = this->TriangleCorners[next];
    const auto [first, last] = this->Edges.Find(from, to);
    const int begin = this->Corners.Count();
    const auto count = last - first;
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      const std::uint32_t point = this->Find((from < to ? first[i] : first[count - 1 - i]).Point);
      this->Known.Add(point, this->Corners.Add(point, 1u << edge));
    }
    this->AddToBorder(edge, begin, this->Corners.Count(), next);
  }
}

// The middle one first: one after the other, each would change the edges to all that come later.
void SkdTriangleSplitter::AddToBorder(int before, int begin, int end, int next)
{
  if (begin < end)
  {
    const int middle = begin + (end - begin) / 2;
    this->Border.push_back({ middle, before, next });
    this->AddToBorder(before, begin, middle, middle);
    this->AddToBorder(middle, middle + 1, end, next);
  }
}

void SkdTriangleSplitter::CollectInside(const SkdSplitElement* first, const SkdSplitElement* last)
{
  this->Inner.clear();
  this->Curves.clear();
  for (int line = 0; first != last; ++first, ++line)
  {
    const bool isOnEdge = first->GetEdges() != 0;
    const bool isCurve = this->Segments.GetSegment(first->Segment).IsCurve;
    int before = -1;
    this->Segments.GetChain(first->Segment, this->Chain);
    for (const std::uint32_t point : this->Chain)
    {
      const int known = this->Known.Add(point, this->Corners.Count());
      if (known == this->Corners.Count())
      {
        this->Corners.Add(point, 0);
      }
      this->Corners.PutOnLine(known, line);
      if (before >= 0 && !isOnEdge)
      {
        this->Inner.emplace_back(before, known);
      }
      if (before >= 0 && isCurve)
      {
        this->Curves.push_back(SkdMakeSplitEdge(this->IdOf(before), this->IdOf(known)));
      }
      before = known;
    }
  }
}
}
