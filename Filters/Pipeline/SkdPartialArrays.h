// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPartialArrays.h
 * @brief Arrays that only some blocks of composite data have.
 *
 * They are kept where data of several blocks come together: NaN where there is no value, or 0 in
 * arrays of integers, and "SkdValid_" with the array's name marks by 1 where there is one.
 */

#ifndef SkdPartialArrays_h
#define SkdPartialArrays_h

#include "Pipeline/SkdBlocks.h"

#include <set>
#include <string>
#include <vector>

class vtkInformationVector;

namespace skdtree
{
constexpr const char* SkdPartialMarkPrefix = "SkdValid_";

/// Adds a list of names to a data object's report, SkdReportPartialArrays, unless it is empty.
void SkdReportPartialArrays(const std::set<std::string>& names, vtkDataObject* output);

/// Adds the names of marked arrays to the reports of the outputs that have them.
void SkdReportPartialArrays(vtkInformationVector* outputs);

/// The blocks that have points, with all arrays of numbers that any of them has, for code that
/// takes only those that all have and of one type: others become arrays of double, NaN where there
/// are no values. Inserts the names of partial ones into `partial`.
std::vector<SkdBlock> SkdCompleteArrays(
  const std::vector<SkdBlock>& blocks, std::set<std::string>& partial);
}

#endif
