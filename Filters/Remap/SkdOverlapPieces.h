// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapPieces.h
 * @brief The cells of a mesh as the convex pieces that overlaps are found of.
 */

#ifndef SkdOverlapPieces_h
#define SkdOverlapPieces_h

#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Box.h"
#include "Remap/SkdOverlapBlock.h"
#include "Remap/SkdOverlapSurface.h"

#include <cstdint>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;

namespace skdtree
{
class SkdLoop;

/// The cells of one mesh, read once. Any number of threads may look at them.
class SkdOverlapPieces
{
public:
  /// Reads all cells in parallel. False if stopped.
  bool Read(vtkDataSet* data, const SkdOverlapSurface& surface, const SkdOverlapReading& reading,
    SkdLoop& loop);

  /// Cells that are not left out, in the order of their ids.
  std::uint32_t GetNumberOfCells() const { return static_cast<std::uint32_t>(this->Ids.size()); }
  vtkIdType IdOf(std::uint32_t cell) const { return this->Ids[cell]; }
  const skd::Box3& BoundsOf(std::uint32_t cell) const { return this->Bounds[cell]; }

  const SkdOverlapBlock& BlockOf(std::uint32_t cell) const
  {
    return this->Blocks[cell / BlockSize];
  }
  /// The pieces First .. Last - 1 of its block.
  struct Range
  {
    std::uint32_t First;
    std::uint32_t Last;
  };
  Range PiecesOf(std::uint32_t cell) const
  {
    const auto& first = this->BlockOf(cell).FirstPiece;
    return { first[cell % BlockSize], first[cell % BlockSize + 1] };
  }

  /// If requested: the points of a cell with corners that are none of them (SkdOverlapBlock); of
  /// another cell there are none.
  struct PointRange
  {
    const vtkIdType* First;
    std::size_t Size;
  };
  PointRange OwnPointsOf(std::uint32_t cell) const
  {
    const SkdOverlapBlock& block = this->BlockOf(cell);
    const std::size_t first = block.FirstOwnPoint[cell % BlockSize];
    return { block.OwnPoints.data() + first, block.FirstOwnPoint[cell % BlockSize + 1] - first };
  }

  ///@{
  /// Of whole cells, on the surface, when they are measured.
  double MeasureOf(std::uint32_t cell) const { return this->Measures[cell]; }
  const skd::Vector3& CentreOf(std::uint32_t cell) const { return this->Centres[cell]; }
  ///@}

  /// Finds measures and centroids; `cells` gets them as the world has them. O(n).
  void Measure(const SkdOverlapSurface& surface, SkdOverlapCells& cells);

private:
  static constexpr std::uint32_t BlockSize = 1024;

  struct ReadFrom
  {
    const SkdCellTree& Tree;
    SkdCellSource Source;
    const SkdOverlapSurface& Surface;
    const SkdOverlapReading& Reading;
  };
  void ReadBlock(std::uint32_t number, const ReadFrom& from);
  void FindFaults();

  vtkIdType NumberOfAllCells = 0;
  vtkIdType NumberOfGhosts = 0; // that are skipped
  std::vector<vtkIdType> Ids;
  std::vector<skd::Box3> Bounds;
  /// Of a whole cell, about a point.
  skd::Moments MomentsOf(std::uint32_t cell, const skd::Vector3& reference) const;
  skd::Vector3 NormalOf(std::uint32_t cell) const;

  std::vector<SkdOverlapBlock> Blocks;
  std::vector<vtkIdType> Crossing;
  std::vector<vtkIdType> TooLarge;
  std::vector<double> Measures;
  std::vector<skd::Vector3> Centres;
};

/// The meshes that are compared.
struct SkdOverlapPair
{
  SkdOverlapPieces Donor;
  SkdOverlapPieces Target;

  /// Reads both, the donor as it is or into simplices, as the algorithm's progress goes from
  /// `first` to `last`. False if stopped, or if the surface has a problem.
  bool Read(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSurface& surface,
    const SkdOverlapSettings& settings, bool intoSimplices, vtkAlgorithm* algorithm, double first,
    double last);
};
}

#endif
