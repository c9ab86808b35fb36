// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdMeshRefiner.h
 * @brief Refines a mesh until no criterion requires finer cells.
 *
 * In rounds: each tests the cells made in the previous round, once, in parallel, and cuts those to
 * be refined, together with cells that must be cut with them. A round that would make too many
 * cells is undone as a whole, so the mesh is always valid. Several processes perform the same
 * rounds; cells are counted together.
 */

#ifndef SkdMeshRefiner_h
#define SkdMeshRefiner_h

#include "Core/Meshing/Grid/Balance.h"
#include "Core/Meshing/Mesh/SharedCuts.h"
#include "Meshing/Refine/SkdCriteria.h"

class vtkAlgorithm;

namespace skdtree
{
struct SkdMeshSettings : SkdCriteria
{
  int MinimumLevel = 0;     ///< which all cells get
  bool IsConforming = true; ///< by bisection; else cell by cell
  skd::Contact Balance = skd::Contact::None;
  int Layers = 0; ///< around cells that are wanted finer
  std::uint64_t CellLimit = 0;
  skd::SharedCuts* Shared = nullptr; ///< with other processes, each of which refines a piece
};

/// What became of it.
struct SkdMeshOutcome
{
  bool IsAborted = false;
  bool IsStopped = false;    ///< by the cell limit
  int StoppedAtLevel = -1;   ///< then: the least level of the cells that were wanted finer
  double CellsEstimated = 0; ///< if nothing had stopped it, by the growth so far; else their number
  int Rounds = 0;
};

class SkdMeshRefiner
{
public:
  /// Reports the algorithm's progress, from `first` to `last`, and checks for abort.
  SkdMeshRefiner(vtkAlgorithm* algorithm, double first, double last, skd::RefinedMesh& mesh,
    const SkdParts& parts, const SkdMeshSettings& settings);

  /// The result depends on neither the number of threads nor the numbering of cells and points.
  SkdMeshOutcome Refine();

private:
  std::vector<std::uint32_t> FindWanted(std::uint32_t begin);
  bool IsWanted(std::uint32_t cell) const;
  bool Cut(const std::vector<std::uint32_t>& wanted);
  bool Bisect(const std::vector<std::uint32_t>& cells);
  bool IsAny(bool here) const;
  bool FitTogether() const;
  void TellSize() const;
  double Estimate() const;
  int LeastLevelOf(const std::vector<std::uint32_t>& cells) const;

  vtkAlgorithm* Algorithm;
  double First;
  double Last;
  skd::RefinedMesh& Mesh;
  const SkdParts& Parts;
  const SkdMeshSettings& Settings;
  SkdMeshOutcome Outcome;
  std::vector<double> LeavesAfter; // each round
  double Done = 0.0;               // of the whole work, as far as it is known
};
}

#endif
