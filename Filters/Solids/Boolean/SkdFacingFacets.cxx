// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFacingFacets.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/MarkedNumbers.h"
#include "Core/Search/Tree/PackedRTree.h"
#include "Solids/Boolean/SkdFaceSets.h"
#include "Solids/Boolean/SkdRoundedPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
using Triangle = std::array<skd::Vector3, 3>;

/// Whether b is outside of a along one of its edges.
bool IsBesideAnEdge(
  const Triangle& a, const Triangle& b, const skd::Vector3& normal, double tolerance)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const skd::Vector3 edge = a[(i + 1) % 3] - a[i];
    const skd::Vector3 across = Cross(normal, edge);
    const double inside = Dot(across, a[(i + 2) % 3] - a[i]) < 0.0 ? -1.0 : 1.0;
    const double most = tolerance * Norm(across);
    const auto isOutside = [&](const skd::Vector3& x)
    { return inside * Dot(across, x - a[i]) <= most; };
    if (std::all_of(b.begin(), b.end(), isOutside))
    {
      return true;
    }
  }
  return false;
}

/// Planes rounded to steps of about 1/4096 in direction and distance, whichever way they face, as
/// numbers of a table of marks. Those that are one but for rounding are the same, but for very few
/// directions near an end of a step.
class PlaneTable
{
public:
  PlaneTable(const skd::Box3& bounds, std::size_t count)
    : Center(bounds.Centroid())
    , Steps(4096.0 / std::max(Norm(bounds.Max - bounds.Min), std::numeric_limits<double>::min()))
  {
    constexpr std::uint32_t most = 1u << 31;
    while (this->Size < 32 * count && this->Size < most)
    {
      this->Size *= 2;
    }
  }

  struct Place
  {
    std::uint32_t Numbers[2]; // different if the plane is near an end of a step
    bool IsReversed;          // whether it faces to the center
    bool IsAmbiguous;         // whether it may do so by rounding: the center is in it
  };

  /// Of a plane with a normal of length 1, through a point.
  Place Find(const skd::Vector3& normal, const skd::Vector3& x) const
  {
    constexpr double near = 0.01; // steps, far more than rounding
    const double distance = this->Steps * Dot(normal, x - this->Center);
    const double sign = distance < 0.0 ? -1.0 : 1.0;
    const double away = sign * distance;
    const std::uint64_t direction = this->Pack(sign * normal);
    const auto numberAt = [&](double at) { return this->Hash(direction, at); };
    return { { numberAt(away), numberAt(away + near) }, sign < 0.0, away < near };
  }
  std::uint32_t GetSize() const { return this->Size; }

private:
  static std::uint64_t Pack(const skd::Vector3& normal)
  {
    constexpr double steps = 4096.0;
    constexpr double offset = 4096.37; // makes all positive; those along the axes are within a step
    std::uint64_t number = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      number = (number << 14) |
        static_cast<std::uint32_t>(static_cast<std::int32_t>(steps * normal[axis] + offset));
    }
    return number;
  }

  std::uint32_t Hash(std::uint64_t direction, double distance) const
  {
    const auto step = static_cast<std::uint32_t>(static_cast<std::int32_t>(distance));
    const std::uint64_t number = direction << 14 ^ step;
    return static_cast<std::uint32_t>(number * 0x9e3779b97f4a7c15u >> 32) & (this->Size - 1);
  }

  skd::Vector3 Center;
  double Steps;              // for each unit of distance
  std::uint32_t Size = 1024; // a power of two
};

class FacingFacets
{
public:
  FacingFacets(const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
    const std::vector<std::uint32_t>& origins, const SkdFaceSets& faces)
    : Set(set)
    , Facets(facets)
    , Signs(signs)
    , Origins(origins)
    , Faces(faces)
  {
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> Find()
  {
    this->ListSome();
    std::vector<skd::Box3> boxes;
    for (const Facet& facet : this->Some)
    {
      skd::Box3 box;
      std::for_each(
        facet.Corners.begin(), facet.Corners.end(), [&box](const auto& x) { box.Add(x); });
      boxes.push_back(box.Inflated(facet.Tolerance));
    }
    const skd::PackedRTree tree(boxes);
    std::vector<std::vector<std::uint32_t>> others(this->Some.size());
    SkdForEach(this->Some.size(),
      [&](std::size_t i)
      {
        tree.ForEachOverlapping(boxes[i],
          [&](std::uint32_t k)
          {
            if (i < k && this->AreFacing(this->Some[i], this->Some[k]))
            {
              others[i].push_back(this->Some[k].Number);
            }
          });
        std::sort(others[i].begin(), others[i].end());
      });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      for (const std::uint32_t other : others[i])
      {
        pairs.emplace_back(this->Some[i].Number, other);
      }
    }
    return pairs;
  }

private:
  struct Facet
  {
    std::uint32_t Number;
    Triangle Corners;
    skd::Vector3 Normal; // as the boundary has it, of length 1
    double Tolerance;
  };

  /// As Facet has it; 0 without an area.
  skd::Vector3 NormalOf(std::uint32_t facet, const Triangle& x) const
  {
    const skd::Vector3 normal = Cross(x[1] - x[0], x[2] - x[0]);
    const double length = Norm(normal);
    return length > 0.0 ? (this->Signs[facet] / length) * normal : skd::Vector3{};
  }
  std::uint32_t FaceOf(const Facet& facet) const
  {
    const std::uint32_t parent = this->Facets.Parents[facet.Number];
    return this->Origins.empty() ? parent : this->Origins[parent] / 2;
  }

  /// Lists facets in the plane of some others which face the other way, and a few more, but no
  /// slivers.
  void ListSome()
  {
    skd::Box3 bounds;
    for (const skd::Vector3& x : this->Set.GetPoints())
    {
      bounds.Add(x);
    }
    const auto n = static_cast<std::uint32_t>(this->Signs.size());
    const PlaneTable table(bounds, n);
    std::vector<PlaneTable::Place> places(n);
    SkdForEach(n,
      [&](std::uint32_t facet)
      {
        if (this->Signs[facet] != 0)
        {
          const Triangle x = this->Facets.GetPositions(this->Set, facet);
          places[facet] = table.Find(this->NormalOf(facet, x), x[0]);
        }
      });
    std::array<skd::MarkedNumbers, 2> marks{ skd::MarkedNumbers(table.GetSize()),
      skd::MarkedNumbers(table.GetSize()) }; // of either way
    for (std::uint32_t facet = 0; facet < n; ++facet)
    {
      if (this->Signs[facet] != 0)
      {
        marks[places[facet].IsReversed].Mark(places[facet].Numbers[0]);
        marks[places[facet].IsReversed].Mark(places[facet].Numbers[1]);
      }
    }
    for (std::uint32_t facet = 0; facet < n; ++facet)
    {
      const PlaneTable::Place& at = places[facet];
      const skd::MarkedNumbers& others = marks[!at.IsReversed];
      if (this->Signs[facet] != 0 &&
        (at.IsAmbiguous || others.IsMarked(at.Numbers[0]) || others.IsMarked(at.Numbers[1])))
      {
        this->Add(facet);
      }
    }
  }

  void Add(std::uint32_t facet)
  {
    const Triangle x = this->Facets.GetPositions(this->Set, facet);
    const double tolerance = SkdToleranceOf(this->Set.GetCornerPoints(this->Facets.Parents[facet]));
    if (SkdWidthOf(x) > tolerance)
    {
      this->Some.push_back({ facet, x, this->NormalOf(facet, x), tolerance });
    }
  }

  bool AreFacing(const Facet& a, const Facet& b) const
  {
    constexpr double least = -1.0 + 1e-6;
    const double tolerance = std::max(a.Tolerance, b.Tolerance);
    return Dot(a.Normal, b.Normal) < least &&
      this->Faces.AreInOnePlane(this->FaceOf(a), this->FaceOf(b)) &&
      SkdDoOverlap(a.Corners, b.Corners, a.Normal, tolerance);
  }

  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  const SkdFacetSigns& Signs;
  const std::vector<std::uint32_t>& Origins;
  const SkdFaceSets& Faces;
  std::vector<Facet> Some;
};
}

//------------------------------------------------------------------------------
bool SkdDoOverlap(
  const Triangle& a, const Triangle& b, const skd::Vector3& normal, double tolerance)
{
  return !IsBesideAnEdge(a, b, normal, tolerance) && !IsBesideAnEdge(b, a, normal, tolerance);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::uint32_t, std::uint32_t>> SkdFindFacingFacets(
  const SkdMovedTriangles& set, const SkdFacets& facets, const SkdFacetSigns& signs,
  const std::vector<std::uint32_t>& origins, const SkdFaceSets& faces)
{
  return FacingFacets(set, facets, signs, origins, faces).Find();
}
}
