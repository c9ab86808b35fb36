// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOpenSolid.h
 * @brief Inside test for surfaces with holes, including self-intersecting ones.
 *
 * Where the holes of each shell are small, compared with the shell, they are closed (SkdHoleCaps),
 * and the result is that of the closed surface: exact, by winding numbers, whatever overlaps. The
 * confidence is at most the share of directions in which the point does not see a hole.
 *
 * Otherwise the winding number decides, with an orientation that is consistent within each
 * component of the surface. Where there are several components, one orientation is the given one,
 * another one has normals outward by the parity of lines, which is wrong where bodies overlap. If
 * they contradict each other, the number farther from 1/2 decides, with the confidence 1/2. If not,
 * the confidence is 1/2 plus the distance of the number from that limit, and at most the share of
 * seven lines whose directed crossings, with the given orientation, say the same.
 */

#ifndef SkdOpenSolid_h
#define SkdOpenSolid_h

#include "Bodies/SkdSolid.h"
#include "Bodies/SkdWinding.h"

#include <memory>
#include <vector>

namespace skdtree
{
class SkdHoleCaps;

/// Inside if a winding number is at least 1/2 or at most -1/2; the confidence is 1/2 plus its
/// distance from there, at most 1.
SkdSide SkdSideOf(const skd::WindingNumber::Sum& sum);

class SkdOpenSolid
{
public:
  /// A boundary with open edges, a locator of its surface, and the epsilon of a locator of the
  /// closed surface. O(n log n), about what the locator takes.
  SkdOpenSolid(const SkdBoundary& boundary, vtkSkdTreeCellLocator* locator, double epsilon);

  /// `tolerance` is that of SkdWinding::Ask(). Thread-safe.
  SkdSide Ask(const double x[3], double tolerance) const;
  bool IsInside(const double x[3]) const;

  /// The orientation that makes normals point outward: see SkdFindReversed.
  std::vector<bool> FindOutward(vtkPolyData* surface) const;

private:
  bool Close(const SkdBoundary& boundary, const SkdHoleCaps& caps, double epsilon);
  bool IsNearlyClosed(vtkIdType numberOfCaps) const;
  void MakeWindings();
  std::vector<bool> FindConsistent(const std::vector<bool>& outward) const;

  bool IsInsideBounds(const double x[3]) const;
  bool IsInsideForLines(const double x[3]) const;
  SkdSide AskWindings(const double x[3], double tolerance) const;
  double ShareOfLines(const double x[3], bool isInside) const;

  vtkSmartPointer<vtkPolyData> Surface; // as it is
  vtkSmartPointer<vtkSkdTreeCellLocator> Locator;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };

  ///@{
  /// The closed surface; nullptr where holes are large.
  vtkSmartPointer<vtkPolyData> Closed;
  std::unique_ptr<SkdSolid> Solid;
  std::unique_ptr<SkdWinding> Holes;
  ///@}

  ///@{
  /// With the given orientation, consistent within components, and with normals outward; nullptr
  /// if that is the same, or holes are small.
  std::unique_ptr<SkdWinding> Given;
  std::unique_ptr<SkdWinding> Outward;
  vtkSmartPointer<vtkUnsignedCharArray> Reversed; // of Given; nullptr: none
  ///@}
};
}

#endif
