// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Surfaces/SkdSplitRegions.h"

#include "Bodies/SkdEdgeTable.h"
#include "Core/Geometry/DisjointSets.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace skdtree
{
std::vector<std::uint32_t> SkdFindSplitRegions(
  const std::vector<SkdTriangleSet::Corners>& triangles, std::vector<SkdSplitEdge> borders)
{
  skd::DisjointSets<> regions(triangles.size());
  vtkSMPTools::Sort(borders.begin(), borders.end());
  std::uint32_t numberOfPoints = 0;
  for (const SkdTriangleSet::Corners& corners : triangles)
  {
    numberOfPoints =
      std::max(numberOfPoints, *std::max_element(corners.begin(), corners.end()) + 1);
  }
  SkdMakeEdgeTable(triangles, numberOfPoints)
    .ForEach(
      [&](std::uint32_t low, const skd::EdgeUse<>* first, const skd::EdgeUse<>* last)
      {
        const bool isInner = last - first > 1 &&
          !std::binary_search(borders.begin(), borders.end(), SkdMakeSplitEdge(low, first->High));
        for (const skd::EdgeUse<>* use = first + 1; isInner && use != last; ++use)
        {
          regions.Unite(first->Triangle, use->Triangle);
        }
      });
  return regions.Number();
}
}
