// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdWindingNumbers.h"

#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/DisjointSets.h"
#include "Core/Geometry/Predicates/ExactPoint.h"
#include "Solids/Boolean/SkdLineCrossings.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace skdtree
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/// Lines through a component that are tried.
constexpr int MostLines = 64;

/// Facets that are connected by edges.
struct Component
{
  std::vector<std::uint32_t> Triangles;
  std::uint32_t Largest = None; // of them, or of a part
  double Area = -1.0;
  skd::Box3 Box;
};

/// A region of a component, and its winding numbers.
struct Seed
{
  std::uint32_t Region = None;
  SkdRegionWindings Windings;
};

/// Where a line last crosses another component before it enters one, and the region after that.
struct EnclosingRegion
{
  std::uint32_t Component;
  std::uint32_t Triangle;
  std::uint32_t Region;
};

/// Where a line enters a component: the region before it, and others that may be around that.
struct Entrance
{
  std::uint32_t Region = None;
  SkdAxisLine Line;
  std::vector<EnclosingRegion> Around;
};

class Search
{
public:
  Search(const SkdMovedTriangles& set, double scale, const SkdArrangement& arrangement,
    const std::vector<std::uint32_t>& surfaceOf)
    : Set(set)
    , Arrangement(arrangement)
    , SurfaceOf(surfaceOf)
    , Error(SkdSplitPoints::ErrorOf(set.GetSet().GetLargestCoordinate() * scale))
  {
  }

  std::vector<SkdRegionWindings> Find()
  {
    this->Prepare();
    std::vector<SkdRegionWindings> offsets(this->Components.size());
    const std::vector<bool> isNeutral = this->FindNeutral();
    std::atomic<bool> areAllFound{ true };
    SkdForEach(
      static_cast<vtkIdType>(offsets.size()),
      [&](vtkIdType i)
      {
        const Seed seed = this->FindSeed(static_cast<std::uint32_t>(i));
        if (seed.Region == None)
        {
          areAllFound = areAllFound && isNeutral[static_cast<std::size_t>(i)];
          return;
        }
        offsets[i] = this->OffsetOf(seed, {});
      },
      1);
    return areAllFound ? this->WithOffsets(offsets) : std::vector<SkdRegionWindings>();
  }

  /// Components may be open, and go on on other processes.
  std::vector<SkdRegionWindings> FindByAsking(const SkdAskWindings& ask)
  {
    this->AreOpen = true;
    this->Prepare();
    std::vector<SkdRegionWindings> offsets(this->Components.size());
    std::vector<bool> isOpen(offsets.size(), true);
    bool isAnyOpen = true; // on any process
    for (int attempt = 0; attempt < MostLines && isAnyOpen; ++attempt)
    {
      const std::vector<Asked> asked = this->ListAsked(isOpen, attempt);
      std::vector<SkdPositionOnLine> positions;
      for (const Asked& one : asked)
      {
        positions.push_back(one.Position);
      }
      const auto answers = ask(positions, std::count(isOpen.begin(), isOpen.end(), true) > 0);
      isAnyOpen = answers.has_value();
      for (std::size_t i = 0; isAnyOpen && i < asked.size(); ++i)
      {
        if ((*answers)[i])
        {
          isOpen[asked[i].Component] = false;
          offsets[asked[i].Component] = this->OffsetOf(asked[i].From, *(*answers)[i]);
        }
      }
    }
    const std::vector<bool> isNeutral = this->FindNeutral();
    for (std::size_t i = 0; i < offsets.size(); ++i)
    {
      if (isOpen[i] && !isNeutral[i])
      {
        return {};
      }
    }
    return this->WithOffsets(offsets);
  }

  std::vector<std::uint32_t> FindParts()
  {
    this->Prepare();
    std::vector<Entrance> entrances(this->Components.size());
    SkdForEach(
      static_cast<vtkIdType>(entrances.size()),
      [&](vtkIdType i) { entrances[i] = this->FindEntrance(static_cast<std::uint32_t>(i)); }, 1);
    const auto outside = static_cast<std::uint32_t>(this->Windings.size());
    skd::DisjointSets<> parts(outside + std::size_t(1));
    for (const Entrance& entrance : entrances)
    {
      if (entrance.Region == None)
      {
        return {};
      }
      parts.Unite(entrance.Region, this->RegionAround(entrance, entrances, outside));
    }
    return parts.Number();
  }

private:
  /// Where a line enters a component.
  struct Asked
  {
    std::uint32_t Component;
    Seed From;
    SkdPositionOnLine Position;
  };

  /// Of components that are open the next line, where it is of use.
  std::vector<Asked> ListAsked(const std::vector<bool>& isOpen, int attempt) const
  {
    std::vector<Asked> asked;
    for (std::uint32_t i = 0; i < isOpen.size(); ++i)
    {
      const auto take =
        [&](const SkdAxisLine& line, const SkdLineCrossing& first, std::uint32_t region)
      {
        Seed seed{ region, {} };
        const bool isSure = this->AddNested(i, first, line, seed);
        if (isSure)
        {
          asked.push_back({ i, seed, { line, this->Set.GetCornerPoints(first.Triangle) } });
        }
        return isSure;
      };
      if (isOpen[i])
      {
        this->TryEntrance(i, attempt, take);
      }
    }
    return asked;
  }

  /// What is to be added to the numbers of a component's regions.
  SkdRegionWindings OffsetOf(const Seed& seed, const SkdRegionWindings& others) const
  {
    SkdRegionWindings offset = seed.Windings;
    for (const SkdWindingOf& other : others)
    {
      SkdAddWinding(offset, other);
    }
    for (const SkdWindingOf& known : this->Windings[seed.Region])
    {
      SkdAddWinding(offset, { known.Surface, -known.Number });
    }
    return offset;
  }

  std::vector<SkdRegionWindings> WithOffsets(const std::vector<SkdRegionWindings>& offsets)
  {
    for (std::uint32_t region = 0; region < this->Windings.size(); ++region)
    {
      for (const SkdWindingOf& offset : offsets[this->ComponentOf[region]])
      {
        SkdAddWinding(this->Windings[region], offset);
      }
    }
    return std::move(this->Windings);
  }

  void Prepare()
  {
    SkdRelativeWindings relative(this->Arrangement, this->SurfaceOf);
    this->Windings = std::move(relative.OfRegions);
    this->ComponentOf = std::move(relative.ComponentOf);
    this->Components.resize(relative.NumberOfComponents);
    this->CollectComponents();
    this->PrepareLines();
  }

  void CollectComponents()
  {
    const SkdFacets& facets = this->Arrangement.Facets;
    std::vector<bool> isListed(this->SurfaceOf.size(), false);
    for (std::uint32_t facet = 0; facet < facets.GetNumberOfFacets(); ++facet)
    {
      Component& component = this->Components[this->ComponentOf[this->Arrangement.GetFront(facet)]];
      facets.ForEachLayer(facet,
        [&](std::uint32_t parent, int)
        {
          if (!isListed[parent])
          {
            isListed[parent] = true;
            this->AddTriangle(parent, component);
          }
        });
    }
  }

  /// Of many triangles a part is enough to find a large one.
  void AddTriangle(std::uint32_t triangle, Component& component) const
  {
    constexpr std::size_t few = 64;
    constexpr std::size_t step = 16;
    const auto x = this->Set.GetCornerPoints(triangle);
    const std::size_t number = component.Triangles.size();
    component.Triangles.push_back(triangle);
    component.Box.Add(x[0]);
    component.Box.Add(x[1]);
    component.Box.Add(x[2]);
    if (number > few && number % step != 0)
    {
      return;
    }
    const double area = Norm2(Cross(x[1] - x[0], x[2] - x[0]));
    if (area > component.Area)
    {
      component.Area = area;
      component.Largest = triangle;
    }
  }

  /// Finds out how many lines each component will be crossed by: its own, and those of components
  /// that begin within its box.
  void PrepareLines()
  {
    std::vector<skd::Box3> boxes;
    for (const Component& component : this->Components)
    {
      boxes.push_back(component.Box);
    }
    std::vector<std::size_t> counts(boxes.size(), 1);
    this->Boxes.emplace(boxes);
    for (const skd::Box3& box : boxes)
    {
      this->Bounds.Add(box);
    }
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
    {
      this->ForEachAround(i, this->LineOf(i, 0), [&](std::uint32_t other) { ++counts[other]; });
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      this->Lines.push_back(
        std::make_unique<SkdLineCrossings>(this->Set, this->Components[i].Triangles, counts[i]));
    }
  }

  /// Calls visit(other) for other components whose box a line crosses where a component is; before
  /// that, too, if they may be open.
  template <class Visit>
  void ForEachAround(std::uint32_t component, const SkdAxisLine& line, const Visit& visit) const
  {
    skd::Box3 where;
    where.Add(line.Point);
    where.Min[line.Axis] =
      (this->AreOpen ? this->Bounds : this->Components[component].Box).Min[line.Axis];
    where.Max[line.Axis] = this->Components[component].Box.Max[line.Axis];
    this->Boxes->ForEachOverlapping(where,
      [&](std::uint32_t other)
      {
        if (other != component && this->Components[other].Box.Overlaps(where))
        {
          visit(other);
        }
      });
  }

  /// One of many lines, all through a component: through its largest triangle, later through
  /// others.
  SkdAxisLine LineOf(std::uint32_t number, int attempt) const
  {
    constexpr int throughLargest = 8;
    const Component& component = this->Components[number];
    const std::size_t other = 7919 * static_cast<std::size_t>(attempt) % component.Triangles.size();
    const std::uint32_t triangle =
      attempt < throughLargest ? component.Largest : component.Triangles[other];
    const auto x = this->Set.GetCornerPoints(triangle);
    const double angle = 2.4 * attempt; // around the centroid, never the same direction
    const double a = attempt == 0 ? 1.0 / 3.0 : 1.0 / 3.0 + 0.2 * std::cos(angle);
    const double b = attempt == 0 ? 1.0 / 3.0 : 1.0 / 3.0 + 0.2 * std::sin(angle);
    return { std::max(0, this->Set.Get(triangle).Axis), a * x[0] + b * x[1] + (1 - a - b) * x[2] };
  }

  /// Calls visit(line, first crossing of the component, region before it) for lines through a
  /// component until that returns true.
  template <class Visit>
  void ForEachEntrance(std::uint32_t component, const Visit& visit) const
  {
    for (int attempt = 0; attempt < MostLines; ++attempt)
    {
      if (this->TryEntrance(component, attempt, visit))
      {
        return;
      }
    }
  }

  /// The same by one line. Returns what `visit` returned, or false.
  template <class Visit>
  bool TryEntrance(std::uint32_t component, int attempt, const Visit& visit) const
  {
    const SkdAxisLine line = this->LineOf(component, attempt);
    const auto crossings = this->Lines[component]->Find(line);
    if (!crossings || crossings->empty())
    {
      return false;
    }
    const SkdLineCrossing first = *std::min_element(crossings->begin(), crossings->end(),
      [&](const SkdLineCrossing& a, const SkdLineCrossing& b)
      { return SkdCompareCrossings(this->Set, a.Triangle, b.Triangle, line) < 0; });
    const std::uint32_t region = this->RegionBefore(first, line);
    return region != None && visit(line, first, region);
  }

  /// Where a line enters a component the region before it is outside of the component; winding
  /// numbers there are those that other components cause.
  Seed FindSeed(std::uint32_t component) const
  {
    Seed found;
    this->ForEachEntrance(component,
      [&](const SkdAxisLine& line, const SkdLineCrossing& first, std::uint32_t region)
      {
        Seed seed{ region, {} };
        const bool isSure = this->AddNested(component, first, line, seed);
        found = isSure ? std::move(seed) : Seed();
        return isSure;
      });
    return found;
  }

  Entrance FindEntrance(std::uint32_t component) const
  {
    Entrance found;
    this->ForEachEntrance(component,
      [&](const SkdAxisLine& line, const SkdLineCrossing& first, std::uint32_t region)
      {
        Entrance entrance{ region, line, {} };
        const bool isSure = this->AddEnclosing(component, first, entrance);
        found = isSure ? std::move(entrance) : Entrance();
        return isSure;
      });
    return found;
  }

  /// A component is within a bounded region of another one, or in none. Of those that it is in, the
  /// innermost is the one that the line left last: no other one that is around is between.
  std::uint32_t RegionAround(
    const Entrance& entrance, const std::vector<Entrance>& entrances, std::uint32_t outside) const
  {
    const EnclosingRegion* innermost = nullptr;
    for (const EnclosingRegion& other : entrance.Around)
    {
      const bool isBounded = other.Region != entrances[other.Component].Region;
      if (isBounded &&
        (!innermost ||
          SkdCompareCrossings(this->Set, innermost->Triangle, other.Triangle, entrance.Line) < 0))
      {
        innermost = &other;
      }
    }
    return innermost ? innermost->Region : outside;
  }

  /// Of each component whether all its regions have the same numbers, whatever they are: nothing is
  /// bounded there. No line may be found through faces laid on each other that are needles.
  std::vector<bool> FindNeutral() const
  {
    std::vector<bool> isNeutral(this->Components.size(), true);
    for (std::uint32_t region = 0; region < this->Windings.size(); ++region)
    {
      if (!this->Windings[region].empty())
      {
        isNeutral[this->ComponentOf[region]] = false;
      }
    }
    return isNeutral;
  }

  /// Adds the last crossings of other components before one. False if the line passes through an
  /// edge of theirs.
  bool AddEnclosing(
    std::uint32_t component, const SkdLineCrossing& crossing, Entrance& entrance) const
  {
    const SkdAxisLine& line = entrance.Line;
    bool isSure = true;
    this->ForEachAround(component, line,
      [&](std::uint32_t other)
      {
        const auto crossings = this->Lines[other]->Find(line);
        isSure = isSure && crossings;
        const SkdLineCrossing* last = nullptr;
        for (std::size_t i = 0; isSure && i < crossings->size(); ++i)
        {
          const SkdLineCrossing& before = (*crossings)[i];
          const int order =
            SkdCompareCrossings(this->Set, before.Triangle, crossing.Triangle, line);
          isSure = order != 0;
          const bool isLater = order < 0 &&
            (!last || SkdCompareCrossings(this->Set, last->Triangle, before.Triangle, line) < 0);
          last = isLater ? &before : last;
        }
        if (isSure && last)
        {
          const std::uint32_t region = this->RegionAfter(*last, line);
          isSure = region != None;
          entrance.Around.push_back({ other, last->Triangle, region });
        }
      });
    return isSure;
  }

  /// @{ The region that a line leaves, or enters, where it crosses a triangle, the lowest that is
  /// there; None if it passes near an edge of its pieces.
  std::uint32_t RegionBefore(const SkdLineCrossing& crossing, const SkdAxisLine& line) const
  {
    const std::uint32_t facet = this->FacetAt(crossing, line);
    return facet == None  ? None
      : crossing.Sign > 0 ? this->Arrangement.GetBack(facet)
                          : this->Arrangement.GetFront(facet);
  }
  std::uint32_t RegionAfter(const SkdLineCrossing& crossing, const SkdAxisLine& line) const
  {
    const std::uint32_t facet = this->FacetAt(crossing, line);
    return facet == None  ? None
      : crossing.Sign > 0 ? this->Arrangement.GetFront(facet)
                          : this->Arrangement.GetBack(facet);
  }
  ///@}

  std::uint32_t FacetAt(const SkdLineCrossing& crossing, const SkdAxisLine& line) const
  {
    const std::vector<std::uint32_t>& parents = this->Arrangement.Facets.Parents;
    const auto range = std::equal_range(parents.begin(), parents.end(), crossing.Triangle);
    for (auto at = range.first; at != range.second; ++at)
    {
      const auto facet = static_cast<std::uint32_t>(at - parents.begin());
      const auto x = this->Arrangement.Facets.GetPositions(this->Set, facet);
      const SkdTriangleSet::Corners& corners = this->Arrangement.Facets.Corners[facet];
      int inside = 0;
      for (int i = 0; i < 3; ++i)
      {
        const int k = (i + 1) % 3;
        const bool areGiven = std::max(corners[i], corners[k]) < this->Set.GetPoints().size();
        inside += crossing.Sign *
          skd::FilteredOrient2D(x[i], x[k], line.Point, line.Axis, areGiven ? 0.0 : this->Error);
      }
      if (inside == 3)
      {
        return facet;
      }
    }
    return None;
  }

  /// Adds the numbers that other components cause just before a crossing. False if the line passes
  /// through one of their edges.
  bool AddNested(std::uint32_t component, const SkdLineCrossing& crossing, const SkdAxisLine& line,
    Seed& seed) const
  {
    bool isSure = true;
    this->ForEachAround(component, line,
      [&](std::uint32_t other)
      {
        const auto crossings = this->Lines[other]->Find(line);
        isSure = isSure && crossings;
        for (const SkdLineCrossing& before : isSure ? *crossings : std::vector<SkdLineCrossing>())
        {
          const int order =
            SkdCompareCrossings(this->Set, before.Triangle, crossing.Triangle, line);
          isSure = isSure && order != 0;
          if (order < 0)
          {
            SkdAddWinding(seed.Windings, { this->SurfaceOf[before.Triangle], -before.Sign });
          }
        }
      });
    return isSure;
  }

  const SkdMovedTriangles& Set;
  const SkdArrangement& Arrangement;
  const std::vector<std::uint32_t>& SurfaceOf;
  std::vector<SkdRegionWindings> Windings; // at first relative ones
  std::vector<std::uint32_t> ComponentOf;  // of regions
  const double Error;                      // of new points
  bool AreOpen = false;                    // components may be
  std::vector<Component> Components;
  std::optional<skd::PackedRTree> Boxes; // of components
  skd::Box3 Bounds;                      // of all
  std::vector<std::unique_ptr<SkdLineCrossings>> Lines;
};
}

std::vector<std::uint32_t> SkdFindPartsOfSpace(const SkdPlacement& placement,
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf)
{
  return Search(placement.First, placement.Scale, arrangement, surfaceOf).FindParts();
}

std::vector<SkdRegionWindings> SkdFindWindingNumbers(const SkdPlacement& placement,
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf)
{
  return Search(placement.First, placement.Scale, arrangement, surfaceOf).Find();
}

std::vector<SkdRegionWindings> SkdFindWindingNumbers(const SkdPlacement& placement,
  const SkdArrangement& arrangement, const std::vector<std::uint32_t>& surfaceOf,
  const SkdAskWindings& ask)
{
  return Search(placement.First, placement.Scale, arrangement, surfaceOf).FindByAsking(ask);
}
}
