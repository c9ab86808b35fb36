// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdGridRefiner.h
 * @brief The five steps of section 6.5: base cells, and their recursive refinement where they
 * intersect parts.
 *
 * Level by level. A cell's candidate list is passed on to its children, so all cells together need
 * one traversal of the parts' trees. Then growing layers, and finally the 2:1 balance.
 */

#ifndef SkdGridRefiner_h
#define SkdGridRefiner_h

#include "Core/Meshing/Grid/Balance.h"
#include "Core/Parallel/Processes.h"
#include "Meshing/Refine/SkdCandidateLists.h"
#include "Meshing/Refine/SkdCriteria.h"
#include "Meshing/Refine/SkdGrid.h"

class vtkAlgorithm;

namespace skdtree
{
struct SkdRefineSettings : SkdCriteria
{
  skd::Contact Balance = skd::Contact::None;
  int Layers = 0;
  std::uint64_t CellLimit = 0;
  /// @{ Do not refine base cells that are more than this number of cells away from own ones; -1:
  /// refine all. The own cells of all processes are then counted together.
  int KnownLayers = -1;
  const skd::Processes* Processes = nullptr;
  ///@}
};

class SkdGridRefiner
{
public:
  /// Reports the algorithm's progress, from `first` to `last`, and checks for abort.
  SkdGridRefiner(vtkAlgorithm* algorithm, double first, double last, SkdGrid& grid,
    const SkdParts& parts, const SkdRefineSettings& settings);

  /// Refines the base cells. The result does not depend on the number of threads. Returns false
  /// after an abort: the grid is then incomplete but valid. With several processes all must call
  /// it.
  bool Refine();

  /// Refines at most `most` cells a level, evenly chosen from those to refine. Returns the
  /// estimated number of cells to refine on each level.
  std::vector<double> RefineSample(std::size_t most);

private:
  /// The result of the refinement test of a cell.
  struct Finding
  {
    std::int32_t Part = -1;
    std::int32_t LevelWanted = 0; ///< by the parts that meet it
  };
  struct Batch
  {
    SkdCandidateLists Lists;
    std::vector<Finding> Findings;
  };

  Finding Examine(const skd::Box3& box, const SkdCandidateLists& above, std::size_t position,
    SkdCandidateLists& below) const;
  std::int32_t Count(
    const skd::Box3& box, const SkdCandidateLists& lists, std::size_t position) const;
  bool ExamineLevel(int level);
  void KeepFindings(int level, const std::vector<Batch>& batches);
  bool MarkLevel(int level, std::vector<char>& marks);
  bool IsLeftAlone(int level, std::uint32_t cell) const;
  void LeaveOutIndivisible(int level, std::vector<char>& marks);
  bool IsWanted(int level, std::uint32_t cell) const;
  bool IsWantedByParts(int level, std::uint32_t cell, const skd::Box3& box) const;
  bool IsAny(bool here) const;
  bool HasRoomFor(int level, std::uint64_t families);
  bool HasRoomFor(int level, const std::vector<char>& marks);
  bool HasRoomFor(int level, std::uint64_t families, std::uint64_t cells);
  void RefineMarked(int level, const std::vector<char>& marks);
  void Balance();
  bool RefineForBalance(int level, std::uint32_t cell);
  template <class Body>
  bool ForCells(int level, double share, const Body& body);

  vtkAlgorithm* Algorithm;
  double First;
  double Last;
  SkdGrid& Grid;
  const SkdParts& Parts;
  const SkdRefineSettings& Settings;
  SkdCandidateLists Lists; // of the cells of the level that was examined last
  std::vector<Finding> Findings;
  std::vector<char> IsNear;      // of base cells: near own ones; empty if all are
  std::uint64_t OwnFamilies = 0; // that were made so far
};
}

#endif
