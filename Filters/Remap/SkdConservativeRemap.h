// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdConservativeRemap.h
 * @brief Fields of a donor on the cells of a target, by the overlaps of the cells of both.
 */

#ifndef SkdConservativeRemap_h
#define SkdConservativeRemap_h

#include "Remap/SkdDonorGradients.h"
#include "Remap/SkdPointWeights.h"

#include <vector>

namespace skdtree
{
/// What a mean is taken over where a target cell is not all covered by donor cells that count.
enum class SkdNormalization
{
  Covered, ///< what is covered: the mean of what there is
  Whole    ///< the whole cell, nothing being where it is not covered: integrals are kept
};

/// What keeps results of second order within the averages around them.
enum class SkdLimiter
{
  None,
  BarthJespersen,   ///< gradients are shortened
  ClipAndAssuredSum ///< results are clipped, and what that changes of their sum is given back
};

struct SkdConservativeRules
{
  SkdNormalization Normalization = SkdNormalization::Covered;
  double MinimumCoverage = 0.0; ///< a share; a cell covered less has no value
  bool RotatesVectors = true;   ///< on a sphere
};

/// Of one component of a field.
struct SkdRemapIntegrals
{
  double Source = 0.0;   ///< over the donor
  double Overlap = 0.0;  ///< over what of the donor the target covers
  double Target = 0.0;   ///< over the target, or what of it is covered if that is what is taken
  double Absolute = 0.0; ///< of the donor's values without their signs
  double Covered = 0.0;  ///< how much of the target cells with a value is covered by what counts
  double Whole = 0.0;    ///< the target's length, area or volume

  /// |Overlap - Target| / Absolute; 0 where there is nothing.
  double GetError() const;
};

/// Of one component of a field whose results are clipped, for SkdLimiter::ClipAndAssuredSum: what
/// that takes from its integral, and how much there is room for below and above.
struct SkdClippedSum
{
  double Lost = 0.0;
  double RoomBelow = 0.0; ///< not positive
  double RoomAbove = 0.0;
};

struct SkdRemappedField
{
  std::vector<double> Values; ///< of the target's cells, tuple by tuple; NaN where there is none
  std::vector<SkdRemapIntegrals> Integrals; ///< of each component
  ///@{
  /// Until AssureSums(): of each component that has to be clipped, the bounds of each cell and what
  /// this target alone adds to the sums; and how much of the cells is covered by what counts.
  std::vector<SkdCellRanges> Bounds;
  std::vector<SkdClippedSum> Clipped;
  std::vector<double> Covered;
  ///@}
};

/// Maps fields by the overlaps of one target with one donor. Fields of cells are averages; with
/// gradients linear in each donor cell. Intensive fields become averages of the target's cells.
/// Extensive ones are spread evenly (or by their densities' gradients) over donor cells, and what
/// is in a target cell is added up.
class SkdConservativeRemap
{
public:
  SkdConservativeRemap(
    const SkdOverlapWeights& weights, SkdOverlapSpace space, const SkdConservativeRules& rules);

  /// With several processes, which donor cells count in integrals over the donor on this one:
  /// nothing if it has all of the donor. Must outlive this.
  void SetOwnDonors(const std::vector<unsigned char>& own) { this->OwnDonors = &own; }

  /// A field of cells, of first order without `gradients`. First order keeps to the bounds of the
  /// donor's values where it is normalised by what is covered, and so does second order with a
  /// limiter. In parallel; the same to the last bit whatever the number of threads.
  /// SkdLimiter::ClipAndAssuredSum needs AssureSums() after that.
  SkdRemappedField Map(
    const SkdDonorField& field, const SkdDonorGradients* gradients, SkdLimiter limiter) const;

  /// Clips the results, and gives back what that takes from the integral over all parts of the
  /// target: `sums` are those of `mapped.Clipped` over all of them, which may be on other
  /// processes.
  void AssureSums(const SkdDonorField& field, const std::vector<SkdClippedSum>& sums,
    SkdRemappedField& mapped) const;

  /// A field of points, as the functions of the table make it, intensive; `points` are where they
  /// are.
  SkdRemappedField MapPoints(const SkdDonorField& field, const SkdOverlapPointTable& table,
    const std::vector<skd::Vector3>& points) const;

private:
  struct Shares;
  struct Row;

  bool IsReversed(const SkdDonorField& field) const;
  SkdDonorField DensityOf(const SkdDonorField& field) const;
  SkdRemappedField MapShares(const Shares& shares) const;
  void LimitSlopes(const SkdDonorField& density, int component, const SkdDonorGradients& gradients,
    const SkdCellRanges& ranges, std::vector<skd::Vector3>& slopes) const;
  void LimitInOverlaps(const SkdDonorField& density, int component, const SkdCellRanges& ranges,
    std::vector<skd::Vector3>& slopes) const;
  void LimitUncovered(const SkdDonorField& density, int component,
    const SkdDonorGradients& gradients, const SkdCellRanges& ranges,
    std::vector<skd::Vector3>& slopes) const;
  double FactorOf(bool isExtensive, std::size_t target, double covered) const;
  void FindClipped(const Shares& shares, std::size_t component, SkdRemappedField& mapped) const;
  template <class Visit>
  void VisitClipped(const SkdRemappedField& mapped, std::size_t component, bool isExtensive,
    const Visit& visit) const;
  static SkdCellRange RangeOf(
    const Shares& shares, std::size_t target, const SkdCellRanges& ranges);
  void TakePart(const Shares& shares, std::size_t target, vtkIdType donor, Row& row) const;
  void MapRow(const Shares& shares, std::size_t target, Row& row) const;
  void Finish(const Shares& shares, std::size_t target, Row& row) const;
  void AddDonor(const SkdDonorField& density, const std::vector<std::vector<skd::Vector3>>& slopes,
    SkdRemappedField& mapped) const;
  bool IsOwn(std::size_t donor) const
  {
    return !this->OwnDonors || this->OwnDonors->empty() || (*this->OwnDonors)[donor] != 0;
  }
  void AddTarget(const SkdDonorField& field, SkdRemappedField& mapped) const;

  const SkdOverlapWeights& Weights;
  SkdOverlapSpace Space;
  SkdConservativeRules Rules;
  const std::vector<unsigned char>* OwnDonors = nullptr;
};
}

#endif
