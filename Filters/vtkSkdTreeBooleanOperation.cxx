// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeBooleanOperation.h"

#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdMotion.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Solids/Boolean/SkdBooleanOutputs.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace skdtree;

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

  vtkSmartPointer<vtkMatrix4x4> Matrix; // nullptr: none

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

void vtkSkdTreeBooleanOperation::SetTransform(vtkMatrix4x4* motion)
{
  SkdSetTransform(this, motion, this->Impl->Matrix);
}

vtkMatrix4x4* vtkSkdTreeBooleanOperation::GetTransform()
{
  return this->Impl->Matrix;
}

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
  SkdBooleanBlocks blocks = SkdMakeBooleanBlocks(vtkDataObject::GetData(inputVector[0]), source);
  const vtkSmartPointer<vtkMatrix4x4> motion = SkdMotionOf(this);
  if (source && !motion->IsIdentity())
  {
    blocks.Motion = skd::RigidMotion::FromMatrix(&motion->Element[0][0]);
    if (!blocks.Motion)
    {
      vtkErrorMacro("Translation, Rotation and RotationCenter must be finite; there is no output.");
      return 1;
    }
  }
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
    this->MergePieces, "CloseCut", this->CloseCut, "ChordalDeviation", this->ChordalDeviation,
    "Translation", this->Translation, "Rotation", this->Rotation, "RotationCenter",
    this->RotationCenter, "Transform", this->Impl->Matrix ? "set" : "none");
}
VTK_ABI_NAMESPACE_END
