// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMatchedSurfaces.h
 * @brief The overlaps of a curved surface with all blocks of another one that nearly coincides.
 */

#ifndef SkdMatchedSurfaces_h
#define SkdMatchedSurfaces_h

#include "Core/Parallel/Processes.h"
#include "Pipeline/SkdBlocks.h"
#include "Remap/SkdOverlapCache.h"

#include <deque>
#include <string>
#include <vector>

namespace skdtree
{
/// What was found of both, on all processes together.
struct SkdSurfaceFindings
{
  bool HasSides = true;       ///< whether normals tell the sides of both meshes
  vtkIdType Folded = 0;       ///< cells of the donor that are covered more than once
  vtkIdType Uncovered = 0;    ///< cells of the donor that are not, or not all, covered
  double SourceCoverage = 0.; ///< what of the donor's area is covered
  double LargestGap = 0.0;    ///< between facets that have to do with each other

  /// What to warn of, with what to do.
  void AddWarnings(std::vector<std::string>& warnings) const;
};

/// Finds how the surfaces face each other and the overlaps of all blocks, and sees to it that no
/// donor cell hands out more than its area: where a target has folds, what covers a cell is scaled
/// down to it. One donor, of which each process has all, or what is near its target and own cells.
class SkdMatchedSurfaces
{
public:
  /// `overlaps` are those of the blocks; `processes` all that take part, or nullptr.
  SkdMatchedSurfaces(vtkDataSet* donor, const std::vector<SkdBlock>& blocks,
    std::deque<SkdOverlapCache>& overlaps, const skd::Processes* processes)
    : Donor(donor)
    , Blocks(blocks)
    , Overlaps(overlaps)
    , Processes(processes)
  {
  }

  /// Sets the side of the settings, and finds. False if aborted.
  bool Match(SkdOverlapSettings& settings, vtkAlgorithm* algorithm, double first, double last);

  const SkdSurfaceFindings& GetFindings() const { return this->Findings; }

  /// Of how many blocks overlaps were not kept.
  int GetNumberOfNew() const { return this->NumberOfNew; }

private:
  void FindSide(SkdFacetRules& rules);
  bool Update(std::size_t block, const SkdOverlapSettings& settings, vtkAlgorithm* algorithm,
    double first, double last);
  std::vector<double> SumOverAll(std::vector<double> own) const;
  std::vector<double> SumOfCells(std::vector<double> covered) const;
  void SumUp(double whole, double handed, bool isSpread);
  std::vector<double> FindShares(const std::vector<double>& covered);

  vtkDataSet* Donor;
  const std::vector<SkdBlock>& Blocks;
  std::deque<SkdOverlapCache>& Overlaps;
  const skd::Processes* Processes;
  SkdSurfaceFindings Findings;
  int NumberOfNew = 0;
};
}

#endif
