// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdSourceTrees.h
 * @brief A tree for each block of a Source, reused while the block's mesh is unchanged.
 */

#ifndef SkdSourceTrees_h
#define SkdSourceTrees_h

#include "Cells/Read/SkdMeshSnapshot.h"
#include "Pipeline/SkdBlocks.h"
#include "vtkSkdTreeCellLocator.h"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace skdtree
{
/// The point of a Source nearest to a query point.
struct SkdNearest
{
  double Point[3];
  double Distance2; // squared
  int Block;        // index in the list of the Source's blocks
  vtkIdType CellId; // in that block
};

/// A radius that includes a squared distance: the square of its root may be less.
inline double SkdRadiusIncluding(double distance2)
{
  return std::nextafter(std::sqrt(distance2), std::numeric_limits<double>::infinity());
}

/// Statistics of a search structure, for reports.
struct SkdTreeCounts
{
  vtkIdType Cells = 0;        // in the trees
  vtkIdType CellsLeftOut = 0; // ghost, blanked, empty, not finite or of unknown type
  double Tolerance = 0.0;     // the largest absolute epsilon of a tree
};

/// A locator that is built explicitly and does not check for changes in each query.
vtkSmartPointer<vtkSkdTreeCellLocator> SkdMakeLocator(vtkDataSet* mesh);

/// Builds such a locator's tree if it is new or epsilon has changed. Returns whether it did.
bool SkdBuildLocator(vtkSkdTreeCellLocator* locator, double epsilon, bool isNew);

class SkdSourceTrees
{
public:
  /// Updates the trees to `blocks`. Returns the number of trees built; the others were reused.
  int Update(const std::vector<SkdBlock>& blocks, double epsilon);

  /// Forgets all.
  void Clear() { this->Trees.clear(); }

  /// The nearest point at a distance of at most `maximumDistance`, ties to the lowest
  /// (block, cell id). None of a point that is not finite. Thread-safe.
  std::optional<SkdNearest> FindNearest(const double x[3], double maximumDistance) const;

  ///@{
  /// The mesh of a block, its structure alone, and the locator that has it as its data set.
  vtkDataSet* GetMesh(int block) const { return this->Trees[block].Mesh.Get(); }
  vtkSkdTreeCellLocator* GetLocator(int block) const { return this->Trees[block].Locator; }
  ///@}

  SkdTreeCounts GetCounts() const;

private:
  struct Tree
  {
    SkdMeshSnapshot Mesh;
    vtkSmartPointer<vtkSkdTreeCellLocator> Locator;

    bool Update(vtkDataSet* mesh, double epsilon); // whether it was built
  };
  std::vector<Tree> Trees;
};
}

#endif
