// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeCurveIntersection.h"

#include "Curves/SkdCurveHitArrays.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdReport.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeCurveIntersection);

class vtkSkdTreeCurveIntersection::Internals
{
public:
  SkdCurveTree First;
  SkdCurveTree Second;
};

namespace
{
void Report(const SkdCurveHitTable& table, double rounding, vtkPolyData* output)
{
  const auto count = [](const auto& list) { return static_cast<vtkIdType>(list.size()); };
  SkdReport report(output);
  report.AddCount("Curves", count(table.First.Tree.GetCurves().GetCurves()));
  report.AddCount("OtherCurves", count(table.Second.Tree.GetCurves().GetCurves()));
  report.AddCount("Parts", count(table.First.Tree.GetSpans()));
  report.AddCount("Hits", count(table.Intersections.Hits));
  report.AddMeasure("Epsilon", table.Second.Tree.GetAbsoluteEpsilon());
  report.AddMeasure("Rounding", rounding);
}
}

//------------------------------------------------------------------------------
vtkSkdTreeCurveIntersection::vtkSkdTreeCurveIntersection()
  : vtkSkdTreeCurveAlgorithm(
      SourceUse::Optional, { VTK_POLY_DATA, VTK_POLY_DATA, VTK_UNSTRUCTURED_GRID })
  , Impl(new Internals)
{
  this->WholeInput = true; // curves against each other need all of them
}

//------------------------------------------------------------------------------
vtkSkdTreeCurveIntersection::~vtkSkdTreeCurveIntersection() = default;

//------------------------------------------------------------------------------
int vtkSkdTreeCurveIntersection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  if (SkdIsLaterPiece(outputVector->GetInformationObject(0)))
  {
    return 1; // the first piece has all
  }
  const std::vector<SkdBlock> blocks = SkdBlocksOf(input);
  const std::vector<SkdBlock> otherBlocks = SkdBlocksOf(source ? source : input);
  SkdStopwatch watch;

  const SkdCurveSettings settings{ this->FindPolylineForm(), this->FindChordTolerance(),
    this->Epsilon };
  SkdCurveTree& first = this->Impl->First;
  SkdCurveTree& second = source ? this->Impl->Second : this->Impl->First;
  int built = first.Update(blocks, settings) ? 1 : 0;
  built += source && second.Update(otherBlocks, settings) ? 1 : 0;
  const auto warnAbout = [this](const char* port, const SkdCurveSet& curves)
  { this->WarnAboutInput(port, curves.GetFaults(), curves.GetCurves().empty(), "curves"); };
  warnAbout("Input", first.GetCurves());
  if (source)
  {
    warnAbout("Source", second.GetCurves());
  }
  const double buildSeconds = watch.Lap();

  const SkdCurveHitFinder finder(
    first, second, { this->Clearance, this->IgnoreJoints, this->CandidateRegions });
  SkdLoop loop(this, static_cast<vtkIdType>(first.GetSpans().size()), 0.2, 0.9);
  const SkdCurveHitTable table{ { first, blocks, SkdIsComposite(input) },
    { second, otherBlocks, SkdIsComposite(source ? source : input) }, finder.Find(loop) };
  const double querySeconds = watch.Lap();

  this->StoreIntersections(table, outputVector);
  Report(table, finder.GetRounding(), output);
  SkdReport report(output);
  report.AddRun(built, buildSeconds, "QuerySeconds", querySeconds);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveIntersection::StoreIntersections(
  const SkdCurveHitTable& table, vtkInformationVector* outputs)
{
  vtkPolyData* points = vtkPolyData::GetData(outputs, 0);
  const SkdCurveTree& first = table.First.Tree;
  SkdStoreCurveHits(table, points);
  SkdStoreIntervals(table,
    first.GetSettings().ChordTolerance * first.GetCurves().GetBounds().Diagonal(),
    vtkPolyData::GetData(outputs, 1));
  if (this->CandidateRegions)
  {
    SkdStoreCandidates(table, vtkUnstructuredGrid::GetData(outputs, 2));
  }
  if (this->InterpolateData)
  {
    SkdWarnAboutRefused(this, SkdStoreDataOfCurves(table, points));
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveIntersection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Clearance", this->Clearance, "IgnoreJoints", this->IgnoreJoints,
    "CandidateRegions", this->CandidateRegions);
}
VTK_ABI_NAMESPACE_END
