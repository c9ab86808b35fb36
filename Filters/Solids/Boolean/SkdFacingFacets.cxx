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
using Pair = std::pair<std::uint32_t, std::uint32_t>;

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
    bool IsReversed;          // against the way that both of a plane agree on
  };

  /// Of a plane with a normal of length 1, through a point.
  Place Find(const skd::Vector3& normal, const skd::Vector3& x) const
  {
    constexpr double near = 0.01; // steps, far more than rounding
    const double distance = this->Steps * Dot(normal, x - this->Center);
    const bool isByNormal = std::abs(distance) < near; // away from the center is by rounding then
    const bool isReversed = isByNormal ? IsNegative(normal) : distance < 0.0;
    const std::uint64_t direction = Pack(isReversed ? -1.0 * normal : normal);
    const double away = std::abs(distance);
    return { { this->Hash(direction, away), this->Hash(direction, away + near) }, isReversed };
  }
  std::uint32_t GetSize() const { return this->Size; }

private:
  /// By the largest component.
  static bool IsNegative(const skd::Vector3& normal)
  {
    const int axis = std::abs(normal[0]) > 0.57 ? 0 : std::abs(normal[1]) > 0.57 ? 1 : 2;
    return normal[axis] < 0.0;
  }

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

  std::vector<Pair> Find()
  {
    this->ListSome();
    std::vector<Pair> pairs;
    for (auto first = this->Some.begin(), last = first; first != this->Some.end(); first = last)
    {
      last = std::find_if(first, this->Some.end(),
        [first](const Facet& facet) { return facet.Plane != first->Plane; });
      this->AddPairs(&*first, &*first + (last - first), pairs);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

private:
  struct Facet
  {
    std::uint32_t Plane; // number in the table
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
      for (int i = 0; i < 2 && this->Signs[facet] != 0; ++i)
      {
        if (others.IsMarked(at.Numbers[i]) && (i == 0 || at.Numbers[1] != at.Numbers[0]))
        {
          this->Add(facet, at.Numbers[i]);
        }
      }
    }
    std::sort(this->Some.begin(), this->Some.end(),
      [](const Facet& a, const Facet& b)
      { return a.Plane != b.Plane ? a.Plane < b.Plane : a.Number < b.Number; });
  }

  void Add(std::uint32_t facet, std::uint32_t plane)
  {
    const Triangle x = this->Facets.GetPositions(this->Set, facet);
    const double tolerance = SkdToleranceOf(this->Set.GetCornerPoints(this->Facets.Parents[facet]));
    if (SkdWidthOf(x) > tolerance)
    {
      this->Some.push_back({ plane, facet, x, this->NormalOf(facet, x), tolerance });
    }
  }

  /// Of facets in one plane, or a few. Their boxes are along the first one's longest edge, as those
  /// of thin ones that are parallel overlap along other axes.
  void AddPairs(const Facet* first, const Facet* last, std::vector<Pair>& pairs) const
  {
    const std::array<skd::Vector3, 3> axes = AxesOf(*first);
    std::vector<skd::Box3> boxes;
    for (const Facet* facet = first; facet != last; ++facet)
    {
      skd::Box3 box;
      for (const skd::Vector3& x : facet->Corners)
      {
        box.Add({ { Dot(axes[0], x), Dot(axes[1], x), Dot(axes[2], x) } });
      }
      boxes.push_back(box.Inflated(facet->Tolerance));
    }
    const skd::PackedRTree tree(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      tree.ForEachOverlapping(boxes[i],
        [&](std::uint32_t k)
        {
          if (i < k && boxes[i].Overlaps(boxes[k]) && this->AreFacing(first[i], first[k]))
          {
            pairs.emplace_back(first[i].Number, first[k].Number);
          }
        });
    }
  }

  /// Along the longest edge, across it and along the normal.
  static std::array<skd::Vector3, 3> AxesOf(const Facet& facet)
  {
    skd::Vector3 longest{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const skd::Vector3 edge = facet.Corners[(i + 1) % 3] - facet.Corners[i];
      longest = Norm2(edge) > Norm2(longest) ? edge : longest;
    }
    const skd::Vector3 along = (1.0 / Norm(longest)) * longest;
    return { along, Cross(facet.Normal, along), facet.Normal };
  }

  bool AreFacing(const Facet& a, const Facet& b) const
  {
    constexpr double least = -1.0 + 1e-6;
    const double tolerance = std::max(a.Tolerance, b.Tolerance);
    return Dot(a.Normal, b.Normal) < least &&
      SkdDoOverlap(a.Corners, b.Corners, a.Normal, tolerance) &&
      this->Faces.AreInOnePlane(this->FaceOf(a), this->FaceOf(b));
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
