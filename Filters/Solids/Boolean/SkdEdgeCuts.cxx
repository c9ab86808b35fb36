// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdEdgeCuts.h"

#include <algorithm>

namespace skdtree
{
using Corners = SkdTriangleSet::Corners;

void SkdEdgeCuts::Meet(const Ends& a, const Ends& b)
{
  const bool isSplit = this->CutAt(a, b.first) | this->CutAt(a, b.second) |
    this->CutAt(b, a.first) | this->CutAt(b, a.second);
  if (!isSplit && this->DoCross(a, b) && this->DoCross(b, a))
  {
    this->CutBoth(a, b);
  }
}

std::vector<std::uint32_t> SkdEdgeCuts::ListPoints(const Ends& edge) const
{
  std::vector<std::uint32_t> points;
  const auto found = this->Cuts.find(edge);
  if (found != this->Cuts.end())
  {
    std::vector<Cut> cuts = found->second;
    std::sort(cuts.begin(), cuts.end());
    for (const Cut& cut : cuts)
    {
      if (std::find(points.begin(), points.end(), cut.second) == points.end())
      {
        points.push_back(cut.second);
      }
    }
  }
  return points;
}

//------------------------------------------------------------------------------
// Whether a point is on an edge but for its ends, which it then cuts.
bool SkdEdgeCuts::CutAt(const Ends& edge, std::uint32_t point)
{
  if (point == edge.first || point == edge.second)
  {
    return false;
  }
  const skd::Vector3 direction = this->At(edge.second) - this->At(edge.first);
  const skd::Vector3 to = this->At(point) - this->At(edge.first);
  const double length = Norm(direction);
  const double along = Dot(to, direction) / length;
  const bool isOn = along > this->Tolerance && along < length - this->Tolerance &&
    Norm(Cross(to, direction)) <= this->Tolerance * length;
  if (isOn)
  {
    this->Cuts[edge].emplace_back(along, point);
  }
  return isOn;
}

// How far a point is on the left of an edge.
double SkdEdgeCuts::DistanceOf(const Ends& edge, std::uint32_t point) const
{
  const skd::Vector3 direction = this->At(edge.second) - this->At(edge.first);
  return Dot(this->Normal, Cross(direction, this->At(point) - this->At(edge.first))) /
    Norm(direction);
}

// Whether the ends of the second edge are on both sides of the first.
bool SkdEdgeCuts::DoCross(const Ends& a, const Ends& b) const
{
  const double first = this->DistanceOf(a, b.first);
  const double second = this->DistanceOf(a, b.second);
  return std::min(first, second) < -this->Tolerance && std::max(first, second) > this->Tolerance;
}

// The lowest point that an edge is cut in there.
std::uint32_t SkdEdgeCuts::FindCut(const Ends& edge, const skd::Vector3& x) const
{
  std::uint32_t lowest = None;
  const auto found = this->Cuts.find(edge);
  if (found != this->Cuts.end())
  {
    for (const Cut& cut : found->second)
    {
      const bool isThere = Norm(this->At(cut.second) - x) <= this->Tolerance;
      lowest = isThere ? std::min(lowest, cut.second) : lowest;
    }
  }
  return lowest;
}

// Where several edges cross in one point but for rounding, they have that in common.
void SkdEdgeCuts::CutBoth(const Ends& a, const Ends& b)
{
  if (!this->Crossings.insert(std::minmax(a, b)).second)
  {
    return;
  }
  const double first = this->DistanceOf(b, a.first);
  const double second = this->DistanceOf(b, a.second);
  const skd::Vector3 from = this->At(a.first);
  const skd::Vector3 x = from + (first / (first - second)) * (this->At(a.second) - from);
  const auto known = std::min(this->FindCut(a, x), this->FindCut(b, x));
  const std::uint32_t number =
    known == None ? this->First + static_cast<std::uint32_t>(this->Positions.size()) : known;
  if (known == None)
  {
    this->Positions.push_back(x);
  }
  this->Cuts[a].emplace_back(Norm(x - from), number);
  this->Cuts[b].emplace_back(Norm(x - this->At(b.first)), number);
}

//------------------------------------------------------------------------------
namespace
{
/// Divides the piece that has the edge from a point to the last of a line, in which others are.
void Divide(
  std::vector<Corners>& pieces, std::uint32_t from, const std::vector<std::uint32_t>& line)
{
  for (Corners& piece : pieces)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (piece[i] == from && piece[(i + 1) % 3] == line.back())
      {
        const std::uint32_t tip = piece[(i + 2) % 3];
        piece = { from, line[0], tip };
        for (std::size_t next = 1; next < line.size(); ++next)
        {
          pieces.push_back({ line[next - 1], line[next], tip });
        }
        return;
      }
    }
  }
}
}

std::vector<Corners> SkdEdgeCuts::PiecesOf(std::uint32_t facet) const
{
  const Corners& corners = this->Facets.Corners[facet];
  std::vector<Corners> pieces{ corners };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::uint32_t from = corners[i];
    const std::uint32_t to = corners[(i + 1) % 3];
    std::vector<std::uint32_t> line = this->ListPoints(EndsOf(from, to));
    if (!line.empty())
    {
      if (from > to)
      {
        std::reverse(line.begin(), line.end());
      }
      line.push_back(to);
      Divide(pieces, from, line);
    }
  }
  return pieces;
}

SkdRoundedFacets SkdEdgeCuts::Split(const SkdFacetSigns& signs) const
{
  Collector split(*this);
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    if (signs[facet] != 0)
    {
      for (const Corners& piece : this->PiecesOf(facet))
      {
        split.Add(piece, this->Facets.Parents[facet], signs[facet]);
      }
    }
  }
  return split.Take();
}

//------------------------------------------------------------------------------
SkdEdgeCuts::Collector::Collector(const SkdEdgeCuts& cuts)
  : Cuts(cuts)
  , OnFaces(cuts.Set, cuts.Parts.GetFaces(), cuts.Parts.GetOrigins())
  , Points(cuts.Facets.NewPoints.Get())
  , IsAdded(cuts.Positions.size(), false)
{
  this->Points.resize(this->Points.size() + this->IsAdded.size());
}

// A new point is as of the face of the first facet that has it.
void SkdEdgeCuts::Collector::Add(const Corners& corners, std::uint32_t parent, signed char sign)
{
  this->Collected.Facets.Corners.push_back(corners);
  this->Collected.Facets.Parents.push_back(parent);
  this->Collected.Signs.push_back(sign);
  for (const std::uint32_t point : corners)
  {
    if (this->Cuts.IsNew(point) && !this->IsAdded[point - this->Cuts.First])
    {
      this->IsAdded[point - this->Cuts.First] = true;
      this->Points[point - this->Cuts.Set.GetPoints().size()] =
        this->OnFaces.PointAt(parent, this->Cuts.At(point));
    }
  }
}

SkdRoundedFacets SkdEdgeCuts::Collector::Take()
{
  this->Collected.Facets.NewPoints = std::move(this->Points);
  return std::move(this->Collected);
}
}
