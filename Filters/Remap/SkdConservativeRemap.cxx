// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdConservativeRemap.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdCompensatedSum.h"
#include "Remap/SkdRemapTolerances.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace skdtree
{
namespace
{
using Gradients = std::vector<std::vector<skd::Vector3>>; // of each component, or none

/// A vector rotated as the shortest arc takes one direction to the other.
skd::Vector3 Transported(const skd::Vector3& v, const skd::Vector3& from, const skd::Vector3& to)
{
  const skd::Vector3 a = (1.0 / skd::Norm(from)) * from;
  const skd::Vector3 b = (1.0 / skd::Norm(to)) * to;
  const skd::Vector3 axis = skd::Cross(a, b);
  const skd::Vector3 once = skd::Cross(axis, v);
  return v + once + (1.0 / (1.0 + skd::Dot(a, b))) * skd::Cross(axis, once);
}
}

double SkdRemapIntegrals::GetError() const
{
  return this->Absolute > 0.0 ? std::abs(this->Overlap - this->Target) / this->Absolute : 0.0;
}

/// What the target's cells are made of.
struct SkdConservativeRemap::Shares
{
  const SkdDonorField& Field; ///< of averages, densities or values of points
  const std::vector<std::size_t>& Rows;
  const std::vector<vtkIdType>& Columns;
  const std::vector<double>& Measures;
  const Gradients& Slopes; ///< with the moments of the table of cells
  const std::vector<skd::Vector3>&
    Positions;                              ///< where vectors are rotated from; empty: they are not
  bool IsSigned;                            ///< whether there are negative measures that count
  const std::vector<SkdCellRanges>& Ranges; ///< of each component that has bounds, or none
  SkdLimiter Limiter;                       ///< how they are kept
};

/// What one cell is made of. One a thread.
struct SkdConservativeRemap::Row
{
  double* Tuple = nullptr; // the result
  double Covered = 0.0;
  bool HasParts = false;
  bool IsWhole = true; // all of its parts count
  bool HasNegative = false;
  std::vector<double> First{}; // values that others are taken relative to, so constants stay so
  std::vector<double> Sums{};
  std::vector<double> Least{};
  std::vector<double> Greatest{};
  std::vector<double> Part{};
};

SkdConservativeRemap::SkdConservativeRemap(
  const SkdOverlapWeights& weights, SkdOverlapSpace space, const SkdConservativeRules& rules)
  : Weights(weights)
  , Space(space)
  , Rules(rules)
{
}

SkdDonorField SkdConservativeRemap::DensityOf(const SkdDonorField& field) const
{
  SkdDonorField density = field;
  const std::vector<double>& measures = this->Weights.GetDonor().Measures;
  for (std::size_t i = 0; i < measures.size(); ++i)
  {
    density.Counts[i] = measures[i] > 0.0 ? density.Counts[i] : 0;
    for (int c = 0; c < field.Components && field.IsExtensive; ++c)
    {
      density
        .Values[i * static_cast<std::size_t>(field.Components) + static_cast<std::size_t>(c)] /=
        measures[i];
    }
  }
  return density;
}

void SkdConservativeRemap::TakePart(
  const Shares& shares, std::size_t target, vtkIdType donor, Row& row) const
{
  const double* values = shares.Field.Tuple(donor);
  std::copy(values, values + shares.Field.Components, row.Part.begin());
  if (!shares.Positions.empty())
  {
    const skd::Vector3 transported = Transported({ { values[0], values[1], values[2] } },
      shares.Positions[static_cast<std::size_t>(donor)],
      this->Weights.GetTarget().Centroids[target]);
    std::copy(transported.X, transported.X + 3, row.Part.begin());
  }
  if (!row.HasParts)
  {
    row.HasParts = true;
    row.First = row.Least = row.Greatest = row.Part;
  }
}

// Sums of value - first value, and of gradients times moments.
void SkdConservativeRemap::MapRow(const Shares& shares, std::size_t target, Row& row) const
{
  const std::vector<skd::Vector3>& moments = this->Weights.GetTable().Moments;
  const auto components = static_cast<std::size_t>(shares.Field.Components);
  row.Covered = 0.0;
  row.HasParts = false;
  row.IsWhole = true;
  row.HasNegative = false;
  row.Sums.assign(components, 0.0);
  row.Part.resize(components);
  for (std::size_t k = shares.Rows[target]; k < shares.Rows[target + 1]; ++k)
  {
    const auto donor = static_cast<std::size_t>(shares.Columns[k]);
    const bool isPart = shares.Measures[k] > 0.0 || (shares.IsSigned && shares.Measures[k] < 0.0);
    if (shares.Field.Counts[donor] == 0 || !isPart)
    {
      row.IsWhole = row.IsWhole && !isPart;
      continue;
    }
    row.HasNegative = row.HasNegative || shares.Measures[k] < 0.0;
    this->TakePart(shares, target, shares.Columns[k], row);
    row.Covered += shares.Measures[k];
    for (std::size_t c = 0; c < components; ++c)
    {
      const SkdCellRange range =
        shares.Ranges.empty() ? SkdCellRange{ row.Part[c], row.Part[c] } : shares.Ranges[c][donor];
      row.Least[c] = std::min(row.Least[c], range.Least);
      row.Greatest[c] = std::max(row.Greatest[c], range.Greatest);
      row.Sums[c] += shares.Measures[k] * (row.Part[c] - row.First[c]);
      row.Sums[c] += shares.Slopes.empty() ? 0.0 : skd::Dot(shares.Slopes[c][donor], moments[k]);
    }
  }
}

void SkdConservativeRemap::Finish(const Shares& shares, std::size_t target, Row& row) const
{
  const double whole = this->Weights.GetTarget().Measures[target];
  const double own = this->Weights.GetTarget().OwnMeasureOf(target, row.Covered);
  if (!(row.Covered > 0.0) || own < this->Rules.MinimumCoverage * whole)
  {
    row.Covered = 0.0;
    return;
  }
  const bool isWhole = this->Rules.Normalization == SkdNormalization::Whole;
  // With negative parts a mean may be beyond the values; with some of the parts missing it is out
  // of all proportion. Limited gradients are beyond the bounds by rounding at most.
  const bool hasBounds = shares.Slopes.empty() ||
    (!shares.Ranges.empty() && shares.Limiter == SkdLimiter::BarthJespersen);
  const bool isBounded = hasBounds && !(row.HasNegative && row.IsWhole);
  for (std::size_t c = 0; c < row.Sums.size(); ++c)
  {
    double total = row.First[c] * row.Covered + row.Sums[c];
    double mean = row.First[c] + row.Sums[c] / row.Covered;
    if (isBounded && !(mean >= row.Least[c] && mean <= row.Greatest[c]) && !std::isnan(mean))
    {
      mean = std::clamp(mean, row.Least[c], row.Greatest[c]);
      total = shares.Slopes.empty() ? total : mean * row.Covered;
    }
    row.Tuple[c] = shares.Field.IsExtensive ? total : isWhole ? total / whole : mean;
  }
}

// What the mean over what of a cell is covered is multiplied by.
double SkdConservativeRemap::FactorOf(bool isExtensive, std::size_t target, double covered) const
{
  const bool isWhole = this->Rules.Normalization == SkdNormalization::Whole;
  return isExtensive ? covered
    : isWhole        ? covered / this->Weights.GetTarget().Measures[target]
                     : 1.0;
}

// On a sphere a gradient that has to be limited is limited as one along it: what it has across is
// out of proportion where the field jumps.
void SkdConservativeRemap::LimitSlopes(const SkdDonorField& density, int component,
  const SkdDonorGradients& gradients, const SkdCellRanges& ranges,
  std::vector<skd::Vector3>& slopes) const
{
  const auto limit = [&](std::vector<skd::Vector3>& some)
  {
    gradients.Limit(density, component, ranges, some);
    this->LimitInOverlaps(density, component, ranges, some);
  };
  if (!gradients.AreOnSphere())
  {
    limit(slopes);
    return;
  }
  const std::vector<skd::Vector3> free = slopes;
  limit(slopes);
  std::vector<char> isLimited(slopes.size());
  std::transform(slopes.begin(), slopes.end(), free.begin(), isLimited.begin(),
    [](const skd::Vector3& a, const skd::Vector3& b) { return a == b ? 0 : 1; });
  std::vector<skd::Vector3> along = gradients.FindTangential(density, component, isLimited);
  limit(along);
  for (std::size_t i = 0; i < slopes.size(); ++i)
  {
    slopes[i] = isLimited[i] != 0 ? along[i] : slopes[i];
  }
}

// The parts of a target's mean are the values of cells' fields at the centroids of overlaps. Where
// a cell bulges between its corners these may be beyond what its corners have. Of an overlap that
// is small the centroid is known the less: what is beyond by no more than that is clipped later.
void SkdConservativeRemap::LimitInOverlaps(const SkdDonorField& density, int component,
  const SkdCellRanges& ranges, std::vector<skd::Vector3>& slopes) const
{
  const SkdOverlapTable& table = this->Weights.GetTable();
  std::vector<double> shares(slopes.size(), 1.0);
  for (std::size_t target = 0; target + 1 < table.Rows.size(); ++target)
  {
    for (std::size_t k = table.Rows[target]; k < table.Rows[target + 1]; ++k)
    {
      const auto donor = static_cast<std::size_t>(table.Columns[k]);
      const double measure = table.Measures[k];
      const double change = skd::Dot(slopes[donor], table.Moments[k]);
      const double here = density.Get(table.Columns[k], component);
      const double room = change > 0.0 ? ranges[donor].Greatest - here : here - ranges[donor].Least;
      const double most = measure * room;
      if (density.Counts[donor] == 0 || !(measure > 0.0 && std::abs(change) > most))
      {
        continue;
      }
      const double smaller = std::min(
        this->Weights.GetTarget().Measures[target], this->Weights.GetDonor().Measures[donor]);
      const double rounding = remap_tolerances::Centroid * (smaller / measure) *
        skd::Norm(slopes[donor]) * skd::Norm(table.Moments[k]);
      if (std::abs(change) > most + rounding)
      {
        shares[donor] = std::min(shares[donor], most / std::abs(change));
      }
    }
  }
  std::transform(shares.begin(), shares.end(), slopes.begin(), slopes.begin(),
    [](double share, const skd::Vector3& slope) { return share < 1.0 ? share * slope : slope; });
}

// Of cells that are covered in part gradients change the sum: within the bounds there is room for
// it if these are limited.
void SkdConservativeRemap::LimitUncovered(const SkdDonorField& density, int component,
  const SkdDonorGradients& gradients, const SkdCellRanges& ranges,
  std::vector<skd::Vector3>& slopes) const
{
  const std::vector<skd::Vector3>& moments = this->Weights.GetDonor().CoveredMoments;
  const auto isUncovered = [](const skd::Vector3& moment) { return skd::Norm2(moment) > 0.0; };
  if (std::any_of(moments.begin(), moments.end(), isUncovered))
  {
    std::vector<skd::Vector3> limited = slopes;
    this->LimitSlopes(density, component, gradients, ranges, limited);
    for (std::size_t i = 0; i < slopes.size(); ++i)
    {
      slopes[i] = isUncovered(moments[i]) ? limited[i] : slopes[i];
    }
  }
}

/// Calls visit(target, mean) for each cell that has a value, of the mean over what of it is
/// covered.
template <class Visit>
void SkdConservativeRemap::VisitClipped(
  const SkdRemappedField& mapped, std::size_t component, bool isExtensive, const Visit& visit) const
{
  for (std::size_t target = 0; target < mapped.Covered.size(); ++target)
  {
    const double covered = mapped.Covered[target];
    const double value = mapped.Values[target * mapped.Integrals.size() + component];
    if (covered > 0.0 && std::isfinite(value))
    {
      visit(target, value / this->FactorOf(isExtensive, target, covered));
    }
  }
}

// A. M. Bradley, P. A. Bosler, O. Guba, M. A. Taylor, G. A. Barnett, SIAM J. Sci. Comput. 41
// (2019). First-order means are within the bounds and have the sum, so there is room for it.
void SkdConservativeRemap::FindClipped(
  const Shares& shares, std::size_t component, SkdRemappedField& mapped) const
{
  SkdCellRanges bounds(mapped.Covered.size(), { 0.0, 0.0 });
  SkdCompensatedSum lost, below, above;
  this->VisitClipped(mapped, component, shares.Field.IsExtensive,
    [&](std::size_t target, double mean)
    {
      const SkdCellRange range = RangeOf(shares, target, shares.Ranges[component]);
      const double clipped = std::clamp(mean, range.Least, range.Greatest);
      const bool counts = this->Weights.GetTarget().IsCounted(target);
      const double covered = counts ? mapped.Covered[target] : 0.0;
      lost.Add(covered * (mean - clipped));
      below.Add(covered * (range.Least - clipped));
      above.Add(covered * (range.Greatest - clipped));
      bounds[target] = range;
    });
  mapped.Bounds.push_back(std::move(bounds));
  mapped.Clipped.push_back({ lost.Get(), below.Get(), above.Get() });
}

void SkdConservativeRemap::AssureSums(const SkdDonorField& field,
  const std::vector<SkdClippedSum>& sums, SkdRemappedField& mapped) const
{
  for (std::size_t c = 0; c < mapped.Bounds.size(); ++c)
  {
    const bool isAdded = sums[c].Lost > 0.0;
    const double room = isAdded ? sums[c].RoomAbove : sums[c].RoomBelow;
    const double share = room != 0.0 ? std::min(1.0, sums[c].Lost / room) : 0.0;
    this->VisitClipped(mapped, c, field.IsExtensive,
      [&](std::size_t target, double mean)
      {
        const auto [least, greatest] = mapped.Bounds[c][target];
        const double clipped = std::clamp(mean, least, greatest);
        const double assured = clipped + share * ((isAdded ? greatest : least) - clipped);
        mapped.Values[target * mapped.Integrals.size() + c] = std::clamp(assured, least, greatest) *
          this->FactorOf(field.IsExtensive, target, mapped.Covered[target]);
      });
  }
  this->AddTarget(field, mapped);
  mapped.Bounds.clear();
}

/// What the source cells that a target's mean is made of, and those around them, are between.
SkdCellRange SkdConservativeRemap::RangeOf(
  const Shares& shares, std::size_t target, const SkdCellRanges& ranges)
{
  constexpr double most = std::numeric_limits<double>::infinity();
  SkdCellRange range{ most, -most };
  for (std::size_t k = shares.Rows[target]; k < shares.Rows[target + 1]; ++k)
  {
    const auto donor = static_cast<std::size_t>(shares.Columns[k]);
    if (shares.Field.Counts[donor] != 0 && shares.Measures[k] > 0.0)
    {
      range.Least = std::min(range.Least, ranges[donor].Least);
      range.Greatest = std::max(range.Greatest, ranges[donor].Greatest);
    }
  }
  return range;
}

SkdRemappedField SkdConservativeRemap::MapShares(const Shares& shares) const
{
  const std::size_t n = this->Weights.GetTarget().Measures.size();
  const auto components = static_cast<std::size_t>(shares.Field.Components);
  SkdRemappedField mapped;
  mapped.Values.assign(n * components, vtkMath::Nan());
  mapped.Integrals.resize(components);
  mapped.Covered.assign(n, 0.0);
  SkdForEach(n,
    [&](std::size_t target)
    {
      thread_local Row row; // keeps its memory
      row.Tuple = mapped.Values.data() + target * components;
      this->MapRow(shares, target, row);
      this->Finish(shares, target, row);
      mapped.Covered[target] = row.Covered;
    });
  const bool isClipped = shares.Limiter == SkdLimiter::ClipAndAssuredSum;
  for (std::size_t c = 0; c < shares.Ranges.size() && isClipped; ++c)
  {
    this->FindClipped(shares, c, mapped);
  }
  this->AddTarget(shares.Field, mapped);
  return mapped;
}

bool SkdConservativeRemap::IsReversed(const SkdDonorField& field) const
{
  return field.IsVector && this->Space == SkdOverlapSpace::Sphere && this->Rules.RotatesVectors;
}

SkdRemappedField SkdConservativeRemap::Map(
  const SkdDonorField& field, const SkdDonorGradients* gradients, SkdLimiter limiter) const
{
  const SkdDonorField density = this->DensityOf(field);
  const bool isReversed = this->IsReversed(field);
  Gradients slopes;
  std::vector<SkdCellRanges> bounds; // by components, which rotated vectors do not keep
  for (int c = 0; c < field.Components && gradients; ++c)
  {
    slopes.push_back(gradients->Find(density, c));
    if (limiter == SkdLimiter::None)
    {
      continue;
    }
    SkdCellRanges ranges = gradients->FindRanges(density, c);
    if (limiter == SkdLimiter::BarthJespersen)
    {
      this->LimitSlopes(density, c, *gradients, ranges, slopes.back());
    }
    else if (!isReversed)
    {
      this->LimitUncovered(density, c, *gradients, ranges, slopes.back());
    }
    if (!isReversed)
    {
      bounds.push_back(std::move(ranges));
    }
  }
  const SkdOverlapTable& table = this->Weights.GetTable();
  const std::vector<skd::Vector3> none;
  SkdRemappedField mapped =
    this->MapShares({ density, table.Rows, table.Columns, table.Measures, slopes,
      isReversed ? this->Weights.GetDonor().Centroids : none, table.IsSigned, bounds, limiter });
  this->AddDonor(density, slopes, mapped);
  return mapped;
}

// Of a cell that is covered in part, its gradient has a part in the integral.
void SkdConservativeRemap::AddDonor(const SkdDonorField& density,
  const std::vector<std::vector<skd::Vector3>>& slopes, SkdRemappedField& mapped) const
{
  const SkdOverlapCells& donor = this->Weights.GetDonor();
  for (std::size_t c = 0; c < mapped.Integrals.size(); ++c)
  {
    SkdCompensatedSum source, overlap, absolute;
    for (std::size_t i = 0; i < donor.Measures.size(); ++i)
    {
      if (density.Counts[i] != 0)
      {
        const double value = density.Get(static_cast<vtkIdType>(i), static_cast<int>(c));
        const double own = this->IsOwn(i) ? donor.Measures[i] : 0.0;
        source.Add(value * own);
        overlap.Add(value * donor.Covered[i]);
        overlap.Add(slopes.empty() ? 0.0 : skd::Dot(slopes[c][i], donor.CoveredMoments[i]));
        absolute.Add(std::abs(value) * own);
      }
    }
    mapped.Integrals[c].Source = source.Get();
    mapped.Integrals[c].Overlap = overlap.Get();
    mapped.Integrals[c].Absolute = absolute.Get();
  }
}

void SkdConservativeRemap::AddTarget(const SkdDonorField& field, SkdRemappedField& mapped) const
{
  const std::vector<double>& covered = mapped.Covered;
  const SkdOverlapCells& cells = this->Weights.GetTarget();
  const std::vector<double>& measures = cells.Measures;
  const bool isWhole = this->Rules.Normalization == SkdNormalization::Whole;
  SkdCompensatedSum all, some;
  for (std::size_t i = 0; i < measures.size(); ++i)
  {
    all.Add(cells.IsCounted(i) ? measures[i] : 0.0);
    some.Add(cells.IsCounted(i) ? cells.OwnMeasureOf(i, covered[i]) : 0.0);
  }
  for (std::size_t c = 0; c < mapped.Integrals.size(); ++c)
  {
    SkdCompensatedSum target;
    for (std::size_t i = 0; i < measures.size(); ++i)
    {
      if (covered[i] > 0.0 && cells.IsCounted(i))
      {
        const double factor = field.IsExtensive ? 1.0 : isWhole ? measures[i] : covered[i];
        target.Add(factor * mapped.Values[i * mapped.Integrals.size() + c]);
      }
    }
    mapped.Integrals[c].Target = target.Get();
    mapped.Integrals[c].Covered = some.Get();
    mapped.Integrals[c].Whole = all.Get();
  }
}

SkdRemappedField SkdConservativeRemap::MapPoints(const SkdDonorField& field,
  const SkdOverlapPointTable& table, const std::vector<skd::Vector3>& points) const
{
  const std::vector<skd::Vector3> none;
  SkdRemappedField mapped = this->MapShares({ field, table.Rows, table.Columns, table.Weights,
    Gradients(), this->IsReversed(field) ? points : none, table.IsSigned,
    std::vector<SkdCellRanges>(), SkdLimiter::None });
  const auto valueOf = [&](vtkIdType point, std::size_t c)
  {
    const bool counts = field.Counts[static_cast<std::size_t>(point)] != 0;
    return counts ? field.Get(point, static_cast<int>(c)) : 0.0;
  };
  for (std::size_t c = 0; c < mapped.Integrals.size(); ++c)
  {
    SkdCompensatedSum source, overlap, absolute;
    for (std::size_t i = 0; i < table.Masses.size(); ++i)
    {
      const double part = table.Masses[i] * valueOf(static_cast<vtkIdType>(i), c);
      source.Add(part);
      absolute.Add(std::abs(part));
    }
    for (std::size_t row = 0; row + 1 < table.Rows.size(); ++row)
    {
      const std::size_t last = table.Rows[this->Weights.GetTarget().IsCounted(row) ? row + 1 : row];
      for (std::size_t k = table.Rows[row]; k < last; ++k)
      {
        overlap.Add(table.Weights[k] * valueOf(table.Columns[k], c));
      }
    }
    mapped.Integrals[c].Source = source.Get();
    mapped.Integrals[c].Overlap = overlap.Get();
    mapped.Integrals[c].Absolute = absolute.Get();
  }
  return mapped;
}
}
