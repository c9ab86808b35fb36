// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdOppositeParts.h"

#include "Solids/Boolean/SkdBoxSet.h"
#include "Solids/Boolean/SkdFacingFacets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace skdtree
{
namespace
{
using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Triangle = std::array<skd::Vector3, 3>;

class OppositeParts
{
public:
  OppositeParts(const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
    const SkdPieceParts& parts, const SkdFaceSets& faces, const std::vector<Pair>& facing)
    : Set(set)
    , Facets(facets)
    , Signs(signs)
    , Parts(parts)
    , Faces(faces)
    , Facing(facing)
  {
    for (std::uint32_t part = 0; part < parts.GetNumberOfParts(); ++part)
    {
      this->Normals.push_back(this->FindNormal(part));
    }
  }

  template <class AreApart>
  std::vector<Pair> Find(const AreApart& areApart, bool areSeveral)
  {
    std::vector<Pair> pairs = this->ListParallel();
    const auto isLeftOut = [&](const Pair& pair)
    { return areApart(pair.first, pair.second) || !this->AreLaid(pair.first, pair.second); };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isLeftOut), pairs.end());
    return this->Choose(pairs, areSeveral);
  }

private:
  /// Of all pairs some: of the parts in a pair one is in no other, and both with !areSeveral.
  std::vector<Pair> Choose(const std::vector<Pair>& pairs, bool areSeveral) const
  {
    std::vector<std::uint32_t> counts(this->Normals.size(), 0);
    for (const auto& [first, second] : pairs)
    {
      ++counts[first];
      ++counts[second];
    }
    enum Role : unsigned char
    {
      Free,
      One,    // in one pair
      Several // in one or more, each with one that is in no other
    };
    std::vector<Role> roles(this->Normals.size(), Free);
    std::vector<Pair> chosen;
    for (const Pair& pair : pairs)
    {
      const bool isFirstOne = counts[pair.first] <= counts[pair.second];
      Role& one = roles[isFirstOne ? pair.first : pair.second];
      Role& several = roles[isFirstOne ? pair.second : pair.first];
      if (one == Free && (several == Free || (several == Several && areSeveral)))
      {
        one = One;
        several = Several;
        chosen.push_back(pair);
      }
    }
    return chosen;
  }

  /// Of the first piece, as the boundary has it; of length 1.
  skd::Vector3 FindNormal(std::uint32_t part) const
  {
    const std::uint32_t facet = this->Parts.GetFirstFacetOf(part);
    const Triangle x = this->Set.GetCornerPoints(this->Facets.Parents[facet]);
    const skd::Vector3 normal = Cross(x[1] - x[0], x[2] - x[0]);
    return (this->Signs[facet] / Norm(normal)) * normal;
  }

  /// Parts that meet at a point and face opposite ways, or nearly, and those of the facets that are
  /// known to face each other, each pair once.
  std::vector<Pair> ListParallel() const
  {
    constexpr double least = -1.0 + 1e-6;
    constexpr std::size_t most = 64; // parts, which are compared with each other
    std::vector<Pair> pairs;
    for (const auto& [first, second] : this->Facing)
    {
      pairs.push_back(
        std::minmax({ this->Parts.GetPartOfFacet(first), this->Parts.GetPartOfFacet(second) }));
    }
    const std::vector<SkdPieceParts::BorderEdge>& border = this->Parts.GetBorder();
    for (std::size_t begin = 0, end = 0; begin < border.size(); begin = end)
    {
      while (end < border.size() && border[end].From == border[begin].From)
      {
        ++end;
      }
      for (std::size_t i = begin; i < end && end - begin <= most; ++i)
      {
        const skd::Vector3& normal = this->Normals[border[i].Part];
        for (std::size_t j = begin; j < i; ++j)
        {
          if (Dot(normal, this->Normals[border[j].Part]) < least)
          {
            pairs.push_back(std::minmax(border[i].Part, border[j].Part));
          }
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  /// In one plane, and one over the other.
  bool AreLaid(std::uint32_t a, std::uint32_t b)
  {
    const auto originOf = [this](std::uint32_t part)
    { return this->Parts.GetOriginOf(this->Parts.GetFirstFacetOf(part)) / 2; };
    if (!this->Faces.AreInOnePlane(originOf(a), originOf(b)))
    {
      return false;
    }
    const bool isFirstLarger =
      this->Parts.GetPiecesOf(a).size() > this->Parts.GetPiecesOf(b).size();
    const std::uint32_t large = isFirstLarger ? a : b;
    const SkdBoxSet& boxes = this->BoxesOf(large);
    const skd::Vector3& normal = this->Normals[a];
    const double tolerance = this->Parts.GetToleranceOf(a, b);
    const auto pieces = this->Parts.GetPiecesOf(isFirstLarger ? b : a);
    return std::any_of(pieces.begin(), pieces.end(),
      [&](std::uint32_t piece)
      {
        const Triangle x = this->Parts.PositionsOf(piece);
        bool isLaid = false;
        boxes.ForEachOverlapping(SkdBoxSet::BoxOf(x, tolerance),
          [&](std::uint32_t k)
          {
            const std::uint32_t other = this->Parts.GetPiecesOf(large)[k];
            isLaid = isLaid || SkdDoOverlap(x, this->Parts.PositionsOf(other), normal, tolerance);
          });
        return isLaid;
      });
  }

  /// Of the pieces of a part, which may be in many pairs.
  const SkdBoxSet& BoxesOf(std::uint32_t part)
  {
    auto known = this->Boxes.find(part);
    if (known == this->Boxes.end())
    {
      std::vector<skd::Box3> boxes;
      for (const std::uint32_t piece : this->Parts.GetPiecesOf(part))
      {
        boxes.push_back(SkdBoxSet::BoxOf(this->Parts.PositionsOf(piece), 0.0));
      }
      known = this->Boxes.emplace(part, SkdBoxSet(std::move(boxes))).first;
    }
    return known->second;
  }

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdFacetSigns& Signs;
  const SkdPieceParts& Parts;
  const SkdFaceSets& Faces;
  const std::vector<Pair>& Facing;
  std::vector<skd::Vector3> Normals;        // of each part
  std::map<std::uint32_t, SkdBoxSet> Boxes; // of parts
};
}

std::vector<Pair> SkdFindOppositeParts(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const SkdPieceParts& parts, const SkdFaceSets& faces,
  const std::vector<Pair>& facing, bool areSeveral,
  const std::function<bool(std::uint32_t, std::uint32_t)>& areApart)
{
  return OppositeParts(set, facets, signs, parts, faces, facing).Find(areApart, areSeveral);
}
}
