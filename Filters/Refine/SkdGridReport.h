// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridReport_h
#define SkdGridReport_h

#include "Refine/SkdGrid.h"

class SkdReport;

/// Tells how many cells there are, of each level, and how many there would be at the maximum level.
void SkdReportGrid(SkdReport& report, const SkdGrid& grid, int maximumLevel);

#endif
