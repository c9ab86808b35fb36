// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdFacetMerger.h"

#include "Core/Geometry/Predicates/Orient3D.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
/// A plane seen along an axis, from the side from which its triangle turns left.
struct SkdFacetMerger::View
{
  int U;
  int V;
  double Sign;

  explicit View(const std::array<skd::Vector3, 3>& x)
  {
    const int axis = std::max(0, skd::ProjectedTriangle(x).Axis);
    this->U = (axis + 1) % 3;
    this->V = (axis + 2) % 3;
    this->Sign = skd::Orient2D(x[0], x[1], x[2], axis);
  }
};

std::vector<SkdFacetMerger::Polygon> SkdFacetMerger::Merge(const std::vector<std::uint32_t>& facets)
{
  std::vector<Polygon> polygons;
  for (const std::uint32_t facet : facets)
  {
    const auto& corners = this->Facets.Corners[facet];
    polygons.emplace_back(corners.begin(), corners.end());
  }
  const View view(this->Set.GetCornerPoints(this->Facets.Parents[facets[0]]));
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    for (std::size_t k = i + 1; k < polygons.size();)
    {
      if (this->MergeTwo(polygons[i], polygons[k], view))
      {
        polygons.erase(polygons.begin() + static_cast<std::ptrdiff_t>(k));
        k = i + 1; // what did not fit may do so now
      }
      else
      {
        ++k;
      }
    }
  }
  return polygons;
}

/// Merges two polygons that have one edge in common, unless the result is not convex or could not
/// be triangulated.
bool SkdFacetMerger::MergeTwo(Polygon& into, Polygon& other, const View& view)
{
  const std::size_t n = into.size();
  const std::size_t m = other.size();
  std::size_t at = n;
  std::size_t opposite = m;
  int count = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t k = 0; k < m; ++k)
    {
      if (into[i] == other[(k + 1) % m] && into[(i + 1) % n] == other[k])
      {
        at = i;
        opposite = k;
        ++count;
      }
    }
  }
  if (count != 1 ||
    std::binary_search(this->FixedEdges.begin(), this->FixedEdges.end(),
      SkdMakeSplitEdge(into[at], into[(at + 1) % n])))
  {
    return false;
  }
  Polygon merged; // from the end of the edge around the one, then around the other
  for (std::size_t i = 1; i <= n; ++i)
  {
    merged.push_back(into[(at + i) % n]);
  }
  for (std::size_t k = 2; k < m; ++k)
  {
    merged.push_back(other[(opposite + k) % m]);
  }
  if (!this->IsConvexAt(merged, 0, view) || !this->IsConvexAt(merged, n - 1, view) ||
    !this->IsCutByVtk(merged))
  {
    return false;
  }
  into = std::move(merged);
  return true;
}

bool SkdFacetMerger::IsConvexAt(const Polygon& polygon, std::size_t corner, const View& view) const
{
  constexpr double rounding = 1e-12; // of a sine
  const std::size_t n = polygon.size();
  const auto at = [&](std::size_t i)
  { return this->Facets.GetPosition(this->Set, polygon[i % n]); };
  const skd::Vector3 before = at(corner) - at(corner + n - 1);
  const skd::Vector3 after = at(corner + 1) - at(corner);
  const double cross =
    view.Sign * (before[view.U] * after[view.V] - before[view.V] * after[view.U]);
  return cross >= -rounding * std::sqrt(Norm2(before) * Norm2(after));
}

bool SkdFacetMerger::IsCutByVtk(const Polygon& polygon)
{
  Polygon sorted = polygon;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() &&
    this->Triangulation.IsCutByVtk(static_cast<vtkIdType>(polygon.size()),
      [&](vtkIdType i)
      { return this->Facets.GetPosition(this->Set, polygon[static_cast<std::size_t>(i)]); });
}
}
