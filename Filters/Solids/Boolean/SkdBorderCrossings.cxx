// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBorderCrossings.h"

#include "Core/Geometry/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;
using BorderEdge = SkdPieceParts::BorderEdge;

/// Ascending ends of an edge.
using Ends = std::pair<std::uint32_t, std::uint32_t>;

Ends EndsOf(std::uint32_t a, std::uint32_t b)
{
  return std::minmax(a, b);
}

/// Where an edge is split: how far along from its lower end, and the point there.
using Cut = std::pair<double, std::uint32_t>;

class BorderCrossings
{
public:
  BorderCrossings(const SkdMovedTriangles& set, const SkdFacets& facets)
    : Set(set)
    , Facets(facets)
    , First(static_cast<std::uint32_t>(set.GetPoints().size() + facets.NewPoints.size()))
  {
  }

  void Add(const SkdPieceParts& parts, std::uint32_t a, std::uint32_t b)
  {
    const skd::Vector3 normal = this->NormalOf(parts.GetFirstFacetOf(a));
    this->Tolerance = parts.GetToleranceOf(a, b);
    for (const std::uint32_t i : parts.GetBorderOf(a))
    {
      for (const std::uint32_t j : parts.GetBorderOf(b))
      {
        this->Meet(parts.GetBorder()[i], parts.GetBorder()[j], normal);
      }
    }
  }

  std::optional<SkdRoundedFacets> Split(const SkdFacetSigns& signs)
  {
    if (!this->Equal.empty())
    {
      return this->UniteEqual(signs);
    }
    if (this->Cuts.empty())
    {
      return std::nullopt;
    }
    this->IsAdded.assign(this->Positions.size(), false);
    SkdRoundedFacets split;
    std::vector<SkdSplitPoint> points = this->Facets.NewPoints.Get();
    points.resize(points.size() + this->Positions.size());
    for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
    {
      if (signs[facet] != 0)
      {
        const std::uint32_t parent = this->Facets.Parents[facet];
        for (const Corners& piece : this->PiecesOf(facet, points))
        {
          split.Facets.Corners.push_back(piece);
          split.Facets.Parents.push_back(parent);
          split.Signs.push_back(signs[facet]);
        }
      }
    }
    split.Facets.NewPoints = std::move(points);
    return split;
  }

private:
  skd::Vector3 At(std::uint32_t point) const { return this->Facets.GetPosition(this->Set, point); }

  skd::Vector3 NormalOf(std::uint32_t facet) const
  {
    const auto x = this->Facets.GetPositions(this->Set, facet);
    const skd::Vector3 normal = Cross(x[1] - x[0], x[2] - x[0]);
    return (1.0 / Norm(normal)) * normal;
  }

  void Meet(const BorderEdge& a, const BorderEdge& b, const skd::Vector3& normal)
  {
    if (a.From != b.From && Norm(this->At(a.From) - this->At(b.From)) <= this->Tolerance)
    {
      this->Equal.emplace_back(a.From, b.From);
    }
    const Ends first = EndsOf(a.From, a.To);
    const Ends second = EndsOf(b.From, b.To);
    const bool isSplit = this->CutAt(first, second.first) | this->CutAt(first, second.second) |
      this->CutAt(second, first.first) | this->CutAt(second, first.second);
    if (!isSplit && this->DoCross(first, second, normal) && this->DoCross(second, first, normal))
    {
      this->CutBoth(first, second, normal);
    }
  }

  /// Whether a point is on an edge but for its ends, which it then cuts.
  bool CutAt(const Ends& edge, std::uint32_t point)
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

  /// How far a point is on the left of an edge, in the plane of the normal.
  double DistanceOf(const Ends& edge, std::uint32_t point, const skd::Vector3& normal) const
  {
    const skd::Vector3 direction = this->At(edge.second) - this->At(edge.first);
    return Dot(normal, Cross(direction, this->At(point) - this->At(edge.first))) / Norm(direction);
  }

  /// Whether the ends of the second edge are on both sides of the first.
  bool DoCross(const Ends& a, const Ends& b, const skd::Vector3& normal) const
  {
    const double first = this->DistanceOf(a, b.first, normal);
    const double second = this->DistanceOf(a, b.second, normal);
    return std::min(first, second) < -this->Tolerance && std::max(first, second) > this->Tolerance;
  }

  void CutBoth(const Ends& a, const Ends& b, const skd::Vector3& normal)
  {
    const auto number = static_cast<std::uint32_t>(this->First + this->Positions.size());
    if (!this->Crossings.emplace(std::minmax(a, b), number).second)
    {
      return;
    }
    const double first = this->DistanceOf(b, a.first, normal);
    const double second = this->DistanceOf(b, a.second, normal);
    const skd::Vector3 from = this->At(a.first);
    const skd::Vector3 x = from + (first / (first - second)) * (this->At(a.second) - from);
    this->Positions.push_back(x);
    this->Cuts[a].emplace_back(Norm(x - from), number);
    this->Cuts[b].emplace_back(Norm(x - this->At(b.first)), number);
  }

  /// The boundary with points that are one but for rounding as one.
  SkdRoundedFacets UniteEqual(const SkdFacetSigns& signs) const
  {
    skd::DisjointSets<> points(this->First);
    for (const auto& [first, second] : this->Equal)
    {
      points.Unite(first, second);
    }
    std::vector<std::uint32_t> lowest(this->First);
    for (std::uint32_t point = 0; point < this->First; ++point)
    {
      lowest[point] = points.Find(point);
    }
    SkdRoundedFacets united =
      SkdUniteEqualPoints(SkdMakeRounded(this->Facets, signs), lowest, false);
    std::size_t count = 0;
    for (std::size_t facet = 0; facet < united.Signs.size(); ++facet)
    {
      if (united.Signs[facet] != 0)
      {
        united.Facets.Corners[count] = united.Facets.Corners[facet];
        united.Facets.Parents[count] = united.Facets.Parents[facet];
        united.Signs[count++] = united.Signs[facet];
      }
    }
    united.Facets.Corners.resize(count);
    united.Facets.Parents.resize(count);
    united.Signs.resize(count);
    return united;
  }

  //----------------------------------------------------------------------------
  std::vector<Corners> PiecesOf(std::uint32_t facet, std::vector<SkdSplitPoint>& points)
  {
    const Corners& corners = this->Facets.Corners[facet];
    std::vector<Corners> pieces{ corners };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t from = corners[i];
      const std::uint32_t to = corners[(i + 1) % 3];
      const auto found = this->Cuts.find(EndsOf(from, to));
      if (found != this->Cuts.end())
      {
        std::vector<std::uint32_t> line = ListPoints(found->second);
        this->AddNew(line, this->Facets.Parents[facet], points);
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

  static std::vector<std::uint32_t> ListPoints(std::vector<Cut> cuts)
  {
    std::sort(cuts.begin(), cuts.end());
    std::vector<std::uint32_t> points;
    for (const Cut& cut : cuts)
    {
      if (std::find(points.begin(), points.end(), cut.second) == points.end())
      {
        points.push_back(cut.second);
      }
    }
    return points;
  }

  /// Points that are new, as of the triangle that is cut there first.
  void AddNew(const std::vector<std::uint32_t>& line, std::uint32_t parent,
    std::vector<SkdSplitPoint>& points)
  {
    for (const std::uint32_t point : line)
    {
      if (point >= this->First && !this->IsAdded[point - this->First])
      {
        this->IsAdded[point - this->First] = true;
        points[point - this->Set.GetPoints().size()] =
          SkdPointIn(this->Set, parent, this->Positions[point - this->First]);
      }
    }
  }

  /// The piece that has the edge from a point to the last of a line, in which others are.
  static void Divide(
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

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  double Tolerance = 0.0;                                     // of the points of two parts
  const std::uint32_t First;                                  // new point
  std::vector<skd::Vector3> Positions;                        // of new points
  std::vector<bool> IsAdded;                                  // these
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Equal; // points, but for rounding
  std::map<Ends, std::vector<Cut>> Cuts;
  std::map<std::pair<Ends, Ends>, std::uint32_t> Crossings; // of edges, the new point
};
}

std::optional<SkdRoundedFacets> SkdSplitBorders(const SkdMovedTriangles& set,
  const SkdFacets& facets, const SkdFacetSigns& signs, const SkdPieceParts& parts,
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
{
  BorderCrossings crossings(set, facets);
  for (const auto& [first, second] : pairs)
  {
    crossings.Add(parts, first, second);
  }
  return crossings.Split(signs);
}
}
