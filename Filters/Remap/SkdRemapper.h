// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRemapper.h
 * @brief Fields of a donor mapped onto meshes: by what cells contain, or conservatively.
 */

#ifndef SkdRemapper_h
#define SkdRemapper_h

#include "Remap/SkdContainedMean.h"
#include "Remap/SkdExtrapolation.h"
#include "Remap/SkdFileRemap.h"
#include "Remap/SkdOverlapCache.h"
#include "Remap/SkdRemapFindings.h"

#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class vtkTable;

namespace skdtree
{
struct SkdRemapSettings
{
  SkdFieldRules Fields;
  SkdOverlapSettings Overlap;
  SkdConservativeRules Conservative;
  bool IsSecondOrder = false;
  SkdLimiter Limiter = SkdLimiter::BarthJespersen;
  SkdStatistic Statistic = SkdStatistic::Mean;
  SkdEmptyCells Empty = SkdEmptyCells::Nearest;
  SkdExtrapolationRules Extrapolation; ///< of what is not covered, and of what no weight is for
  bool WeighsByCosine = false;         ///< of the latitude; on a sphere
  bool WithPointFields = true;         ///< maps the fields of points, too
  bool ToPoints = false;               ///< results go to the target's points
};

/// One donor, block after block of a target. What is made of meshes alone is kept from run to run.
class SkdRemapper
{
public:
  /// Begins a run: reads the donor's fields.
  void Begin(vtkDataSet* donor, const SkdRemapSettings& settings, vtkAlgorithm* algorithm);

  ///@{
  /// Integrals over the parts of all processes, which must all do so: first that this one takes
  /// part in what is conservative, with cells or without, and in the end the sums.
  void ExpectIntegrals();
  void AddIntegrals(const skd::Processes& processes);

  /// How many overlaps the others have.
  void AddOverlaps(const skd::Processes& processes)
  {
    const auto own = static_cast<double>(this->Findings.Overlaps);
    this->Findings.OverlapsElsewhere = static_cast<vtkIdType>(processes.SumOf(own) - own);
  }
  ///@}

  /// Of curved surfaces, before any block is mapped: finds how all blocks face the donor, and the
  /// overlaps. All processes must do so that take part. False if aborted.
  bool MatchSurfaces(const std::vector<SkdBlock>& blocks, const skd::Processes* processes,
    double first, double last);

  ///@{
  /// Adds the fields to a block, the index-th, and the arrays about each cell. Progress goes from
  /// `first` to `last`. False if aborted.
  bool MapContained(vtkDataSet* block, double first, double last);
  bool MapConservative(vtkDataSet* block, std::size_t index, double first, double last);
  ///@}

  /// After all blocks: where results are clipped and the sum is assured, adds the fields, with the
  /// sums over all blocks and processes. All must call it together that map conservatively; it does
  /// nothing else.
  void AssureSums(const skd::Processes* processes);

  /// For a process without cells of the target: its own part in the integrals over the donor.
  void SumUpDonor();

  /// Applies the weights of a file to all blocks, whose cells or points count on from block to
  /// block. Results go to what `wanted` says (vtkDataObject's type), or, if it is -1, to what the
  /// file is of. What is wrong is among the findings.
  void MapByFile(const std::string& fileName, const std::vector<SkdBlock>& blocks, int wanted);

  /// Of a block that was mapped conservatively in this run; nullptr if there are none.
  const SkdOverlapWeights* GetWeights(std::size_t index) const;

  /// With what was found of surfaces.
  const SkdOverlapSettings& GetOverlapSettings() const { return this->Settings.Overlap; }

  const SkdRemapFindings& GetFindings() const { return this->Findings; }

  /// Lets go of the donor's data. What is kept stays.
  void End();

private:
  struct CachedSamples
  {
    SkdMeshSnapshot Mesh;
    bool WeighsByCosine = false;
    std::unique_ptr<SkdContainedMean> Samples;
  };

  /// A block whose fields wait for AssureSums().
  struct ClippedBlock
  {
    vtkSmartPointer<vtkDataSet> Block;
    std::size_t Index;
    std::vector<std::pair<const SkdDonorField*, SkdRemappedField>> Fields;
  };

  bool IsSumAssured() const
  {
    return this->Settings.IsSecondOrder && this->Settings.Limiter == SkdLimiter::ClipAndAssuredSum;
  }
  SkdConservativeRemap MakeRemap(std::size_t index) const;
  std::vector<SkdClippedSum> SumUpClipped(const skd::Processes* processes) const;
  void FinishClipped(const std::vector<SkdClippedSum>& sums);
  void AddConservative(vtkDataSet* block, const SkdOverlapCells& cells,
    const std::vector<skd::Vector3>& middles, const SkdDonorField& field, SkdRemappedField& mapped);
  std::vector<skd::Vector3> MiddlesForExtrapolation(vtkDataSet* block) const;
  const SkdContainedMean& SamplesOf(int type);
  void AddFields(vtkDataSet* block, const std::vector<SkdDonorField>& fields,
    const std::vector<std::vector<double>>& values, const std::vector<double>& measures);
  void Extrapolate(const SkdDonorField& field, const std::vector<skd::Vector3>& positions,
    const std::vector<unsigned char>& isWanted, std::vector<double>& values);
  std::vector<unsigned char> FindUncovered(const SkdDonorField& field, const SkdOverlapCells& cells,
    const std::vector<double>& values) const;
  std::vector<double> FractionsOf(const SkdOverlapWeights& weights) const;
  void AddCounts(vtkDataSet* block, const std::vector<vtkIdType>& counts);
  void AddCoverage(vtkDataSet* block, const SkdOverlapWeights& weights);
  void Count(const SkdOverlapWeights& weights, bool isNew);
  bool ReadFile(const std::string& fileName);
  void AddMapped(const std::vector<SkdBlock>& blocks, int type, const SkdDonorField& field,
    const std::vector<double>& values);
  void AddValid(
    const std::vector<SkdBlock>& blocks, int type, const std::vector<unsigned char>& isMapped);
  bool MapFields(vtkDataSet* block, std::size_t index, double first, double last);

  vtkSmartPointer<vtkDataSet> Donor;
  std::vector<unsigned char> OwnDonors; // SkdOwnCellsOf
  SkdRemapSettings Settings;
  vtkAlgorithm* Algorithm = nullptr;
  std::vector<SkdDonorField> CellFields;
  std::vector<SkdDonorField> PointFields;
  SkdRemapFindings Findings;
  CachedSamples OfPoints;
  CachedSamples OfCells;
  std::deque<SkdOverlapCache> Overlaps; // one a block of the target
  std::vector<bool> HasWeights;
  std::vector<ClippedBlock> Clipped;
  SkdFileWeights FileWeights; // kept while the file is the same
  long FileTime = 0;
};
}

#endif
