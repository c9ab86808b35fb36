// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPartList.h
 * @brief The parts that a Source is made of, kept while it is unchanged.
 */

#ifndef SkdPartList_h
#define SkdPartList_h

#include "InOut/SkdPart.h"
#include "Pipeline/SkdKeptMesh.h"

#include <string>
#include <vector>

enum class SkdPartsBy
{
  Blocks,         // id: the flat index, 0 without composite data
  CellArray,      // id: the value, rounded
  ConnectedPieces // id: 0, 1, ... by their first cell; points of equal coordinates are one
};

/// The values of a cell array of numbers, rounded; empty when there is no such array.
std::vector<int> SkdPartIdsOf(vtkDataSet* mesh, const std::string& array);

/// Whether all data sets have a cell array of numbers of that name.
bool SkdHavePartArray(const std::vector<SkdBlock>& blocks, const std::string& array);

/// The connected piece of each cell, one list a block: cells that share a point, of whatever block,
/// are of one. Numbered by their first cells.
std::vector<std::vector<int>> SkdConnectedPiecesOf(const std::vector<SkdBlock>& blocks);

class SkdPartList
{
public:
  /// Makes the parts those of the blocks, by what is said. Returns how many were made: 0 when all
  /// were kept. The array must be in all blocks.
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

    bool operator==(const Key& other) const
    {
      return this->By == other.By && this->Settings == other.Settings && this->Ids == other.Ids;
    }
  };

  bool IsSameAs(const std::vector<SkdBlock>& blocks) const;
  void MakeByIds(const std::vector<SkdBlock>& blocks);

  std::vector<SkdKeptMesh> Meshes;
  Key Last{ SkdPartsBy::Blocks, { -1.0 }, {} };
  std::vector<SkdPart> Parts;
};

#endif
