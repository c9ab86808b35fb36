// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdCellFinder.h
 * @brief Which cell of a Source holds a point, or serves for one that no cell holds.
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

/// A place in a Source: a cell, and where in it.
struct SkdCellLocation
{
  int Block = -1; // index in the list of blocks; -1: no place
  vtkIdType CellId = -1;
  int SubId = 0;
  double PCoords[3] = { 0.0, 0.0, 0.0 };
  double Distance = 0.0; // from the point that was asked for; 0 within the cell
};

/// When a point that no cell holds is taken for a point of the nearest one.
struct SkdCellFinderRules
{
  double RelativeTolerance = 0.0; // of the diagonal of that cell's bounds
  double AbsoluteTolerance = 0.0;
  double OutsideRadius = -1.0; // whatever the cell; negative: never
};

/// The trees of a Source's blocks, and the numbers that finders want of them.
class SkdCellFinderSource
{
public:
  SkdCellFinderSource(const SkdSourceTrees& trees, const std::vector<SkdBlock>& blocks);

  /// To be called once the trees are those of the blocks, which may be other data sets each time
  /// though trees were kept: `built` of them were not.
  void Update(int built);

  /// The largest tolerance that a cell of the block has. Who asks first looks at all cells, if they
  /// matter: nobody does where every point is within a cell. Thread-safe.
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

/// Finds places. One object a thread.
///
/// A place within a cell goes before any other: of the lowest block, and there of the lowest cell.
/// Else it is the nearest cell that the rules allow, ties to the lowest (block, cell).
class SkdCellFinder
{
public:
  SkdCellFinder(const SkdCellFinderSource& source, const SkdCellFinderRules& rules);

  /// Whether there is a place for x, then kept until the next call. None of a point not finite.
  bool Find(const double x[3]);

  /// Makes the place the point nearest to x of a cell that is known.
  bool Evaluate(int block, vtkIdType cellId, const double x[3]);

  const SkdCellLocation& GetPlace() const { return this->Place; }

  /// Whether the cell of the place fills a volume.
  bool IsInVolume() const;

  ///@{
  /// The points of the place's cell, and the weights by which it interpolates there: exact for
  /// linear fields.
  vtkIdList* GetPointIds() const { return this->PointIds; }
  double* GetWeights() { return this->Weights.data(); }
  ///@}

private:
  bool FindWithin(const double x[3]);
  bool FindByTolerance(const double x[3]);
  bool FindOutside(const double x[3]);
  void FindTolerated(int block, const double x[3], SkdCellLocation& best);
  bool IsTolerated(int block, vtkIdType cell, double distance) const;
  bool Finish();

  const SkdCellFinderSource& Source;
  SkdCellFinderRules Rules;
  SkdCellLocation Place;
  std::vector<double> Weights;
  vtkNew<vtkIdList> PointIds;
  vtkNew<vtkIdList> Near;
  vtkNew<vtkDoubleArray> Distances;
};

#endif
