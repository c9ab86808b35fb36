// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeCurveSurfaceIntersection.h"

#include "Curves/SkdCutCurves.h"
#include "Curves/SkdSurfaceHitArrays.h"
#include "InOut/SkdPartList.h"
#include "Pipeline/SkdBlockArrays.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdStopwatch.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeCurveSurfaceIntersection);

class vtkSkdTreeCurveSurfaceIntersection::Internals
{
public:
  std::vector<SkdBlock> Blocks; // of the Source, while it is looked at
  SkdSurfaceSet Surfaces;
  std::vector<std::vector<int>> Pieces; // of the Source's cells, when they were asked for
};

namespace
{
bool IsComposite(vtkDataObject* data)
{
  return vtkCompositeDataSet::SafeDownCast(data) != nullptr;
}

std::vector<SkdBlock> BlocksWithCells(vtkDataObject* data)
{
  std::vector<SkdBlock> blocks;
  for (const SkdBlock& block : SkdBlocksOf(data))
  {
    if (block.Mesh->GetNumberOfCells() > 0)
    {
      blocks.push_back(block);
    }
  }
  return blocks;
}

void WarnAbout(vtkAlgorithm* self, const char* port, const std::vector<std::string>& faults)
{
  for (const std::string& fault : faults)
  {
    vtkWarningWithObjectMacro(self, << port << ": " << fault << "; they are ignored.");
  }
}

/// The numbers of the intersections along their curves; what is not wanted is taken out.
void Select(vtkSkdTreeCurveSurfaceIntersection* self, SkdSurfaceHitTable& table)
{
  const bool wantsAll = self->GetHitSelection() == vtkSkdTreeCurveSurfaceIntersection::ALL_HITS;
  const bool wantsFirst = self->GetHitSelection() == vtkSkdTreeCurveSurfaceIntersection::FIRST_HIT;
  const vtkIdType wanted = wantsFirst ? 1 : self->GetHitNumber();
  std::vector<SkdSurfaceIntersection> all;
  all.swap(table.Intersections);
  vtkIdType number = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const bool isNext = i > 0 && all[i].Hit.Curve == all[i - 1].Hit.Curve;
    number = isNext ? number + 1 : 1;
    if (wantsAll || number == wanted)
    {
      table.Intersections.push_back(all[i]);
      table.Numbers.push_back(number);
    }
  }
}

/// Makes `output` the Input, with how often each of its cells is hit.
void CountHits(const SkdSurfaceHitTable& table, vtkDataObject* input, vtkDataObject* output)
{
  std::vector<vtkSmartPointer<vtkIdTypeArray>> counts;
  for (const SkdBlock& block : table.CurveBlocks)
  {
    auto count = SkdMakeArray<vtkIdTypeArray>("SkdNumberOfHits", 1, block.Mesh->GetNumberOfCells());
    count->FillValue(0);
    counts.push_back(count);
  }
  for (const SkdSurfaceIntersection& intersection : table.Intersections)
  {
    const SkdCurve& curve = table.Curves.GetCurves()[intersection.Hit.Curve];
    vtkIdTypeArray* count = counts[static_cast<std::size_t>(curve.Block)];
    count->SetValue(curve.CellId, count->GetValue(curve.CellId) + 1);
  }
  SkdMirror(input, output);
  std::size_t next = 0;
  for (const SkdBlock& mirror : BlocksWithCells(output))
  {
    mirror.Mesh->GetCellData()->AddArray(counts[next++]);
    mirror.Mesh->GetCellData()->SetActiveScalars("SkdNumberOfHits");
  }
}

void Report(const SkdSurfaceHitTable& table, double rounding, vtkPolyData* output)
{
  SkdReport report(output);
  report.AddCount("Curves", static_cast<vtkIdType>(table.Curves.GetCurves().size()));
  report.AddCount("CurvePieces", static_cast<vtkIdType>(table.Curves.GetNumberOfPieces()));
  report.AddCount("SurfaceElements", static_cast<vtkIdType>(table.Surfaces.GetElements().size()));
  report.AddCount("Hits", static_cast<vtkIdType>(table.Intersections.size()));
  report.AddMeasure("Epsilon", table.Surfaces.GetAbsoluteEpsilon());
  report.AddMeasure("Rounding", rounding);
}
}

//------------------------------------------------------------------------------
vtkSkdTreeCurveSurfaceIntersection::vtkSkdTreeCurveSurfaceIntersection()
  : vtkSkdTreeSourceAlgorithm(SourceUse::Required, { VTK_POLY_DATA, VTK_POLY_DATA, LIKE_INPUT })
  , Impl(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSkdTreeCurveSurfaceIntersection::~vtkSkdTreeCurveSurfaceIntersection() = default;

//------------------------------------------------------------------------------
int vtkSkdTreeCurveSurfaceIntersection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* source = vtkDataObject::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  const std::vector<SkdBlock> curveBlocks = BlocksWithCells(input);
  SkdStopwatch watch;

  const bool wasBuilt = this->UpdateSurfaces(source);
  const SkdSurfaceSet& surfaces = this->Impl->Surfaces;
  const std::vector<SkdBlock>& surfaceBlocks = this->Impl->Blocks;
  SkdCurveSet curves;
  curves.Read(curveBlocks,
    SkdPolylineForm::Of(this->PolylineForm, this->Tension, this->Bias, this->Continuity));
  this->WarnAboutInputs(curves, surfaces);
  const double buildSeconds = watch.Lap();

  const double delta =
    curves.GetBounds().Diagonal() * (this->ChordTolerance > 0.0 ? this->ChordTolerance : 1e-3);
  const SkdSurfaceHitFinder finder(curves, surfaces, delta);
  SkdLoop loop(this, static_cast<vtkIdType>(curves.GetNumberOfPieces()), 0.2, 0.9);
  SkdSurfaceHitTable table{ curves, curveBlocks, surfaces, surfaceBlocks, finder.Find(loop), {} };
  const double querySeconds = watch.Lap();

  if (this->CutCurves)
  {
    SkdCutCurves({ curves, curveBlocks, surfaces.GetElements(), finder, IsComposite(input), delta },
      table.Intersections, vtkPolyData::GetData(outputVector, 1));
  }
  table.Intersections = finder.UniteAtJoints(std::move(table.Intersections));
  CountHits(table, input, vtkDataObject::GetData(outputVector, 2));
  Select(this, table);
  this->StoreHits(table, IsComposite(input), IsComposite(source), output);
  Report(table, finder.GetRounding(), output);
  SkdReport report(output);
  report.AddCount("TreesBuilt", wasBuilt ? 1 : 0);
  report.AddMeasure("BuildSeconds", buildSeconds);
  report.AddMeasure("QuerySeconds", querySeconds);
  this->Impl->Blocks.clear();
  return 1;
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveSurfaceIntersection::SetPartArray(const char* name)
{
  const std::string wanted = name ? name : "";
  if (this->PartArray != wanted)
  {
    this->PartArray = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// Whether a tree was built.
bool vtkSkdTreeCurveSurfaceIntersection::UpdateSurfaces(vtkDataObject* source)
{
  Internals& internals = *this->Impl;
  internals.Blocks = BlocksWithCells(source);
  const bool wasBuilt =
    internals.Surfaces.Update(internals.Blocks, this->VolumeFaces, this->Epsilon);
  const bool lacksArray =
    this->Parts == CELL_ARRAY && !SkdHavePartArray(internals.Blocks, this->PartArray);
  std::vector<std::vector<int>> ids;
  if (lacksArray)
  {
    vtkErrorMacro("Source has no cell array of numbers named \""
      << this->PartArray << "\" in all its blocks; each block is a part instead.");
  }
  for (std::size_t i = 0; this->Parts == CELL_ARRAY && !lacksArray && i < internals.Blocks.size();
       ++i)
  {
    ids.push_back(SkdPartIdsOf(internals.Blocks[i].Mesh, this->PartArray));
  }
  if (this->Parts == CONNECTED_PIECES)
  {
    const bool isKnown = !wasBuilt && internals.Pieces.size() == internals.Blocks.size();
    ids = isKnown ? std::move(internals.Pieces) : SkdConnectedPiecesOf(internals.Blocks);
  }
  internals.Surfaces.AssignParts(internals.Blocks, ids);
  internals.Pieces = this->Parts == CONNECTED_PIECES ? std::move(ids) : decltype(ids)();
  return wasBuilt;
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveSurfaceIntersection::WarnAboutInputs(
  const SkdCurveSet& curves, const SkdSurfaceSet& surfaces)
{
  WarnAbout(this, "Input", curves.GetFaults());
  WarnAbout(this, "Source", surfaces.GetFaults());
  if (curves.GetCurves().empty())
  {
    vtkWarningMacro("Input has no curves; there are no intersections.");
  }
  if (surfaces.GetElements().empty())
  {
    vtkWarningMacro("Source has no surfaces; there are no intersections.");
  }
  if (!(this->ChordTolerance > 0.0))
  {
    vtkWarningMacro("ChordTolerance is "
      << this->ChordTolerance
      << " and is ignored; curves are approximated within 0.001 of the diagonal of their bounds.");
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveSurfaceIntersection::StoreHits(
  const SkdSurfaceHitTable& table, bool hasCurveBlocks, bool hasSurfaceBlocks, vtkPolyData* output)
{
  SkdStoreSurfaceHits(table, output);
  if (hasCurveBlocks)
  {
    SkdStoreCurveBlocks(table, output);
  }
  if (hasSurfaceBlocks)
  {
    SkdStoreSurfaceBlocks(table, output);
  }
  if (this->InterpolateData)
  {
    std::set<std::string> refused;
    SkdStoreDataAtHits(table, output, refused);
    SkdWarnAboutRefused(this, refused);
  }
}

//------------------------------------------------------------------------------
void vtkSkdTreeCurveSurfaceIntersection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PolylineForm: " << this->PolylineForm << "\n";
  os << indent << "Tension: " << this->Tension << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "Continuity: " << this->Continuity << "\n";
  os << indent << "VolumeFaces: " << (this->VolumeFaces ? "On\n" : "Off\n");
  os << indent << "Parts: " << this->Parts << "\n";
  os << indent << "PartArray: " << this->PartArray << "\n";
  os << indent << "HitSelection: " << this->HitSelection << "\n";
  os << indent << "HitNumber: " << this->HitNumber << "\n";
  os << indent << "InterpolateData: " << (this->InterpolateData ? "On\n" : "Off\n");
  os << indent << "CutCurves: " << (this->CutCurves ? "On\n" : "Off\n");
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "Epsilon: " << this->Epsilon << "\n";
}
VTK_ABI_NAMESPACE_END
