// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeBooleanOperation.h"

#include "Exchange/SkdAskOthers.h"
#include "Exchange/SkdFilterInputs.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdMotion.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "Solids/Boolean/SkdBooleanOutputs.h"
#include "Solids/Boolean/SkdCutPlane.h"
#include "Solids/Boolean/SkdSpreadOutput.h"
#include "Solids/Boolean/SkdSpreadSolids.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>

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
  SkdCutPlane Plane;
  SkdSpreadSolids Dealt; // of inputs that stay in their pieces

  SkdBooleanOptions OptionsOf(vtkSkdTreeBooleanOperation* self, bool isCutByPlane) const
  {
    return { self->KeepPolygons != 0, self->JoinPieces != 0, self->MergePieces != 0,
      self->CloseCut != 0, isCutByPlane };
  }

  /// The operation on inputs that stay in their pieces, of which each process outputs a part. All
  /// must call it together.
  SkdDealt CombineSpread(
    vtkSkdTreeBooleanOperation* self, vtkPolyData* output, vtkPolyData* section);

  /// The inputs, or the Input and the plane that cuts it. Empty after an error.
  std::optional<SkdBooleanBlocks> MakeBlocks(
    vtkSkdTreeBooleanOperation* self, vtkDataObject* input, vtkDataObject* source);

  /// Finds out what is inside, if the operation needs it. False after an error.
  bool FindInside(vtkSkdTreeBooleanOperation* self);
};

std::optional<SkdBooleanBlocks> vtkSkdTreeBooleanOperation::Internals::MakeBlocks(
  vtkSkdTreeBooleanOperation* self, vtkDataObject* input, vtkDataObject* source)
{
  if (source)
  {
    SkdBooleanBlocks blocks = SkdMakeBooleanBlocks(input, source);
    const vtkSmartPointer<vtkMatrix4x4> motion = SkdMotionOf(self);
    if (motion->IsIdentity())
    {
      return blocks;
    }
    blocks.Motion = skd::RigidMotion::FromMatrix(&motion->Element[0][0]);
    if (!blocks.Motion)
    {
      vtkErrorWithObjectMacro(
        self, "Translation, Rotation and RotationCenter must be finite; there is no output.");
      return std::nullopt;
    }
    return blocks;
  }
  if (!self->UsesPlane())
  {
    return SkdMakeBooleanBlocks(input, nullptr);
  }
  const double* const x = self->PlaneOrigin;
  const double* const n = self->PlaneNormal;
  vtkPolyData* const plane = this->Plane.Update(SkdBlocksOf(input), { { x[0], x[1], x[2] } },
    { { n[0], n[1], n[2] } }, self->OpenSurfaces == WINDING_NUMBER);
  if (!plane)
  {
    vtkErrorWithObjectMacro(self,
      "The plane cannot cut the Input: PlaneNormal is 0, or coordinates are too large. There is no "
      "output.");
    return std::nullopt;
  }
  return SkdMakeBooleanBlocks(input, plane);
}

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
  this->Inputs->SetAsks([this](int) { return this->CanStayInPieces(); });
  this->Inputs->SetMutual(
    [this](SkdSearchRange& range)
    {
      range.IsMutual = range.IsOfFaces = range.IsOfOneMesh = true;
      return this->CanStayInPieces();
    });
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

/// Whether the plane cuts, if there is no Source.
bool vtkSkdTreeBooleanOperation::UsesPlane() const
{
  return this->CutByPlane &&
    (this->Operation == INTERSECTION || this->Operation == DIFFERENCE || this->Operation == SPLIT);
}

/// Whether inputs that lie in pieces need not be gathered, as far as properties say.
bool vtkSkdTreeBooleanOperation::CanStayInPieces()
{
  const int operations[] = { UNION, INTERSECTION, DIFFERENCE, REVERSE_DIFFERENCE,
    SYMMETRIC_DIFFERENCE };
  return this->GetNumberOfInputConnections(1) > 0 && this->OpenSurfaces == REFUSE &&
    std::count(std::begin(operations), std::end(operations), this->Operation) > 0 &&
    SkdMotionOf(this)->IsIdentity();
}

SkdDealt vtkSkdTreeBooleanOperation::Internals::CombineSpread(
  vtkSkdTreeBooleanOperation* self, vtkPolyData* output, vtkPolyData* section)
{
  SkdStopwatch watch;
  const SkdSpreadSource& input = *self->Inputs->GetSpread(0);
  SkdTransport& transport = input.GetTransport();
  const SkdDealt dealt =
    this->Dealt.Update(input, *self->Inputs->GetSpread(1), self->ChordalDeviation, self);
  if (dealt != SkdDealt::Done)
  {
    return dealt;
  }
  this->SetSpread(&this->Dealt, &transport);
  SkdBooleanBlocks blocks = this->Dealt.GetBlocks();
  blocks.AlignsFaces = self->AlignFaces != 0;
  const bool isDone =
    this->Update(blocks, self->ChordalDeviation, true, this->MakeRule(self), self);
  const SkdDealt own = isDone ? SkdDealt::Done
    : SkdIsAborted(self)      ? SkdDealt::Aborted
                              : SkdDealt::Unfit;
  const auto most = static_cast<SkdDealt>(SkdMostOf(transport, static_cast<int>(own)));
  if (most != SkdDealt::Done)
  {
    return most;
  }
  this->SetRoundsNumbers(false);
  this->FindSolids(blocks, true);
  if (!this->FindWindings())
  {
    return SkdDealt::Unfit;
  }
  const SkdBooleanRule rule = this->MakeRule(self);
  std::set<std::string> refused;
  SkdBooleanTotals totals = SkdFillBooleanOutputs(
    *this, blocks, rule, this->OptionsOf(self, false), output, section, refused);
  if (!SkdIsClosedOverAll(transport, output))
  {
    return SkdDealt::Unfit;
  }
  totals.Bad = {}; // a part is open, all together are closed
  SkdNumberFacesOverAll(transport, this->Dealt.GetNumbersOfCells(), output);
  SkdReport report(output);
  SkdReportBoolean(self, *this, rule, totals, true, report);
  SkdSumReports(transport, output);
  report.AddCount("CellsInContact", this->Dealt.GetNumberInContact());
  report.AddMeasure("Seconds", watch.Lap());
  if (transport.GetRank() == 0)
  {
    SkdWarnAboutRefused(self, refused);
  }
  return SkdDealt::Done;
}

int vtkSkdTreeBooleanOperation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* section = vtkPolyData::GetData(outputVector, 1);
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  if (this->Inputs->GetSpread(0) && this->Inputs->GetSpread(1))
  {
    if (this->Impl->CombineSpread(this, output, section) != SkdDealt::Unfit)
    {
      return 1;
    }
    output->Initialize();
    section->Initialize();
    input = this->Inputs->GatherSpread(0);
    source = this->Inputs->GatherSpread(1);
  }
  if (SkdIsLaterPiece(outputVector->GetInformationObject(0)))
  {
    return 1; // the first piece has all
  }
  this->CombineWhole(input, source, output, section);
  return 1;
}

void vtkSkdTreeBooleanOperation::CombineWhole(
  vtkDataObject* input, vtkDataObject* source, vtkPolyData* output, vtkPolyData* section)
{
  SkdStopwatch watch;
  const bool isCutByPlane = !source && this->UsesPlane();
  if (this->CutByPlane && !source && !isCutByPlane)
  {
    vtkWarningMacro("CutByPlane is for Intersection, Difference and Split; it is ignored.");
  }
  Internals& solids = *this->Impl;
  solids.SetSpread(nullptr, nullptr);
  auto made = solids.MakeBlocks(this, input, source);
  if (!made)
  {
    return;
  }
  SkdBooleanBlocks& blocks = *made;
  blocks.AlignsFaces = this->AlignFaces != 0;
  const bool areInputs = (source || isCutByPlane) && this->Operation != AT_LEAST;
  if (!solids.Update(blocks, this->ChordalDeviation, areInputs, solids.MakeRule(this), this))
  {
    return;
  }
  SkdWarnAboutInputs(this, solids, blocks, this->ChordalDeviation);
  solids.SetRoundsNumbers(this->OpenSurfaces == WINDING_NUMBER);
  solids.FindSolids(blocks, areInputs);
  if (!solids.FindInside(this))
  {
    return;
  }
  const SkdBooleanRule rule = solids.MakeRule(this);
  std::set<std::string> refused;
  const SkdBooleanTotals totals = SkdFillBooleanOutputs(
    solids, blocks, rule, solids.OptionsOf(this, isCutByPlane), output, section, refused);
  SkdWarnAboutRefused(this, refused);
  SkdReport report(output);
  SkdReportBoolean(this, solids, rule, totals, this->CloseCut != 0, report);
  report.AddMeasure("Seconds", watch.Lap());
}

void vtkSkdTreeBooleanOperation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Operation", this->Operation, "MinimumNumberOfSolids",
    this->MinimumNumberOfSolids, "InsideRule", this->InsideRule, "OpenSurfaces", this->OpenSurfaces,
    "KeepPolygons", this->KeepPolygons, "AlignFaces", this->AlignFaces, "JoinPieces",
    this->JoinPieces, "MergePieces", this->MergePieces, "CloseCut", this->CloseCut, "CutByPlane",
    this->CutByPlane, "PlaneOrigin", this->PlaneOrigin, "PlaneNormal", this->PlaneNormal,
    "ChordalDeviation", this->ChordalDeviation, "Translation", this->Translation, "Rotation",
    this->Rotation, "RotationCenter", this->RotationCenter, "Transform",
    this->Impl->Matrix ? "set" : "none");
}
VTK_ABI_NAMESPACE_END
