// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSheet.h"

#include "Core/Geometry/Distance/ClosestPointOnTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// A point at each region: the centroid of its first facet.
std::vector<skd::Vector3> FindPoints(
  const SkdMovedTriangles& set, const SkdArrangement& arrangement)
{
  std::vector<skd::Vector3> points(arrangement.NumberOfRegions);
  for (std::size_t facet = arrangement.Facets.GetNumberOfFacets(); facet-- > 0;)
  {
    const auto corners = arrangement.Facets.GetPositions(set, static_cast<std::uint32_t>(facet));
    const skd::Vector3 centroid = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
    points[arrangement.GetFront(static_cast<std::uint32_t>(facet))] = centroid;
    points[arrangement.GetBack(static_cast<std::uint32_t>(facet))] = centroid;
  }
  return points;
}

/// Whether a point is behind the sheet's nearest triangle; of several that are as near, as at a
/// common edge, behind the one that faces the point most. O(n).
bool IsBehindNearest(
  const SkdMovedTriangles& set, const std::vector<std::uint32_t>& triangles, const skd::Vector3& x)
{
  constexpr double same = 1.0 + 1e-12; // of squared distances
  double nearest2 = std::numeric_limits<double>::infinity();
  double facing = 0.0;
  for (const std::uint32_t triangle : triangles)
  {
    const auto corners = set.GetCornerPoints(triangle);
    const auto [point, r, s, dist2] =
      skd::ClosestPointOnTriangle(corners[0], corners[1], corners[2], x);
    const skd::Vector3 normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = Norm(normal);
    if (dist2 > same * nearest2 || length == 0.0)
    {
      continue;
    }
    const double height = Dot(normal, x - point) / length;
    if (same * dist2 < nearest2 || std::abs(height) > std::abs(facing))
    {
      facing = height;
    }
    nearest2 = std::min(nearest2, dist2);
  }
  return facing < 0.0;
}

std::vector<std::uint32_t> TrianglesOf(
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t surface)
{
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t triangle = 0; triangle < surfaceOf.size(); ++triangle)
  {
    if (surfaceOf[triangle] == surface)
    {
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

/// A facet of the sheet, from the part of space in front of it to that behind.
struct Step
{
  std::uint32_t From;
  std::uint32_t To;
  int Number; // of layers of the sheet

  bool operator<(const Step& other) const { return this->From < other.From; }
};

/// How often the sheet winds around the parts of the first solid.
class SheetNumbers
{
public:
  SheetNumbers(const SkdArrangement& arrangement, const std::vector<std::uint32_t>& parts,
    const std::vector<std::uint32_t>& surfaceOf, std::uint32_t sheet,
    const std::vector<SkdRegionWindings>& windings)
    : IsInSolid(1 + *std::max_element(parts.begin(), parts.end()), false)
    , IsTouched(this->IsInSolid.size(), false)
    , Numbers(this->IsInSolid.size(), 0)
  {
    for (std::size_t region = 0; region < windings.size(); ++region)
    {
      const bool isIn = std::any_of(windings[region].begin(), windings[region].end(),
        [sheet](const SkdWindingOf& winding) { return winding.Surface != sheet; });
      this->IsInSolid[parts[region]] = this->IsInSolid[parts[region]] || isIn;
    }
    this->ListSteps(arrangement, parts, surfaceOf, sheet);
    this->Spread();
  }

  bool IsTouchedBySheet(std::uint32_t part) const { return this->IsTouched[part]; }
  bool IsWithinSolid(std::uint32_t part) const { return this->IsInSolid[part]; }
  int GetNumber(std::uint32_t part) const { return this->Numbers[part]; }
  const SkdSheetFaults& GetFaults() const { return this->Faults; }

private:
  /// Those that divide something, in both directions.
  void ListSteps(const SkdArrangement& arrangement, const std::vector<std::uint32_t>& parts,
    const std::vector<std::uint32_t>& surfaceOf, std::uint32_t sheet)
  {
    std::vector<bool> isUndivided(this->IsInSolid.size(), false);
    for (std::uint32_t facet = 0; facet < arrangement.Facets.GetNumberOfFacets(); ++facet)
    {
      Step step{ parts[arrangement.GetFront(facet)], parts[arrangement.GetBack(facet)], 0 };
      bool isOfSheet = false;
      arrangement.Facets.ForEachLayer(facet,
        [&](std::uint32_t parent, int sign)
        {
          isOfSheet = isOfSheet || surfaceOf[parent] == sheet;
          step.Number += surfaceOf[parent] == sheet ? sign : 0;
        });
      if (!isOfSheet || !(this->IsInSolid[step.From] || this->IsInSolid[step.To]))
      {
        continue;
      }
      this->IsTouched[step.From] = this->IsTouched[step.To] = true;
      if (step.From != step.To)
      {
        this->Steps.push_back(step);
        this->Steps.push_back({ step.To, step.From, -step.Number });
      }
      else if (!isUndivided[step.From])
      {
        isUndivided[step.From] = true;
        ++this->Faults.Undivided;
      }
    }
    std::stable_sort(this->Steps.begin(), this->Steps.end());
  }

  void Spread()
  {
    std::vector<bool> isKnown(this->IsInSolid.size(), false);
    for (std::uint32_t part = 0; part < isKnown.size(); ++part)
    {
      if (this->IsInSolid[part] && this->IsTouched[part] && !isKnown[part])
      {
        this->SpreadFrom(part, isKnown);
      }
    }
  }

  /// Numbers all parts of the solid that facets of the sheet connect with one; the least number
  /// beside any of these facets is 0.
  void SpreadFrom(std::uint32_t start, std::vector<bool>& isKnown)
  {
    std::vector<std::uint32_t> visited{ start };
    isKnown[start] = true;
    int least = 0;
    bool isContradictory = false;
    for (std::size_t i = 0; i < visited.size(); ++i)
    {
      const std::uint32_t from = visited[i];
      auto step = std::lower_bound(this->Steps.begin(), this->Steps.end(), Step{ from, 0, 0 });
      for (; step != this->Steps.end() && step->From == from; ++step)
      {
        const int number = this->Numbers[from] + step->Number;
        least = std::min(least, number);
        if (!this->IsInSolid[step->To])
        {
          continue;
        }
        if (!isKnown[step->To])
        {
          isKnown[step->To] = true;
          this->Numbers[step->To] = number;
          visited.push_back(step->To);
        }
        isContradictory = isContradictory || this->Numbers[step->To] != number;
      }
    }
    this->Faults.Contradictory += isContradictory ? static_cast<vtkIdType>(visited.size()) : 0;
    for (const std::uint32_t part : visited)
    {
      this->Numbers[part] = isContradictory ? 0 : this->Numbers[part] - least;
    }
  }

  std::vector<bool> IsInSolid;
  std::vector<bool> IsTouched;
  std::vector<int> Numbers;
  std::vector<Step> Steps; // by where they are from
  SkdSheetFaults Faults;
};
}

SkdSheetFaults SkdPlaceSheet(const SkdMovedTriangles& set, const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& parts, const std::vector<std::uint32_t>& surfaceOf,
  std::uint32_t sheet, std::vector<SkdRegionWindings>& windings)
{
  const SheetNumbers numbers(arrangement, parts, surfaceOf, sheet, windings);
  const std::vector<skd::Vector3> points = FindPoints(set, arrangement);
  const std::vector<std::uint32_t> triangles = TrianglesOf(surfaceOf, sheet);
  std::vector<int> numberOf(parts.size(), -1); // of parts
  for (std::uint32_t region = 0; region < windings.size(); ++region)
  {
    const std::uint32_t part = parts[region];
    SkdRegionWindings& of = windings[region];
    of.erase(std::remove_if(of.begin(), of.end(),
               [&](const SkdWindingOf& winding) { return winding.Surface == sheet; }),
      of.end());
    if (!numbers.IsWithinSolid(part))
    {
      continue;
    }
    if (numberOf[part] < 0)
    {
      numberOf[part] = numbers.IsTouchedBySheet(part)
        ? numbers.GetNumber(part)
        : IsBehindNearest(set, triangles, points[region]);
    }
    if (numberOf[part] > 0)
    {
      of.push_back({ sheet, numberOf[part] });
    }
  }
  return numbers.GetFaults();
}
}
