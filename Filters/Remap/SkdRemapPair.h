// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRemapPair.h
 * @brief The two meshes of a remapping, as they are taken, and what they are parts of.
 */

#ifndef SkdRemapPair_h
#define SkdRemapPair_h

#include "Core/Parallel/Processes.h"
#include "Pipeline/SkdBlocks.h"
#include "Remap/SkdOverlapWeights.h"
#include "Remap/SkdRemapRequest.h"

#include <set>
#include <string>

namespace skdtree
{
/// The blocks as one mesh; the mesh itself if there is but one, and an empty one if there is none.
/// Arrays of numbers that only some have are NaN elsewhere; `partial` becomes their names.
vtkSmartPointer<vtkDataSet> SkdJoinBlocks(
  const std::vector<SkdBlock>& blocks, std::set<std::string>& partial);

/// A donor, its blocks as one mesh, and the blocks of a target, each with the mesh that gets the
/// results. Points of longitudes and latitudes are moved to a sphere.
class SkdRemapPair
{
public:
  /// `outputs` are the meshes of `targets`, to add arrays to; `processes` all that have a piece of
  /// the target each, or nullptr.
  SkdRemapPair(const std::vector<SkdBlock>& donor, const std::vector<SkdBlock>& targets,
    const std::vector<SkdBlock>& outputs, const SkdRemapRequest& request,
    const skd::Processes* processes);

  vtkDataSet* GetDonor() const { return this->Donor; }
  const std::vector<SkdBlock>& GetTargets() const { return this->Targets; }
  const std::vector<SkdBlock>& GetOutputs() const { return this->Outputs; }

  /// As they are written to files of weights.
  const SkdWeightsGrids& GetGrids() const { return this->Grids; }

  /// Names of arrays that only some blocks of the donor have.
  const std::set<std::string>& GetPartialArrays() const { return this->PartialArrays; }

  bool HasCells() const; ///< the target

  /// Whether the cells of both are, on all processes. All must call it together.
  bool IsOfOneDimension(const skd::Processes* processes) const;
  bool IsDonorStructured() const { return this->DonorStructured; }
  /// 0 if it is on no sphere; the same on all processes.
  double RadiusOfTarget() const { return this->TargetRadius; }
  vtkIdType GetNumberOfTargetCells() const;

  /// What the meshes are parts of, as asked for, or by what they look like.
  SkdOverlapSpace FindSpace() const;

  /// What to say of meshes one of which may be of longitudes and latitudes, unasked; else nothing.
  std::string GetHint() const;

  /// Gives the results to the meshes as they were before they were moved.
  void Finish();

private:
  double FindTargetRadius(const skd::Processes* processes) const;
  void MoveToSphere(const skd::Processes* processes);
  const SkdBlock* FirstWithCells() const;

  const SkdRemapRequest& Request;
  vtkSmartPointer<vtkDataSet> Donor;
  std::vector<SkdBlock> Targets;
  std::vector<SkdBlock> Outputs;
  std::vector<SkdBlock> Given; // the outputs, where these were moved to a sphere
  SkdWeightsGrids Grids;
  std::set<std::string> PartialArrays;
  bool DonorStructured;
  double TargetRadius = 0.0;
};
}

#endif
