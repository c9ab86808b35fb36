// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSource.h
 * @brief A filter's Source, prepared for nearest point queries with or without signs.
 */

#ifndef SkdSource_h
#define SkdSource_h

#include "Bodies/SkdSignedSource.h"
#include "Pipeline/SkdSourceTrees.h"

namespace skdtree
{
class SkdSource
{
public:
  /// Updates the trees to `source`, building only new ones. With `wantsSide` they are trees of the
  /// boundary, if there is one, and have inside tests (see SkdSignedSource).
  void Update(vtkDataObject* source, bool wantsSide, double epsilon, double chordalDeviation);

  /// Releases the Source's data; the trees are kept.
  void Release() { this->Blocks.clear(); }

  /// The blocks that have cells.
  const std::vector<SkdBlock>& GetBlocks() const { return this->Blocks; }

  /// The mesh of a block: its structure alone.
  vtkDataSet* GetMesh(int block) const;

  /// Whether there is a boundary that was wanted.
  bool HasSides() const { return this->Sided; }

  /// @{ See SkdSourceTrees and SkdSignedSource. Without signs nothing is inside. Thread-safe.
  std::optional<SkdNearest> FindNearest(const double x[3], double maximumDistance) const;
  bool IsInside(const double x[3]) const { return this->Sided && this->Boundary.IsInside(x); }
  ///@}

  ///@{
  /// Of the last Update().
  SkdTreeCounts GetCounts() const;
  vtkIdType GetNumberOfOpenEdges() const;
  double GetChordalLength() const { return this->Sided ? this->Boundary.GetChordalLength() : 0.0; }
  vtkIdType GetNumberOfCoarseFaces() const
  {
    return this->Sided ? this->Boundary.GetNumberOfCoarseFaces() : 0;
  }
  int GetTreesBuilt() const { return this->TreesBuilt; }
  ///@}

private:
  int UpdateTrees(bool wantsSide, double epsilon, double chordalDeviation);

  std::vector<SkdBlock> Blocks;
  SkdSourceTrees Trees;
  SkdSignedSource Boundary;
  bool Sided = false;
  int TreesBuilt = 0;
};
}

#endif
