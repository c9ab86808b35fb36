// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdOverlapWeights.h
 * @brief How much each cell of one mesh has in common with each of another: the weights of
 * conservative remapping, by exact intersection of the pairs that two trees walked together find.
 */

#ifndef SkdOverlapWeights_h
#define SkdOverlapWeights_h

#include "Remap/SkdOverlapTypes.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;

namespace skdtree
{
/// Rows of target cells, columns of donor cells (CSR): of row i the entries Rows[i] .. Rows[i + 1],
/// by ascending donor id. Overlaps that are nothing but rounding are left out. Of cells that are
/// partly inverted, or whose sides pass each other, they may be negative.
struct SkdOverlapTable
{
  std::vector<std::size_t> Rows;  ///< one more than there are target cells
  std::vector<vtkIdType> Columns; ///< ids of donor cells
  std::vector<double> Measures;   ///< of the overlap: length, area or volume
  /// The integral of x - (centroid of the donor cell) over the overlap. A field that is
  /// f + g . (x - centroid) in the donor cell has the integral f * measure + g . moment.
  std::vector<skd::Vector3> Moments;
  bool IsSigned = false; ///< whether there are negative ones
};

/// All overlaps of two meshes. Results do not depend on the number of threads. About a microsecond
/// a pair of cells that meet; 10^6 cells take some hundred MB a mesh.
class SkdOverlapWeights
{
public:
  /// Finds them all. Reports progress from `first` to `last`. False if the algorithm was aborted,
  /// or if GetProblem() says what is wrong. Broken cells must have been repaired (SkdValidInput).
  bool Compute(vtkDataSet* donor, vtkDataSet* target, const SkdOverlapSettings& settings,
    vtkAlgorithm* algorithm, double first = 0.0, double last = 1.0);

  /// Why nothing was computed, a sentence with what to do; empty if nothing is wrong.
  const std::string& GetProblem() const { return this->Problem; }

  /// Multiplies all overlaps of each donor cell: of curved surfaces that have folds a cell may be
  /// covered more than once.
  void ScaleDonors(const std::vector<double>& shares);

  const SkdOverlapTable& GetTable() const { return this->Table; }
  const SkdOverlapCells& GetDonor() const { return this->Donor; }
  const SkdOverlapCells& GetTarget() const { return this->Target; }

  /// The radius that was taken; 1 of what is no sphere.
  double GetRadius() const { return this->Radius; }

  /// The normal of the plane; zero of what is no plane.
  const skd::Vector3& GetNormal() const { return this->Normal; }

  /// Of curved surfaces: how far facets that have to do with each other are apart, at most.
  double GetLargestGap() const { return this->LargestGap; }

private:
  SkdOverlapTable Table;
  SkdOverlapCells Donor;
  SkdOverlapCells Target;
  double Radius = 1.0;
  double LargestGap = 0.0;
  skd::Vector3 Normal{ { 0.0, 0.0, 0.0 } };
  std::string Problem;
};
}

#endif
