// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdVolumeCells_h
#define SkdVolumeCells_h

#include "Pipeline/SkdBlocks.h"

#include <vector>

class vtkDataSet;

namespace skdtree
{
///@{
/// Whether there are volume cells, whose outer faces bound a body. O(cells).
bool SkdHasVolumeCells(vtkDataSet* mesh);
bool SkdHasVolumeCells(const std::vector<SkdBlock>& blocks);
///@}
}

#endif
