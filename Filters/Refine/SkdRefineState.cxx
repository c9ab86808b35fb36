// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/SkdRefineState.h"

#include "Pipeline/SkdReport.h"
#include "vtkMath.h"

#include <algorithm>

namespace
{
void WarnAbout(vtkSkdTreeRefineAlgorithm* self, const SkdSignedSource& boundary)
{
  if (boundary.GetNumberOfFaces() == 0)
  {
    vtkWarningWithObjectMacro(self, "The parts have no surface: nothing is inside.");
  }
  else if (boundary.GetNumberOfOpenEdges() > 0)
  {
    vtkWarningWithObjectMacro(self,
      "The parts are not closed, they have "
        << boundary.GetNumberOfOpenEdges()
        << " open edges: what is inside goes by winding number.");
  }
}
}

int SkdRefineState::Update(vtkSkdTreeRefineAlgorithm* self, const std::vector<SkdLeaf>& parts,
  vtkDataObject* field, bool needsEnclosure)
{
  int treesBuilt = this->Parts.Update(parts, self->GetEpsilon(), SkdComparable);
  this->UpdateField(self, field);
  this->HasEnclosure = needsEnclosure || self->GetInsideLevel() > 0;
  if (this->HasEnclosure)
  {
    treesBuilt += this->Enclosure.Update(parts, self->GetEpsilon(), self->GetChordalDeviation());
    WarnAbout(self, this->Enclosure.GetBoundary());
  }
  return treesBuilt;
}

void SkdRefineState::UpdateField(vtkSkdTreeRefineAlgorithm* self, vtkDataObject* field)
{
  SkdFieldSettings settings;
  settings.Arrays = this->FieldArrays;
  settings.Test = static_cast<SkdFieldTest>(self->GetFieldTest());
  settings.Threshold = self->GetFieldThreshold();
  std::copy_n(self->GetFieldRange(), 2, settings.Range);
  this->Field.Update(SkdLeavesOf(field), settings, self->GetEpsilon());
  for (const std::string& name : this->Field.GetMissing())
  {
    vtkWarningWithObjectMacro(
      self, "The field has no array " << name << " that FieldTest can use.");
  }
}

SkdCriteria SkdRefineState::MakeCriteria(vtkSkdTreeRefineAlgorithm* self) const
{
  SkdCriteria criteria;
  criteria.MaximumLevel = self->GetMaximumLevel();
  criteria.Bands = this->Bands;
  criteria.Test = self->GetTest() == vtkSkdTreeRefineAlgorithm::EXACT ? SkdOverlapTest::Exact
                                                                      : SkdOverlapTest::Blind;
  for (const int blockIndex : this->Parts.GetBlockIndices())
  {
    const auto level = this->PartLevels.find(blockIndex);
    criteria.PartLevels.push_back(
      level == this->PartLevels.end() ? criteria.MaximumLevel : level->second);
  }
  if (self->GetRefineByBend())
  {
    criteria.BendAngle = vtkMath::RadiansFromDegrees(self->GetBendAngle());
    criteria.FlatLevel = self->GetFlatLevel();
  }
  if (self->GetInsideLevel() > 0)
  {
    criteria.InsideLevel = self->GetInsideLevel();
    criteria.IsInside = [this](const skd::Vector3& x) { return this->Enclosure.IsInside(x); };
  }
  if (!this->FieldArrays.empty())
  {
    criteria.FieldLevel = self->GetFieldLevel();
    criteria.IsFieldWanted = [this](const SkdRegion& cell) { return this->Field.IsWanted(cell); };
  }
  return criteria;
}

void SkdRefineState::Report(SkdReport& report) const
{
  const SkdTreeCounts counts = this->Parts.GetCounts();
  report.AddCount("Parts", this->Parts.GetNumberOfParts());
  report.AddCount("PartCells", counts.Cells);
  report.AddCount("PartCellsLeftOut", counts.CellsLeftOut);
  report.AddMeasure("Epsilon", counts.Tolerance);
  if (this->HasEnclosure)
  {
    report.AddCount("OpenEdges", this->Enclosure.GetBoundary().GetNumberOfOpenEdges());
    report.AddMeasureOf("ChordalLength", this->Enclosure.GetBoundary().GetChordalLength());
  }
}
