// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdKeptOverlaps_h
#define SkdKeptOverlaps_h

#include "Cells/Read/SkdMeshSnapshot.h"
#include "Remap/SkdDonorGradients.h"
#include "Remap/SkdOverlapWeights.h"
#include "Remap/SkdPointWeights.h"

#include <memory>

/// The overlaps of one target with the donor, and what else is made of both meshes alone: kept
/// while these and the settings are the same.
class SkdKeptOverlaps
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
};

#endif
