// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSolid.h
 * @brief What a closed surface encloses, be it one that meets itself.
 *
 * One ray decides, exactly: by which facets it passes through, and which way. Where shells of the
 * surface lie within each other without touching, they take turns: the inner is a cavity, however
 * it is turned. Shells that touch or cross each other, and cavities turned inward with what they
 * are in, are one body: what its winding number is not 0 of is inside, all shells being turned
 * outward, but those cavities.
 *
 * The confidence is 1 unless the surface as it is turned says otherwise (of its winding number: of
 * a shell within another that is turned the same way, or of bodies that overlap and one of which is
 * inside out; faces that are there repeatedly count as often in it), then 1/2. Of shells whose
 * triangles are not turned alike, which say nothing, it is 3/4 where bodies overlap, and 1/2 in
 * those that have one side only.
 */

#ifndef SkdSolid_h
#define SkdSolid_h

#include "Pipeline/SkdBoundary.h"
#include "Pipeline/SkdShells.h"
#include "Pipeline/SkdWaysOut.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeCellLocator.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

/// What is said of a point.
struct SkdSide
{
  bool IsInside = false;
  double Confidence = 1.0; // 0.5 to 1: the share of the votes, or what stands for it
  ///@{
  /// The winding number, and what it is off by at most; 0 where it was not asked.
  double WindingNumber = 0.0;
  double WindingBound = 0.0;
  ///@}
};

/// A pass through a surface along a line.
struct SkdPassAlong
{
  double At; ///< how far along
  int After; ///< what is around what follows: 0 outside, 1 or -1 inside, others must be asked
};

class SkdSolid
{
public:
  /// The triangles, without open edges, and a locator of them, both to be kept as they are.
  SkdSolid(const SkdBoundary& boundary, vtkSkdTreeCellLocator* locator);

  /// `way` leads from x to the outside. Cost: a ray; where it passes through more than one facet
  /// for the first time, shells are found, and where x is in several, those that touch each other.
  /// Thread-safe.
  SkdSide Ask(const double x[3], const SkdWayOut& way) const;

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

#endif
