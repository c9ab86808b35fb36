// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Growth.h
 * @brief how costs grow with the number of cells
 */
#ifndef skdbench_Growth_h
#define skdbench_Growth_h

#include "Measure.h"

namespace skdbench
{

/// Sizes ascending: builds and a few queries on noisy spheres, then builds and finding cells among
/// tetrahedra, by the kinds that are for millions.
std::vector<Results> MeasureGrowth(const std::vector<Kind>& kinds, const Options& options);

}

#endif
