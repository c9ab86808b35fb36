// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdFileRemap.h
 * @brief Weights that a file has, ours or another program's, applied to fields.
 */

#ifndef SkdFileRemap_h
#define SkdFileRemap_h

#include "Pipeline/SkdBlocks.h"
#include "Remap/SkdDonorFields.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace skdtree
{
/// Weights as they are read: a sparse matrix.
struct SkdFileWeights
{
  std::string Name;
  ///@{
  /// Cells or points of the target and of the source; 0 if the file does not say.
  std::size_t Rows = 0;
  std::size_t Columns = 0;
  ///@}
  std::vector<int> Row;    ///< of each entry, from 1
  std::vector<int> Column; ///< of each entry, from 1
  std::size_t WeightsPerEntry = 1;
  std::vector<double> Weights; ///< of second order those of the gradient, too (SkdWriteWeights)

  /// Reads a file with row, col and S, as those of ESMF, TempestRemap and NCO have them, or with
  /// dst_address, src_address and remap_matrix, as those of SCRIP and CDO. What is wrong, a
  /// sentence; empty if nothing is.
  std::string Read(const std::string& fileName);
};

/// Which data sets' points or cells (vtkDataObject's types) the numbers of a file are.
struct SkdFileMeshes
{
  int SourceType;
  int TargetType;
};

class SkdFileRemap
{
public:
  SkdFileRemap(const SkdFileWeights& weights, vtkDataSet* donor,
    const std::vector<SkdBlock>& blocks, vtkAlgorithm* algorithm);

  /// `wanted` is vtkDataObject's type that results are wanted of, or -1. What is wrong, a sentence
  /// with both sizes; empty if nothing is.
  std::string Match(int wanted);
  const SkdFileMeshes& GetMeshes() const { return this->Meshes; }

  /// Values at all of the target's cells or points, block after block. What does not count has no
  /// share, and the others have its weight among them; NaN of what is in no entry. `isMapped`
  /// becomes 1 where there is a value.
  std::vector<double> Map(const SkdDonorField& field, std::vector<unsigned char>& isMapped) const;

private:
  std::vector<double> Expand(const SkdDonorField& field) const;

  const SkdFileWeights& Weights;
  vtkDataSet* Donor;
  const std::vector<SkdBlock>& Blocks;
  vtkAlgorithm* Algorithm;
  SkdFileMeshes Meshes{ 0, 0 };
};
}

#endif
