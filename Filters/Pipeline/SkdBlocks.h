// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBlocks.h
 * @brief The data sets in a data object, composite or not.
 */

#ifndef SkdBlocks_h
#define SkdBlocks_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <vector>

/// A data set and its flat index in the composite data set, 0 if there is none.
struct SkdBlock
{
  vtkSmartPointer<vtkDataSet> Mesh;
  int BlockIndex;
};

/// The data sets in `object`, by ascending flat index. Empty blocks and blocks that are not a
/// vtkDataSet (such as tables) are skipped. Empty for nullptr.
std::vector<SkdBlock> SkdBlocksOf(vtkDataObject* object);

/// Gives `output` the structure and all the data of `input`, which is of the same type, without
/// copying arrays. Returns the data sets of the output: arrays can be added to them.
std::vector<SkdBlock> SkdMirror(vtkDataObject* input, vtkDataObject* output);

/// The points of all of them.
vtkIdType SkdCountPoints(const std::vector<SkdBlock>& blocks);

#endif
