// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdWeightsMatrix_h
#define SkdWeightsMatrix_h

#include "Remap/SkdConservativeRemap.h"

#include <cstddef>
#include <vector>

namespace skdtree
{
/// The matrix of a file of weights, as a list of its entries. Rows, cells of the target, and
/// columns, cells of the source, count from 1.
struct SkdWeightsMatrix
{
  using Numbers = std::vector<double>;

  std::vector<int> Rows;
  std::vector<int> Columns;
  Numbers Weights; ///< so many an entry
  std::size_t WeightsPerEntry = 1;
  Numbers Measures; ///< of the overlaps, where they are wanted
  bool WithMeasures = false;

  std::size_t Size() const { return this->Rows.size(); }

  std::size_t NumbersPerEntry() const { return 3 + this->WeightsPerEntry; }

  /// An entry with its measure as so many numbers, and again: see SkdWeightsGrid.
  template <class Transfer>
  void TransferEntry(std::size_t entry, const Transfer& transfer)
  {
    transfer(this->Rows[entry]);
    transfer(this->Columns[entry]);
    transfer(this->Measures[entry]);
    for (std::size_t i = 0; i < this->WeightsPerEntry; ++i)
    {
      transfer(this->Weights[entry * this->WeightsPerEntry + i]);
    }
  }

  void Resize(std::size_t entries);

  /// By rows, in each by columns; with measures only.
  void Sort();

  /// Adds the overlaps of a target's block, whose cells count from `firstRow` + 1. With three
  /// weights an entry the second and third are those of the derivatives along the meridian and
  /// along the parallel.
  void Add(const SkdOverlapWeights& weights, SkdNormalization normalization, std::size_t firstRow);
};
}

#endif
