// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdOverlaps.h"

#include "Core/Geometry/Predicates/ExactPoint.h"
#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>

namespace skdtree
{
namespace
{
using Corners = SkdTriangleSet::Corners;
constexpr std::uint32_t None = SkdSplitSegments::None;

class Search
{
public:
  Search(const std::vector<SkdTrianglePair>& pairs, const SkdContactPoints& contacts,
    const SkdSplitSegments& segments, const SkdSplitResult& split)
    : Pairs(pairs)
    , Contacts(contacts)
    , Points(segments.GetPoints())
    , Set(*segments.GetSide(0).Set)
    , Split(split)
    , PointOf(this->Set.GetPoints().size(), None)
  {
    const std::vector<std::uint32_t>& cornerOf = segments.GetSide(0).CornerOf;
    for (std::uint32_t point = 0; point < this->Points.GetNumberOfPoints(); ++point)
    {
      if (cornerOf[point] != None)
      {
        this->PointOf[cornerOf[point]] = this->Points.Find(point);
      }
    }
  }

  void Add(std::size_t pair, SkdOverlaps& overlaps) const
  {
    const std::uint32_t lower = this->Pairs[pair].First;
    const std::uint32_t higher = this->Pairs[pair].Second;
    const int axis = this->Set.Get(lower).Axis;
    const int sign = this->OrientationOf(lower, axis) * this->OrientationOf(higher, axis);
    this->ForEachPieceIn(pair, lower, axis,
      [&](std::uint32_t piece) {
        overlaps.Layers.push_back({ piece, higher, sign });
      });
    this->ForEachPieceIn(
      pair, higher, axis, [&](std::uint32_t piece) { overlaps.IsHigher[piece] = true; });
  }

private:
  int OrientationOf(std::uint32_t triangle, int axis) const
  {
    const auto x = this->Set.GetCornerPoints(triangle);
    return skd::Orient2D(x[0], x[1], x[2], axis);
  }

  /// The pieces of a triangle within the overlap of a pair.
  template <class Visit>
  void ForEachPieceIn(std::size_t pair, std::uint32_t triangle, int axis, const Visit& visit) const
  {
    const std::vector<std::uint32_t>& parents = this->Split.Parents;
    const auto range = std::equal_range(parents.begin(), parents.end(), triangle);
    for (auto at = range.first; at != range.second; ++at)
    {
      const auto piece = static_cast<std::uint32_t>(at - parents.begin());
      if (this->IsInside(this->Split.Triangles[piece], pair, axis))
      {
        visit(piece);
      }
    }
  }

  /// No piece crosses a side of the overlap, so its centroid decides, unless rounding could matter.
  bool IsInside(const Corners& piece, std::size_t pair, int axis) const
  {
    std::array<std::uint32_t, 3> points;
    skd::Vector3 centroid{ { 0.0, 0.0, 0.0 } };
    for (std::size_t i = 0; i < 3; ++i)
    {
      points[i] = this->PointAt(piece[i]);
      if (points[i] == None)
      {
        return false;
      }
      centroid = centroid + (1.0 / 3.0) * this->Points.GetPosition(points[i]);
    }
    const double error = 2.0 * this->Points.GetError();
    const auto sureSide = [&](std::uint32_t a, std::uint32_t b)
    {
      return skd::FilteredOrient2D(
        this->Points.GetPosition(a), this->Points.GetPosition(b), centroid, axis, error);
    };
    Sides sides;
    const bool isSure = this->AddSides(pair, sureSide, sides);
    if (isSure || sides.AreBoth())
    {
      return !sides.AreBoth();
    }
    for (const std::uint32_t point : points)
    {
      this->AddSides(
        pair,
        [&](std::uint32_t a, std::uint32_t b)
        { return point == a || point == b ? 0 : this->Points.Orient(a, b, point, axis); },
        sides);
    }
    return !sides.AreBoth();
  }

  struct Sides
  {
    bool IsLeft = false;
    bool IsRight = false;
    bool AreBoth() const { return this->IsLeft && this->IsRight; }
  };

  /// On which sides of the sides of an overlap something is. Returns whether it is on none of them.
  template <class SideOf>
  bool AddSides(std::size_t pair, const SideOf& sideOf, Sides& sides) const
  {
    const int count = this->Pairs[pair].Contact.Count;
    bool isOff = true;
    for (int i = 0; i < count && !sides.AreBoth(); ++i)
    {
      const int side = sideOf(this->Points.Find(this->Contacts.GetPoint(pair, i)),
        this->Points.Find(this->Contacts.GetPoint(pair, (i + 1) % count)));
      sides.IsLeft = sides.IsLeft || side > 0;
      sides.IsRight = sides.IsRight || side < 0;
      isOff = isOff && side != 0;
    }
    return isOff;
  }

  /// A point of the contacts, or None.
  std::uint32_t PointAt(std::uint32_t corner) const
  {
    const std::size_t given = this->PointOf.size();
    return corner < given ? this->PointOf[corner] : this->Split.Ids[corner - given];
  }

  const std::vector<SkdTrianglePair>& Pairs;
  const SkdContactPoints& Contacts;
  const SkdSplitPoints& Points;
  const SkdMovedTriangles& Set;
  const SkdSplitResult& Split;
  std::vector<std::uint32_t> PointOf; // of each corner
};
}

void SkdOverlaps::Add(const std::vector<SkdDuplicate>& duplicates, const SkdSplitResult& split)
{
  std::vector<SkdFacetLayer> more;
  const auto addAt = [&](std::uint32_t piece, std::uint32_t original, int sign)
  {
    auto at =
      std::lower_bound(duplicates.begin(), duplicates.end(), SkdDuplicate{ original, 0, 0 });
    for (; at != duplicates.end() && at->Original == original; ++at)
    {
      more.push_back({ piece, at->Triangle, sign * at->Sign });
    }
  };
  for (const SkdFacetLayer& layer : this->Layers)
  {
    addAt(layer.Facet, layer.Parent, layer.Sign);
  }
  std::vector<bool> isDuplicate;
  for (const SkdDuplicate& duplicate : duplicates)
  {
    isDuplicate.resize(std::max<std::size_t>(isDuplicate.size(), duplicate.Triangle + 1), false);
    isDuplicate[duplicate.Triangle] = true;
  }
  for (std::uint32_t piece = 0; piece < split.Triangles.size(); ++piece)
  {
    const std::uint32_t parent = split.Parents[piece];
    this->IsHigher[piece] =
      this->IsHigher[piece] || (parent < isDuplicate.size() && isDuplicate[parent]);
    addAt(piece, parent, 1);
  }
  this->Layers.insert(this->Layers.end(), more.begin(), more.end());
  std::sort(this->Layers.begin(), this->Layers.end());
}

SkdOverlaps SkdFindOverlaps(const std::vector<SkdTrianglePair>& pairs,
  const SkdContactPoints& contacts, const SkdSplitSegments& segments, const SkdSplitResult& split)
{
  SkdOverlaps overlaps{ std::vector<bool>(split.Triangles.size(), false), {} };
  const Search search(pairs, contacts, segments, split);
  for (std::size_t pair = 0; pair < pairs.size(); ++pair)
  {
    if (pairs[pair].Contact.Count > 2)
    {
      search.Add(pair, overlaps);
    }
  }
  std::sort(overlaps.Layers.begin(), overlaps.Layers.end());
  return overlaps;
}
}
