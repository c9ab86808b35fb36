// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdGridExtras.h"

#include "Meshing/Refine/SkdGridDistances.h"
#include "Meshing/Refine/SkdGridFractions.h"
#include "Meshing/Refine/SkdGridInside.h"

namespace skdtree
{
SkdGridExtras SkdFindExtras(const SkdGrid& grid, const SkdGridRequests& requests,
  const SkdParts& parts, const SkdEnclosure& enclosure, vtkAlgorithm* algorithm, double first,
  double last)
{
  const double third = (last - first) / 3.0;
  SkdGridExtras extras;
  if (requests.NeedBoundary())
  {
    extras.Inside = SkdFindInside(grid, enclosure, algorithm, first, first + third);
  }
  if (requests.Fractions)
  {
    extras.Fractions = SkdFindFractions(grid, enclosure, extras.Inside, requests.Epsilon, algorithm,
      first + third, first + 2.0 * third);
  }
  if (!requests.Inside)
  {
    extras.Inside.clear(); // was for the fractions only
  }
  if (requests.Distances)
  {
    extras.Distances = SkdFindDistances(grid, parts, algorithm, first + 2.0 * third, last);
    if (requests.Inside)
    {
      SkdSignDistances(extras.Distances, extras.Inside);
    }
  }
  return extras;
}
}
