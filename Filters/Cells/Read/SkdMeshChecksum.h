// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdMeshChecksum_h
#define SkdMeshChecksum_h

#include "vtkDataSet.h"

#include <cstddef>

namespace skdtree
{
/// A hash of all arrays of a mesh that a tree depends on: points, cells, ghost marks, rational
/// weights and degrees. To notice values that were changed in place where only the data set was
/// told so (vtkDataSet::Modified()). O(n), some gigabytes a second. Two meshes that differ have the
/// same one with a probability of 2^-64.
std::size_t SkdMeshChecksum(vtkDataSet* mesh);
}

#endif
