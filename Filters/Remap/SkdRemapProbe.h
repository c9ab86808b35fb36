// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRemapProbe.h
 * @brief A donor's fields interpolated at a target's points, or at the middles of its cells.
 */

#ifndef SkdRemapProbe_h
#define SkdRemapProbe_h

#include "Remap/SkdDonorFields.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>

class vtkAlgorithm;
class vtkDataSet;
class vtkSkdTreeProbe;

namespace skdtree
{
struct SkdProbeSettings
{
  SkdFieldRules Fields;
  std::set<std::string> Gradients; ///< arrays whose gradients are added
  bool TakesNearest = true;        ///< where there is no cell of the donor
  bool IsOnSphere = false;
  double Radius = 0.0;
  bool ToCells = false;
};

/// Keeps its tree of the donor from run to run.
class SkdRemapProbe
{
public:
  SkdRemapProbe();
  ~SkdRemapProbe();

  /// Adds the interpolated arrays to a block; those whose names are in use and may not be changed
  /// are `refused`. Reports progress of the algorithm from `first` to `last`.
  void Map(vtkDataSet* block, vtkDataSet* donor, bool withCellData,
    const SkdProbeSettings& settings, vtkAlgorithm* algorithm, double first, double last,
    std::set<std::string>& refused);

private:
  void SetUp(const SkdProbeSettings& settings);
  void AddTo(
    vtkDataSet* block, const SkdProbeSettings& settings, std::set<std::string>& refused) const;

  vtkNew<vtkSkdTreeProbe> Prober;
};
}

#endif
