// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRayOutputs_h
#define SkdRayOutputs_h

#include "Pipeline/SkdBlocks.h"
#include "Search/Rays/SkdRayCaster.h"
#include "Search/Rays/SkdRayStarts.h"

#include <string>
#include <vector>

class vtkDataSetAttributes;
class vtkPolyData;

namespace skdtree
{
/// The rays of a data set, and where they hit.
struct SkdCastRays
{
  SkdRayStarts Starts;
  SkdRayHitLists Lists;

  /// Where a hit of a ray is.
  skd::Vector3 PointOf(vtkIdType ray, const SkdRayHit& hit) const
  {
    const auto i = static_cast<std::size_t>(ray);
    return this->Starts.Points[i] + hit.Distance * this->Starts.Directions[i];
  }
};

/// The Source, as far as outputs need it.
struct SkdRayTarget
{
  const SkdSourceTrees& Trees;
  const std::vector<SkdBlock>& Blocks;
  bool IsComposite;

  /// Makes cells of its meshes thread-safe to read.
  void Touch() const
  {
    for (std::size_t block = 0; block < this->Blocks.size(); ++block)
    {
      SkdTouchCells(this->Trees.GetMesh(static_cast<int>(block)));
    }
  }
};

/// The starts of all of them.
inline vtkIdType SkdCountStarts(const std::vector<SkdCastRays>& rays, bool withHidden)
{
  vtkIdType count = 0;
  for (const SkdCastRays& cast : rays)
  {
    count += cast.Starts.GetNumber() - (withHidden ? 0 : cast.Starts.CountHidden());
  }
  return count;
}

/// Adds the number of hits of each ray.
void SkdAddHitCounts(vtkDataSetAttributes* data, const SkdCastRays& rays);

/// Adds distance, point, cell, side and, of a composite Source, block of the first hit of each ray.
void SkdAddFirstHits(
  vtkDataSetAttributes* data, const SkdCastRays& rays, const SkdRayTarget& target);

/// The same without hits of the starts that another process lists. By data set whether this one
/// lists each; an empty list: it does.
std::vector<SkdCastRays> SkdListedRays(
  std::vector<SkdCastRays> rays, const std::vector<std::vector<unsigned char>>& listed);

/// Fills `output` with a point for each hit or, with `areLines`, a line from the start to it, in
/// the order of the rays. Their data are those of the hit, and of the start those arrays that all
/// `starts` have, without ghost marks.
void SkdFillHits(vtkPolyData* output, const std::vector<SkdCastRays>& rays,
  const std::vector<vtkDataSetAttributes*>& starts, const SkdRayTarget& target, bool areLines);
}

#endif
