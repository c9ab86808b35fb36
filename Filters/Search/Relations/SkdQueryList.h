// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdQueryList.h
 * @brief The query shapes: one, or all points or cells of data sets.
 */

#ifndef SkdQueryList_h
#define SkdQueryList_h

#include "Bodies/SkdParts.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Search/Relations/SkdQueryShape.h"

#include <optional>

namespace skdtree
{
class SkdQueryList
{
public:
  void SetShape(const SkdQueryShape& shape);
  void SetPoints(const std::vector<SkdBlock>& blocks);
  /// Those that are in the parts' trees, which must outlive the list as the blocks they are of.
  void SetCells(const SkdParts& parts, const std::vector<SkdBlock>& blocks, bool wantsOutlines);

  vtkIdType GetSize() const;

  /// Thread-safe.
  SkdQueryShape Make(vtkIdType query) const;

  ///@{
  /// The point or cell that a query is, and its block; 0 for a shape.
  vtkIdType GetId(vtkIdType query) const;
  int GetBlockIndex(vtkIdType query) const;
  ///@}

private:
  void Clear();
  void AddBlock(int blockIndex, vtkIdType size);
  /// Its block and its index there.
  std::pair<std::size_t, vtkIdType> Find(vtkIdType query) const;

  std::optional<SkdQueryShape> Shape;
  std::vector<SkdBlock> Points;
  const SkdParts* Parts = nullptr;
  std::vector<SkdJoinedIds> Joined; // of the parts
  bool WantsOutlines = false;
  std::vector<int> BlockIndices;
  std::vector<vtkIdType> Starts{ 0 }; // of blocks, and the end
};
}

#endif
