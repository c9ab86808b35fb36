// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRefineState.h
 * @brief What a filter that refines keeps: lists of its settings, and the trees of what asks for
 * cells.
 */

#ifndef SkdRefineState_h
#define SkdRefineState_h

#include "Refine/SkdCriteria.h"
#include "Refine/SkdEnclosure.h"
#include "Refine/SkdFieldCriterion.h"
#include "vtkSkdTreeRefineAlgorithm.h"

#include <map>
#include <set>
#include <string>
#include <vector>

class SkdReport;

class SkdRefineState
{
public:
  ///@{
  /// Settings.
  std::map<int, int> PartLevels; // by block index
  std::vector<SkdDistanceBand> Bands;
  std::set<std::string> FieldArrays;
  ///@}

  SkdParts Parts;
  SkdEnclosure Enclosure; ///< of the parts, if something needs it
  SkdFieldCriterion Field;

  /// Makes trees those of the parts and of the field, if that is asked, and warns of arrays that it
  /// does not have. Returns how many trees of parts were built. Throws as SkdParts::Update() does.
  int Update(vtkSkdTreeRefineAlgorithm* self, const std::vector<SkdLeaf>& parts,
    vtkDataObject* field, bool needsEnclosure);

  /// What the filter's settings ask for. This must live.
  SkdCriteria MakeCriteria(vtkSkdTreeRefineAlgorithm* self) const;

  /// Tells of the parts.
  void Report(SkdReport& report) const;

private:
  void UpdateField(vtkSkdTreeRefineAlgorithm* self, vtkDataObject* field);

  bool HasEnclosure = false;
};

#endif
