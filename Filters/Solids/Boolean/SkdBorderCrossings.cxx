// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBorderCrossings.h"

#include "Core/Geometry/DisjointSets.h"
#include "Solids/Boolean/SkdEdgeCuts.h"

namespace skdtree
{
namespace
{
using BorderEdge = SkdPieceParts::BorderEdge;

class BorderCrossings
{
public:
  BorderCrossings(const SkdMovedTriangles& set, const SkdFacets& facets)
    : Set(set)
    , Facets(facets)
    , Cuts(set, facets)
  {
  }

  void Add(const SkdPieceParts& parts, std::uint32_t a, std::uint32_t b)
  {
    const double tolerance = parts.GetToleranceOf(a, b);
    this->Cuts.SetPlane(this->NormalOf(parts.GetFirstFacetOf(a)), tolerance);
    for (const std::uint32_t i : parts.GetBorderOf(a))
    {
      for (const std::uint32_t j : parts.GetBorderOf(b))
      {
        const BorderEdge& first = parts.GetBorder()[i];
        const BorderEdge& second = parts.GetBorder()[j];
        if (first.From != second.From &&
          Norm(this->At(first.From) - this->At(second.From)) <= tolerance)
        {
          this->Equal.emplace_back(first.From, second.From);
        }
        this->Cuts.Meet(
          SkdEdgeCuts::EndsOf(first.From, first.To), SkdEdgeCuts::EndsOf(second.From, second.To));
      }
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
  SkdEdgeCuts Cuts;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Equal; // points, but for rounding
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
