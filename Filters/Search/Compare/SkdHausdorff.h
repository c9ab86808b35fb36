// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdHausdorff.h
 * @brief The directed Hausdorff distance of two surfaces, by branch and bound.
 *
 * The distance of a point x from a set is at most that from one of its triangles, which is a convex
 * function of x. Over a piece of a triangle it is thus no more than its largest value at the three
 * corners, for each of the triangles that are nearest to the corners; and, as distances change no
 * faster than x moves, no more than the distance of a corner and the way from there. Pieces whose
 * bound exceeds the largest distance found by more than the tolerance are bisected (compare
 * Tang, Lee, Kim, *Interactive Hausdorff distance computation for general polygonal models*, ACM
 * TOG 28(3), 2009). Each process bisects pieces of its own triangles, but all go in the same
 * rounds, with the same largest distance and limit, so that the result does not depend on threads,
 * nor on which process has which triangle.
 */

#ifndef SkdHausdorff_h
#define SkdHausdorff_h

#include "Pipeline/SkdLoop.h"
#include "Search/Compare/SkdComparedSet.h"
#include "Search/Compare/SkdReduction.h"

#include <limits>

namespace skdtree
{
struct SkdHausdorff
{
  ///@{
  /// The largest distance found, and what the supremum of all distances cannot exceed. NaN of an
  /// empty set.
  double Distance = std::numeric_limits<double>::quiet_NaN();
  double UpperBound = std::numeric_limits<double>::quiet_NaN();
  ///@}

  ///@{
  /// Where it was found: a point, the nearest one of the other set, and where their elements come
  /// from.
  skd::Vector3 From{};
  skd::Vector3 To{};
  SkdComparedSet::Origin FromOrigin{ -1, -1 };
  SkdComparedSet::Origin ToOrigin{ -1, -1 };
  ///@}

  vtkIdType Bisections = 0; // of all processes
};

/// How far to go: until the bound is within a tolerance (a length), or at most so many bisections
/// are made. Of pieces with the same bound all are bisected or none.
struct SkdHausdorffLimits
{
  double Tolerance;
  vtkIdType Bisections;
};

/// From all of `from` to the nearest of `to`, reported as going from `first` to `last` of the
/// algorithm's progress. Where it is stopped, the upper bound is farther away than the tolerance.
/// All processes must call it together, and get the same.
SkdHausdorff SkdHausdorffOf(const SkdComparedSet& from, const SkdComparedSet& to,
  const SkdHausdorffLimits& limits, const SkdReduction& all, vtkAlgorithm* self, double first,
  double last);
}

#endif
