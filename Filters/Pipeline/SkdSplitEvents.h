// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdSplitEvents_h
#define SkdSplitEvents_h

#include "Pipeline/SkdSplitSegments.h"

/// What happens where the new segments of a side's triangles meet others of the same triangle,
/// ascending, each once. In parallel; of a triangle with n segments O(n log n) plus what overlaps
/// along an axis.
std::vector<SkdSplitEvent> SkdFindSplitEvents(const SkdSplitSegments& segments, int side);

#endif
