// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentReference.h
 * @brief intersections and distances of segments, in extended precision
 */
#ifndef skdtest_SegmentReference_h
#define skdtest_SegmentReference_h

#include "Support/PrimitiveDistance.h"

namespace skdtest
{

/// Where a segment enters a box (0 if it starts inside); negative if it does not meet it.
double EntryIntoBox(const Point& p1, const Point& p2, const Bounds& box);

/// The least distance of the segments p1 p2 and q1 q2.
double SegmentsDistance(const Point& p1, const Point& p2, const Point& q1, const Point& q2);

}

#endif
