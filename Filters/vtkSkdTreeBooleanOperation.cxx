// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeBooleanOperation.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Solids/Boolean/SkdBooleanOutputs.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeBooleanOperation);

/// Kept while the inputs are unchanged.
class vtkSkdTreeBooleanOperation::Internals : public SkdSolidArrangement
{
public:
  SkdBooleanRule MakeRule(vtkSkdTreeBooleanOperation* self) const
  {
    return { static_cast<SkdBooleanOperation>(self->Operation),
      static_cast<SkdInsideRule>(self->InsideRule), this->GetSolids().Count,
      static_cast<std::uint32_t>(self->MinimumNumberOfSolids), this->IsSheet(1) };
  }

  /// Finds out what is inside, if the operation needs it. False after an error.
  bool FindInside(vtkSkdTreeBooleanOperation* self);
};

bool vtkSkdTreeBooleanOperation::Internals::FindInside(vtkSkdTreeBooleanOperation* self)
{
  const auto operation = static_cast<SkdBooleanOperation>(self->Operation);
  const auto unclosed = this->FindUnclosed(operation);
  if (operation == SkdBooleanOperation::Imprint && unclosed)
  {
    return true; // an imprint of open surfaces is one without winding numbers
  }
  if (unclosed)
  {
    SkdTellUnclosed(self, *this, *unclosed);
    return false;
  }
  const auto faults = this->FindWindings();
  SkdTellSheetFaults(self, faults);
  SkdTellRounded(self, *this);
  return faults.has_value();
}

vtkSkdTreeBooleanOperation::vtkSkdTreeBooleanOperation()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Optional, { VTK_POLY_DATA, VTK_POLY_DATA })
  , Impl(new Internals)
{
  this->WholeInput = true; // all of it bounds the solid
  this->AnyMagnitude = true;
}

vtkSkdTreeBooleanOperation::~vtkSkdTreeBooleanOperation() = default;

int vtkSkdTreeBooleanOperation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (SkdIsLaterPiece(outputVector->GetInformationObject(0)))
  {
    return 1; // the first piece has all
  }
  SkdStopwatch watch;
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  const SkdBooleanBlocks blocks =
    SkdMakeBooleanBlocks(vtkDataObject::GetData(inputVector[0]), source);
  Internals& solids = *this->Impl;
  const bool areInputs = source && this->Operation != AT_LEAST;
  if (!solids.Update(blocks, this->ChordalDeviation, areInputs, solids.MakeRule(this), this))
  {
    return 1;
  }
  SkdWarnAboutInputs(this, solids, blocks, this->ChordalDeviation);
  solids.SetRoundsNumbers(this->OpenSurfaces == WINDING_NUMBER);
  solids.FindSolids(blocks, areInputs);
  if (!solids.FindInside(this))
  {
    return 1;
  }
  const SkdBooleanRule rule = solids.MakeRule(this);
  const bool closesCut = this->CloseCut != 0;
  std::set<std::string> refused;
  const SkdBooleanTotals totals = SkdFillBooleanOutputs(solids, blocks, rule,
    { this->KeepPolygons != 0, this->JoinPieces != 0, this->MergePieces != 0, closesCut }, output,
    vtkPolyData::GetData(outputVector, 1), refused);
  SkdWarnAboutRefused(this, refused);
  SkdReport report(output);
  SkdReportBoolean(this, solids, rule, totals, closesCut, report);
  report.AddMeasure("Seconds", watch.Lap());
  return 1;
}

void vtkSkdTreeBooleanOperation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Operation", this->Operation, "MinimumNumberOfSolids",
    this->MinimumNumberOfSolids, "InsideRule", this->InsideRule, "OpenSurfaces", this->OpenSurfaces,
    "KeepPolygons", this->KeepPolygons, "JoinPieces", this->JoinPieces, "MergePieces",
    this->MergePieces, "CloseCut", this->CloseCut, "ChordalDeviation", this->ChordalDeviation);
}
VTK_ABI_NAMESPACE_END
