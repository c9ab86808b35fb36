// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdGridReport_h
#define SkdGridReport_h

#include "Meshing/Refine/SkdGridEstimate.h"

namespace skdtree
{
class SkdReport;

/// Reports the numbers of cells, by level, and the estimate.
void SkdReportGrid(SkdReport& report, const SkdGrid& grid, const SkdGridEstimate& estimate);
}

#endif
