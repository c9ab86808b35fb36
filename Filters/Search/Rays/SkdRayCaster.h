// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdRayCaster_h
#define SkdRayCaster_h

#include "Core/Geometry/Rows.h"
#include "Core/Geometry/Vector.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdSourceTrees.h"

#include <vector>

namespace skdtree
{
/// A point where a ray meets the Source.
struct SkdRayHit
{
  double Distance; // along the ray's direction: negative behind the start
  vtkIdType CellId;
  int Block; // index in the list of the Source's blocks
};

/// The hits of many rays, of each ray the nearest first.
class SkdRayHitLists : public skd::Rows<SkdRayHit>
{
public:
  vtkIdType GetNumberOfHits(vtkIdType ray) const
  {
    return static_cast<vtkIdType>((*this)[static_cast<std::size_t>(ray)].size());
  }

  /// Of the hits of all rays, the first of a ray.
  vtkIdType GetStart(vtkIdType ray) const
  {
    return static_cast<vtkIdType>(this->GetOffsets()[static_cast<std::size_t>(ray)]);
  }
  vtkIdType GetNumberOfHits() const { return static_cast<vtkIdType>(this->GetItems().size()); }

  /// The nearest hit of a ray, or nullptr.
  const SkdRayHit* GetFirst(vtkIdType ray) const
  {
    const Row hits = (*this)[static_cast<std::size_t>(ray)];
    return hits.size() > 0 ? hits.begin() : nullptr;
  }
};

struct SkdRayLimits
{
  double Tolerance; // hits closer to one another are one
  double Start;     // hits closer to the start are left out; negative: those there count, too
  double Maximum;   // no hit is farther
  bool BothWays;    // also against the direction
};

/// A length relative to the diagonal of the bounds of a Source, and at least 8 units in the last
/// place of the largest coordinate of both.
double SkdRayTolerance(
  double relative, const std::vector<SkdBlock>& source, const std::vector<SkdBlock>& input);

/// Casts rays at a Source by the locator's batches of rays.
class SkdRayCaster
{
public:
  SkdRayCaster(const SkdSourceTrees& trees, int blocks, const SkdRayLimits& limits);

  using Vectors = std::vector<skd::Vector3>;

  ///@{
  /// The first hit of each ray, or all of them. Directions have length 1, or 0: no hit. After an
  /// abort the remaining rays have none. Hits in several cells at one point are one, of the lowest
  /// (block, cell id).
  SkdRayHitLists FindFirst(const Vectors& starts, const Vectors& directions, SkdLoop& loop) const;
  SkdRayHitLists FindAll(const Vectors& starts, const Vectors& directions, SkdLoop& loop) const;
  ///@}

  /// The first hits of the rays from `begin` to `end`, block -1 if there is none, in parallel.
  void FindFirstOf(const Vectors& starts, const Vectors& directions, vtkIdType begin, vtkIdType end,
    std::vector<SkdRayHit>& first) const;

private:
  struct Batch;
  struct Answers;
  template <class Cast>
  void ForEachBatch(const Vectors& starts, const Vectors& directions, vtkIdType begin,
    vtkIdType end, const Cast& cast) const;
  std::size_t Merge(SkdRayHit* first, SkdRayHit* last) const;

  const SkdSourceTrees& Trees;
  int Blocks;
  SkdRayLimits Limits;
};
}

#endif
