// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSolid.h
 * @brief Inside test for closed surfaces, including self-intersecting ones.
 *
 * One ray decides exactly, by the facets it passes through and its direction through each. Nested
 * shells that do not touch are alternately bodies and cavities, whatever their orientation. Shells
 * that touch or intersect, together with cavities oriented inward, form one body: points whose
 * winding number is not 0 are inside, with all shells except these cavities oriented outward.
 *
 * The confidence is 1, or 1/2 if the winding number of the given orientation contradicts the result
 * (a nested shell of the same orientation, overlapping bodies one of which is inside out; duplicate
 * faces count repeatedly). For shells that are not oriented consistently it is 3/4 where bodies
 * overlap, and 1/2 in one-sided ones.
 */

#ifndef SkdSolid_h
#define SkdSolid_h

#include "Bodies/SkdBoundary.h"
#include "Bodies/SkdShells.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeCellLocator.h"

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace skdtree
{
/// A vector from a point within bounds to a point outside of them, to count crossings on
/// (section 6.3).
using SkdRayEnd = std::array<double, 3>;

/// Six rays go along the axes in both directions, the shortest first, because they intersect few
/// boxes. They are slightly tilted, because many surfaces have faces and edges along the axes, and
/// a ray within such a face is the most expensive to decide. A seventh, oblique ray avoids ties.
std::array<SkdRayEnd, 7> SkdRayEndsAlongAxes(const double bounds[6], const double x[3]);

/// What is said of a point.
struct SkdSide
{
  bool IsInside = false;
  double Confidence = 1.0; // 0.5 to 1: the share of the votes, or what stands for it
  /// @{ The winding number and the bound of its error; 0 if they were not requested.
  double WindingNumber = 0.0;
  double WindingBound = 0.0;
  ///@}
};

/// A pass through a surface along a line.
struct SkdPassAlong
{
  double At; ///< how far along
  int After; ///< what is around what follows: 0 outside, 1 or -1 inside, others need a query
};

class SkdSolid
{
public:
  /// The triangles, without open edges, and a locator of them, both to be kept as they are.
  SkdSolid(const SkdBoundary& boundary, vtkSkdTreeCellLocator* locator);

  /// `ray` leads from x to the outside. Cost: one ray. When a ray first passes through more than
  /// one facet, shells are computed, and when x is first in several, their contacts. Thread-safe.
  SkdSide Ask(const double x[3], const SkdRayEnd& ray) const;

  /// The passes along a segment whose ends are outside, as distances from its start if it has this
  /// length. Thread-safe.
  void FindPasses(
    const double p1[3], const double p2[3], double length, std::vector<SkdPassAlong>& passes) const;

private:
  struct Around;

  bool IsClear(vtkIdType sum) const;
  void FindShells() const;
  void FindGroups() const;
  void JoinCavities(std::vector<int>& groups) const;
  bool AreOpposite(int a, int b) const;
  bool IsWithin(int shell, const std::vector<int>& groups) const;
  const std::vector<Around>& FindAround(const double x[3], const double end[3]) const;
  const std::vector<Around>& FindAround(const skd::Vector3& x) const;
  SkdSide Weigh(const double x[3], const double end[3]) const;
  int CountGroupsAround(const std::vector<Around>& arounds) const;

  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkSkdTreeCellLocator> Locator;
  std::vector<int> Repeats; // see SkdBoundary
  double Bounds[6];

  ///@{
  /// Made when they are first needed.
  mutable std::once_flag ShellsFlag;
  mutable std::once_flag GroupsFlag;
  mutable std::atomic<bool> HasShells{ false };
  mutable std::unique_ptr<SkdShells> Shells;
  mutable bool HasOneSided = false;
  mutable std::vector<int> Groups;  // of each shell
  mutable std::vector<char> Cavity; // whether a shell is one within its group
  ///@}
};
}

#endif
