// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdCurveHitGroups_h
#define SkdCurveHitGroups_h

#include "Curves/SkdCurveHit.h"

#include <vector>

/// Puts hits in order, and makes one of those that tell the same place of two curves: at joints of
/// their pieces, or within what they may be off by. The ends of stretches that go on there go.
std::vector<SkdCurveHit> SkdUniteCurveHits(std::vector<SkdCurveHit>& hits, bool isSelf);

/// Makes one of those hits that tell one place of curves which go on as each other there: of the
/// curves of the lowest numbers. Ends of stretches stay, and nothing else where there are any.
void SkdUniteAtJoints(std::vector<SkdCurveHit>& hits, bool isSelf);

/// Puts stretches in order and joins those of two curves that follow each other.
std::vector<SkdCurveStretch> SkdJoinStretches(std::vector<SkdCurveStretch>& stretches);

/// Of each pair of curves the nearest approach, unless they meet at one of `hits`.
std::vector<SkdCurveHit> SkdNearestApproaches(
  std::vector<SkdCurveHit>& near, const std::vector<SkdCurveHit>& hits);

#endif
