// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapCache.h"

#include "Pipeline/SkdJoinedIds.h"
#include "Remap/SkdPointWeights.h"

namespace skdtree
{
bool SkdOverlapCache::IsFor(
  vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings) const
{
  return this->Known && settings.Space == this->Settings.Space &&
    settings.DonorIsLonLat == this->Settings.DonorIsLonLat &&
    settings.TargetIsLonLat == this->Settings.TargetIsLonLat &&
    settings.Radius == this->Settings.Radius && settings.Facets == this->Settings.Facets &&
    settings.SkipsGhosts == this->Settings.SkipsGhosts && this->Donor.IsSameAs(donor) &&
    this->Target.IsSameAs(target) && this->Weights->GetTarget().Counts == SkdOwnCellsOf(target);
}

bool SkdOverlapCache::Update(vtkDataSet* donor, vtkDataSet* target,
  const SkdOverlapSettings& settings, vtkAlgorithm* algorithm, double first, double last)
{
  this->New = !this->IsFor(donor, target, settings);
  if (this->New)
  {
    this->Gradients.reset();
    this->PointTable.reset();
    this->Weights = std::make_unique<SkdOverlapWeights>();
    this->Known = this->Weights->Compute(donor, target, settings, algorithm, first, last);
    this->Covered = this->Weights->GetDonor().Covered;
    this->Shares.clear();
    this->Settings = settings;
    this->Donor.Keep(donor);
    this->Target.Keep(target);
  }
  std::vector<unsigned char> own = SkdOwnCellsOf(donor);
  if (own != this->OwnDonors) // the same mesh in other pieces
  {
    this->PointTable.reset();
    this->OwnDonors = std::move(own);
  }
  return this->Known;
}

bool SkdOverlapCache::TakeShares(const std::vector<double>& shares)
{
  if (shares == this->Shares)
  {
    return true;
  }
  if (!this->Shares.empty())
  {
    return false;
  }
  this->Weights->ScaleDonors(shares); // that are not empty, as none have been taken
  this->Shares = shares;
  this->PointTable.reset();
  return true;
}

const SkdSideVotes& SkdOverlapCache::GetSides(vtkDataSet* donor, vtkDataSet* target)
{
  if (!this->SidesOfDonor.IsSameAs(donor) || !this->SidesOfTarget.IsSameAs(target))
  {
    this->Sides = SkdCountSides(donor, target);
    this->SidesOfDonor.Keep(donor);
    this->SidesOfTarget.Keep(target);
  }
  return this->Sides;
}

const SkdDonorGradients& SkdOverlapCache::GetGradients(vtkDataSet* donor)
{
  if (!this->Gradients)
  {
    this->Gradients = std::make_unique<SkdDonorGradients>(donor, this->Weights->GetDonor(),
      this->Weights->GetNormal(), this->Settings.Space == SkdOverlapSpace::Sphere);
  }
  return *this->Gradients;
}

const SkdOverlapPointTable* SkdOverlapCache::GetPointTable(
  vtkDataSet* donor, vtkDataSet* target, vtkAlgorithm* algorithm, double first, double last)
{
  if (!this->PointTable)
  {
    auto table = std::make_unique<SkdOverlapPointTable>();
    if (SkdFindPointWeights(
          donor, target, this->Settings, *table, algorithm, first, last, this->Shares))
    {
      this->PointTable = std::move(table);
    }
  }
  return this->PointTable.get();
}
}
