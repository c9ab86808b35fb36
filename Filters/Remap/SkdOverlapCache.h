// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdOverlapCache_h
#define SkdOverlapCache_h

#include "Cells/Read/SkdMeshSnapshot.h"
#include "Remap/SkdDonorGradients.h"
#include "Remap/SkdOverlapWeights.h"
#include "Remap/SkdPointWeights.h"
#include "Remap/SkdSurfaceSides.h"

#include <memory>

namespace skdtree
{
/// The overlaps of one target with the donor, and what else is made of both meshes alone: kept
/// while these and the settings are the same.
class SkdOverlapCache
{
public:
  /// Makes it that of these meshes. Reports progress from `first` to `last`. False if the algorithm
  /// was aborted or if there is a problem: nothing is kept then.
  bool Update(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings,
    vtkAlgorithm* algorithm, double first, double last);

  /// Whether the last Update() found new ones.
  bool IsNew() const { return this->New; }
  const std::string& GetProblem() const { return this->Weights->GetProblem(); }

  const SkdOverlapWeights& GetWeights() const { return *this->Weights; }

  /// Of curved surfaces, after Update(): multiplies the overlaps of each donor cell; empty shares
  /// are all 1. False if others have been taken before: Forget() and Update() then.
  bool TakeShares(const std::vector<double>& shares);
  void Forget() { this->Known = false; }

  /// What overlaps of each donor cell were before shares were taken.
  const std::vector<double>& GetCovered() const { return this->Covered; }

  /// Of curved surfaces: how the target's cells face the donor's.
  const SkdSideVotes& GetSides(vtkDataSet* donor, vtkDataSet* target);

  ///@{
  /// Made when they are first wanted. The table is nullptr if the algorithm was aborted.
  const SkdDonorGradients& GetGradients(vtkDataSet* donor);
  const SkdOverlapPointTable* GetPointTable(
    vtkDataSet* donor, vtkDataSet* target, vtkAlgorithm* algorithm, double first, double last);
  ///@}

private:
  bool IsFor(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings) const;

  SkdMeshSnapshot Donor;
  SkdMeshSnapshot Target;
  SkdOverlapSettings Settings;
  bool Known = false;
  bool New = false;
  std::unique_ptr<SkdOverlapWeights> Weights = std::make_unique<SkdOverlapWeights>();
  std::unique_ptr<SkdDonorGradients> Gradients;
  std::unique_ptr<SkdOverlapPointTable> PointTable;
  std::vector<unsigned char> OwnDonors; // SkdOwnCellsOf
  std::vector<double> Covered;
  std::vector<double> Shares;
  SkdMeshSnapshot SidesOfDonor;
  SkdMeshSnapshot SidesOfTarget;
  SkdSideVotes Sides;
};
}

#endif
