// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCellFinder.h
 * @brief Finds the cell of a Source that contains a point, or the nearest one within a tolerance.
 */

#ifndef SkdCellFinder_h
#define SkdCellFinder_h

#include "Pipeline/SkdSourceTrees.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <memory>
#include <mutex>
#include <vector>

namespace skdtree
{
/// A location in a Source: a cell and parametric coordinates in it.
struct SkdCellLocation
{
  int Block = -1; // index in the list of blocks; -1: no location
  vtkIdType CellId = -1;
  int SubId = 0;
  double PCoords[3] = { 0.0, 0.0, 0.0 };
  double Distance = 0.0; // from the query point; 0 within the cell
};

/// The conditions for using the nearest cell for a point that no cell contains.
struct SkdCellFinderRules
{
  double RelativeTolerance = 0.0; // of the diagonal of that cell's bounds
  double AbsoluteTolerance = 0.0;
  double OutsideRadius = -1.0; // whatever the cell; negative: never
};

/// The trees of a Source's blocks, and their data for finders.
class SkdCellFinderSource
{
public:
  SkdCellFinderSource(const SkdSourceTrees& trees, const std::vector<SkdBlock>& blocks);

  /// Call this after updating the trees to the blocks, which may be new data sets although trees
  /// were reused; `built` trees were not.
  void Update(int built);

  /// The largest tolerance of the cells of the block. The first call visits all cells, if needed;
  /// it is not needed if every point is within a cell. Thread-safe.
  double GetLargestTolerance(const SkdCellFinderRules& rules, int block) const;

  const SkdSourceTrees& Trees;
  const std::vector<SkdBlock>& Blocks;
  int MaxCellSize = 0; // points of a cell

private:
  struct LargestCell
  {
    std::once_flag IsKnown;
    double Diagonal = 0.0;
  };
  std::vector<std::unique_ptr<LargestCell>> LargestCells; // one a block
};

/// Finds locations. One object a thread.
///
/// Cells that contain the point are preferred: the lowest block, then the lowest cell. Otherwise it
/// is the nearest cell that the rules allow, ties to the lowest (block, cell).
class SkdCellFinder
{
public:
  SkdCellFinder(const SkdCellFinderSource& source, const SkdCellFinderRules& rules);

  /// Finds the location of x, which is kept until the next call. False if there is none or x is not
  /// finite.
  bool Find(const double x[3]);

  /// Sets the location to the point nearest to x in a given cell.
  bool Evaluate(int block, vtkIdType cellId, const double x[3]);

  const SkdCellLocation& GetLocation() const { return this->Location; }

  /// Whether the cell of the location is a volume cell.
  bool IsInVolume() const;

  /// @{ The points of the location's cell, and the interpolation weights there: exact for linear
  /// fields.
  vtkIdList* GetPointIds() const { return this->PointIds; }
  double* GetWeights() { return this->Weights.data(); }
  ///@}

private:
  bool FindWithin(const double x[3]);
  bool FindByTolerance(const double x[3]);
  bool FindOutside(const double x[3]);
  void FindTolerated(int block, const double x[3], bool& isComplete);
  bool FindNext(int block, const double x[3], double radius, double& dist2);
  void TakeNext();
  bool IsTolerated(int block, vtkIdType cell, double distance) const;
  bool Finish();

  const SkdCellFinderSource& Source;
  SkdCellFinderRules Rules;
  SkdCellLocation Location;
  std::vector<double> Weights;
  SkdCellLocation Next; // what FindNext() found, and its weights
  std::vector<double> NextWeights;
  vtkNew<vtkIdList> PointIds;
  vtkNew<vtkIdList> Near;
  vtkNew<vtkDoubleArray> Distances;
};
}

#endif
