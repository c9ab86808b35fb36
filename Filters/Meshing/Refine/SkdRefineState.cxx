// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdRefineState.h"

#include "Pipeline/SkdReport.h"
#include "vtkAlgorithm.h"
#include "vtkMath.h"

#include <algorithm>

namespace skdtree
{
namespace
{
void WarnAbout(vtkAlgorithm* self, const SkdSignedSource& boundary)
{
  if (boundary.GetNumberOfFaces() == 0)
  {
    vtkWarningWithObjectMacro(self,
      "The parts have no surface, so no cell is inside. Give closed surfaces or volume cells.");
  }
  else if (boundary.GetNumberOfOpenEdges() > 0)
  {
    vtkWarningWithObjectMacro(self,
      "The parts are not closed: they have "
        << boundary.GetNumberOfOpenEdges()
        << " open edges. The winding number decides what is inside; it may be wrong near gaps.");
  }
}
}

int SkdRefineState::Update(
  vtkAlgorithm* self, const std::vector<SkdBlock>& parts, vtkDataObject* field, bool needsEnclosure)
{
  int treesBuilt = this->Parts.Update(parts, this->Options.Epsilon, SkdComparable);
  this->UpdateField(self, field);
  this->HasEnclosure = needsEnclosure || this->Options.InsideLevel > 0;
  if (this->HasEnclosure)
  {
    treesBuilt +=
      this->Enclosure.Update(parts, this->Options.Epsilon, this->Options.ChordalDeviation);
    WarnAbout(self, this->Enclosure.GetBoundary());
    SkdWarnAboutCoarseFaces(
      self, this->Enclosure.GetBoundary().GetNumberOfCoarseFaces(), this->Options.ChordalDeviation);
  }
  return treesBuilt;
}

void SkdRefineState::UpdateField(vtkAlgorithm* self, vtkDataObject* field)
{
  SkdFieldSettings settings;
  settings.Arrays = this->FieldArrays;
  settings.Test = this->Options.FieldTest;
  settings.Threshold = this->Options.FieldThreshold;
  std::copy_n(this->Options.FieldRange, 2, settings.Range);
  settings.IsRelative = this->Options.RelativeFieldThreshold;
  const bool isUsed = !this->FieldArrays.empty();
  this->Field.Update(
    isUsed ? SkdBlocksOf(field) : std::vector<SkdBlock>(), settings, this->Options.Epsilon);
  for (const std::string& name : this->Field.GetMissing())
  {
    vtkWarningWithObjectMacro(
      self, "The field has no array " << name << " that FieldTest can use; it is ignored.");
  }
}

SkdCriteria SkdRefineState::MakeCriteria() const
{
  SkdCriteria criteria;
  criteria.MaximumLevel = this->Options.MaximumLevel;
  criteria.Bands = this->Bands;
  criteria.Test = this->Options.Test;
  for (const int blockIndex : this->Parts.GetBlockIndices())
  {
    const auto level = this->PartLevels.find(blockIndex);
    criteria.PartLevels.push_back(
      level == this->PartLevels.end() ? criteria.MaximumLevel : level->second);
  }
  if (this->Options.RefineByNormalDeviation)
  {
    criteria.NormalDeviation = vtkMath::RadiansFromDegrees(this->Options.NormalDeviation);
    criteria.MinimumSurfaceLevel = this->Options.MinimumSurfaceLevel;
  }
  if (this->Options.InsideLevel > 0)
  {
    criteria.InsideLevel = this->Options.InsideLevel;
    criteria.IsInside = [this](const skd::Vector3& x) { return this->Enclosure.IsInside(x); };
  }
  if (!this->FieldArrays.empty())
  {
    criteria.FieldLevel = this->Options.FieldLevel;
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
}
