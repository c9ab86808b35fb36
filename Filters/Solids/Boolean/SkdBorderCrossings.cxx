// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBorderCrossings.h"

#include "Core/Geometry/DisjointSets.h"
#include "Solids/Boolean/SkdBoxSet.h"
#include "Solids/Boolean/SkdEdgeCuts.h"

#include <array>
#include <map>

namespace skdtree
{
namespace
{
using BorderEdge = SkdPieceParts::BorderEdge;

class BorderCrossings
{
public:
  BorderCrossings(const SkdMovedTriangles& set, const SkdFacets& facets, const SkdPieceParts& parts)
    : Set(set)
    , Facets(facets)
    , Parts(parts)
    , Cuts(set, facets, parts)
  {
  }

  void Add(std::uint32_t a, std::uint32_t b)
  {
    const bool isFirstLarger =
      this->Parts.GetBorderOf(a).size() > this->Parts.GetBorderOf(b).size();
    const std::uint32_t large = isFirstLarger ? a : b;
    const SkdBoxSet& boxes = this->BoxesOf(large);
    const double tolerance = this->Parts.GetToleranceOf(a, b);
    this->Cuts.SetPlane(this->NormalOf(this->Parts.GetFirstFacetOf(a)), tolerance);
    for (const std::uint32_t i : this->Parts.GetBorderOf(isFirstLarger ? b : a))
    {
      const BorderEdge& first = this->Parts.GetBorder()[i];
      boxes.ForEachOverlapping(this->BoxOf(first, tolerance),
        [&](std::uint32_t k)
        {
          const std::uint32_t second = this->Parts.GetBorderOf(large)[k];
          this->Meet(first, this->Parts.GetBorder()[second], tolerance);
        });
    }
  }

  std::optional<SkdRoundedFacets> Split(const SkdFacetSigns& signs) const
  {
    if (!this->Equal.empty())
    {
      return this->UniteEqual(signs);
    }
    return this->Cuts.IsEmpty() ? std::nullopt : std::make_optional(this->Cuts.Split(signs));
  }

private:
  skd::Box3 BoxOf(const BorderEdge& edge, double tolerance) const
  {
    return SkdBoxSet::BoxOf(std::array{ this->At(edge.From), this->At(edge.To) }, tolerance);
  }

  /// Of the edges around a part, which may be in many pairs.
  const SkdBoxSet& BoxesOf(std::uint32_t part)
  {
    auto known = this->Boxes.find(part);
    if (known == this->Boxes.end())
    {
      std::vector<skd::Box3> boxes;
      for (const std::uint32_t edge : this->Parts.GetBorderOf(part))
      {
        boxes.push_back(
          this->BoxOf(this->Parts.GetBorder()[edge], this->Parts.GetToleranceOf(part, part)));
      }
      known = this->Boxes.emplace(part, SkdBoxSet(std::move(boxes))).first;
    }
    return known->second;
  }

  void Meet(const BorderEdge& a, const BorderEdge& b, double tolerance)
  {
    if (a.From != b.From && Norm(this->At(a.From) - this->At(b.From)) <= tolerance)
    {
      this->Equal.emplace_back(a.From, b.From);
    }
    this->Cuts.Meet(SkdEdgeCuts::EndsOf(a.From, a.To), SkdEdgeCuts::EndsOf(b.From, b.To));
  }

  skd::Vector3 At(std::uint32_t point) const { return this->Facets.GetPosition(this->Set, point); }

  skd::Vector3 NormalOf(std::uint32_t facet) const
  {
    const auto x = this->Facets.GetPositions(this->Set, facet);
    const skd::Vector3 normal = Cross(x[1] - x[0], x[2] - x[0]);
    return (1.0 / Norm(normal)) * normal;
  }

  /// The boundary with points that are one but for rounding as one.
  SkdRoundedFacets UniteEqual(const SkdFacetSigns& signs) const
  {
    const auto count =
      static_cast<std::uint32_t>(this->Set.GetPoints().size() + this->Facets.NewPoints.size());
    skd::DisjointSets<> points(count);
    for (const auto& [first, second] : this->Equal)
    {
      points.Unite(first, second);
    }
    std::vector<std::uint32_t> lowest(count);
    for (std::uint32_t point = 0; point < count; ++point)
    {
      lowest[point] = points.Find(point);
    }
    SkdRoundedFacets united =
      SkdUniteEqualPoints(SkdMakeRounded(this->Facets, signs), lowest, false);
    std::size_t left = 0;
    for (std::size_t facet = 0; facet < united.Signs.size(); ++facet)
    {
      if (united.Signs[facet] != 0)
      {
        united.Facets.Corners[left] = united.Facets.Corners[facet];
        united.Facets.Parents[left] = united.Facets.Parents[facet];
        united.Signs[left++] = united.Signs[facet];
      }
    }
    united.Facets.Corners.resize(left);
    united.Facets.Parents.resize(left);
    united.Signs.resize(left);
    return united;
  }

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdPieceParts& Parts;
  SkdEdgeCuts Cuts;
  std::map<std::uint32_t, SkdBoxSet> Boxes;                   // of parts
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Equal; // points, but for rounding
};
}

std::optional<SkdRoundedFacets> SkdSplitBorders(const SkdMovedTriangles& set,
  const SkdFacets& facets, const SkdFacetSigns& signs, const SkdPieceParts& parts,
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
{
  BorderCrossings crossings(set, facets, parts);
  for (const auto& [first, second] : pairs)
  {
    crossings.Add(first, second);
  }
  return crossings.Split(signs);
}
}
