// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdMatchedSurfaces.h"

#include "Pipeline/SkdCompensatedSum.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdLoop.h"
#include "Remap/SkdRemapTolerances.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <set>
#include <utility>

namespace skdtree
{
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
// Of a donor of which each process has some cells, those that it has for its target alone are told
// by their ids: first how much is covered of them, then by their owners how much is in all.
std::vector<double> SkdMatchedSurfaces::SumOfCells(std::vector<double> covered) const
{
  const std::vector<unsigned char> own = SkdOwnCellsOf(this->Donor);
  if (!this->Processes || own.empty())
  {
    return this->SumOverAll(std::move(covered));
  }
  const SkdJoinedIds ids(this->Donor);
  const auto tell = [&](bool ofOwn, const auto& isWanted)
  {
    std::vector<double> rows;
    for (std::size_t cell = 0; cell < covered.size(); ++cell)
    {
      const vtkIdType id = ids.Of(static_cast<vtkIdType>(cell));
      if ((own[cell] != 0) == ofOwn && isWanted(cell, id))
      {
        rows.insert(rows.end(), { static_cast<double>(id), covered[cell] });
      }
    }
    return this->Processes->GatherFromOthers(rows);
  };
  std::set<vtkIdType> shared; // cells that others have, too
  const auto take = [&](const std::vector<std::vector<double>>& told, bool ofOwn, bool adds)
  {
    for (const std::vector<double>& rows : told)
    {
      for (std::size_t i = 0; i + 1 < rows.size(); i += 2)
      {
        const auto id = static_cast<vtkIdType>(rows[i]);
        const auto cell = static_cast<std::size_t>(ids.Find(id));
        const bool isHere = cell < covered.size() && ids.Of(static_cast<vtkIdType>(cell)) == id;
        if (isHere && (own[cell] != 0) == ofOwn)
        {
          covered[cell] = adds ? covered[cell] + rows[i + 1] : rows[i + 1];
          shared.insert(id);
        }
      }
    }
  };
  take(tell(false, [](std::size_t, vtkIdType) { return true; }), true, true);
  const std::set<vtkIdType> sharedNow = shared;
  take(tell(true, [&sharedNow](std::size_t, vtkIdType id) { return sharedNow.count(id) > 0; }),
    false, false);
  return covered;
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
// many processes have added it up. A process without a part of the target has no measures.
std::vector<double> SkdMatchedSurfaces::FindShares(const std::vector<double>& covered)
{
  std::vector<double> shares;
  const std::vector<double> none;
  const std::vector<double>& measures =
    this->Blocks.empty() ? none : this->Overlaps.front().GetWeights().GetDonor().Measures;
  const std::vector<unsigned char> own = SkdOwnCellsOf(this->Donor);
  SkdCompensatedSum whole, handed;
  for (std::size_t i = 0; i < measures.size(); ++i)
  {
    if (covered[i] > (1.0 + remap_tolerances::CoverGap) * measures[i])
    {
      shares.resize(measures.size(), 1.0);
      shares[i] = measures[i] / covered[i];
    }
    if (own.empty() || own[i] != 0)
    {
      whole.Add(measures[i]);
      handed.Add(std::min(covered[i], measures[i]));
      const double room = remap_tolerances::Coverage * measures[i];
      this->Findings.Folded += covered[i] > measures[i] + room ? 1 : 0;
      this->Findings.Uncovered += covered[i] < measures[i] - room ? 1 : 0;
    }
  }
  this->SumUp(whole.Get(), handed.Get(), !own.empty());
  return shares;
}

void SkdMatchedSurfaces::SumUp(double whole, double handed, bool isSpread)
{
  std::vector<double> sums{ whole, handed, static_cast<double>(this->Findings.Folded),
    static_cast<double>(this->Findings.Uncovered) };
  sums = isSpread ? this->SumOverAll(sums) : sums;
  this->Findings.Folded = static_cast<vtkIdType>(sums[2]);
  this->Findings.Uncovered = static_cast<vtkIdType>(sums[3]);
  this->Findings.SourceCoverage = sums[0] > 0.0 ? sums[1] / sums[0] : 0.0;
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
  covered = this->SumOfCells(std::move(covered));
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
}
