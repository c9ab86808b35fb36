// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRefineState.h
 * @brief The state of a refining filter: lists of its settings, and the trees of its criteria.
 */

#ifndef SkdRefineState_h
#define SkdRefineState_h

#include "Meshing/Refine/SkdCriteria.h"
#include "Meshing/Refine/SkdEnclosure.h"
#include "Meshing/Refine/SkdFieldCriterion.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <set>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace skdtree
{
class SkdReport;

/// The scalar settings of a refining filter: vtkSkdTreeRefineAlgorithm.h.
struct SkdRefineOptions
{
  int MaximumLevel = 0;
  SkdOverlapTest Test = SkdOverlapTest::Exact;
  bool RefineByNormalDeviation = false;
  double NormalDeviation = 0.0; ///< degrees
  int MinimumSurfaceLevel = 0;
  int InsideLevel = 0;
  SkdFieldTest FieldTest = SkdFieldTest::Difference;
  double FieldThreshold = 0.0;
  double FieldRange[2] = { 0.0, 0.0 };
  bool RelativeFieldThreshold = false;
  int FieldLevel = 0;
  double Epsilon = 0.0;
  double ChordalDeviation = 0.0;
};

class SkdRefineState
{
public:
  ///@{
  /// Settings.
  SkdRefineOptions Options;
  std::map<int, int> PartLevels; // by block index
  std::vector<SkdDistanceBand> Bands;
  std::set<std::string> FieldArrays;
  ///@}

  SkdParts Parts;
  SkdEnclosure Enclosure; ///< of the parts, if something needs it
  SkdFieldCriterion Field;

  /// Where a process refines a grid, if it needs only the parts near it: see SkdUpdateOwnBoxes().
  vtkSmartPointer<vtkPolyData> OwnBoxes;

  /// Updates the trees of the parts and, if needed, of the field, and warns about missing arrays.
  /// Returns the number of trees built for parts. Throws like SkdParts::Update().
  int Update(vtkAlgorithm* self, const std::vector<SkdBlock>& parts, vtkDataObject* field,
    bool needsEnclosure);

  /// The criteria of the settings. This object must outlive them.
  SkdCriteria MakeCriteria() const;

  /// Tells of the parts.
  void Report(SkdReport& report) const;

private:
  void UpdateField(vtkAlgorithm* self, vtkDataObject* field);

  bool HasEnclosure = false;
};
}

#endif
