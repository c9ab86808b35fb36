// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdBodyExit_h
#define SkdBodyExit_h

#include "Bodies/SkdWinding.h"
#include "Pipeline/SkdBlocks.h"
#include "Search/Rays/SkdRayCaster.h"

#include <memory>
#include <mutex>
#include <vector>

namespace skdtree
{
/// Where rays that begin on a surface leave the body that it bounds: where the winding number
/// returns to 0, for shells of the body may overlap.
///
/// The winding number where a ray begins is counted along a line to the outside. On a surface with
/// open edges, which is only known once a ray needs it, it is the generalized winding number
/// rounded, and at least 1: then the first shell that the ray leaves is that on which it begins.
class SkdBodyExit
{
public:
  /// Rays begin `start` from where they are given. `own` is how far curved faces may be from their
  /// facets: what a ray enters closer than that is the face on which it begins.
  SkdBodyExit(const SkdSourceTrees& trees, int blocks, double start, double own);

  /// Whether it has so many blocks and this start.
  bool IsOf(std::size_t blocks, double start) const
  {
    return this->Surfaces.size() == blocks && this->Start == start;
  }

  /// The exit of a ray, given its first hit; block -1 if there is none, or the ray begins outside.
  /// Costs one line to the outside, and all hits of the ray unless the first one is the exit.
  /// Thread-safe.
  SkdRayHit Find(const skd::Vector3& from, const skd::Vector3& along, const SkdRayHit& first) const;

  /// Whether facets stand for curved faces, so that a first hit may be of the face on which a ray
  /// begins.
  bool HasOwnHits() const { return this->Own > 0.0; }

private:
  struct Pass
  {
    double Distance;
    int Block;
    vtkIdType CellId;
    int Direction; // 1: out through the front, -1: in
  };

  bool IsSimple() const { return !this->IsCurved && !this->HasOwnHits(); }
  SkdRayHit FindLast(const skd::Vector3& begin, const std::vector<Pass>& passes, vtkIdType number,
    const SkdRayHit& first) const;
  vtkIdType CountAround(const skd::Vector3& x) const;
  vtkIdType Corrected(vtkIdType number, const skd::Vector3& x) const;
  const std::vector<Pass>& FindPasses(const skd::Vector3& from, const skd::Vector3& along) const;

  const SkdSourceTrees& Trees;
  std::vector<SkdBlock> Surfaces;
  double Start;
  double Own;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Length = 0.0;   // leads out of the bounds
  bool IsCurved = false; // some cell is: then directions come of normals

  mutable std::once_flag OpenFlag;
  mutable std::unique_ptr<SkdWinding> Winding; // of a surface with open edges, else nullptr
};
}

#endif
