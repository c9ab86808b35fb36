// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdCriteria.h"

#include "Cells/Search/SkdVisitCandidates.h"

#include <algorithm>

namespace skdtree
{
namespace
{
bool IsMetBy(const SkdCellTree& tree, const SkdRegion& region, SkdOverlapTest test)
{
  const skd::CandidateLanes all = skd::AllCandidates().front();
  bool isMet = false;
  tree.VisitCandidates({ &all, &all + 1 }, region.GetBox(),
    [&](std::uint32_t cell) { isMet = isMet || region.Meets(tree, cell, test); });
  return isMet;
}

double NormalDeviationIn(const SkdCellTree& tree, const SkdRegion& region, SkdOverlapTest test)
{
  return tree.FindNormalDeviation(
    region.GetBox(), [&](std::uint32_t cell) { return region.Meets(tree, cell, test); });
}

bool IsNear(int level, const SkdRegion& region, const SkdParts& parts,
  const std::vector<SkdDistanceBand>& bands)
{
  double maxDistance = -1.0;
  for (const SkdDistanceBand& band : bands)
  {
    maxDistance = level < band.Level ? std::max(maxDistance, band.Distance) : maxDistance;
  }
  if (!(maxDistance >= 0.0))
  {
    return false;
  }
  // The middle decides most.
  const double limit = maxDistance + region.GetRadius();
  const double distance = parts.FindDistance(region.GetMiddle(), limit);
  thread_local skd::SimplexSet room;
  return distance <= maxDistance ||
    (distance <= limit && parts.AreWithin(region.GetSet(room), maxDistance));
}
}

bool SkdCriteria::IsWantedByParts(int level, const SkdRegion& region, const SkdParts& parts) const
{
  const bool isAnyDeviation = !(this->NormalDeviation >= 0.0) || level < this->MinimumSurfaceLevel;
  for (std::uint32_t part = 0; part < parts.GetNumberOfParts(); ++part)
  {
    const SkdCellTree& tree = parts.GetTree(part);
    if (level < this->PartLevels[part] && IsMetBy(tree, region, this->Test) &&
      (isAnyDeviation || NormalDeviationIn(tree, region, this->Test) > this->NormalDeviation))
    {
      return true;
    }
  }
  return false;
}

bool SkdCriteria::IsWantedByOthers(int level, const SkdRegion& region, const SkdParts& parts) const
{
  return IsNear(level, region, parts, this->Bands) ||
    (level < this->InsideLevel && this->IsInside(region.GetMiddle())) ||
    (level < this->FieldLevel && this->IsFieldWanted(region));
}
}
