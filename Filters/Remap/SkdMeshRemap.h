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

class vtkDataObject;
class vtkTable;

namespace skdtree
{
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
  void FillOverlaps(vtkDataObject* overlaps) const;
  ///@}

  /// After Run(): writes the file of weights that is asked for, unless there it is. Returns what is
  /// to be told, if anything.
  std::string WriteWeights();

  ///@{
  /// After Run(): what to warn of, arrays that were refused, and the report.
  std::vector<std::string> GetWarnings() const;
  std::set<std::string> GetRefused() const;
  void AddReport(double seconds, vtkDataObject* output) const;
  ///@}

  /// Lets go of the meshes' data. What is kept stays.
  void End();

private:
  void SetUp(const skd::Processes* processes);
  void Begin(bool hasOthers);
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
