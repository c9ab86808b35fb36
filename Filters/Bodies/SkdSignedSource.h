// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSignedSource.h
 * @brief The tree of a Source's boundary, with inside tests; reused while the Source's meshes are
 * unchanged.
 */

#ifndef SkdSignedSource_h
#define SkdSignedSource_h

#include "Bodies/SkdBody.h"
#include "Pipeline/SkdBlockSnapshots.h"

#include <optional>
#include <vector>

namespace skdtree
{
class SkdSignedSource
{
public:
  /// Updates the boundary and the tree to `blocks`, with curved faces as facets within a chordal
  /// deviation relative to the diagonal of all. Returns the number of trees built, 0 if all were
  /// reused.
  int Update(const std::vector<SkdBlock>& blocks, double epsilon, double chordalDeviation);

  /// Forgets all.
  void Clear() { *this = SkdSignedSource(); }

  /// The number of faces; if it is 0 nothing is inside.
  vtkIdType GetNumberOfFaces() const { return this->GetBoundary().Faces->GetNumberOfCells(); }

  /// See SkdBoundary.
  vtkPolyData* GetSurface() const { return this->GetBoundary().Surface; }

  /// The deviation as a length; 0 if no cell is curved.
  double GetChordalLength() const { return this->ChordalLength; }

  /// See SkdBlockSurface.
  vtkIdType GetNumberOfCoarseFaces() const { return this->GetBoundary().CoarseFaces; }

  /// Edges at which the boundary is open.
  vtkIdType GetNumberOfOpenEdges() const { return this->GetBoundary().OpenEdges; }

  /// As SkdSourceTrees::FindNearest, on the boundary: the cell is that of the face.
  std::optional<SkdNearest> FindNearest(const double x[3], double maximumDistance) const
  {
    return this->Body.FindNearest(x, maximumDistance);
  }

  /// Whether x is inside the boundary, see SkdSolid, of an open one SkdOpenSolid. Points on the
  /// boundary may be either. Thread-safe.
  bool IsInside(const double x[3]) const;

  /// The mesh of a block: its structure alone.
  vtkDataSet* GetMesh(int block) const { return this->Meshes.Get(block); }

  SkdTreeCounts GetCounts() const;

private:
  const SkdBoundary& GetBoundary() const { return this->Body.GetBoundary(); }

  SkdBlockSnapshots Meshes;
  double ChordalLength = 0.0; // 0 where no cell is curved
  SkdBody Body;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }; // of the surface
};
}

#endif
