// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdNearSides.h"

#include "Core/Geometry/DisjointSets.h"
#include "Solids/Boolean/SkdLineCrossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace skdtree
{
namespace
{
constexpr int Near = SkdNearSides::Near;
constexpr int Unknown = Near - 1;

class SideSearch
{
public:
  SideSearch(const SkdRigidPair& pair, const SkdPlacement& whole,
    const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& points,
    const SkdArrangedPart& part)
    : Pair(pair)
    , Whole(whole)
    , Triangles(triangles)
    , Points(points)
    , Part(part)
    , OfClusters(pair.GetNumberOfClusters(), Unknown)
    , OfTriangles(pair.GetSet().GetTriangles().size())
  {
    for (const std::uint32_t triangle : triangles)
    {
      int& ofCluster = this->OfClusters[pair.GetClusterOf(triangle)];
      if (ofCluster != Near)
      {
        ofCluster = Near;
        for (const std::uint32_t other : pair.GetTrianglesOfCluster(pair.GetClusterOf(triangle)))
        {
          this->OfTriangles[other] = Unknown;
        }
      }
      this->OfTriangles[triangle] = Near;
    }
  }

  std::optional<SkdNearSides> Find()
  {
    if (!this->FindPatches() || !this->TakeFromFans() || !this->SpreadAll() || !this->FindByLines())
    {
      return std::nullopt;
    }
    SkdNearSides sides;
    for (const std::uint32_t patch : this->PatchOf)
    {
      sides.OfFacets.push_back(this->OfPatches[patch]);
    }
    sides.OfClusters = std::move(this->OfClusters);
    sides.OfTriangles = std::move(this->OfTriangles);
    return sides;
  }

private:
  /// A patch beside a triangle that is not arranged.
  struct Link
  {
    std::uint32_t Triangle;
    std::uint32_t Patch;

    bool operator<(const Link& other) const { return this->Triangle < other.Triangle; }
  };

  int NumberOf(std::uint32_t triangle) const
  {
    const int ofCluster = this->OfClusters[this->Pair.GetClusterOf(triangle)];
    return ofCluster == Near ? this->OfTriangles[triangle] : ofCluster;
  }

  std::uint32_t TriangleOf(std::uint32_t facet) const
  {
    return this->Triangles[this->Part.Facets.Parents[facet]];
  }

  /// Patches are of facets that edges connect which only two of them have. False if an edge is not
  /// of a closed surface.
  bool FindPatches()
  {
    skd::DisjointSets<> patches(this->Part.Facets.GetNumberOfFacets());
    bool isFit = true;
    this->Part.Facets.Edges.ForEach(
      [&](std::uint32_t low, const SkdEdgeUse* first, const SkdEdgeUse* last)
      {
        if (last - first == 2)
        {
          isFit = isFit && first[0].IsForward != first[1].IsForward &&
            this->IsOfSource(first[0]) == this->IsOfSource(first[1]);
          patches.Unite(first[0].Triangle, first[1].Triangle);
        }
        else if (last - first == 1)
        {
          const std::uint32_t beyond = this->FindBeyond(low, *first);
          isFit = isFit && beyond != SkdRigidPair::None && this->NumberOf(beyond) != Near;
          this->Links.push_back({ beyond, first->Triangle });
        }
      });
    this->PatchOf = patches.Number();
    std::uint32_t count = 0;
    for (const std::uint32_t patch : this->PatchOf)
    {
      count = std::max(count, patch + 1);
    }
    this->OfPatches.assign(count, Unknown);
    for (Link& link : this->Links)
    {
      link.Patch = this->PatchOf[link.Patch];
    }
    std::sort(this->Links.begin(), this->Links.end());
    this->LinksOf = skd::IndexRows(count,
      [&](const auto& add)
      {
        for (const Link& link : this->Links)
        {
          add(link.Patch, link.Triangle);
        }
      });
    return isFit;
  }

  bool IsOfSource(const SkdEdgeUse& use) const
  {
    return this->Pair.IsOfSource(this->TriangleOf(use.Triangle));
  }

  /// The triangle beyond an edge of a triangle that is not split there.
  std::uint32_t FindBeyond(std::uint32_t low, const SkdEdgeUse& use) const
  {
    if (std::max(low, use.High) >= this->Points.size())
    {
      return SkdRigidPair::None;
    }
    const std::uint32_t triangle = this->TriangleOf(use.Triangle);
    const SkdTriangleSet::Corners& corners = this->Pair.GetSet().GetTriangles()[triangle];
    const std::uint32_t from = this->Points[use.IsForward ? low : use.High];
    const std::uint32_t to = this->Points[use.IsForward ? use.High : low];
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (corners[i] == from && corners[(i + 1) % 3] == to)
      {
        return this->Pair.GetNeighbours(triangle)[i];
      }
    }
    return SkdRigidPair::None;
  }

  /// How often a facet's own surface winds around what is beside it.
  int NumberAt(std::uint32_t side) const
  {
    const std::uint32_t component = this->Pair.GetComponentOf(this->TriangleOf(side / 2));
    return this->Pair.GetComponents()[component].InFront + static_cast<int>(side % 2);
  }

  bool TakeFromFans()
  {
    return std::all_of(this->Part.Fans.begin(), this->Part.Fans.end(),
      [this](const SkdArrangedPart::Fan& fan) { return this->TakeFrom(fan); });
  }

  /// A turn around the edge comes from the last facet of the other surface and goes on to the next.
  bool TakeFrom(const SkdArrangedPart::Fan& fan)
  {
    if (fan.size() != 4)
    {
      return false;
    }
    std::array<int, 2> counts{};
    std::array<int, 2> sums{};
    for (const SkdEdgeUse& use : fan)
    {
      const bool isOfSource = this->IsOfSource(use);
      ++counts[isOfSource];
      sums[isOfSource] += use.IsForward ? 1 : -1;
    }
    bool isFit = counts[0] == 2 && sums[0] == 0 && sums[1] == 0;
    for (std::size_t i = 0; i < fan.size() && isFit; ++i)
    {
      const bool isOfSource = this->IsOfSource(fan[i]);
      std::size_t next = i;
      std::size_t last = i;
      do
      {
        next = (next + 1) % 4;
      } while (this->IsOfSource(fan[next]) == isOfSource);
      do
      {
        last = (last + 3) % 4;
      } while (this->IsOfSource(fan[last]) == isOfSource);
      const int number = this->NumberAt(SkdSideEntered(fan[next]));
      isFit = number == this->NumberAt(SkdSideLeft(fan[last])) &&
        this->SetPatch(this->PatchOf[fan[i].Triangle], number);
    }
    return isFit;
  }

  ///@{
  /// False if another number is known. What is beside is known later.
  bool SetPatch(std::uint32_t patch, int number)
  {
    int& known = this->OfPatches[patch];
    if (known == Unknown)
    {
      known = number;
      this->OpenPatches.push_back(patch);
    }
    return known == number;
  }
  bool SetTriangle(std::uint32_t triangle, int number)
  {
    if (this->NumberOf(triangle) == Unknown)
    {
      this->OpenTriangle(triangle, number);
    }
    return this->NumberOf(triangle) == number;
  }
  ///@}

  /// Of clusters without triangles that are near, all triangles are known at once.
  void OpenTriangle(std::uint32_t triangle, int number)
  {
    const std::uint32_t cluster = this->Pair.GetClusterOf(triangle);
    if (this->OfClusters[cluster] == Near)
    {
      this->OfTriangles[triangle] = number;
      this->OpenTriangles.push_back(triangle);
      return;
    }
    this->OfClusters[cluster] = number;
    this->OpenClusters.push_back(cluster);
  }

  bool SpreadAll()
  {
    bool isFit = true;
    while (isFit &&
      !(this->OpenPatches.empty() && this->OpenClusters.empty() && this->OpenTriangles.empty()))
    {
      while (isFit && !this->OpenClusters.empty())
      {
        const std::uint32_t cluster = this->OpenClusters.back();
        this->OpenClusters.pop_back();
        isFit = this->SpreadFromCluster(cluster);
      }
      while (isFit && !this->OpenTriangles.empty())
      {
        const std::uint32_t triangle = this->OpenTriangles.back();
        this->OpenTriangles.pop_back();
        isFit = this->SpreadFrom(triangle);
      }
      if (isFit && !this->OpenPatches.empty())
      {
        const std::uint32_t patch = this->OpenPatches.back();
        this->OpenPatches.pop_back();
        for (const std::uint32_t triangle : this->LinksOf[patch])
        {
          isFit = isFit && this->SetTriangle(triangle, this->OfPatches[patch]);
        }
      }
    }
    return isFit;
  }

  /// Beside clusters with triangles that are near, each triangle is looked at.
  bool SpreadFromCluster(std::uint32_t cluster)
  {
    const int number = this->OfClusters[cluster];
    bool isFit = true;
    bool isBesideNear = false;
    for (const std::uint32_t other : this->Pair.GetClustersBeside(cluster))
    {
      int& known = this->OfClusters[other];
      if (known == Unknown)
      {
        known = number;
        this->OpenClusters.push_back(other);
      }
      isBesideNear = isBesideNear || known == Near;
      isFit = isFit && (known == Near || known == number);
    }
    if (isBesideNear)
    {
      const auto triangles = this->Pair.GetTrianglesOfCluster(cluster);
      this->OpenTriangles.insert(this->OpenTriangles.end(), triangles.begin(), triangles.end());
    }
    return isFit;
  }

  bool SpreadFrom(std::uint32_t triangle)
  {
    const int number = this->NumberOf(triangle);
    bool isFit = true;
    bool isBesidePatch = false;
    for (const std::uint32_t other : this->Pair.GetNeighbours(triangle))
    {
      const int known = this->NumberOf(other);
      if (known == Unknown)
      {
        this->OpenTriangle(other, number);
      }
      isBesidePatch = isBesidePatch || known == Near;
      isFit = isFit && (known == number || known == Unknown || known == Near);
    }
    return isFit && !(isBesidePatch && !this->SpreadToPatches(triangle, number));
  }

  bool SpreadToPatches(std::uint32_t triangle, int number)
  {
    const auto [first, last] =
      std::equal_range(this->Links.begin(), this->Links.end(), Link{ triangle, 0 });
    return std::all_of(
      first, last, [&](const Link& link) { return this->SetPatch(link.Patch, number); });
  }

  //----------------------------------------------------------------------------
  /// Of components without an edge of both surfaces nothing is known.
  bool FindByLines()
  {
    std::vector<std::uint32_t> unknown;
    std::vector<bool> isKnown(this->Pair.GetComponents().size(), true);
    for (std::uint32_t component = 0; component < isKnown.size(); ++component)
    {
      isKnown[component] = this->NumberOf(this->Pair.GetTrianglesOf(component)[0]) != Unknown;
    }
    for (std::uint32_t facet = 0; facet < this->PatchOf.size(); ++facet)
    {
      if (this->OfPatches[this->PatchOf[facet]] == Unknown)
      {
        isKnown[this->Pair.GetComponentOf(this->TriangleOf(facet))] = false;
      }
    }
    for (std::uint32_t component = 0; component < isKnown.size(); ++component)
    {
      if (!isKnown[component])
      {
        unknown.push_back(component);
      }
    }
    return std::all_of(unknown.begin(), unknown.end(),
             [&](std::uint32_t component)
             {
               const std::optional<int> number = this->CountAlongLine(component, unknown.size());
               return number && this->SetComponent(component, *number);
             }) &&
      this->SetPatches();
  }

  bool SetComponent(std::uint32_t component, int number)
  {
    const auto triangles = this->Pair.GetTrianglesOf(component);
    this->Numbers.resize(this->Pair.GetComponents().size(), Unknown);
    this->Numbers[component] = number;
    for (const std::uint32_t triangle : triangles)
    {
      const std::uint32_t cluster = this->Pair.GetClusterOf(triangle); // of one component
      const bool hasNear = this->OfClusters[cluster] == Near;
      if (!hasNear && this->Pair.GetTrianglesOfCluster(cluster)[0] != triangle)
      {
        continue; // it is set once
      }
      int& known = hasNear ? this->OfTriangles[triangle] : this->OfClusters[cluster];
      if (known != Near && known != Unknown)
      {
        return false;
      }
      known = known == Near ? Near : number;
    }
    return true;
  }

  bool SetPatches()
  {
    for (std::uint32_t facet = 0; facet < this->PatchOf.size(); ++facet)
    {
      int& known = this->OfPatches[this->PatchOf[facet]];
      if (known == Unknown)
      {
        known = this->Numbers[this->Pair.GetComponentOf(this->TriangleOf(facet))];
      }
    }
    return true;
  }

  std::optional<int> CountAlongLine(std::uint32_t component, std::size_t numberOfLines)
  {
    constexpr int most = 64;
    const SkdRigidPair::Component& of = this->Pair.GetComponents()[component];
    if (!this->Pair.GetBounds(!of.IsOfSource).Overlaps(this->Whole.First.GetBox(of.Largest)))
    {
      return 0;
    }
    const SkdLineCrossings& others = this->GetCrossings(!of.IsOfSource, numberOfLines);
    for (int attempt = 0; attempt < most; ++attempt)
    {
      if (const auto number = this->CountAlongLine(others, component, attempt))
      {
        return number;
      }
    }
    return std::nullopt;
  }

  /// Of a line through the largest triangle, later through others. None if it passes an edge.
  std::optional<int> CountAlongLine(
    const SkdLineCrossings& others, std::uint32_t component, int attempt) const
  {
    constexpr int throughLargest = 8;
    const SkdMovedTriangles& set = this->Whole.First;
    const auto triangles = this->Pair.GetTrianglesOf(component);
    const std::size_t other = 7919 * static_cast<std::size_t>(attempt) % triangles.size();
    const std::uint32_t triangle = attempt < throughLargest
      ? this->Pair.GetComponents()[component].Largest
      : triangles.begin()[other];
    const auto x = set.GetCornerPoints(triangle);
    const double angle = 2.4 * attempt; // around the centroid, never the same direction
    const double a = attempt == 0 ? 1.0 / 3.0 : 1.0 / 3.0 + 0.2 * std::cos(angle);
    const double b = attempt == 0 ? 1.0 / 3.0 : 1.0 / 3.0 + 0.2 * std::sin(angle);
    const SkdAxisLine line{ std::max(0, set.Get(triangle).Axis),
      a * x[0] + b * x[1] + (1 - a - b) * x[2] };
    bool isSure = true;
    const bool isCrossed = SkdCrossTriangle(set, triangle, line, isSure).has_value();
    const auto crossings = others.Find(line);
    if (!isCrossed || !isSure || !crossings)
    {
      return std::nullopt;
    }
    int number = 0;
    for (const SkdLineCrossing& crossing : *crossings)
    {
      const int order = SkdCompareCrossings(set, crossing.Triangle, triangle, line);
      isSure = isSure && order != 0;
      number -= order < 0 ? crossing.Sign : 0;
    }
    return isSure ? std::make_optional(number) : std::nullopt;
  }

  const SkdLineCrossings& GetCrossings(bool ofSource, std::size_t numberOfLines)
  {
    std::optional<SkdLineCrossings>& crossings = this->Crossings[ofSource];
    if (!crossings)
    {
      std::vector<std::uint32_t>& all = this->All[ofSource];
      const auto n = static_cast<std::uint32_t>(this->OfTriangles.size());
      const std::uint32_t begin = ofSource ? this->Pair.GetMiddle() : 0;
      all.resize((ofSource ? n : this->Pair.GetMiddle()) - begin);
      std::iota(all.begin(), all.end(), begin);
      crossings.emplace(this->Whole.First, all, numberOfLines);
    }
    return *crossings;
  }

  const SkdRigidPair& Pair;
  const SkdPlacement& Whole;
  const std::vector<std::uint32_t>& Triangles;
  const std::vector<std::uint32_t>& Points;
  const SkdArrangedPart& Part;
  std::vector<std::uint32_t> PatchOf; // of each facet
  std::vector<Link> Links;            // by triangles
  skd::IndexRows LinksOf;             // of each patch: triangles
  std::vector<int> OfPatches;
  std::vector<int> OfClusters; // see SkdNearSides
  skd::RawVector<int> OfTriangles;
  std::vector<int> Numbers; // of components that lines tell
  std::vector<std::uint32_t> OpenPatches;
  std::vector<std::uint32_t> OpenClusters;
  std::vector<std::uint32_t> OpenTriangles;
  std::array<std::vector<std::uint32_t>, 2> All; // triangles of each surface, if they are crossed
  std::array<std::optional<SkdLineCrossings>, 2> Crossings;
};
}

std::optional<SkdNearSides> SkdFindNearSides(const SkdRigidPair& pair, const SkdPlacement& whole,
  const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& points,
  const SkdArrangedPart& part)
{
  return SideSearch(pair, whole, triangles, points, part).Find();
}
}
