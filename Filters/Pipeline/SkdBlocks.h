// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdBlocks.h
 * @brief The data sets in a data object, composite or not.
 */

#ifndef SkdBlocks_h
#define SkdBlocks_h

#include "vtkDataSet.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace skdtree
{
/// A data set and its flat index in the composite data set, 0 if there is none.
struct SkdBlock
{
  vtkSmartPointer<vtkDataSet> Mesh;
  int BlockIndex;

  /// Of a piece of one mesh, which AMR data and partitioned data sets are: the flat index of the
  /// first piece of that mesh, be it there or not. -1 of others: each is a mesh by itself.
  int FirstPiece = -1;
};

/// Whether an object is a composite data set, whose blocks have flat indices. False for nullptr.
bool SkdIsComposite(vtkDataObject* object);

/// The data sets in `object`, by ascending flat index. Empty blocks and blocks that are not a
/// vtkDataSet (such as tables) are skipped. Empty for nullptr.
std::vector<SkdBlock> SkdBlocksOf(vtkDataObject* object);

/// The number of each of them among all leaves of the structure, empty ones, too: the same on
/// processes that have the structure alike, but other blocks in it. What is not composite is one
/// leaf.
struct SkdLeafNumbers
{
  std::vector<unsigned int> Of; ///< each block
  unsigned int Count = 0;       ///< of all leaves
};
SkdLeafNumbers SkdLeafNumbersOf(vtkDataObject* object);

/// Those of them that have cells.
std::vector<SkdBlock> SkdBlocksWithCells(std::vector<SkdBlock> blocks);

/// Gives `output` the structure and all the data of `input`, which is of the same type, without
/// copying arrays. Returns the data sets of the output: arrays can be added to them.
std::vector<SkdBlock> SkdMirror(vtkDataObject* input, vtkDataObject* output);

/// An array of the flat indices of some blocks, which are given by their indices in a list; -1
/// where the index is -1.
vtkSmartPointer<vtkIntArray> SkdMakeBlockIndices(
  const char* name, const std::vector<int>& positions, const std::vector<SkdBlock>& blocks);

/// Removes the point and cell data of the blocks, except ghost marks.
void SkdDropData(const std::vector<SkdBlock>& blocks);

/// Whether a mesh is a grid: an image, a rectilinear or a curvilinear one.
bool SkdIsStructured(vtkDataSet* mesh);

/// The points of all of them.
vtkIdType SkdCountPoints(const std::vector<SkdBlock>& blocks);

/// Makes GetCell(), GetCellPoints() and GetCellBounds() of a mesh thread-safe.
void SkdTouchCells(vtkDataSet* mesh);
}

#endif
