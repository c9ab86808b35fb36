// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPartList.h
 * @brief The parts of a Source, reused while it is unchanged.
 */

#ifndef SkdPartList_h
#define SkdPartList_h

#include "Pipeline/SkdBlockSnapshots.h"
#include "Search/InOut/SkdPart.h"

#include <string>
#include <vector>

namespace skdtree
{
enum class SkdPartsBy
{
  Blocks,         // id: the flat index, 0 without composite data
  CellArray,      // id: the value, rounded
  ConnectedPieces // id: 0, 1, ... by their first cell; points of equal coordinates are one
};

/// The rounded values of a numeric cell array; empty if there is no such array.
std::vector<int> SkdPartIdsOf(vtkDataSet* mesh, const std::string& array);

/// Whether all data sets have a numeric cell array of that name.
bool SkdHavePartArray(const std::vector<SkdBlock>& blocks, const std::string& array);

/// The connected component of each cell, one list a block: cells that share a point, also of
/// different blocks, belong to one. Numbered by their first cells.
std::vector<std::vector<int>> SkdConnectedPiecesOf(const std::vector<SkdBlock>& blocks);

class SkdPartList
{
public:
  /// Updates the parts to the blocks. Returns the number of parts made, 0 if all were reused. All
  /// blocks must have the array.
  int Update(const std::vector<SkdBlock>& blocks, SkdPartsBy by, const std::string& array,
    const SkdPartSettings& settings);

  const std::vector<SkdPart>& Get() const { return this->Parts; }
  double GetChordalLength() const { return this->Last.Settings.ChordalLength; }

private:
  struct Key
  {
    SkdPartsBy By;
    SkdPartSettings Settings;
    std::vector<std::vector<int>> Ids; // of cells, one list a block, unless by blocks
    std::vector<int> BlockIndices;     // of blocks, which may move while their meshes stay

    bool operator==(const Key& other) const
    {
      return this->By == other.By && this->Settings == other.Settings && this->Ids == other.Ids &&
        this->BlockIndices == other.BlockIndices;
    }
  };

  void MakeByIds(const std::vector<SkdBlock>& blocks);

  SkdBlockSnapshots Meshes;
  Key Last{ SkdPartsBy::Blocks, { -1.0 }, {}, {} };
  std::vector<SkdPart> Parts;
};
}

#endif
