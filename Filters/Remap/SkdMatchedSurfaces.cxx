// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdMatchedSurfaces.h"

#include "Pipeline/SkdLoop.h"
#include "Remap/SkdCompensatedSum.h"
#include "Remap/SkdRemapTolerances.h"

#include "vtkDataSet.h"

#include <algorithm>

//------------------------------------------------------------------------------
void SkdSurfaceFindings::AddWarnings(std::vector<std::string>& warnings) const
{
  if (!this->HasSides)
  {
    warnings.emplace_back(
      "The polygons of Input and Source are ordered in no one way: facets of either sense count, "
      "so "
      "that the two sides of a plate thinner than SurfaceDistance mix. Orient both meshes "
      "(vtkPolyDataNormals).");
  }
  if (this->Folded > 0)
  {
    warnings.push_back(std::to_string(this->Folded) +
      " cells of Source are covered more than once: Input has folds or several layers there within "
      "SurfaceDistance, among which what they have is shared out. If these are other walls, lessen "
      "SurfaceDistance or SurfaceAngle.");
  }
  if (this->Uncovered > 0)
  {
    const double percent = 100.0 * (1.0 - this->SourceCoverage);
    warnings.push_back(std::to_string(this->Uncovered) + " cells of Source (" +
      std::to_string(percent) +
      " % of its area) are not covered by Input, or in part: what they have there is not handed "
      "on. "
      "If the surfaces are farther apart, set SurfaceDistance; if cells of one mesh are turned "
      "over, "
      "orient it.");
  }
}

//------------------------------------------------------------------------------
std::vector<double> SkdMatchedSurfaces::SumOverAll(std::vector<double> own) const
{
  if (this->Processes)
  {
    for (const std::vector<double>& other : this->Processes->GatherFromOthers(own))
    {
      for (std::size_t i = 0; i < std::min(own.size(), other.size()); ++i)
      {
        own[i] += other[i];
      }
    }
  }
  return own;
}

//------------------------------------------------------------------------------
void SkdMatchedSurfaces::FindSide(SkdFacetRules& rules)
{
  std::vector<double> votes{ 0.0, 0.0 };
  for (std::size_t i = 0; i < this->Blocks.size(); ++i)
  {
    const SkdSideVotes& some = this->Overlaps[i].GetSides(this->Donor, this->Blocks[i].Mesh);
    votes[0] += some.Alike;
    votes[1] += some.Opposite;
  }
  votes = this->SumOverAll(votes);
  rules.Side = SkdSideVotes{ votes[0], votes[1] }.GetSide();
  this->Findings.HasSides = rules.Side != 0 || !(votes[0] + votes[1] > 0.0);
}

//------------------------------------------------------------------------------
bool SkdMatchedSurfaces::Update(std::size_t block, const SkdOverlapSettings& settings,
  vtkAlgorithm* algorithm, double first, double last)
{
  SkdOverlapCache& overlaps = this->Overlaps[block];
  const bool isDone =
    overlaps.Update(this->Donor, this->Blocks[block].Mesh, settings, algorithm, first, last);
  this->NumberOfNew += overlaps.IsNew() ? 1 : 0;
  return isDone;
}

//------------------------------------------------------------------------------
// What is covered just once, to rounding, is left as it is, so that results do not depend on how
// many processes have added it up.
std::vector<double> SkdMatchedSurfaces::FindShares(const std::vector<double>& covered)
{
  std::vector<double> shares;
  if (this->Blocks.empty())
  {
    return shares;
  }
  const std::vector<double>& measures = this->Overlaps.front().GetWeights().GetDonor().Measures;
  SkdCompensatedSum whole, handed;
  for (std::size_t i = 0; i < measures.size(); ++i)
  {
    whole.Add(measures[i]);
    handed.Add(std::min(covered[i], measures[i]));
    if (covered[i] > (1.0 + remap_tolerances::CoverGap) * measures[i])
    {
      shares.resize(measures.size(), 1.0);
      shares[i] = measures[i] / covered[i];
    }
    const double room = remap_tolerances::Coverage * measures[i];
    this->Findings.Folded += covered[i] > measures[i] + room ? 1 : 0;
    this->Findings.Uncovered += covered[i] < measures[i] - room ? 1 : 0;
  }
  this->Findings.SourceCoverage = whole.Get() > 0.0 ? handed.Get() / whole.Get() : 0.0;
  return shares;
}

//------------------------------------------------------------------------------
bool SkdMatchedSurfaces::Match(
  SkdOverlapSettings& settings, vtkAlgorithm* algorithm, double first, double last)
{
  while (this->Overlaps.size() < this->Blocks.size())
  {
    this->Overlaps.emplace_back();
  }
  this->FindSide(settings.Facets);
  std::vector<double> covered(static_cast<std::size_t>(this->Donor->GetNumberOfCells()), 0.0);
  bool isDone = true;
  const double step =
    (last - first) / static_cast<double>(std::max<std::size_t>(1, this->Blocks.size()));
  for (std::size_t i = 0; i < this->Blocks.size() && isDone; ++i)
  {
    const double begin = first + static_cast<double>(i) * step;
    isDone = this->Update(i, settings, algorithm, begin, begin + step);
    if (isDone)
    {
      const std::vector<double>& some = this->Overlaps[i].GetCovered();
      std::transform(covered.begin(), covered.end(), some.begin(), covered.begin(), std::plus<>());
    }
  }
  covered = this->SumOverAll(covered);
  const std::vector<double> shares = isDone ? this->FindShares(covered) : std::vector<double>();
  for (std::size_t i = 0; i < this->Blocks.size() && isDone; ++i)
  {
    if (!this->Overlaps[i].TakeShares(shares))
    {
      this->Overlaps[i].Forget();
      isDone = this->Update(i, settings, algorithm, last, last);
      isDone = isDone && this->Overlaps[i].TakeShares(shares);
    }
    this->Findings.LargestGap =
      std::max(this->Findings.LargestGap, this->Overlaps[i].GetWeights().GetLargestGap());
  }
  return isDone;
}
