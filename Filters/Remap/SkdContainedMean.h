// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdContainedMean.h
 * @brief What the cells of a mesh make of the donor points that they hold (section 6.6).
 *
 * Steps 1 to 3 of the algorithm there: the points are put into a tree once; then each cell of a
 * mesh, or of one that was moved, makes one query and takes the mean of what it truly holds
 * (SkdTargetCells says what that is), not of what is in its box.
 */

#ifndef SkdContainedMean_h
#define SkdContainedMean_h

#include "Pipeline/SkdLoop.h"
#include "Remap/SkdSampleStatistic.h"
#include "Remap/SkdSampleTree.h"
#include "Remap/SkdTargetCells.h"

#include <algorithm>
#include <limits>

namespace skdtree
{
/// What a cell takes that holds no sample with a value.
enum class SkdEmptyCells
{
  Leave,       ///< nothing
  Nearest,     ///< the sample nearest to the mean of its corners, ties to the lowest
  EnclosingBox ///< those in its box, grown twofold about its middle until there are some
};

class SkdContainedMean
{
public:
  /// `weights`: positive, one a point, or none: all are 1. See SkdSampleTree.
  SkdContainedMean(std::vector<skd::Vector3> points, std::vector<double> weights, bool isOnSphere);

  const SkdSampleTree& GetTree() const { return this->Tree; }
  bool IsOnSphere() const { return this->Tree.IsOnSphere(); }
  std::size_t GetNumberOfPoints() const { return this->Tree.GetNumberOfPoints(); }
  double GetWeight(std::uint32_t i) const { return this->Weights.empty() ? 1.0 : this->Weights[i]; }

  /// The points that a loaded cell holds, ascending. Thread-safe.
  void FindContained(const SkdTargetCells::Cell& cell, std::vector<std::uint32_t>& points) const;

  /// The points with isWanted(i) that an empty cell takes, ascending. Thread-safe. Include
  /// SkdNearestSamples.h to call it.
  template <class Wanted>
  void FindSubstitutes(const SkdTargetCells::Cell& cell, SkdEmptyCells empty,
    const Wanted& isWanted, std::vector<std::uint32_t>& points) const;

  /// Calls visit(cell, id, points) in parallel for each cell that holds or could hold points. Each
  /// thread has its own cell and list. Whether all was done: not if aborted.
  template <class Visit>
  bool ForEachCell(const SkdTargetCells& cells, SkdLoop& loop, const Visit& visit) const;

  /// The means of `values`, one a point, NaN where there is none: such points do not count. NaN
  /// for cells without a mean. The same to the last bit whatever the number of threads.
  std::vector<double> GetMeans(const SkdTargetCells& cells, const std::vector<double>& values,
    SkdEmptyCells empty, SkdLoop& loop) const;

private:
  SkdSampleTree Tree;
  std::vector<double> Weights;
};

template <class Wanted>
void SkdContainedMean::FindSubstitutes(const SkdTargetCells::Cell& cell, SkdEmptyCells empty,
  const Wanted& isWanted, std::vector<std::uint32_t>& points) const
{
  points.clear();
  if (empty == SkdEmptyCells::Nearest)
  {
    const std::int64_t nearest = this->Tree.FindNearest(cell.GetCentre(), isWanted);
    if (nearest >= 0)
    {
      points.push_back(static_cast<std::uint32_t>(nearest));
    }
  }
  const skd::Box3 bounds = this->Tree.GetBounds();
  skd::Box3 box = cell.GetBox();
  const auto isLeftOut = [&](std::uint32_t i)
  { return !isWanted(i) || !box.Contains(this->Tree.CoordinatesOf(this->Tree.GetPoint(i))); };
  bool isAll = empty != SkdEmptyCells::EnclosingBox || !(box.Diagonal() > 0.0);
  while (points.empty() && !isAll)
  {
    const double growth = 0.5 * box.Diagonal();
    box = box.Inflated(growth);
    isAll = box.Contains(bounds) || !(growth < std::numeric_limits<double>::max());
    this->Tree.FindWithin(box, points);
    points.erase(std::remove_if(points.begin(), points.end(), isLeftOut), points.end());
  }
  std::sort(points.begin(), points.end());
}

template <class Visit>
bool SkdContainedMean::ForEachCell(
  const SkdTargetCells& cells, SkdLoop& loop, const Visit& visit) const
{
  return loop.For(cells.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      SkdTargetCells::Cell cell(cells);
      std::vector<std::uint32_t> points;
      for (vtkIdType id = begin; id < end; ++id)
      {
        if (cell.Load(id))
        {
          this->FindContained(cell, points);
          visit(cell, id, points);
        }
      }
    });
}
}

#endif
