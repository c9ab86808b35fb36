// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMeshRemap.h
 * @brief Fields of one mesh on another, by any of the methods.
 */

#ifndef SkdMeshRemap_h
#define SkdMeshRemap_h

#include "Remap/SkdRemapPair.h"
#include "Remap/SkdRemapProbe.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkTable;

namespace skdtree
{
/// The cells of a target's blocks in the whole of which each process has a part.
struct SkdTargetRows
{
  std::vector<std::vector<vtkIdType>> OfBlocks; ///< SkdWeightsShare::Rows
  vtkIdType Number = 0;                         ///< of the whole
  std::vector<int> GridSizes;                   ///< SkdGridSizesOf the whole
  std::string Problem;                          ///< why there is no whole; else empty
};

/// Processes that write one file together.
struct SkdWeightsSharers
{
  using Numbers = std::vector<double>;

  const skd::Processes& Processes;
  int Rank; ///< of this one
  std::function<SkdTargetRows()> FindRows;
  /// Calls take(numbers) on one process with those of all.
  std::function<void(
    int process, const Numbers& own, const std::function<void(const Numbers&)>& take)>
    GatherAt;
};

/// Maps a donor's fields onto a target, whatever the request, and tells what it has done. What is
/// made of the meshes alone is kept from run to run while these are unchanged.
class SkdMeshRemap
{
public:
  /// Adds the results to the outputs of the pair. `processes` are all that take part with a piece
  /// of the target each, or nullptr; the algorithm gets the progress.
  void Run(SkdRemapPair& pair, const SkdRemapRequest& request, const skd::Processes* processes,
    vtkAlgorithm* algorithm);

  ///@{
  /// After Run(), of what was mapped conservatively: the weights as rows, and the overlaps as a
  /// mesh, one a block if `overlaps` has blocks. `withBlocks` adds the block to each row.
  void FillWeights(bool withBlocks, vtkTable* table) const;
  void FillOverlaps(vtkDataObject* input, vtkDataObject* overlaps) const;
  ///@}

  /// After Run(): writes the file of weights that is asked for, unless there it is. `sharers` are
  /// all processes that have a part of the target, or nullptr: they must call it together, and one
  /// of them writes. Returns what this one is to tell, if anything.
  std::string WriteWeights(const SkdWeightsSharers* sharers);

  ///@{
  /// After Run(): what to warn of, arrays that were refused, and the report.
  std::vector<std::string> GetWarnings() const;
  std::set<std::string> GetRefused() const;
  void AddReport(double seconds, vtkDataObject* output) const;
  ///@}

  /// Lets go of the meshes' data. What is kept stays.
  void End();

private:
  std::string WriteShares(const SkdWeightsFileSettings& file,
    const std::vector<SkdWeightsBlock>& blocks, const SkdWeightsSharers& sharers) const;
  std::vector<vtkIdType> RowsOf(const SkdTargetRows& rows) const;
  void SetUp(const skd::Processes* processes);
  void Begin(const skd::Processes* processes);
  void MapAll(const skd::Processes* processes);
  void MapBlocks(double start);
  void MapBlock(std::size_t block, double first, double last);
  void MapAutomatically(std::size_t block, double first, double last);
  void Interpolate(vtkDataSet* block, bool withCellData, double first, double last);

  SkdRemapper Remapper;
  SkdRemapProbe Probe;
  SkdWeightsFileSettings Written; // the file that there is

  // Of one run:
  SkdRemapPair* Pair = nullptr;
  const SkdRemapRequest* Request = nullptr;
  vtkAlgorithm* Algorithm = nullptr;
  SkdRemapSettings Settings;
  SkdRemapMethod Method = SkdRemapMethod::Automatic; // as the meshes are
  bool AreCurved = false;
  std::set<std::string> Refused;
  std::set<std::string> Empty; // arrays that are interpolated and have no value
};
}

#endif
