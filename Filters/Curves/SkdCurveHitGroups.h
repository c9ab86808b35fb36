// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurveHitGroups_h
#define SkdCurveHitGroups_h

#include "Curves/SkdCurveHit.h"

#include <vector>

namespace skdtree
{
/// Sorts hits, and merges those of the same intersection of two curves: at joints of their pieces,
/// or within their error. Ends of intervals that continue there are removed.
std::vector<SkdCurveHit> SkdUniteCurveHits(std::vector<SkdCurveHit>& hits, bool isSelf);

/// Merges hits at the joint of curves that continue each other into that of the curves with the
/// lowest numbers. Ends of intervals are kept, and replace all others there.
void SkdUniteAtJoints(std::vector<SkdCurveHit>& hits, bool isSelf);

/// Sorts intervals and joins adjacent ones of the same two curves.
std::vector<SkdCurveInterval> SkdJoinIntervals(std::vector<SkdCurveInterval>& intervals);

/// The nearest approach of each pair of curves, unless they intersect at one of `hits`.
std::vector<SkdCurveHit> SkdNearestApproaches(
  std::vector<SkdCurveHit>& near, const std::vector<SkdCurveHit>& hits);
}

#endif
