// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Table.h
 * @brief results as Markdown and CSV
 */
#ifndef skdbench_Table_h
#define skdbench_Table_h

#include "Measure.h"

#include <iosfwd>

namespace skdbench
{

/// Machine, VTK's version and whether it is optimised, and how to read what follows.
void PrintHeader(std::ostream& out, const Options& options);

/// One data set: absolute costs of the skD-tree, all others as multiples of it.
void PrintScene(std::ostream& out, const SceneResult& result, const std::vector<Kind>& kinds);

/// Where the skD-tree is slower than the best of VTK, and which was wrong how often.
void PrintSummary(std::ostream& out, const Results& results);

/// A table for each kind, a row for each size.
void PrintGrowth(std::ostream& out, const Results& growth);

/// Every number, one a line, after a line that names the columns.
void PrintCsv(std::ostream& out, const std::vector<Results>& all);

/// The results of the skD-tree that the referee found wrong.
int CountOurErrors(const Results& results);

}

#endif
