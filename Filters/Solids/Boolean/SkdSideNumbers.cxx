// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdSideNumbers.h"

#include "Bodies/SkdWinding.h"
#include "Cells/Read/SkdForEach.h"
#include "Core/Geometry/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace skdtree
{
namespace
{
SkdWinding MakeWinding(
  const SkdMovedTriangles& set, const std::vector<std::uint32_t>& surfaceOf, std::uint32_t surface)
{
  std::vector<skd::WindingNumber::Triangle> triangles;
  for (std::uint32_t triangle = 0; triangle < surfaceOf.size(); ++triangle)
  {
    if (surfaceOf[triangle] == surface)
    {
      triangles.push_back(set.GetCornerPoints(triangle));
    }
  }
  return SkdWinding(triangles);
}

/// Facets that follow each other across edges of two.
std::vector<std::uint32_t> FindPatches(const SkdFacets& facets)
{
  skd::DisjointSets<> patches(facets.GetNumberOfFacets());
  facets.Edges.ForEach(
    [&patches](std::uint32_t, const SkdEdgeUse* first, const SkdEdgeUse* last)
    {
      if (last - first == 2)
      {
        patches.Unite(first[0].Triangle, first[1].Triangle);
      }
    });
  return patches.Number();
}

class Sides
{
public:
  Sides(const SkdMovedTriangles& set, const SkdFacets& facets)
    : Set(set)
    , Facets(facets)
    , Areas(facets.GetNumberOfFacets(), 0.0)
  {
  }

  /// Numbers on both sides of a facet, a little away from its middle if it is of the surface.
  void Find(
    const SkdWinding& winding, const std::vector<std::uint32_t>& surfaceOf, SkdSideNumbers& sides)
  {
    constexpr double away = 1e-3; // of the facet's height
    SkdForEach(
      this->Areas.size(),
      [&](std::size_t i)
      {
        const auto facet = static_cast<std::uint32_t>(i);
        const auto x = this->Facets.GetPositions(this->Set, facet);
        const skd::Vector3 normal = Cross(x[1] - x[0], x[2] - x[0]);
        const skd::Vector3 middle = (1.0 / 3.0) * (x[0] + x[1] + x[2]);
        const double longest2 =
          std::max({ Norm2(x[1] - x[0]), Norm2(x[2] - x[1]), Norm2(x[0] - x[2]) });
        bool isOf = false;
        int layers = 0;
        this->Facets.ForEachLayer(facet,
          [&](std::uint32_t parent, int sign)
          {
            isOf = isOf || surfaceOf[parent] == sides.Surface;
            layers += surfaceOf[parent] == sides.Surface ? sign : 0;
          });
        // The normal is as long as the height times the longest side.
        const double share = longest2 > 0.0 && isOf ? away / std::sqrt(longest2) : 0.0;
        const skd::Vector3 front = middle + share * normal;
        this->Areas[i] = Norm(normal);
        sides.Numbers[2 * i] = static_cast<int>(std::lround(winding.At(front.X)));
        sides.Numbers[2 * i + 1] = sides.Numbers[2 * i] + layers; // jumps by 1 at each
      },
      256);
  }

  /// The numbers that nearly all of a patch has are those of all of it.
  void MakePatchesOne(const std::vector<std::uint32_t>& patchOf, SkdSideNumbers& sides) const
  {
    constexpr double slivers = 1e-6; // of the area of a patch
    std::vector<std::map<std::pair<int, int>, double>> areas;
    for (std::uint32_t facet = 0; facet < patchOf.size(); ++facet)
    {
      areas.resize(std::max<std::size_t>(areas.size(), patchOf[facet] + std::size_t(1)));
      areas[patchOf[facet]][{ sides.Get(facet, false), sides.Get(facet, true) }] +=
        this->Areas[facet];
    }
    for (std::uint32_t facet = 0; facet < patchOf.size(); ++facet)
    {
      const auto& of = areas[patchOf[facet]];
      double sum = 0.0;
      auto most = of.begin();
      for (auto at = of.begin(); at != of.end(); ++at)
      {
        sum += at->second;
        most = at->second > most->second ? at : most;
      }
      if (most->second >= (1.0 - slivers) * sum)
      {
        sides.Numbers[2 * facet] = most->first.first;
        sides.Numbers[2 * facet + 1] = most->first.second;
      }
    }
  }

private:
  const SkdMovedTriangles& Set;
  const SkdFacets& Facets;
  std::vector<double> Areas; // twice that of each facet
};
}

SkdSideNumbers SkdFindSideNumbers(const SkdMovedTriangles& set, const SkdArrangement& arrangement,
  const std::vector<std::uint32_t>& surfaceOf, std::uint32_t surface)
{
  const SkdFacets& facets = arrangement.Facets;
  SkdSideNumbers numbers{ surface, std::vector<int>(2 * facets.GetNumberOfFacets(), 0) };
  const SkdWinding winding = MakeWinding(set, surfaceOf, surface);
  Sides sides(set, facets);
  sides.Find(winding, surfaceOf, numbers);
  sides.MakePatchesOne(FindPatches(facets), numbers);
  return numbers;
}
}
