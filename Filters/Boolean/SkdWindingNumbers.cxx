// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Boolean/SkdWindingNumbers.h"

#include "Boolean/SkdSolidAngles.h"
#include "Cells/SkdForEach.h"
#include "Core/Tree/PackedRTree.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/// Adds winding numbers to others.
void Add(SkdRegionWindings& to, const SkdWindingOf& winding)
{
  const auto at = std::lower_bound(to.begin(), to.end(), winding);
  if (at == to.end() || at->Surface != winding.Surface)
  {
    to.insert(at, winding);
    return;
  }
  at->Number += winding.Number;
  if (at->Number == 0)
  {
    to.erase(at);
  }
}

/// The area of a triangle by its longest side, squared: large if its centroid is far from its
/// edges.
double Height2Of(const std::array<skd::Vector3, 3>& x)
{
  const double longest2 = std::max({ Norm2(x[1] - x[0]), Norm2(x[2] - x[1]), Norm2(x[0] - x[2]) });
  return longest2 > 0.0 ? Norm2(Cross(x[1] - x[0], x[2] - x[0])) / longest2 : 0.0;
}

/// Facets that are connected by edges.
struct Component
{
  std::uint32_t Facet = None; // the highest, at which winding numbers are found
  double Height2 = -1.0;
  skd::Vector3 Centroid; // of that facet
  std::vector<std::uint32_t> Triangles;
  skd::Box3 Box;
};

class Search
{
public:
  Search(const SkdPlacedTriangles& set, const SkdArrangement& arrangement,
    const std::vector<std::uint32_t>& surfaceOf)
    : Set(set)
    , Arrangement(arrangement)
    , SurfaceOf(surfaceOf)
    , Windings(arrangement.NumberOfRegions)
    , ComponentOf(arrangement.NumberOfRegions, None)
  {
  }

  std::vector<SkdRegionWindings> Find()
  {
    this->SpreadWindings();
    this->CollectComponents();
    std::vector<SkdRegionWindings> front(this->Components.size());
    SkdForEach(
      static_cast<vtkIdType>(front.size()),
      [&](vtkIdType i) { front[i] = this->FindOwnWindings(this->Components[i]); }, 1);
    this->AddNested(front);
    for (std::size_t i = 0; i < front.size(); ++i)
    {
      const SkdRegionWindings& known =
        this->Windings[this->Arrangement.GetFront(this->Components[i].Facet)];
      std::for_each(known.begin(), known.end(),
        [&](const SkdWindingOf& w) {
          Add(front[i], { w.Surface, -w.Number });
        });
    }
    for (std::uint32_t region = 0; region < this->Windings.size(); ++region)
    {
      for (const SkdWindingOf& offset : front[this->ComponentOf[region]])
      {
        Add(this->Windings[region], offset);
      }
    }
    return std::move(this->Windings);
  }

private:
  /// A facet between two regions, as seen from one of them.
  struct Link
  {
    std::uint32_t From;
    std::uint32_t To;
    std::uint32_t Facet;

    bool operator<(const Link& o) const
    {
      return this->From != o.From ? this->From < o.From
                                  : (this->To != o.To ? this->To < o.To : this->Facet < o.Facet);
    }
    bool ConnectsAs(const Link& o) const { return this->From == o.From && this->To == o.To; }
  };

  std::vector<Link> ListLinks() const
  {
    std::vector<Link> links;
    Link last{ None, None, None };
    for (std::uint32_t facet = 0; facet < this->Arrangement.Facets.GetNumberOfFacets(); ++facet)
    {
      const Link link{ this->Arrangement.GetFront(facet), this->Arrangement.GetBack(facet), facet };
      if (!link.ConnectsAs(last))
      {
        links.push_back(link);
        links.push_back({ link.To, link.From, facet });
        last = link;
      }
    }
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end(),
                  [](const Link& a, const Link& b) { return a.ConnectsAs(b); }),
      links.end());
    return links;
  }

  /// Numbers relative to one region of each component.
  void SpreadWindings()
  {
    const std::vector<Link> links = this->ListLinks();
    std::uint32_t count = 0;
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < this->Windings.size(); ++start)
    {
      if (this->ComponentOf[start] != None)
      {
        continue;
      }
      this->ComponentOf[start] = count++;
      open.push_back(start);
      while (!open.empty())
      {
        const std::uint32_t region = open.back();
        open.pop_back();
        auto link = std::lower_bound(links.begin(), links.end(), Link{ region, 0, 0 });
        for (; link != links.end() && link->From == region; ++link)
        {
          if (this->ComponentOf[link->To] == None)
          {
            this->ComponentOf[link->To] = this->ComponentOf[region];
            this->Windings[link->To] = this->Across(*link);
            open.push_back(link->To);
          }
        }
      }
    }
    this->Components.resize(count);
  }

  /// The numbers behind a facet are higher by 1 for each of its layers.
  SkdRegionWindings Across(const Link& link) const
  {
    SkdRegionWindings windings = this->Windings[link.From];
    const int step = link.From == this->Arrangement.GetFront(link.Facet) ? 1 : -1;
    this->Arrangement.Facets.ForEachLayer(link.Facet,
      [&](std::uint32_t parent, int sign) {
        Add(windings, { this->SurfaceOf[parent], step * sign });
      });
    return windings;
  }

  void CollectComponents()
  {
    const SkdFacets& facets = this->Arrangement.Facets;
    std::vector<bool> isListed(this->SurfaceOf.size(), false);
    for (std::uint32_t facet = 0; facet < facets.GetNumberOfFacets(); ++facet)
    {
      Component& component = this->Components[this->ComponentOf[this->Arrangement.GetFront(facet)]];
      const std::array<skd::Vector3, 3> x = facets.GetPositions(this->Set, facet);
      const double height2 = Height2Of(x);
      if (height2 > component.Height2)
      {
        component.Facet = facet;
        component.Height2 = height2;
        component.Centroid = (1.0 / 3.0) * (x[0] + x[1] + x[2]);
      }
      facets.ForEachLayer(facet,
        [&](std::uint32_t parent, int)
        {
          if (!isListed[parent])
          {
            isListed[parent] = true;
            component.Triangles.push_back(parent);
            component.Box.Add(this->Set.GetBox(parent));
          }
        });
    }
  }

  /// The numbers in front of a component's highest facet that its own triangles cause. Half of the
  /// sum over the facet's layers is missing at its centroid, where these have no solid angle.
  SkdRegionWindings FindOwnWindings(const Component& component) const
  {
    std::vector<std::uint32_t> layers;
    SkdSolidAngles::Numbers numbers;
    this->Arrangement.Facets.ForEachLayer(component.Facet,
      [&](std::uint32_t parent, int sign)
      {
        layers.push_back(parent);
        numbers[this->SurfaceOf[parent]] -= 0.5 * sign;
      });
    SkdAddSolidAngles(
      this->Set, this->SurfaceOf, component.Triangles, layers, component.Centroid, numbers);
    return Rounded(numbers);
  }

  static SkdRegionWindings Rounded(const SkdSolidAngles::Numbers& numbers)
  {
    SkdRegionWindings windings;
    for (const auto& [surface, number] : numbers)
    {
      if (std::abs(number) > 0.5)
      {
        windings.push_back({ surface, static_cast<int>(std::lround(number)) });
      }
    }
    return windings;
  }

  /// Adds the numbers that other components cause.
  void AddNested(std::vector<SkdRegionWindings>& front) const
  {
    if (front.size() < 2)
    {
      return;
    }
    std::vector<skd::Box3> boxes;
    for (const Component& component : this->Components)
    {
      boxes.push_back(component.Box);
    }
    const skd::PackedRTree tree(boxes);
    std::vector<std::vector<std::uint32_t>> within(front.size()); // of each, those in its box
    for (std::uint32_t i = 0; i < front.size(); ++i)
    {
      skd::Box3 point;
      point.Add(this->Components[i].Centroid);
      tree.ForEachOverlapping(point,
        [&](std::uint32_t other)
        {
          if (other != i && boxes[other].Contains(this->Components[i].Centroid))
          {
            within[other].push_back(i);
          }
        });
    }
    for (std::uint32_t other = 0; other < front.size(); ++other)
    {
      this->AddOf(this->Components[other], within[other], front);
    }
  }

  void AddOf(const Component& component, std::vector<std::uint32_t>& within,
    std::vector<SkdRegionWindings>& front) const
  {
    const SkdSolidAngles angles(this->Set, this->SurfaceOf, component.Triangles, within.size());
    std::sort(within.begin(), within.end());
    SkdForEach(
      static_cast<vtkIdType>(within.size()),
      [&](vtkIdType i)
      {
        SkdSolidAngles::Numbers numbers;
        angles.Add(this->Components[within[i]].Centroid, numbers);
        for (const SkdWindingOf& winding : Rounded(numbers))
        {
          ::Add(front[within[i]], winding);
        }
      },
      1);
  }

  const SkdPlacedTriangles& Set;
  const SkdArrangement& Arrangement;
  const std::vector<std::uint32_t>& SurfaceOf;
  std::vector<SkdRegionWindings> Windings;
  std::vector<std::uint32_t> ComponentOf; // of regions
  std::vector<Component> Components;
};
}

std::vector<SkdRegionWindings> SkdFindWindingNumbers(const SkdPlacedTriangles& set,
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf)
{
  return Search(set, arrangement, surfaceOf).Find();
}
