// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSurfaceSet.h
 * @brief The surfaces of some data sets as triangles and patches in Bernstein form, and their
 * skD-tree; reused while the meshes are unchanged.
 */

#ifndef SkdSurfaceSet_h
#define SkdSurfaceSet_h

#include "Core/Curves/BezierPatch.h"
#include "Core/Geometry/Segment.h"
#include "Core/Search/Tree/Tree.h"
#include "Curves/SkdSurfaceReader.h"
#include "Pipeline/SkdBlockSnapshots.h"
#include "Pipeline/SkdBlocks.h"

#include <string>
#include <vector>

namespace skdtree
{
class SkdSurfaceSet
{
public:
  /// Reads all surface cells: planar quads, polygons and strips as triangles, others as patches.
  /// With `withVolumes` also the faces of volume cells that no other cell of the mesh has.
  /// Ghosts and what GetFaults() describes are left out. Returns whether anything was
  /// updated.
  bool Update(const std::vector<SkdBlock>& blocks, bool withVolumes, double epsilon);

  /// Sets the part of each element, by a list of ids for each block, one a cell; without lists by
  /// block, or by mesh where blocks are pieces of one. Intersections of coincident parts are
  /// separate.
  void AssignParts(
    const std::vector<SkdBlock>& blocks, const std::vector<std::vector<int>>& idsOfCells);

  const std::vector<SkdSurfaceElement>& GetElements() const { return this->Elements; }

  /// The corners of an element that is no patch, as they are.
  void GetTriangle(const SkdSurfaceElement& element, skd::Vector3 (&corners)[3]) const;

  /// An element as a patch seen from an origin.
  skd::BezierPatch GetPatch(const SkdSurfaceElement& element, const skd::Vector3& origin) const;

  ///@{
  /// visit(number of element) for all whose safety boxes meet the segment, or the box. Thread-safe.
  /// SkdVisitSurfaces.h has them.
  template <class Visit>
  void VisitAlong(const skd::Segment<3>& segment, Visit visit) const;
  template <class Visit>
  void VisitWithin(const skd::Box3& box, Visit visit) const;
  ///@}

  const skd::Box3& GetBounds() const { return this->Bounds; }
  double GetAbsoluteEpsilon() const { return this->AbsoluteEpsilon; }

  /// Messages about cells that could not be read.
  const std::vector<std::string>& GetFaults() const { return this->Faults; }

private:
  void Build(double epsilon);
  skd::Box3 BoundsOf(const SkdSurfaceElement& element) const;

  SkdBlockSnapshots Meshes;
  std::vector<SkdSurfaceElement> Elements;
  std::vector<skd::Vector3> Corners;
  std::vector<skd::Homogeneous> Controls; // of each patch its points, after a point: the origin
  skd::Tree<3> Tree;
  skd::Box3 Bounds;
  double Epsilon = -1.0;
  double AbsoluteEpsilon = 0.0;
  bool WithVolumes = false;
  std::vector<std::string> Faults;
};
}

#endif
