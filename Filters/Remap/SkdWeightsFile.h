// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdWeightsFile.h
 * @brief Weights as files that other programs for remapping read.
 */

#ifndef SkdWeightsFile_h
#define SkdWeightsFile_h

#include "Pipeline/SkdBlocks.h"
#include "Remap/SkdConservativeRemap.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataSet;

namespace skdtree
{
/// Whose names and conventions a file follows.
enum class SkdWeightsFormat
{
  Esmf, ///< of the Earth System Modeling Framework: row, col, S
  Scrip ///< of Jones' SCRIP, which CDO reads: dst_address, src_address, remap_matrix
};

struct SkdWeightsFileSettings
{
  std::string Name; ///< "": none is written
  SkdWeightsFormat Format = SkdWeightsFormat::Esmf;
  SkdOverlapSpace Space = SkdOverlapSpace::Sphere;
  SkdNormalization Normalization = SkdNormalization::Covered;
  bool WithGradients = false; ///< SCRIP's weights of the gradient

  bool operator==(const SkdWeightsFileSettings& other) const;
};

/// A block of the target, with its overlaps.
struct SkdWeightsBlock
{
  vtkDataSet* Target;
  const SkdOverlapWeights* Weights;
};

/// What is told of the donor and of the target beside their cells.
struct SkdWeightsGrids
{
  std::vector<int> Source;
  std::vector<int> Target;
};

/// One file of several processes, each of which has the weights of its cells of the target, and all
/// of the donor.
struct SkdWeightsShare
{
  using Numbers = std::vector<double>;

  /// Of each cell of the target, block after block, its row in the whole, or -1: it is not written.
  std::vector<vtkIdType> Rows;
  vtkIdType NumberOfRows = 0; ///< of the whole
  int CornersPerCell = 1;     ///< of the whole, at most
  bool IsWriter = false;      ///< which has weights
  /// Calls take(numbers) on the writer, with what each process tells, in their order.
  std::function<void(const Numbers& own, const std::function<void(const Numbers&)>& take)> Gather;
};

/// How many cells a structured grid of two dimensions has along each, the first varies fastest.
/// Empty of other meshes, and of several blocks.
std::vector<int> SkdGridSizesOf(const std::vector<SkdBlock>& blocks);

/// Writes the weights of all blocks of a target, whose cells count on from block to block. Cells
/// count from 1. On a sphere centres and corners are longitudes and latitudes in degrees and areas
/// are of the unit sphere; else centres are Cartesian (ESMF only, with zc_a and zc_b) and areas,
/// lengths or volumes as they are. SCRIP's second and third weight are those of the derivatives by
/// latitude, and by longitude over the cosine of the latitude, at the Cartesian centroid of the
/// source cell; the attribute remap_order is then 2, by which other programs know. With a share all
/// processes must call it together, and the writer writes. What is wrong, a sentence; empty if
/// nothing is.
std::string SkdWriteWeights(const SkdWeightsFileSettings& settings, vtkDataSet* donor,
  const std::vector<SkdWeightsBlock>& blocks, const SkdWeightsGrids& grids,
  const SkdWeightsShare* share);

/// How many corners a cell of any of the blocks has, at most.
int SkdCornersPerCell(const std::vector<SkdBlock>& blocks);
}

#endif
