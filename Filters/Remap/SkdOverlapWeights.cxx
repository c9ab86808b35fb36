// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapWeights.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Remap/SkdOverlapSearch.h"
#include "Remap/SkdPieceOverlap.h"
#include "Remap/SkdRemapTolerances.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace skdtree
{
namespace
{
using skd::Vector3;

/// A pair of cells, as its part of the walk has found it.
struct Entry
{
  std::uint32_t Target;
  std::uint32_t Donor;
  double Measure;
  Vector3 Moment; // about the donor's centroid
};

/// Sums up the overlaps of all pieces of two cells.
Entry Overlap(const SkdOverlapPair& meshes, const SkdOverlapSettings& settings,
  std::uint32_t target, std::uint32_t donor)
{
  const SkdNoShapes noShapes;
  const SkdPieceOverlap<SkdNoShapes> overlap(settings, noShapes);
  const Vector3& centre = meshes.Donor.CentreOf(donor);
  skd::Moments sum;
  SkdForEachPiecePair(meshes.Target, target, meshes.Donor, donor,
    [&](const SkdPieceView& one, const SkdPieceView& other)
    {
      const Vector3* reference = nullptr;
      const skd::Moments moments = overlap.Find(one, other, reference);
      if (moments.Measure != 0.0)
      {
        sum.Add(moments.Moved(centre - *reference), one.Piece.Sign * other.Piece.Sign);
      }
    });
  return { target, donor, sum.Measure, sum.First };
}

using Entries = std::vector<std::vector<Entry>>;

/// What of target cells of a curved surface is covered, by their own measure: projected the other
/// way round than overlaps are. By the parts of the walk.
class OwnCover
{
public:
  OwnCover(const SkdOverlapPair& meshes, const SkdFacetRules& rules)
    : TheMeshes(meshes)
    , Rules(rules)
  {
  }

  void SetParts(std::size_t parts) { this->Found.resize(parts); }

  void Add(std::size_t part, std::uint32_t target, std::uint32_t donor)
  {
    double sum = 0.0;
    double gap = 0.0;
    SkdForEachPiecePair(this->TheMeshes.Target, target, this->TheMeshes.Donor, donor,
      [&](const SkdPieceView& one, const SkdPieceView& other)
      {
        SkdFacetOverlap overlap(one, this->Rules);
        if (overlap.Find(other))
        {
          sum += one.Piece.Sign * other.Piece.Sign * overlap.GetMoments().Measure;
          gap = std::max(gap, overlap.GetGap());
        }
      });
    if (sum != 0.0)
    {
      this->Found[part].push_back({ target, sum, gap });
    }
  }

  /// The largest gap.
  double Finish(SkdOverlapCells& targets) const
  {
    double gap = 0.0;
    targets.OwnCovered.assign(targets.Measures.size(), 0.0);
    for (const std::vector<Own>& part : this->Found)
    {
      for (const Own& own : part)
      {
        targets.OwnCovered[static_cast<std::size_t>(this->TheMeshes.Target.IdOf(own.Target))] +=
          own.Measure;
        gap = std::max(gap, own.Gap);
      }
    }
    return gap;
  }

private:
  struct Own
  {
    std::uint32_t Target;
    double Measure;
    double Gap;
  };

  const SkdOverlapPair& TheMeshes;
  const SkdFacetRules& Rules;
  std::vector<std::vector<Own>> Found;
};

/// Where the entries of each target cell begin, and where the last ends.
std::vector<std::size_t> RowStartsOf(const Entries& parts, std::uint32_t numberOfTargets)
{
  std::vector<std::size_t> rowStarts(std::size_t(numberOfTargets) + 1, 0);
  for (const std::vector<Entry>& part : parts)
  {
    for (const Entry& entry : part)
    {
      ++rowStarts[entry.Target + 1];
    }
  }
  std::partial_sum(rowStarts.begin(), rowStarts.end(), rowStarts.begin());
  return rowStarts;
}

/// All entries by (target, donor): the same whatever part they are from. Each part is let go of
/// once it is read: there may be gigabytes of them.
std::vector<Entry> Sorted(Entries& parts, const std::vector<std::size_t>& rowStarts)
{
  std::vector<Entry> sorted(rowStarts.back());
  std::vector<std::size_t> next(rowStarts.begin(), rowStarts.end() - 1);
  for (std::vector<Entry>& part : parts)
  {
    for (const Entry& entry : part)
    {
      sorted[next[entry.Target]++] = entry;
    }
    std::vector<Entry>().swap(part);
  }
  SkdForEach(rowStarts.size() - 1,
    [&](std::size_t row)
    {
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(rowStarts[row]),
        sorted.begin() + static_cast<std::ptrdiff_t>(rowStarts[row + 1]),
        [](const Entry& a, const Entry& b) { return a.Donor < b.Donor; });
    });
  return sorted;
}

/// Moments about a centroid sum up to nothing over a cell that is all covered. What rounding leaves
/// of the sum, relative to a cell far smaller than the sphere more than elsewhere, is shared out,
/// so that gradients add nothing to integrals.
void BalanceMoments(SkdOverlapTable& table, SkdOverlapCells& donors)
{
  const auto isCovered = [&](std::size_t i)
  {
    const double gap = std::abs(donors.Covered[i] - donors.Measures[i]);
    return gap <= remap_tolerances::CoverGap * donors.Measures[i];
  };
  for (std::size_t k = 0; k < table.Columns.size(); ++k)
  {
    const auto column = static_cast<std::size_t>(table.Columns[k]);
    if (isCovered(column))
    {
      const double share = table.Measures[k] / donors.Covered[column];
      table.Moments[k] = table.Moments[k] - share * donors.CoveredMoments[column];
    }
  }
  for (std::size_t i = 0; i < donors.Covered.size(); ++i)
  {
    if (isCovered(i))
    {
      donors.CoveredMoments[i] = { { 0.0, 0.0, 0.0 } };
    }
  }
}

/// Rows are of all cells of the target, in the order of their ids.
void FillTable(Entries& found, const SkdOverlapPair& meshes, const SkdOverlapSurface& surface,
  SkdOverlapTable& table, SkdOverlapCells& donors, SkdOverlapCells& targets)
{
  const std::vector<Entry> entries =
    Sorted(found, RowStartsOf(found, meshes.Target.GetNumberOfCells()));
  table.Rows.assign(targets.Measures.size() + 1, 0);
  donors.CoveredMoments.assign(donors.Measures.size(), { { 0.0, 0.0, 0.0 } });
  table.Columns.resize(entries.size());
  table.Measures.resize(entries.size());
  table.Moments.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const Entry& entry = entries[i];
    const auto row = static_cast<std::size_t>(meshes.Target.IdOf(entry.Target));
    const vtkIdType column = meshes.Donor.IdOf(entry.Donor);
    const double measure = surface.Measure(entry.Measure);
    ++table.Rows[row + 1];
    table.Columns[i] = column;
    table.Measures[i] = measure;
    table.Moments[i] = surface.Moment(entry.Moment);
    table.IsSigned = table.IsSigned || measure < 0.0;
    targets.Covered[row] += measure;
    if (targets.IsCounted(row))
    {
      donors.Covered[static_cast<std::size_t>(column)] += measure;
      Vector3& sum = donors.CoveredMoments[static_cast<std::size_t>(column)];
      sum = sum + table.Moments[i];
    }
  }
  BalanceMoments(table, donors);
  std::partial_sum(table.Rows.begin(), table.Rows.end(), table.Rows.begin());
}
}

//------------------------------------------------------------------------------
bool SkdOverlapWeights::Compute(vtkDataSet* donor, vtkDataSet* target,
  const SkdOverlapSettings& settings, vtkAlgorithm* algorithm, double first, double last)
{
  const SkdOverlapSurface surface(donor, target, settings);
  this->Table = {};
  this->Radius = surface.GetRadius();
  this->Normal = surface.GetNormal();
  this->Problem = surface.GetProblem();
  if (!this->Problem.empty())
  {
    return false;
  }
  const auto at = [&](double share) { return first + share * (last - first); };
  SkdOverlapPair meshes;
  if (!meshes.Read(donor, target, surface, settings, false, algorithm, at(0.0), at(0.2)))
  {
    return false;
  }
  SkdLoop ofPairs(algorithm, 0, at(0.2), at(1.0), 8);
  meshes.Donor.Measure(surface, this->Donor);
  meshes.Target.Measure(surface, this->Target);
  this->Target.Counts = SkdOwnCellsOf(target);
  const SkdOverlapTree donors(meshes.Donor);
  const SkdOverlapTree targets(meshes.Target);
  Entries found;
  const bool isCurved = settings.Space == SkdOverlapSpace::CurvedSurface;
  OwnCover own(meshes, settings.Facets);
  const auto begin = [&](std::size_t parts)
  {
    found.resize(parts);
    own.SetParts(parts);
  };
  const bool isDone = SkdForEachCandidatePair(targets, donors, ofPairs, begin,
    [&](std::size_t part, std::uint32_t a, std::uint32_t b)
    {
      const Entry entry = Overlap(meshes, settings, a, b);
      if (isCurved)
      {
        own.Add(part, a, b);
      }
      const double smaller = std::min(meshes.Target.MeasureOf(a), meshes.Donor.MeasureOf(b));
      if (std::abs(entry.Measure) > remap_tolerances::CellOverlap * smaller)
      {
        found[part].push_back(entry);
      }
    });
  if (isDone)
  {
    FillTable(found, meshes, surface, this->Table, this->Donor, this->Target);
    this->LargestGap = isCurved ? own.Finish(this->Target) : 0.0;
  }
  return isDone;
}

//------------------------------------------------------------------------------
void SkdOverlapWeights::ScaleDonors(const std::vector<double>& shares)
{
  std::fill(this->Target.Covered.begin(), this->Target.Covered.end(), 0.0);
  for (std::size_t row = 0; row + 1 < this->Table.Rows.size(); ++row)
  {
    for (std::size_t k = this->Table.Rows[row]; k < this->Table.Rows[row + 1]; ++k)
    {
      const double share = shares[static_cast<std::size_t>(this->Table.Columns[k])];
      this->Table.Measures[k] *= share;
      this->Table.Moments[k] = share * this->Table.Moments[k];
      this->Target.Covered[row] += this->Table.Measures[k];
    }
  }
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    this->Donor.Covered[i] *= shares[i];
    this->Donor.CoveredMoments[i] = shares[i] * this->Donor.CoveredMoments[i];
  }
  BalanceMoments(this->Table, this->Donor);
}
}
