// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Works.h
 * @brief samples of queries for each kind of work, made for a data set
 */
#ifndef skdbench_Works_h
#define skdbench_Works_h

#include "QueryKind.h"

class vtkDataSet;

namespace skdbench
{

/// All kinds of work that make sense for the data set, each with `count` queries.
std::vector<Work> MakeWorks(vtkDataSet* data, int count);

}

#endif
