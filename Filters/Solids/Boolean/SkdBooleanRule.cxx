// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBooleanRule.h"

namespace skdtree
{
SkdBoundaryMeasures SkdMeasureBoundary(const SkdMovedTriangles& set, const SkdFacets& facets,
  const SkdFacetSigns& signs, const std::optional<skd::Vector3>& common)
{
  SkdBoundaryMeasures measures;
  const skd::Vector3 first = set.GetPoints().empty() ? skd::Vector3{} : set.GetPoints()[0];
  const skd::Vector3 origin = common.value_or(first);
  for (std::uint32_t facet = 0; facet < signs.size(); ++facet)
  {
    if (signs[facet] != 0)
    {
      const std::array<skd::Vector3, 3> x = facets.GetPositions(set, facet);
      const skd::Vector3 normal = Cross(x[1] - x[0], x[2] - x[0]);
      measures.Volume += signs[facet] * Dot(x[0] - origin, normal);
      measures.Area += Norm(normal);
    }
  }
  measures.Volume /= 6.0;
  measures.Area /= 2.0;
  return measures;
}
}
